// SPDX-License-Identifier: Apache-2.0
#include "devices/live/stream_event.h"

namespace noctule {

std::optional<StreamEvent> streamEventOf(DeviceEvent&& event, int board_count) {
    if (auto* block = std::get_if<link::SoundBlock>(&event.event)) {
        if (block->values.empty() || block->board_count != board_count)
            return std::nullopt;
        return ArrivedBlock{std::make_shared<const link::SoundBlock>(std::move(*block)), event.arrived_ns};
    }
    if (auto* pulses = std::get_if<link::Pulses>(&event.event))
        return std::move(*pulses);
    if (const auto* gap = std::get_if<link::Gap>(&event.event))
        return *gap;
    if (auto* status = std::get_if<link::BoxStatus>(&event.event))
        return std::move(*status);
    if (auto* error = std::get_if<link::BoxError>(&event.event))
        return std::move(*error);
    return std::nullopt;
}

}  // namespace noctule
