// SPDX-License-Identifier: Apache-2.0
// Compiled apart from the rest of its folder: its definitions change with every commit.
#include <string_view>

#include "app/batch/program.h"

namespace noctule::batch {

std::string programVersion() {
    constexpr std::string_view kSources = NOCTULE_SOURCES;
    return std::string(NOCTULE_VERSION) + (kSources.empty() ? "" : "-") + std::string(kSources);
}

std::string softwareName() {
    return "noctule " + programVersion();
}

}  // namespace noctule::batch
