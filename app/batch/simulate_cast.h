// SPDX-License-Identifier: Apache-2.0
// `simulate --cast`: several performers in one take.
#pragma once

#include "app/batch/verb.h"

namespace noctule::batch {

Result<Outcome> runSimulateCast(const VerbContext& context);

}  // namespace noctule::batch
