// SPDX-License-Identifier: Apache-2.0
#include "core/robot/teleoperation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "core/math/rotation.h"
#include "core/robot/inverse_kinematics.h"
#include "core/robot/urdf_reader.h"

namespace noctule::robot {
namespace {

/// Seven joints as a person's arm has them, upper arm and forearm 0.3 m.
std::string armUrdf() {
    struct One {
        const char *name, *axis, *origin;
    };
    const One joints[] = {{"s0", "0 1 0", "0 0 0"},   {"s1", "1 0 0", "0 0 0"},   {"s2", "0 0 1", "0 0 0"},
                          {"e", "0 1 0", "0 0 -0.3"}, {"f", "0 0 1", "0 0 -0.1"}, {"w0", "0 1 0", "0 0 -0.2"},
                          {"w1", "1 0 0", "0 0 0"}};
    std::string text = "<robot name=\"arm\"><link name=\"l0\"/>";
    int number = 0;
    for (const One& joint : joints) {
        const std::string parent = "l" + std::to_string(number), child = "l" + std::to_string(++number);
        text += "<link name=\"" + child + "\"/><joint name=\"" + joint.name +
                "\" type=\"revolute\"><parent link=\"" + parent + "\"/><child link=\"" + child +
                "\"/><axis xyz=\"" + joint.axis + "\"/><origin xyz=\"" + joint.origin +
                "\"/><limit lower=\"-2.5\" upper=\"2.5\" velocity=\"2\" effort=\"1\"/></joint>";
    }
    return text + "</robot>";
}

struct Bench {
    RobotArm arm;
    RobotProfile profile;
    JointVector q;
};

Bench bench(double acceleration = 0, double jerk = 0) {
    const auto model = parseUrdf(armUrdf(), "arm");
    EXPECT_TRUE(model);
    ArmProfile arm;
    arm.name = "right";
    arm.base = "l0";
    arm.tip = "l7";
    arm.shoulder_joint = "s0";
    arm.elbow_joint = "e";
    arm.wrist_joint = "w0";
    arm.reference_rad = {0, -0.2, 0, -1.5, 0, 0.1, 0};
    arm.max_speed.assign(7, 2);
    RobotProfile profile;
    profile.max_acceleration = acceleration;
    profile.max_jerk = jerk;
    auto made = makeArm(*model, arm);
    EXPECT_TRUE(made) << (made ? "" : made.error().text());
    const JointVector q = made->reference;
    return {std::move(*made), profile, q};
}

TeleopPose poseAt(int64_t time_ns, const Vector3d& p) {
    TeleopPose pose;
    pose.time_ns = time_ns;
    pose.p_world_hand = p;
    return pose;
}

constexpr int64_t kStep_ns = 1'000'000'000 / 140;
constexpr TeleopKeys kHeld{true, true, false, false, false};
constexpr TeleopKeys kAccepted{true, true, true, false, false};
constexpr TeleopKeys kClutchOpen{true, false, false, false, false};
constexpr TeleopKeys kNobody{false, true, false, false, false};

/// Calls step() with the clock running.
class Session {
public:
    explicit Session(const Bench& bench, const TeleopSettings& settings = {})
        : own_(bench),
          operator_(own_.arm.chain, own_.arm.profile.max_speed, own_.profile, settings, own_.q) {}

    TeleopCommand step(const Vector3d& p, const TeleopKeys& keys) {
        now_ns_ += kStep_ns;
        return last_ = operator_.step(now_ns_, poseAt(now_ns_, p), keys);
    }
    TeleopCommand blind(const TeleopKeys& keys) {
        now_ns_ += kStep_ns;
        return last_ = operator_.step(now_ns_, poseAt(seen_ns_, Vector3d::Zero()), keys);
    }
    void seenNow() { seen_ns_ = now_ns_; }
    TeleopCommand follow(const Vector3d& p) {
        step(p, kHeld);
        step(p, kAccepted);
        for (int i = 0; i < 200; ++i)
            step(p, kHeld);
        return last_;
    }
    Vector3d tip() const { return tipOf(last_.q); }
    Vector3d tipOf(const JointVector& q) const {
        ChainState state;
        own_.arm.chain.forward(q, state);
        return state.p_base_tip;
    }
    const TeleopCommand& last() const { return last_; }

private:
    Bench own_;
    Teleoperator operator_;
    int64_t now_ns_ = 1'000'000'000, seen_ns_ = 0;
    TeleopCommand last_;
};

// What must hold of the table, said independently of its lines.
TEST(TeleopStates, TheTableIsSafe) {
    std::set<std::pair<int, int>> pairs;
    for (const TeleopTransition& t : kTeleopTransitions)
        EXPECT_TRUE(pairs.emplace(static_cast<int>(t.from), static_cast<int>(t.event)).second) << "twice";
    for (int s = 0; s < kTeleopStates; ++s) {
        const auto state = static_cast<TeleopState>(s);
        EXPECT_EQ(after(state, TeleopEvent::kStop), TeleopState::kStopped);
        for (int e = 0; e < kTeleopEvents; ++e) {
            const auto event = static_cast<TeleopEvent>(e);
            const TeleopState next = after(state, event);
            if (state == next)
                continue;
            if (next == TeleopState::kFollowing) {
                EXPECT_TRUE(state == TeleopState::kBlending && event == TeleopEvent::kBlended);
            }
            if (next == TeleopState::kBlending) {
                EXPECT_TRUE(state == TeleopState::kSynchronising && event == TeleopEvent::kAccept);
            }
            if (state == TeleopState::kStopped) {
                EXPECT_TRUE(event == TeleopEvent::kReset && next == TeleopState::kIdle);
            }
        }
        const bool moves = state == TeleopState::kFollowing || state == TeleopState::kBlending;
        if (moves) {
            EXPECT_EQ(after(state, TeleopEvent::kRelease), TeleopState::kHolding);
            EXPECT_EQ(after(state, TeleopEvent::kLose), TeleopState::kLost);
        }
    }
}

TEST(Teleoperation, EngagingMovesNothingAndTheHandIsThenFollowed) {
    Session session(bench());
    const Vector3d hand(1, 2, 3);
    session.step(hand, kHeld);
    EXPECT_EQ(session.last().state, TeleopState::kSynchronising);
    const Vector3d before = session.tip();
    session.follow(hand);
    EXPECT_EQ(session.last().state, TeleopState::kFollowing);
    EXPECT_LT((session.tip() - before).norm(), 1e-3);
    for (int i = 0; i < 140; ++i)
        session.step(hand + Vector3d(0, 0.05, 0.05), kHeld);
    EXPECT_LT((session.tip() - before - Vector3d(0, 0.05, 0.05)).norm(), 1e-3);
}

TEST(Teleoperation, ReindexingAtAnyTimeMovesNothing) {
    Session session(bench());
    session.follow(Vector3d::Zero());
    for (int i = 0; i < 100; ++i)
        session.step(Vector3d(0.02, 0.04, 0), kHeld);
    session.step(Vector3d(0.02, 0.04, 0), kClutchOpen);
    EXPECT_EQ(session.last().state, TeleopState::kHolding);
    const JointVector held = session.last().q;
    for (int i = 0; i < 50; ++i)  // the hand goes elsewhere, the arm stays
        session.step(Vector3d(-0.5, 0.3, 0.1), kClutchOpen);
    EXPECT_EQ(session.last().q, held);
    session.follow(Vector3d(-0.5, 0.3, 0.1));
    EXPECT_EQ(session.last().state, TeleopState::kFollowing);
    EXPECT_LT((session.tip() - session.tipOf(held)).norm(), 1e-3);
    EXPECT_LT((session.last().q - held).cwiseAbs().maxCoeff(), radians(0.1));
}

TEST(Teleoperation, APostureTooFarOffIsNotAccepted) {
    Session session(bench());
    Bench own = bench();
    Teleoperator driver(own.arm.chain, own.arm.profile.max_speed, own.profile, {}, own.q);
    TeleopPose pose = poseAt(1, Vector3d::Zero());
    pose.posture = own.q;
    (*pose.posture)[3] -= 0.5;
    driver.step(1, pose, kHeld);
    TeleopCommand command = driver.step(1, pose, kAccepted);
    EXPECT_EQ(command.state, TeleopState::kSynchronising);
    EXPECT_EQ(command.farthest_joint, 3);
    EXPECT_NEAR(command.farthest_rad, 0.5, 1e-9);
    (*pose.posture)[3] += 0.3;  // near enough now: blended in over a second
    command = driver.step(1, pose, kAccepted);
    EXPECT_EQ(command.state, TeleopState::kBlending);
    int steps = 1;
    for (; steps < 300 && command.state == TeleopState::kBlending; ++steps) {
        const JointVector before = command.q;
        command = driver.step(1, pose, kHeld);
        EXPECT_LE((command.q - before).cwiseAbs().maxCoeff(),
                  0.2 * 1.9 / 140);  // of the blend, not of the limit
    }
    EXPECT_NEAR(steps, 140, 2);
    EXPECT_EQ(command.state, TeleopState::kFollowing);
    EXPECT_LT((command.q - *pose.posture).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(Teleoperation, DeadMansKeyWatchdogAndStopHoldTheArm) {
    const auto moving = [] {
        Session session(bench());
        session.follow(Vector3d::Zero());
        for (int i = 0; i < 10; ++i)
            session.step(Vector3d(0, 0.3, 0), kHeld);
        return session;
    };
    Session released = moving();
    const JointVector before = released.last().q;
    released.step(Vector3d(0, 0.3, 0), kNobody);
    EXPECT_EQ(released.last().state, TeleopState::kHolding);
    EXPECT_EQ(released.last().q, before);

    Session lost = moving();
    lost.seenNow();
    int steps = 0;
    while (steps < 40 && lost.last().state != TeleopState::kLost) {
        lost.blind(kHeld);
        ++steps;
    }
    EXPECT_EQ(lost.last().state, TeleopState::kLost);
    EXPECT_NEAR(steps, 15, 1);  // 100 ms
    lost.step(Vector3d::Zero(), kNobody);
    EXPECT_EQ(lost.last().state, TeleopState::kHolding);  // never back to following by itself

    Session stopped = moving();
    stopped.step(Vector3d(0, 0.3, 0), {true, true, false, true, false});
    const JointVector at = stopped.last().q;
    for (int i = 0; i < 20; ++i)
        stopped.step(Vector3d(0, 0.3, 0), kAccepted);
    EXPECT_EQ(stopped.last().state, TeleopState::kStopped);
    EXPECT_EQ(stopped.last().q, at);
}

TEST(Teleoperation, TheTipStaysInsideTheBox) {
    TeleopSettings settings;
    Session free(bench());
    free.step(Vector3d::Zero(), kHeld);
    settings.box_max_m.z() = free.tip().z() + 0.05;
    Session session(bench(), settings);
    session.follow(Vector3d::Zero());
    for (int i = 0; i < 200; ++i)
        session.step(Vector3d(0, 0, 0.2), kHeld);
    EXPECT_TRUE(session.last().is_outside_box);
    EXPECT_NEAR(session.tip().z(), settings.box_max_m.z(), 1e-3);
}

TEST(Teleoperation, AnUncertainPoseSlowsTheArm) {
    Bench own = bench();
    Teleoperator driver(own.arm.chain, own.arm.profile.max_speed, own.profile, {}, own.q);
    TeleopPose pose = poseAt(1, Vector3d::Zero());
    pose.posture = own.q;
    driver.step(1, pose, kHeld);
    TeleopCommand command = driver.step(1, pose, kAccepted);
    for (int i = 0; i < 150; ++i)
        command = driver.step(1, pose, kHeld);
    ASSERT_EQ(command.state, TeleopState::kFollowing);
    pose.posture = JointVector(own.q.array() + 0.5);
    pose.confidence = 0.2;
    const JointVector before = command.q;
    command = driver.step(1, pose, kHeld);
    EXPECT_TRUE(command.is_slowed);
    EXPECT_LE((command.q - before).cwiseAbs().maxCoeff(), 0.25 * 2 / 140 + 1e-12);
}

/// Poses and keys of a broken world: jumps, gaps, numbers that are none, clocks that go backwards.
struct Faults {
    RandomPostures random;
    TeleopPose pose = poseAt(0, Vector3d::Zero());
    TeleopKeys keys = kHeld;

    std::optional<TeleopPose> next(int64_t now_ns, const JointVector& q) {
        const auto happens = [&](double rate) { return random.uniform() < rate; };
        keys.accept = happens(0.2);
        keys.stop = happens(0.001);
        keys.reset = happens(0.02);
        if (happens(0.005))
            keys.dead_man = !keys.dead_man;
        if (happens(0.01))
            keys.clutch = !keys.clutch;
        if (!happens(0.1))
            pose.time_ns = happens(0.005) ? now_ns + 1'000'000'000 : now_ns;
        for (int i = 0; i < 3; ++i)
            pose.p_world_hand[i] += 0.02 * (random.uniform() - 0.5);
        if (happens(0.01))
            pose.p_world_hand = Vector3d::Constant(3 * random.uniform() - 1.5);
        pose.q_world_hand =
            happens(0.01) ? expQuaternion(Vector3d::Constant(3 * random.uniform())) : pose.q_world_hand;
        pose.confidence = random.uniform();
        pose.posture.reset();
        if (happens(0.3))
            pose.posture = JointVector(q.array() + 0.6 * (random.uniform() - 0.5));
        TeleopPose sent = pose;
        if (happens(0.003))
            sent.p_world_hand.x() = std::numeric_limits<double>::quiet_NaN();
        if (happens(0.003))
            sent.q_world_hand.coeffs().setZero();
        if (happens(0.002))
            sent.posture = JointVector::Constant(7, std::numeric_limits<double>::infinity());
        return happens(0.01) ? std::nullopt : std::optional(sent);
    }
};

TEST(Teleoperation, NothingJumpsWhateverGoesWrong) {
    for (const bool smooth : {false, true}) {
        std::set<TeleopState> seen;
        for (uint64_t seed = 1; seed <= 4; ++seed) {
            Bench own = smooth ? bench(20, 400) : bench();
            TeleopSettings settings;
            settings.blend_s = 0.2;  // short, so that faults do not end every blend
            Teleoperator driver(own.arm.chain, own.arm.profile.max_speed, own.profile, settings, own.q);
            Faults faults{RandomPostures(seed)};
            JointVector last = own.q, speed = JointVector::Zero(7), acceleration = speed;
            for (int64_t i = 1; i <= 6000; ++i) {
                const auto pose = faults.next(i * kStep_ns, last);
                const TeleopCommand command = driver.step(i * kStep_ns, pose, faults.keys);
                seen.insert(command.state);
                ASSERT_TRUE(command.q.allFinite());
                const JointVector new_speed = (command.q - last) * 140;
                const JointVector new_acceleration = (new_speed - speed) * 140;
                ASSERT_LE(new_speed.cwiseAbs().maxCoeff(), 2 + 1e-9) << "seed " << seed << ", step " << i;
                ASSERT_LE(command.q.cwiseAbs().maxCoeff(), 2.5 + 1e-9);
                if (smooth) {
                    ASSERT_LE(new_acceleration.cwiseAbs().maxCoeff(), 20 * (1 + 1e-6));
                    ASSERT_LE(((new_acceleration - acceleration) * 140).cwiseAbs().maxCoeff(),
                              400 * (1 + 1e-6));
                }
                last = command.q;
                speed = new_speed;
                acceleration = new_acceleration;
            }
        }
        EXPECT_EQ(seen.size(), static_cast<size_t>(kTeleopStates));  // faults reached every state
    }
}

}  // namespace
}  // namespace noctule::robot
