// SPDX-License-Identifier: Apache-2.0
// The words of BVH files that reader and writer share.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/formats/bvh.h"

namespace noctule {

/// Offsets and channels closer than this are the same place: what decimals in a file round away.
inline constexpr double kSamePlace_m = 1e-7;

/// "Zrotation" in any case.
std::optional<BvhChannel> channelFromText(std::string_view text);
std::string toText(BvhChannel channel);

inline bool isRotation(BvhChannel channel) {
    return channel >= BvhChannel::kXrotation;
}
/// 0 = x, 1 = y, 2 = z
inline int axisOf(BvhChannel channel) {
    return static_cast<int>(channel) % 3;
}
inline BvhChannel positionChannel(int axis) {
    return static_cast<BvhChannel>(axis);
}
inline BvhChannel rotationChannel(int axis) {
    return static_cast<BvhChannel>(3 + axis);
}

/// What to do about a word that should be a number.
std::string numberRemedy(std::string_view word);

}  // namespace noctule
