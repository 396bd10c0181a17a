// SPDX-License-Identifier: Apache-2.0
// How feet lie flat is found in the stands of a motion, and guessed from the shins without any.
#include "core/mesh/retarget/feet_at_rest.h"

#include <gtest/gtest.h>

#include "core/body/actor.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

Skeleton withLegsApart(double angle_rad) {
    std::vector<Joint> joints = defaultActor().skeleton.joints();
    for (Joint& joint : joints)
        for (const auto& [side, sign] : {std::pair{"Left", 1.0}, {"Right", -1.0}})
            if (joint.name == std::string(side) + "Leg" || joint.name == std::string(side) + "Foot")
                joint.offset_m = axisAngle(Vector3d::UnitZ(), sign * angle_rad) * joint.offset_m;
    return Skeleton::make(joints).value();
}

double offBy_deg(const Vector3d& a, const Vector3d& b) {
    return degrees(std::atan2(a.cross(b).norm(), a.dot(b)));
}

TEST(FeetAtRest, UprightLegsHaveFlatFeet) {
    const FeetAtRest feet = feetAtRest(defaultActor().skeleton);
    for (const Vector3d& up : feet.up)
        EXPECT_LT(offBy_deg(up, Vector3d::UnitY()), 1e-6);
}

TEST(FeetAtRest, WithoutAMotionFeetAreTiltedAsTheShins) {
    const FeetAtRest feet = feetAtRest(withLegsApart(radians(20)));
    EXPECT_LT(offBy_deg(feet.up[0], axisAngle(Vector3d::UnitZ(), radians(20)) * Vector3d::UnitY()), 1e-6);
    EXPECT_LT(offBy_deg(feet.up[1], axisAngle(Vector3d::UnitZ(), radians(-20)) * Vector3d::UnitY()), 1e-6);
}

/// One step a second: a foot comes down on its heel, lies still for 0.3 s as `flat` says, and rolls off.
class TiltedSteps {
public:
    explicit TiltedSteps(const Quaterniond& flat) : flat_(flat) {}

    Pose at(double t_s) const {
        const double phase = t_s - std::floor(t_s);
        const double pitch_rad = phase < 0.1 ? -3 * (0.1 - phase) : phase < 0.4 ? 0 : 2 * (phase - 0.4);
        Pose pose = bindPose();
        const int foot = skeleton.find("LeftFoot");
        pose.q_parent_joint[static_cast<size_t>(foot)] = axisAngle(Vector3d::UnitX(), pitch_rad) * flat_;
        pose.p_world_root.y() += 0.3 * std::abs(pitch_rad);
        return pose;
    }

    FootPlants plants() const {
        FootPlants plants;
        for (int step = 0; step < 5; ++step)
            plants[0].push_back({step + 0.02, step + 0.6});
        return plants;
    }

    const Skeleton skeleton = defaultActor().skeleton;

private:
    Pose bindPose() const { return defaultActor().restPose(); }

    Quaterniond flat_;
};

TEST(FeetAtRest, StandsTellHowAFootLiesFlat) {
    const Quaterniond flat = axisAngle(Vector3d(0.6, 0, 0.8), radians(25));
    const TiltedSteps steps(flat);
    const FeetAtRest feet =
        feetAtRest(steps.skeleton, steps.plants(), [&](double t_s) { return steps.at(t_s); });
    const GlobalPose standing = globalPose(steps.skeleton, steps.at(0.2));
    const auto foot = static_cast<size_t>(steps.skeleton.find("LeftFoot"));
    EXPECT_LT(offBy_deg(standing.q_world_joint[foot] * feet.up[0], Vector3d::UnitY()), 1);
    EXPECT_EQ(feet.up[1], feetAtRest(steps.skeleton).up[1]) << "never seen to stand";
}

TEST(FeetAtRest, WhatCannotBeAFootLyingFlatIsNotBelieved) {
    const TiltedSteps steps(axisAngle(Vector3d::UnitX(), radians(70)));
    const auto pose = [&](double t_s) { return steps.at(t_s); };
    EXPECT_EQ(feetAtRest(steps.skeleton, steps.plants(), pose), feetAtRest(steps.skeleton)) << "on tiptoe";
    const auto nothing = [](double) { return std::optional<Pose>(); };
    EXPECT_EQ(feetAtRest(steps.skeleton, steps.plants(), nothing), feetAtRest(steps.skeleton));
}

}  // namespace
}  // namespace noctule
