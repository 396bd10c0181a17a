// SPDX-License-Identifier: Apache-2.0
// Adds a marker of the operator (kind "user") to a take that exists.
#pragma once

#include <string>

#include "core/job/job.h"
#include "core/job/result.h"

namespace noctule {

/// `t_s` on the take's clock; outside the take is kUsage. A label may be empty.
Status markTake(const std::string& path, double t_s, const std::string& label, const JobContext& job);

}  // namespace noctule
