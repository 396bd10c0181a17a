// SPDX-License-Identifier: Apache-2.0
// Writes a simulated take of one suit or of several; every step stops at the first error.
#pragma once

#include "core/simulation/range_rows.h"

namespace noctule::simulation {

/// What is written, apart from the header. Everything must outlive the writing.
struct TakeContent {
    std::vector<StagedSuit> suits;  ///< at least one; ids count from 1
    std::optional<Room> chamber{};  ///< of a cast
    std::vector<std::pair<std::string, std::string>> meta{};
};

Result<SimulationSummary> makeTake(const TakeContent& content, const TakeRequest& request,
                                   const JobContext& job);

}  // namespace noctule::simulation
