// SPDX-License-Identifier: Apache-2.0
#include "core/review/joint_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "core/body/actor.h"
#include "core/math/rotation.h"
#include "core/motion/joint_angles.h"

namespace noctule {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// 2 s at 100 Hz of the default actor, posed by `pose(t, Pose&)`.
template <class Pose_>
TimedMotion made(Pose_ pose, std::vector<double> sigma_rad = {}) {
    TimedMotion motion{defaultActor().skeleton, {}};
    for (int i = 0; i < 200; ++i) {
        Pose at = motion.skeleton.zeroPose();
        pose(i / 100.0, motion.skeleton, at);
        motion.frames.push_back({i * 10'000'000LL, at, sigma_rad});
    }
    return motion;
}

void set(const Skeleton& skeleton, Pose& pose, const char* joint, const Quaterniond& q) {
    pose.q_parent_joint[static_cast<size_t>(skeleton.find(joint))] = q;
}

TEST(CurveChoices, NameEveryFreedomOnce) {
    const Skeleton skeleton = defaultActor().skeleton;
    const std::vector<CurveChoice> choices = curveChoices(skeleton);
    std::vector<CurveChoice> sorted = choices;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(std::adjacent_find(sorted.begin(), sorted.end()), sorted.end());
    const auto has = [&](const CurveChoice& c) {
        return std::find(choices.begin(), choices.end(), c) != choices.end();
    };
    EXPECT_TRUE(has({"Hips", "up"}) && has({"Hips", "yaw"}));
    EXPECT_TRUE(has({"LeftLeg", "flexion"}) && has({"RightForeArm", "pronation"}) && has({"Head", "z"}));
    EXPECT_FALSE(has({"Neck", "x"}));  // fixed
    const TimedMotion motion = made([](double, const Skeleton&, Pose&) {});
    for (const CurveChoice& choice : choices)
        EXPECT_EQ(motionCurve(motion, choice).value.size(), 200u) << choice.joint << " " << choice.freedom;
    EXPECT_EQ(mainCurve(skeleton, "LeftLeg"), (CurveChoice{"LeftLeg", "flexion"}));
    EXPECT_EQ(mainCurve(skeleton, "Hips").freedom, "up");
    EXPECT_EQ(mainCurve(skeleton, "Tail"), CurveChoice{});
}

TEST(MotionCurve, HingesShowTheirNamedAngleWithSigma) {
    std::vector<double> sigma(3 * defaultActor().skeleton.joints().size(), 0.0);
    sigma[3 * static_cast<size_t>(defaultActor().skeleton.find("LeftLeg"))] = 0.02;  // about its axis, X
    const TimedMotion motion =
        made([](double t_s, const Skeleton& skeleton,
                Pose& pose) { set(skeleton, pose, "LeftLeg", axisAngle(Vector3d::UnitX(), 0.5 * t_s)); },
             sigma);
    const MotionCurve curve = motionCurve(motion, {"LeftLeg", "flexion"});
    EXPECT_EQ(curve.unit, CurveUnit::kDegrees);
    EXPECT_NEAR(curve.value.series().value[100], 0.5 / kDegree, 1e-3);
    ASSERT_EQ(curve.high.size(), 200u);
    EXPECT_NEAR(curve.high.series().value[100] - curve.value.series().value[100], 2 * 0.02 / kDegree, 1e-3);
    EXPECT_NEAR(curve.value.series().value[100] - curve.low.series().value[100], 2 * 0.02 / kDegree, 1e-3);
}

TEST(MotionCurve, AReferenceWhoseKneeIsABallHasItsFlexion) {
    const TimedMotion motion = made([](double t_s, const Skeleton& skeleton, Pose& pose) {
        set(skeleton, pose, "LeftLeg", axisAngle(Vector3d::UnitX(), 0.5 * t_s));
    });
    std::vector<Joint> joints = motion.skeleton.joints();
    for (Joint& joint : joints)
        if (joint.name == "LeftLeg")
            joint.type = JointType::kBall,
            joint.dof = motion.skeleton.joint(motion.skeleton.find("LeftUpLeg")).dof;
    const TimedMotion reference{Skeleton::make(joints).value(), motion.frames};
    EXPECT_TRUE(motionCurve(reference, {"LeftLeg", "flexion"}).value.empty());
    const MotionCurve curve = motionCurve(reference, {"LeftLeg", "flexion"}, &motion.skeleton);
    ASSERT_EQ(curve.value.size(), 200u);
    EXPECT_NEAR(curve.value.series().value[100], 0.5 / kDegree, 1e-3);
}

TEST(MotionCurve, UniversalJointsKeepTheirAnglesApart) {
    std::vector<double> sigma(3 * defaultActor().skeleton.joints().size(), 0.0);
    const auto arm = static_cast<size_t>(defaultActor().skeleton.find("LeftForeArm"));
    const double flexion = 0.8, pronation = 0.6, sigma_flexion = 0.03, sigma_pronation = 0.05;
    // A change of the flexion turns about -Y before the pronation about X: seen from the joint, about
    // exp(-X pronation) (-Y).
    sigma[3 * arm] = sigma_pronation;
    sigma[3 * arm + 1] = sigma_flexion * std::cos(pronation);
    sigma[3 * arm + 2] = sigma_flexion * std::sin(pronation);
    const TimedMotion motion = made(
        [&](double, const Skeleton& skeleton, Pose& pose) {
            set(skeleton, pose, "LeftForeArm",
                axisAngle(-Vector3d::UnitY(), flexion) * axisAngle(Vector3d::UnitX(), pronation));
        },
        sigma);
    const MotionCurve bent = motionCurve(motion, {"LeftForeArm", "flexion"});
    const MotionCurve turned = motionCurve(motion, {"LeftForeArm", "pronation"});
    EXPECT_NEAR(bent.value.series().value[5], flexion / kDegree, 1e-3);
    EXPECT_NEAR(turned.value.series().value[5], pronation / kDegree, 1e-3);
    EXPECT_NEAR(bent.high.series().value[5] - bent.value.series().value[5], 2 * sigma_flexion / kDegree,
                1e-3);
    EXPECT_NEAR(turned.high.series().value[5] - turned.value.series().value[5], 2 * sigma_pronation / kDegree,
                1e-3);
}

TEST(MotionCurve, AnglesDoNotJump) {
    const TimedMotion motion = made([](double t_s, const Skeleton& skeleton, Pose& pose) {
        pose.q_parent_joint[0] = axisAngle(Vector3d::UnitY(), 4 * t_s);
        set(skeleton, pose, "Head", axisAngle(Vector3d::UnitZ(), 4 * t_s));
    });
    for (const CurveChoice& choice : {CurveChoice{"Hips", "yaw"}, CurveChoice{"Head", "z"}}) {
        const MotionCurve curve = motionCurve(motion, choice);
        const std::vector<float>& value = curve.value.series().value;
        EXPECT_NEAR(value.back(), 4 * 1.99 / kDegree, 0.01) << choice.joint;
        for (size_t i = 1; i < value.size(); ++i)
            ASSERT_LT(std::abs(value[i] - value[i - 1]), 4);
        EXPECT_TRUE(curve.low.empty());  // this motion has no sigma
    }
}

TEST(MotionCurve, AHingeStaysWithinHalfATurnAndBreaksThere) {
    const TimedMotion motion = made([](double t_s, const Skeleton& skeleton, Pose& pose) {
        set(skeleton, pose, "LeftLeg", axisAngle(Vector3d::UnitX(), 4 * t_s));
        set(skeleton, pose, "LeftForeArm", axisAngle(-Vector3d::UnitY(), -8 * t_s));
    });
    for (const auto& [joint, rad_per_s, breaks] :
         {std::tuple{"LeftLeg", 4, 1}, std::tuple{"LeftForeArm", -8, 3}}) {
        const MotionCurve flexion = motionCurve(motion, {joint, "flexion"});
        const Series& curve = flexion.value.series();
        int broken = 0;
        for (size_t i = 0; i < curve.value.size(); ++i) {
            if (std::isnan(curve.value[i])) {
                ++broken;
                continue;
            }
            EXPECT_LE(std::abs(curve.value[i]), 180) << joint;
            const double turned_deg = rad_per_s * curve.t_s[i] / kDegree;
            EXPECT_NEAR(std::remainder(curve.value[i] - turned_deg, 360), 0, 0.01)
                << joint << " at " << curve.t_s[i];
            if (i > 0 && !std::isnan(curve.value[i - 1]))
                EXPECT_LT(std::abs(curve.value[i] - curve.value[i - 1]), 10)
                    << joint << " at " << curve.t_s[i];
        }
        EXPECT_EQ(broken, breaks) << joint;
        EXPECT_EQ(curve.value.size(), 200u + static_cast<size_t>(breaks)) << joint;
    }
}

TEST(MotionCurve, TheRootIsInMetresAndHolesBreakTheCurve) {
    TimedMotion motion =
        made([](double t_s, const Skeleton&, Pose& pose) { pose.p_world_root.y() = 1 + t_s; });
    motion.frames[50].pose.reset();
    const MotionCurve curve = motionCurve(motion, {"Hips", "up"});
    EXPECT_EQ(curve.unit, CurveUnit::kMetres);
    EXPECT_FLOAT_EQ(curve.value.series().value[49], 1.49F);
    EXPECT_TRUE(std::isnan(curve.value.series().value[50]));
    EXPECT_TRUE(motionCurve(motion, {"Hips", "flexion"}).value.empty());
    EXPECT_TRUE(motionCurve(motion, {"Tail", "up"}).value.empty());
}

}  // namespace
}  // namespace noctule
