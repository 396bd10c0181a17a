// SPDX-License-Identifier: Apache-2.0
// noctule-virtual-suit from its command line to its end.
#pragma once

#include <string>
#include <vector>

#include "core/job/job.h"

namespace noctule::virtual_suit {

/// Wants a QCoreApplication. `cancel` ends it within a moment. Returns the exit code.
int runVirtualSuit(const std::vector<std::string>& words, const CancelFlag& cancel);

}  // namespace noctule::virtual_suit
