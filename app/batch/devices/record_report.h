// SPDX-License-Identifier: Apache-2.0
// What the verb `record` says of a recording, as JSON and as text.
#pragma once

#include "app/batch/verb.h"
#include "devices/live/record_take.h"

namespace noctule::batch {

nlohmann::json recordingJson(const RecordReport& report);
std::string recordingText(const RecordReport& report);

}  // namespace noctule::batch
