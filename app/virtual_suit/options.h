// SPDX-License-Identifier: Apache-2.0
// The command line of noctule-virtual-suit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/batch/arguments.h"
#include "app/virtual_suit/address.h"

namespace noctule::virtual_suit {

struct Options {
    batch::Arguments arguments;  ///< whom to dress: those of `simulate`
    std::string take{};          ///< empty: a simulation
    std::optional<Address> tcp{}, control{};
    bool pty = false, loop = false;
    std::optional<quint16> announce_port{};
    double speed = 1;
    uint64_t seed = 1;
};

/// kUsage names the mistake.
Result<Options> parseOptions(const std::vector<std::string>& words);

std::string helpText();

}  // namespace noctule::virtual_suit
