// SPDX-License-Identifier: Apache-2.0
// Suits that sound in one room: whether their boxes, carriers and pulses can be told from each other.
#pragma once

#include <string>
#include <vector>

#include "core/job/result.h"
#include "devices/driver_box/hello.h"

namespace noctule {

/// Carriers nearer than this cannot be told apart (take format 1.1).
inline constexpr double kLeastCarrierSpacing_hz = 5000;

struct SuitVoice {
    std::string who;  ///< "suit 2 (tcp://10.0.0.8:41941)"
    link::Hello hello;
};

/// Fails (kDevice) and names both for one box that is there twice, and for carriers that are too near.
Status checkVoices(const std::vector<SuitVoice>& voices);

/// Whole sentences on pairs whose pulses may collide during a whole take.
std::vector<std::string> voiceWarnings(const std::vector<SuitVoice>& voices);

/// The suit with what its box says of carrier, pulses and rate: meta holds those of suit 1 only.
Suit withVoice(Suit suit, const link::Hello& hello);

}  // namespace noctule
