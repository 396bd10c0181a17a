// SPDX-License-Identifier: Apache-2.0
// The command line of noctule-virtual-suit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/batch/arguments.h"
#include "app/batch/help.h"
#include "app/virtual_suit/address.h"

namespace noctule::virtual_suit {

struct Options {
    batch::Arguments arguments;  ///< those of `simulate` and a box's own
    std::optional<Address> tcp{}, control{};
    std::optional<quint16> announce_port{};

    std::string take() const { return arguments.text("take"); }  ///< empty: a simulation
    bool loop() const { return arguments.given("loop"); }
    bool pty() const { return arguments.given("pty"); }
    double speed() const { return *arguments.number("speed"); }
    uint64_t seed() const { return static_cast<uint64_t>(*arguments.whole("seed")); }
};

/// kUsage names the mistake.
Result<Options> parseOptions(const std::vector<std::string>& words);

inline constexpr const char* kExample = "noctule-virtual-suit --rig rest --tcp 127.0.0.1:41941";

std::string helpText();
// What the help is made of; manual page and completion are made of it too.
const std::vector<batch::Option>& optionTable();
std::string controlHelp();

}  // namespace noctule::virtual_suit
