// SPDX-License-Identifier: Apache-2.0
// The verb `record` with several devices: one suit each, all in one take.
#pragma once

#include "app/batch/verb.h"
#include "devices/live/stream_request.h"

namespace noctule::batch {

/// kUsage when an option that names one per device names more or fewer.
Status checkPerDevice(const Arguments& arguments);

/// `all`: what is wished of all suits alike.
Result<Outcome> recordSeveral(const VerbContext& context, const StreamRequest& all);

}  // namespace noctule::batch
