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

/// The upper arm hangs, the forearm points ahead and swings up by `angle_rad`; the chest is turned.
PerformerFrame swinging(double angle_rad, double chest_rad) {
    PerformerFrame frame;
    frame.R_hips_chest = axisAngle(Vector3d::UnitY(), chest_rad).toRotationMatrix();
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
    explicit Scene(DriveSettings settings = {}, bool has_waist = false) {
        auto read = parseUrdf(test::plainArmUrdf(has_waist), "arm");
        EXPECT_TRUE(read);
        model = std::move(*read);
        const RobotProfile profile = test::plainArmProfile(has_waist);
        auto parts = drivenParts(model, profile, {Mapping::kPosture, true, true, has_waist});
        EXPECT_TRUE(parts) << (parts ? "" : parts.error().text());
        q_robot.assign(parts->joints().size(), 0);
        q_robot[3] = -1.4;
        drive = std::make_unique<LiveDrive>(model, profile, *parts, std::array{0.6, 0.6}, settings, q_robot);
        last_q = q_robot;
    }

    /// One command; checks the step itself.
    DriveOutput step(const TeleopKeys& keys = kDriven) {
        now_ns += kDriveStep_ns;
        const double t = static_cast<double>(now_ns) * 1e-9;
        if (suit_sends) {
            performer.arrived_ns = now_ns;
            performer.frame = swinging(0.5 * std::sin(2 * t), chestAt(t));
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

    double chestAt(double time_s) const { return chest_rad * std::sin(1.5 * time_s); }

    RobotModel model;
    std::unique_ptr<LiveDrive> drive;
    int64_t now_ns = 1'000'000'000;
    PerformerSeen performer;
    std::optional<RobotSeen> robot;
    std::vector<double> q_robot, last_q;
    bool suit_sends = true, is_silent = false, refuses = false;
    double confidence = 1, fastest = 0, chest_rad = 0;
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

TEST(LiveDrive, TheWaistFollowsTheChest) {
    Scene scene({}, true);
    scene.chest_rad = 0.6;
    scene.followNow();
    double waist_off = 0, elbow_off = 0;
    for (int i = 0; i < 600; ++i) {
        scene.step();
        const double t = static_cast<double>(scene.now_ns) * 1e-9;
        waist_off = std::max(waist_off, std::abs(scene.last.q[7] - scene.chestAt(t)));
        elbow_off = std::max(elbow_off, std::abs(scene.last.q[3] - (-radians(90) - 0.5 * std::sin(2 * t))));
    }
    EXPECT_LT(waist_off, 0.03) << "rad";
    EXPECT_LT(elbow_off, 0.03) << "the arm is led in the axes of the chest, rad";
    scene.chest_rad = 2;  // farther than the waist goes
    for (int i = 0; i < 600; ++i)
        EXPECT_LE(std::abs(scene.step().q[7]), 0.9 + 1e-9);
}

TEST(LiveDrive, TheWaistIsPartOfTheAcceptance) {
    Scene scene({}, true);
    scene.q_robot[7] = scene.last_q[7] = 0.6;
    scene.drive.reset();
    const RobotProfile profile = test::plainArmProfile(true);
    const auto parts = drivenParts(scene.model, profile, {Mapping::kPosture, true, true, true});
    scene.drive = std::make_unique<LiveDrive>(scene.model, profile, *parts, std::array{0.6, 0.6},
                                              DriveSettings(), scene.q_robot);
    scene.run(2);
    EXPECT_EQ(scene.last.state, TeleopState::kSynchronising);
    EXPECT_EQ(scene.last.trouble, DriveTrouble::kTooFar);
    EXPECT_EQ(scene.last.about, "waist");
    EXPECT_EQ(scene.last.q, scene.q_robot) << "nothing moves";
}

TEST(LiveDrive, TheWaistHoldsWithTheArms) {
    Scene scene({}, true);
    scene.chest_rad = 0.6;
    scene.followNow();
    scene.suit_sends = false;
    scene.expectHolds();
}

TEST(LiveDrive, AnUncertainTrunkSlowsTheWaistAlone) {
    Scene scene({}, true);
    scene.chest_rad = 0.6;
    scene.performer.trunk_confidence = 0.2;
    scene.run(8);
    ASSERT_EQ(scene.last.state, TeleopState::kFollowing);
    EXPECT_EQ(scene.last.trouble, DriveTrouble::kUncertain);
    double waist = 0, elbow = 0;
    for (int i = 0; i < 600; ++i) {
        const std::vector<double> before = scene.last.q;
        scene.step();
        waist = std::max(waist, std::abs(scene.last.q[7] - before[7]) * 140);
        elbow = std::max(elbow, std::abs(scene.last.q[3] - before[3]) * 140);
    }
    EXPECT_LE(waist, kDriveSpeed / 4 * (1 + 1e-9));
    EXPECT_GT(waist, 0.1);
    EXPECT_GT(elbow, kDriveSpeed / 4) << "the arms are sure";
}

TEST(LiveDrive, AnArmThatHangsBelowTheWaistsJointsSharesThem) {
    auto model = parseUrdf(test::plainArmUrdf(true), "arm");
    RobotProfile profile = test::plainArmProfile(true);
    profile.arms[0].base = "hips";
    profile.arms[0].reference_rad.insert(profile.arms[0].reference_rad.begin(), 0);
    profile.arms[0].max_speed.push_back(2);
    const auto parts = drivenParts(*model, profile, {Mapping::kPosture, true, true, true});
    ASSERT_FALSE(parts);
    EXPECT_NE(parts.error().text().find("\"waist\" belongs to two driven parts"), std::string::npos)
        << parts.error().text();
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
    scene.performer.frame = swinging(1.2, 0);  // elsewhere; the suit keeps still from here
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
