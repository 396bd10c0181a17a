// SPDX-License-Identifier: Apache-2.0
// The verb `export` for drives of a robot that a take holds.
#pragma once

#include "app/batch/verb.h"

namespace noctule::batch {

std::vector<Option> driveExportOptions();
/// Any of its files is wanted.
bool exportsDrive(const Arguments& arguments);
Result<Outcome> exportDrive(const VerbContext& context);

}  // namespace noctule::batch
