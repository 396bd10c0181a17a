// SPDX-License-Identifier: Apache-2.0
#include "core/session/body_measures.h"

#include <cmath>

namespace noctule {
namespace {

// Adults of one height differ by about 5 % (standard deviation) in a limb (Drillis, Contini 1966).
constexpr double kPlausible = 0.2;
constexpr double kPlausibleHeight = 0.06;

constexpr Measure kMeasures[] = {
    {"upper_arm_m", &BodyMeasures::upper_arm_m}, {"forearm_m", &BodyMeasures::forearm_m},
    {"hand_m", &BodyMeasures::hand_m},           {"shoulder_width_m", &BodyMeasures::shoulder_width_m},
    {"trunk_m", &BodyMeasures::trunk_m},         {"hip_width_m", &BodyMeasures::hip_width_m},
    {"thigh_m", &BodyMeasures::thigh_m},         {"shin_m", &BodyMeasures::shin_m},
    {"foot_m", &BodyMeasures::foot_m},
};

Vector3d offset(const Skeleton& skeleton, const char* joint) {
    return skeleton.joint(skeleton.find(joint)).offset_m;
}

}  // namespace

std::optional<BodyMeasures> measuresOf(const Actor& actor) {
    const Skeleton& s = actor.skeleton;
    for (const char* joint :
         {"Spine", "Chest", "Neck", "LeftShoulder", "RightShoulder", "LeftArm", "RightArm", "LeftForeArm",
          "RightForeArm", "LeftHand", "RightHand", "LeftUpLeg", "RightUpLeg", "LeftLeg", "RightLeg",
          "LeftFoot", "RightFoot", "LeftToeBase", "RightToeBase"})
        if (s.find(joint) < 0)
            return std::nullopt;
    const auto length = [&](const std::string& joint) {
        return (offset(s, ("Left" + joint).c_str()).norm() + offset(s, ("Right" + joint).c_str()).norm()) / 2;
    };
    BodyMeasures m;
    m.height_m = actor.height_m;
    m.upper_arm_m = length("ForeArm");
    m.forearm_m = length("Hand");
    m.hand_m = s.joint(s.find("LeftHand")).end_m.value_or(Vector3d::Zero()).norm();
    m.shoulder_width_m = (offset(s, "LeftShoulder") + offset(s, "LeftArm")).x() -
                         (offset(s, "RightShoulder") + offset(s, "RightArm")).x();
    m.trunk_m = (offset(s, "Spine") + offset(s, "Chest") + offset(s, "Neck")).y();
    m.hip_width_m = offset(s, "LeftUpLeg").x() - offset(s, "RightUpLeg").x();
    m.thigh_m = length("Leg");
    m.shin_m = length("Foot");
    m.foot_m = (offset(s, "LeftToeBase").z() + offset(s, "RightToeBase").z()) / 2;
    return m;
}

std::span<const Measure> bodyMeasures() {
    return kMeasures;
}

double proportionalLength_m(const BodyMeasures& measures, double BodyMeasures::*length) {
    BodyMeasures height_only;
    height_only.height_m = measures.height_m;
    return measuresOf(defaultActor(height_only)).value().*length;
}

MeasureDoubt doubtAbout(const BodyMeasures& measures, double BodyMeasures::*length) {
    if (measures.*length <= 0)
        return MeasureDoubt::kNone;
    const double ratio = measures.*length / proportionalLength_m(measures, length);
    if (ratio < 1 - kPlausible)
        return MeasureDoubt::kShort;
    return ratio > 1 + kPlausible ? MeasureDoubt::kLong : MeasureDoubt::kNone;
}

HeightCheck checkHeight(const BodyMeasures& measures) {
    HeightCheck check{measures.height_m, true};
    for (const auto length : {&BodyMeasures::trunk_m, &BodyMeasures::thigh_m, &BodyMeasures::shin_m})
        if (measures.*length > 0)
            check.sum_m += measures.*length - proportionalLength_m(measures, length);
    check.fits = std::abs(check.sum_m / measures.height_m - 1) <= kPlausibleHeight;
    return check;
}

}  // namespace noctule
