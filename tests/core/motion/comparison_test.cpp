// SPDX-License-Identifier: Apache-2.0
#include "core/motion/comparison.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/motion/made_motion.h"

namespace noctule {
namespace {

using namespace test;

Comparison compared(const TimedMotion& a, const TimedMotion& b, const ComparisonOptions& options = {}) {
    auto result = compareMotions(a, b, options);
    EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().text());
    return result.ok() ? result.value() : Comparison{};
}

const JointCurve& curveOf(const Comparison& comparison, const std::string& joint) {
    return *std::ranges::find(comparison.curves, joint, &JointCurve::name);
}

/// Of a course that is short enough to hold every frame.
double valueAt(const Course& course, size_t frame) {
    return course.stretches().at(frame).first;
}

TEST(Comparison, EqualMotionsDifferByNothing) {
    const TimedMotion motion = swinging(skeleton(), 4, 140);
    const Comparison c = compared(motion, motion);
    EXPECT_EQ(c.joints.size(), 17u);  // 21 joints less the root, the neck and two rigid toes
    EXPECT_NEAR(c.mean_deg, 0, 1e-6);
    EXPECT_NEAR(*c.end_effector_mm, 0, 1e-6);
    EXPECT_NEAR(c.root.position_m, 0, 1e-9);
    EXPECT_NEAR(c.duration_s, 4 - 1.0 / 140, 1e-6);
    EXPECT_EQ(c.frames, 560);
    EXPECT_FALSE(c.nees);
}

TEST(Comparison, ConstantAngleOnOneJointIsFoundThereAndOnlyThere) {
    const TimedMotion reference = swinging(skeleton(), 5, 120);
    TimedMotion estimate = reference;
    disturb(estimate, "LeftArm", [](double) { return axisAngle(Vector3d::UnitZ(), radians(5)); });
    const Comparison c = compared(estimate, reference);
    const AngleStatistics& arm = c.find("LeftArm")->angle;
    EXPECT_NEAR(arm.mean_deg, 5, 1e-6);
    EXPECT_NEAR(arm.std_deg, 0, 1e-5);
    EXPECT_NEAR(arm.rms_deg, 5, 1e-6);
    EXPECT_NEAR(arm.max_deg, 5, 1e-6);
    EXPECT_NEAR(arm.drift_deg_per_min, 0, 1e-6);
    EXPECT_NEAR(c.find("LeftForeArm")->angle.mean_deg, 0, 1e-6);
    EXPECT_NEAR(c.mean_deg, 5.0 / 17, 1e-6);
    // The wrist is at most upper arm and forearm away from the shoulder: 0.54 m turned by 5 degrees.
    EXPECT_GT(c.find("LeftHand")->position_mm, 20);
    EXPECT_LT(c.find("LeftHand")->position_mm, 1000 * 2 * 0.54 * std::sin(radians(2.5)) + 1e-6);
    EXPECT_NEAR(*c.end_effector_mm, c.find("LeftHand")->position_mm / 5, 1e-9);
}

TEST(Comparison, MeanAndDeviationOfAWave) {
    const TimedMotion reference = swinging(skeleton(), 10, 100);
    TimedMotion estimate = reference;
    disturb(estimate, "Head", [](double t) {
        return axisAngle(Vector3d::UnitX(), radians(3 + std::sin(2 * std::numbers::pi * t)));
    });
    const AngleStatistics head = compared(estimate, reference).find("Head")->angle;
    EXPECT_NEAR(head.mean_deg, 3, 1e-3);
    EXPECT_NEAR(head.std_deg, std::sqrt(0.5), 1e-3);
    EXPECT_NEAR(head.rms_deg, std::sqrt(9.5), 1e-3);
    EXPECT_NEAR(head.max_deg, 4, 1e-3);
}

TEST(Comparison, DriftIsTheSlopePerMinute) {
    const TimedMotion reference = swinging(skeleton(), 90, 50);
    TimedMotion estimate = reference;
    disturb(estimate, "Chest",
            [](double t) { return axisAngle(Vector3d::UnitY(), radians(1 + t * 4 / 60)); });
    EXPECT_NEAR(compared(estimate, reference).find("Chest")->angle.drift_deg_per_min, 4, 1e-6);
}

TEST(Comparison, SignsOfQuaternionsHaveNoEffect) {
    const TimedMotion reference = swinging(skeleton(), 3, 140);
    TimedMotion estimate = swinging(skeleton(), 3, 90);
    disturb(estimate, "RightLeg", [](double) { return axisAngle(Vector3d::UnitX(), 0.1); });
    const Comparison before = compared(estimate, reference);
    TimedMotion flipped = reference;
    for (size_t i = 0; i < flipped.frames.size(); i += 3)
        for (size_t j = i % 2; j < flipped.frames[i].pose->q_parent_joint.size(); j += 2)
            flipped.frames[i].pose->q_parent_joint[j].coeffs() *= -1;
    const Comparison after = compared(estimate, flipped);
    EXPECT_NEAR(after.mean_deg, before.mean_deg, 1e-9);
    EXPECT_NEAR(after.root.yaw_deg, before.root.yaw_deg, 1e-9);
    for (size_t k = 0; k < 3; ++k)
        for (size_t i = 0; i < static_cast<size_t>(after.frames); ++i)
            ASSERT_NEAR(valueAt(curveOf(after, "Head").reference_deg[k], i),
                        valueAt(curveOf(before, "Head").reference_deg[k], i), 1e-6);
}

TEST(Comparison, OnlyTheWindowCounts) {
    const TimedMotion reference = swinging(skeleton(), 6, 100);
    TimedMotion estimate = reference;
    disturb(estimate, "Head", [](double t) { return axisAngle(Vector3d::UnitX(), t < 3 ? 1.0 : 0.01); });
    ComparisonOptions options;
    options.from_ns = 3 * kSecond_ns;
    options.to_ns = 5 * kSecond_ns;
    const Comparison c = compared(estimate, reference, options);
    EXPECT_EQ(c.frames, 201);
    EXPECT_NEAR(c.find("Head")->angle.max_deg, degrees(0.01), 1e-6);
    EXPECT_NEAR(c.mean_curve_deg.stretches().front().time_s, 3, 1e-9);
}

TEST(Comparison, MissingFramesAreSkippedAndCountedAndNeverBridgedFar) {
    TimedMotion reference = swinging(skeleton(), 4, 100);
    TimedMotion estimate = reference;
    reference.frames[50].pose.reset();                           // one frame: bridged
    reference.frames[60].pose->p_world_root.x() = std::nan("");  // the same as missing
    for (size_t i = 200; i < 250; ++i)                           // half a second: a hole
        reference.frames[i].pose.reset();
    estimate.frames[300].pose.reset();
    const Comparison c = compared(estimate, reference);
    EXPECT_EQ(c.reference_missing, 52);
    EXPECT_EQ(c.unmatched, 50);
    EXPECT_EQ(c.estimate_missing, 1);
    EXPECT_EQ(c.frames, 400 - 50 - 1);
    EXPECT_LT(c.mean_deg, 0.01);  // only what slerp over 20 ms costs
}

TEST(Comparison, JointThatOnlyTheReferenceMovesIsComposedIntoTheNextCommonOne) {
    std::vector<Joint> joints = skeleton().joints();
    const int neck = skeleton().find("Neck");
    Joint& reference_neck = joints[static_cast<size_t>(neck)];
    reference_neck.type = JointType::kBall;
    reference_neck.dof = joints[static_cast<size_t>(skeleton().find("Head"))].dof;
    const Skeleton richer = Skeleton::make(joints).value();
    TimedMotion reference = swinging(richer, 3, 100);
    TimedMotion estimate = swinging(skeleton(), 3, 100);
    const auto at = [&](const char* name) { return static_cast<size_t>(skeleton().find(name)); };
    for (size_t i = 0; i < estimate.frames.size(); ++i) {  // our head carries neck and head
        const auto& q = reference.frames[i].pose->q_parent_joint;
        estimate.frames[i].pose->q_parent_joint[at("Head")] = q[at("Neck")] * q[at("Head")];
    }
    const Comparison c = compared(estimate, reference);
    EXPECT_EQ(c.find("Neck"), nullptr);
    EXPECT_TRUE(c.find("Head")->composed);
    EXPECT_EQ(c.find("Head")->relative_to, "Chest");
    EXPECT_FALSE(c.find("LeftArm")->composed);
    EXPECT_NEAR(c.mean_deg, 0, 1e-6);
    EXPECT_LT(c.find("Head")->position_mm, 60);  // the moving neck displaces the head's joint
}

TEST(Comparison, ForeignNamesMatchThroughAliases) {
    std::vector<Joint> joints = skeleton().joints();
    for (Joint& joint : joints) {
        joint.name = joint.aliases.at("mixamo");
        joint.aliases.clear();
    }
    TimedMotion reference = swinging(skeleton(), 2, 100);
    reference.skeleton = Skeleton::make(joints).value();
    const Comparison c = compared(swinging(skeleton(), 2, 100), reference);
    EXPECT_EQ(c.joints.size(), 17u);
    EXPECT_NEAR(c.mean_deg, 0, 1e-6);
}

TEST(Comparison, RootDriftForgivesTheStartAndNothingElse) {
    const TimedMotion reference = swinging(skeleton(), 10, 50);
    TimedMotion estimate = reference;
    const Quaterniond turn = axisAngle(Vector3d::UnitY(), 0.7);
    for (TimedPose& frame : estimate.frames) {
        frame.pose->q_parent_joint[0] = turn * frame.pose->q_parent_joint[0];
        frame.pose->p_world_root = turn * frame.pose->p_world_root + Vector3d(3, 0, -2);
    }
    const Comparison moved = compared(estimate, reference);
    EXPECT_NEAR(moved.root.yaw_deg, 0, 1e-6);
    EXPECT_NEAR(moved.root.position_m, 0, 1e-9);
    for (TimedPose& frame : estimate.frames) {
        const double t_s = static_cast<double>(frame.time_ns) * 1e-9;
        frame.pose->q_parent_joint[0] = axisAngle(Vector3d::UnitY(), radians(t_s)) *
                                        axisAngle(Vector3d::UnitX(), radians(2)) *
                                        frame.pose->q_parent_joint[0];
        frame.pose->p_world_root.x() += 0.1 * t_s;
    }
    const Comparison drifted = compared(estimate, reference);
    EXPECT_NEAR(drifted.root.tilt_deg, 2, 1e-6);
    EXPECT_NEAR(drifted.root.yaw_deg, 10 / std::sqrt(3), 0.05);  // rms of 0..10 degrees
    EXPECT_NEAR(drifted.root.position_m, 1 / std::sqrt(3), 0.01);
}

TEST(Comparison, NeesOfMatchedNoiseIsOneAndOfAnOverconfidentFilterFour) {
    TimedMotion reference = swinging(skeleton(), 20, 100);
    TimedMotion estimate = reference;
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    for (TimedPose& frame : estimate.frames) {
        frame.sigma_rad.assign(3 * frame.pose->q_parent_joint.size(), 0);
        for (size_t j = 1; j < frame.pose->q_parent_joint.size(); ++j) {
            const size_t freedoms = skeleton().joints()[j].dof.size();
            Vector3d error = Vector3d::Zero();
            for (size_t k = 0; k < freedoms; ++k) {
                frame.sigma_rad[3 * j + k] = 0.002 * static_cast<double>(k + 1);
                error[static_cast<int>(k)] = frame.sigma_rad[3 * j + k] * normal(random);
            }
            frame.pose->q_parent_joint[j] = frame.pose->q_parent_joint[j] * expQuaternion(error);
        }
    }
    const Comparison honest = compared(estimate, reference);
    EXPECT_NEAR(*honest.nees, 1, 0.02);
    EXPECT_NEAR(*honest.find("Head")->nees, 1, 0.06);
    for (TimedPose& frame : estimate.frames)
        for (double& sigma : frame.sigma_rad)
            sigma /= 2;
    EXPECT_NEAR(*compared(estimate, reference).nees, 4, 0.08);
}

TEST(Comparison, CurvesHoldAnglesSigmaAndDifference) {
    const TimedMotion reference = swinging(skeleton(), 2, 100);
    TimedMotion estimate = reference;
    disturb(estimate, "RightArm", [](double) { return axisAngle(Vector3d::UnitY(), radians(4)); });
    for (TimedPose& frame : estimate.frames)
        frame.sigma_rad.assign(3 * skeleton().joints().size(), radians(1));
    const Comparison c = compared(estimate, reference);
    ASSERT_EQ(c.curves.size(), c.joints.size());
    for (size_t i = 0; i < c.joints.size(); ++i)
        EXPECT_EQ(c.curves[i].name, c.joints[i].name);
    const JointCurve& arm = curveOf(c, "RightArm");
    for (size_t i = 0; i < static_cast<size_t>(c.frames); ++i) {
        ASSERT_NEAR(valueAt(arm.difference_deg, i), 4, 1e-6);
        // Y comes last in Z-X-Y, so a right turn about Y changes that angle alone.
        ASSERT_NEAR(valueAt(arm.estimate_deg[2], i) - valueAt(arm.reference_deg[2], i), 4, 1e-6);
        ASSERT_NEAR(valueAt(arm.estimate_deg[0], i) - valueAt(arm.reference_deg[0], i), 0, 1e-6);
        ASSERT_GE(valueAt(arm.sigma_deg[2], i), 0.99);
    }
    EXPECT_EQ(arm.sigma_deg[0].stretches().size(), 200u);

    ComparisonOptions without;
    without.curves = false;
    EXPECT_TRUE(compared(estimate, reference, without).curves.empty());
}

TEST(Comparison, CurvesOfLongMotionsAreBoundedAndKeepThePeakOfOneFrame) {
    TimedMotion reference{skeleton(), {}};
    const Pose pose = skeleton().zeroPose();
    for (int i = 0; i < 10'000; ++i)
        reference.frames.push_back({i * kSecond_ns / 120, pose, {}});
    TimedMotion estimate = reference;
    const auto arm = static_cast<size_t>(skeleton().find("RightArm"));
    estimate.frames[7'531].pose->q_parent_joint[arm] = axisAngle(Vector3d::UnitY(), radians(40));
    for (TimedPose& frame : estimate.frames)
        frame.sigma_rad.assign(3 * skeleton().joints().size(), radians(1));
    const Comparison c = compared(estimate, reference);
    EXPECT_EQ(c.frames, 10'000);
    const JointCurve& curve = curveOf(c, "RightArm");
    for (const Course* course : {&curve.estimate_deg[0], &curve.reference_deg[1], &curve.sigma_deg[2],
                                 &curve.difference_deg, &c.mean_curve_deg, &c.root.yaw_curve_deg})
        EXPECT_LE(course->stretches().size(), Course::kMost);
    double largest_deg = 0;
    for (const Course::Stretch& stretch : curve.difference_deg.stretches())
        largest_deg = std::max({largest_deg, stretch.first, stretch.second});
    EXPECT_NEAR(largest_deg, 40, 1e-6);
    EXPECT_NEAR(c.find("RightArm")->angle.mean_deg, 40.0 / 10'000, 1e-9) << "figures are of all frames";
}

TEST(Comparison, ReferenceOnAnotherClockIsAligned) {
    const TimedMotion estimate = swinging(skeleton(), 20, 140);
    const TimedMotion reference = swinging(skeleton(), 20, 120, 0.4137);  // the same movement 0.4137 s later
    ComparisonOptions options;
    options.align_time = true;
    const Comparison c = compared(estimate, reference, options);
    EXPECT_NEAR(static_cast<double>(c.offset.add_to_reference_ns) * 1e-9, -0.4137, 0.001);
    EXPECT_GT(c.offset.correlation, 0.99);
    EXPECT_LT(c.mean_deg, 0.1);
    EXPECT_GT(compared(estimate, reference).mean_deg, 5);
    options.reference_offset_ns = -413'700'000;
    EXPECT_LT(compared(estimate, reference, options).mean_deg, 0.01);
}

TEST(Comparison, LongMotionsOfFiguresWithOtherBonesAreCompared) {
    const TimedMotion estimate = swinging(skeleton(), 40, 100);  // more instants than are kept for matching
    std::vector<Joint> joints = skeleton().joints();
    for (Joint& joint : joints)
        if (joint.name == "LeftLeg")
            joint.offset_m = axisAngle(Vector3d::UnitX(), 0.05) * joint.offset_m;
    TimedMotion reference = estimate;
    reference.skeleton = Skeleton::make(std::move(joints)).value();
    const Comparison c = compared(estimate, reference);
    EXPECT_EQ(c.frames, 4000);
    EXPECT_LT(c.mean_deg, 1);
}

TEST(Comparison, SaysWhatCannotBeCompared) {
    const TimedMotion motion = swinging(skeleton(), 1, 100);
    TimedMotion later = motion;
    for (TimedPose& frame : later.frames)
        frame.time_ns += 10 * kSecond_ns;
    EXPECT_EQ(compareMotions(motion, later).error().kind, ErrorKind::kUnusable);
    TimedMotion wrong = motion;
    wrong.frames[3].pose->q_parent_joint.pop_back();
    EXPECT_NE(compareMotions(wrong, motion).error().message.find("the estimate: frame 3"), std::string::npos);
    ComparisonOptions aligned;
    aligned.align_time = true;
    EXPECT_NE(compareMotions(wrong, motion, aligned).error().message.find("the estimate: frame 3"),
              std::string::npos);
    TimedMotion disordered = motion;
    disordered.frames[5].time_ns = 0;
    EXPECT_FALSE(compareMotions(motion, disordered).ok());
    TimedMotion stranger{
        Skeleton::make({{"Root", -1, Vector3d::Zero(), JointType::kFree, {}, {}, {}}}).value(), {}};
    stranger.frames.push_back({0, stranger.skeleton.zeroPose(), {}});
    EXPECT_NE(compareMotions(motion, stranger).error().message.find("share no joint"), std::string::npos);
    EXPECT_FALSE(compareMotions(TimedMotion{skeleton(), {}}, motion).ok());
}

}  // namespace
}  // namespace noctule
