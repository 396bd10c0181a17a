// SPDX-License-Identifier: Apache-2.0
// The data among the events of a device that streams, on the device's sample clock; sound is shared from here
// on and never copied.
#pragma once

#include "devices/device/device.h"
#include "devices/live/live_item.h"

namespace noctule {

using StreamEvent = std::variant<ArrivedBlock, link::Pulses, link::Gap, link::BoxStatus, link::BoxError>;

/// Nothing for an event that is no data, or a block of another suit.
std::optional<StreamEvent> streamEventOf(DeviceEvent&& event, int board_count);

}  // namespace noctule
