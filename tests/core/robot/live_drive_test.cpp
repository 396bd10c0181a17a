// SPDX-License-Identifier: Apache-2.0
// A performer, a robot and the network between them in simulated time, with everything that can break.
#include "core/robot/live_drive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "core/math/rotation.h"
#include "core/robot/urdf_reader.h"
#include "tests/support/plain_arm.h"

namespace noctule::robot {
namespace {

constexpr double kDriveSpeed = test::kPlainArmSpeed;
constexpr int64_t kDriveStep_ns = 1'000'000'000 / 140;

/// The upper arm hangs, the forearm points ahead and swings up by `angle_rad`.
PerformerFrame swinging(double angle_rad) {
    PerformerFrame frame;
    ArmPose& arm = frame.in_chest[1];
    arm.upper = -Vector3d::UnitY();
    arm.forearm = Vector3d(0, std::sin(angle_rad), std::cos(angle_rad));
    arm.wrist_m = 0.3 * arm.upper + 0.3 * arm.forearm;
    arm.R_forearm = axisAngle(Vector3d::UnitX(), -angle_rad).toRotationMatrix() *
                    PerformerArms::referenceForearm(Side::kRight);
    arm.R_hand = arm.R_forearm;
    return frame;
}

constexpr TeleopKeys kDriven{true, true, true, false, false};
constexpr TeleopKeys kNotDriven{};

class Scene {
public:
    explicit Scene(DriveSettings settings = {}) {
        auto read = parseUrdf(test::plainArmUrdf(), "arm");
        EXPECT_TRUE(read);
        model = std::move(*read);
        const RobotProfile profile = test::plainArmProfile();
        auto arms = drivenArms(model, profile, {});
        EXPECT_TRUE(arms) << (arms ? "" : arms.error().text());
        q_robot.assign(7, 0);
        q_robot[3] = -1.4;
        drive = std::make_unique<LiveDrive>(model, profile, *arms, std::array{0.6, 0.6}, settings, q_robot);
        last_q = q_robot;
    }

    /// One command; checks the step itself.
    DriveOutput step(const TeleopKeys& keys = kDriven) {
        now_ns += kDriveStep_ns;
        const double t = static_cast<double>(now_ns) * 1e-9;
        if (suit_sends) {
            performer.arrived_ns = now_ns;
            performer.frame = swinging(0.5 * std::sin(2 * t));
            performer.confidence = confidence;
        }
        const bool accepts = !refuses && !is_silent;
        for (size_t i = 0; i < last_q.size() && accepts; ++i)
            if (static_cast<int>(i) != stuck)
                q_robot[i] = last_q[i];
        if (!is_silent)
            robot = {now_ns, q_robot, refuses};
        const DriveOutput output = drive->step({now_ns, performer, robot, keys});
        fastest = 0;
        for (size_t i = 0; i < last_q.size(); ++i) {
            const double speed = std::abs(output.q[i] - last_q[i]) / (1.0 / 140);
            EXPECT_LE(speed, kDriveSpeed * (1 + 1e-9)) << "joint " << i;
            EXPECT_NEAR(output.v[i], (output.q[i] - last_q[i]) * 140, 1e-9);
            fastest = std::max(fastest, speed);
        }
        last_q = output.q;
        return last = output;
    }
    void run(double seconds, const TeleopKeys& keys = kDriven) {
        for (int i = 0; i < static_cast<int>(seconds * 140); ++i)
            step(keys);
    }
    void followNow() {
        run(3);
        ASSERT_EQ(last.state, TeleopState::kFollowing);
        ASSERT_EQ(last.trouble, DriveTrouble::kNone);
    }
    /// Within a tenth of a second and one step nothing moves any more.
    void expectHolds() {
        run(0.1);
        step();
        for (int i = 0; i < 70; ++i) {
            step();
            EXPECT_EQ(fastest, 0) << i << " steps after it had to hold";
        }
    }

    RobotModel model;
    std::unique_ptr<LiveDrive> drive;
    int64_t now_ns = 1'000'000'000;
    PerformerSeen performer;
    std::optional<RobotSeen> robot;
    std::vector<double> q_robot, last_q;
    bool suit_sends = true, is_silent = false, refuses = false;
    double confidence = 1, fastest = 0;
    int stuck = -1;
    DriveOutput last;
};

TEST(LiveDrive, FollowsThePerformer) {
    Scene scene;
    scene.followNow();
    double off = 0;
    for (int i = 0; i < 600; ++i) {
        scene.step();
        const double t = static_cast<double>(scene.now_ns) * 1e-9;
        off = std::max(off, std::abs(scene.last.q[3] - (-radians(90) - 0.5 * std::sin(2 * t))));
    }
    EXPECT_LT(off, 0.03) << "elbow angle, rad";
}

TEST(LiveDrive, NothingMovesUntilTheKeysAreHeld) {
    Scene scene;
    scene.run(1, kNotDriven);
    EXPECT_EQ(scene.last.q, scene.q_robot);
    EXPECT_EQ(scene.last.state, TeleopState::kIdle);
    scene.run(1, {true, true, false, false, false});
    EXPECT_EQ(scene.last.state, TeleopState::kSynchronising);
    EXPECT_EQ(scene.fastest, 0);
}

TEST(LiveDrive, HoldsWhenTheSuitStalls) {
    Scene scene;
    scene.followNow();
    scene.suit_sends = false;
    scene.expectHolds();
    EXPECT_EQ(scene.last.trouble, DriveTrouble::kNoPose);
    scene.suit_sends = true;
    scene.run(3);
    EXPECT_EQ(scene.last.state, TeleopState::kFollowing);
}

TEST(LiveDrive, HoldsWhenTheRobotIsSilent) {
    Scene scene;
    scene.followNow();
    scene.is_silent = true;
    scene.expectHolds();
    EXPECT_EQ(scene.last.trouble, DriveTrouble::kRobotSilent);
    EXPECT_NE(sentenceFor(scene.last), "");
    scene.is_silent = false;
    scene.run(3);
    EXPECT_EQ(scene.last.state, TeleopState::kFollowing);
}

TEST(LiveDrive, HoldsWhenTheDeadMansKeyIsLetGo) {
    Scene scene;
    scene.followNow();
    for (int i = 0; i < 70; ++i) {
        scene.step(kNotDriven);
        EXPECT_EQ(scene.fastest, 0);
    }
    EXPECT_EQ(scene.last.state, TeleopState::kHolding);
}

TEST(LiveDrive, GoesBackToARobotThatRefuses) {
    Scene scene;
    scene.followNow();
    scene.refuses = true;
    for (int i = 0; i < 140; ++i)
        scene.step();
    EXPECT_EQ(scene.last.trouble, DriveTrouble::kRobotRefuses);
    EXPECT_EQ(scene.last.state, TeleopState::kHolding);
    for (size_t i = 0; i < 7; ++i)
        EXPECT_NEAR(scene.last.q[i], scene.q_robot[i], 1e-6);
    scene.refuses = false;
    scene.run(3);
    EXPECT_EQ(scene.last.state, TeleopState::kFollowing);
}

TEST(LiveDrive, NamesTheJointThatDoesNotFollow) {
    Scene scene;
    scene.followNow();
    scene.stuck = 3;
    bool was_named = false;
    for (int i = 0; i < 700; ++i) {
        scene.step();
        was_named |= scene.last.trouble == DriveTrouble::kJointOff && scene.last.about == "e" &&
                     scene.last.state != TeleopState::kFollowing;
    }
    EXPECT_TRUE(was_named);
}

TEST(LiveDrive, AnUncertainPoseSlows) {
    Scene scene;
    scene.followNow();
    scene.confidence = confidenceFor(0.5);
    for (int i = 0; i < 300; ++i) {
        scene.step();
        EXPECT_LE(scene.fastest, 0.25 * kDriveSpeed + 1e-9);
        EXPECT_EQ(scene.last.trouble, DriveTrouble::kUncertain);
    }
    EXPECT_EQ(confidenceFor(0.05), 1);
    EXPECT_EQ(confidenceFor(1), 0);
}

TEST(LiveDrive, ReindexingMovesNothing) {
    DriveSettings settings;
    settings.follows_posture = false;
    Scene scene(settings);
    scene.followNow();
    scene.run(0.2, {true, false, false, false, false});
    scene.performer.frame = swinging(1.2);  // elsewhere; the suit keeps still from here
    scene.suit_sends = false;
    const std::vector<double> before = scene.last.q;
    for (int i = 0; i < 100; ++i) {
        scene.performer.arrived_ns = scene.now_ns;
        scene.step();
    }
    EXPECT_NE(scene.last.state, TeleopState::kHolding);
    for (size_t i = 0; i < 7; ++i)
        EXPECT_NEAR(scene.last.q[i], before[i], 1e-4);
}

TEST(LiveDrive, StopNeedsAReset) {
    Scene scene;
    scene.followNow();
    scene.step({true, true, true, true, false});
    scene.run(1);
    EXPECT_EQ(scene.last.state, TeleopState::kStopped);
    EXPECT_EQ(scene.fastest, 0);
    scene.step({true, true, true, false, true});
    scene.run(3);
    EXPECT_EQ(scene.last.state, TeleopState::kFollowing);
}

TEST(LiveDrive, APoseTooFarAwayIsNotAccepted) {
    DriveSettings settings;
    settings.teleop.farthest_rad = 0.01;
    Scene scene(settings);
    scene.run(0.5);
    EXPECT_EQ(scene.last.state, TeleopState::kSynchronising);
    EXPECT_EQ(scene.last.trouble, DriveTrouble::kTooFar);
    EXPECT_EQ(scene.last.about, "e");
}

}  // namespace
}  // namespace noctule::robot
