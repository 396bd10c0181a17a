// SPDX-License-Identifier: Apache-2.0
// The lengths of a person one by one: what they are in an actor, in proportion to the height, and whether
// what was typed can be right. Metres.
#pragma once

#include <optional>
#include <span>

#include "core/body/actor.h"

namespace noctule {

struct Measure {
    const char* key;  ///< as in session.json: "upper_arm_m"
    double BodyMeasures::*length;
};

/// The lengths that an actor has, of limbs the mean of both sides; none without the canonical joints.
std::optional<BodyMeasures> measuresOf(const Actor& actor);

/// All but the height.
std::span<const Measure> bodyMeasures();

/// What a length is when it is left to the height.
double proportionalLength_m(const BodyMeasures& measures, double BodyMeasures::*length);

inline constexpr double kShortest_m = 0.5, kTallest_m = 2.5;  ///< heights that the studio accepts

enum class MeasureDoubt {
    kNone,
    kShort,  ///< rarely that short for this height: more than 20 % off
    kLong,
};
MeasureDoubt doubtAbout(const BodyMeasures& measures, double BodyMeasures::*length);

/// The height that trunk, thigh and shin make with head and feet in proportion, and whether it is the one
/// that was given, within 6 %.
struct HeightCheck {
    double sum_m = 0;
    bool fits = true;
};
HeightCheck checkHeight(const BodyMeasures& measures);

}  // namespace noctule
