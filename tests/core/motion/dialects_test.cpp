// SPDX-License-Identifier: Apache-2.0
// References in the dialects of other programs, against the same motion in ours.
#include "tests/core/motion/dialects.h"

#include <gtest/gtest.h>

namespace noctule::test {
namespace {

using Names = std::map<std::string, std::string>;

Comparison againstOurs(const TimedMotion& reference, const TimedMotion& estimate) {
    auto result = compareMotions(estimate, reference);
    EXPECT_TRUE(result) << result.error().text();
    return std::move(*result);
}

TEST(Dialects, RestPosesAndNamesAreNoErrors) {
    const TimedMotion ours = lively(0, 12, 60);
    EXPECT_LT(againstOurs(inDialect(ours, aPose(), false, {}), ours).mean_deg, 1e-3);
    EXPECT_LT(againstOurs(inDialect(ours, sittingPose(), false, {}), ours).mean_deg, 1e-3);
    EXPECT_LT(againstOurs(inDialect(ours, {}, false, xsensNames()), ours).mean_deg, 1e-3);
    EXPECT_LT(againstOurs(inDialect(ours, aPose(), false, xsensNames()), ours).mean_deg, 1e-3);
}

TEST(Dialects, AxesAlongTheBonesAreNoErrors) {
    const TimedMotion ours = lively(0, 12, 60);
    for (const Names& names : {Names{}, xsensNames()}) {
        const Comparison c = againstOurs(inDialect(ours, {}, true, names), ours);
        EXPECT_LT(c.mean_deg, 0.5);
        EXPECT_EQ(c.joints.size(), 17u);
        EXPECT_LT(c.root.tilt_deg, 0.5);
        EXPECT_LT(*c.end_effector_mm, 5);
        for (const MatchedJoint& joint : c.matched)
            EXPECT_EQ(joint.segment.from, FrameFrom::kMotion) << joint.name;
    }
}

TEST(Dialects, WhatWasMatchedIsNamed) {
    const TimedMotion ours = lively(0, 4, 60);
    const Comparison c = againstOurs(inDialect(ours, {}, false, xsensNames()), ours);
    const auto arm = std::ranges::find(c.matched, "LeftArm", &MatchedJoint::name);
    ASSERT_NE(arm, c.matched.end());
    EXPECT_EQ(arm->reference_name, "LeftShoulder");
    EXPECT_EQ(arm->segment.from, FrameFrom::kSame);
}

TEST(Dialects, AnErrorStaysAnErrorInEveryDialect) {
    const TimedMotion truth = lively(0, 12, 60);
    TimedMotion estimate = truth;
    const auto wave = [](double t_s) {
        return axisAngle(Vector3d(1, 2, 3).normalized(), 0.3 * std::sin(2 * t_s));
    };
    disturb(estimate, "LeftForeArm", wave);
    const double expected_deg = againstOurs(truth, estimate).find("LeftForeArm")->angle.mean_deg;
    EXPECT_GT(expected_deg, 8);
    EXPECT_NEAR(
        againstOurs(inDialect(truth, aPose(), false, {}), estimate).find("LeftForeArm")->angle.mean_deg,
        expected_deg, 0.01);
    EXPECT_NEAR(
        againstOurs(inDialect(truth, {}, true, xsensNames()), estimate).find("LeftForeArm")->angle.mean_deg,
        expected_deg, 1);
}

/// A constant error of 10 degrees is one of the run where the zero pose shows the bones, and where the axes
/// say nothing its part across the bone still is.
TEST(Dialects, ConstantErrorsAreOnlyTakenOffWhereNothingShowsThem) {
    const TimedMotion truth = lively(0, 12, 60);
    TimedMotion estimate = truth;
    disturb(estimate, "LeftArm", [](double) { return axisAngle(Vector3d::UnitZ(), 0.1745); });
    EXPECT_NEAR(againstOurs(inDialect(truth, aPose(), false, {}), estimate).find("LeftArm")->angle.mean_deg,
                10, 0.1);
    EXPECT_GT(againstOurs(inDialect(truth, {}, true, {}), estimate).find("LeftArm")->angle.mean_deg, 8);
}

TEST(Dialects, SameAxesAreLeftAlone) {
    const TimedMotion truth = lively(0, 6, 60);
    TimedMotion estimate = truth;
    disturb(estimate, "RightUpLeg", [](double) { return axisAngle(Vector3d::UnitY(), 0.7); });
    const Comparison c = againstOurs(truth, estimate);
    EXPECT_NEAR(c.find("RightUpLeg")->angle.mean_deg, degrees(0.7), 1e-6);
    EXPECT_EQ(c.matched[0].segment.from, FrameFrom::kSame);
}

}  // namespace
}  // namespace noctule::test
