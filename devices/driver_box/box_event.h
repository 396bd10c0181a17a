// SPDX-License-Identifier: Apache-2.0
// What the box's side of the link asks of the box around it, in the order in which it happened.
#pragma once

#include <string>
#include <variant>

#include "devices/driver_box/hello.h"
#include "devices/driver_box/messages.h"

namespace noctule::link {

/// Sample and emit from now on; the first sample is number 0.
struct StartWanted {};
/// No more sound is taken.
struct StopWanted {};
struct IdentifyWanted {
    Identify identify;
};
struct SettingsWanted {
    Settings settings;
};
/// Close the stream of this client; disconnected() need not be called.
struct ClientDropped {
    std::string why;
};

using BoxEvent = std::variant<StartWanted, StopWanted, IdentifyWanted, SettingsWanted, ClientDropped>;

}  // namespace noctule::link
