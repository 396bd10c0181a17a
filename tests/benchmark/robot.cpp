// SPDX-License-Identifier: Apache-2.0
// Robonaut 2's right arm on one core: forward kinematics with Jacobians, a posture from cold (100 us are
// wanted), one frame of following (20 us in the median). Needs ../shared/data/robots.
#include <benchmark/benchmark.h>

#include "core/body/actor.h"
#include "core/math/rotation.h"
#include "core/robot/arm_follower.h"
#include "core/robot/inverse_kinematics.h"
#include "core/robot/saved_profile.h"
#include "core/robot/urdf_reader.h"

namespace noctule::robot {
namespace {

struct Bench {
    RobotModel model;
    RobotProfile profile;
    RobotArm arm;
};

/// Null without the robots.
const Bench* bench() {
    static const std::unique_ptr<const Bench> made = []() -> std::unique_ptr<const Bench> {
        auto model = readUrdf(NOCTULE_ROBOTS "/robonaut2/r2.urdf");
        if (!model)
            return nullptr;
        const auto profile = makeProfile(*model);
        if (!profile)
            return nullptr;
        for (const ArmProfile& one : profile->arms)
            if (one.side == Side::kRight)
                if (auto arm = makeArm(*model, one))
                    return std::make_unique<const Bench>(Bench{*model, *profile, *arm});
        return nullptr;
    }();
    return made.get();
}

void kinematics(benchmark::State& state) {
    if (!bench())
        return state.SkipWithError("needs ../shared/data/robots");
    const Chain& chain = bench()->arm.chain;
    RandomPostures random(3);
    const JointVector q = random.next(chain);
    ChainState at;
    PointJacobian J, J_turn;
    for (auto _ : state) {
        chain.forward(q, at);
        chain.pointJacobian(at, chain.size() - 1, at.p_base_tip, J);
        chain.turnJacobian(at, chain.size() - 1, J_turn);
        benchmark::DoNotOptimize(J.data());
        benchmark::DoNotOptimize(J_turn.data());
    }
}
BENCHMARK(kinematics);

/// TRAC-IK's protocol: reachable places, from the middle posture.
void coldPosture(benchmark::State& state) {
    if (!bench())
        return state.SkipWithError("needs ../shared/data/robots");
    const Chain& chain = bench()->arm.chain;
    RandomPostures random(11);
    ChainState at;
    int64_t arrived = 0;
    for (auto _ : state) {
        chain.forward(random.next(chain), at);
        arrived += findPosture(chain, at.R_base_tip, at.p_base_tip, chain.middle()).arrived;
    }
    state.counters["arrived_percent"] =
        100.0 * static_cast<double>(arrived) / static_cast<double>(state.iterations());
}
BENCHMARK(coldPosture)->Unit(benchmark::kMicrosecond);

void followOneFrame(benchmark::State& state) {
    if (!bench())
        return state.SkipWithError("needs ../shared/data/robots");
    const Skeleton& skeleton = defaultActor().skeleton;
    const auto performer = PerformerArms::make(skeleton, "performer");
    ArmFollower follower(bench()->arm, bench()->profile, performer->armLength_m(Side::kRight), 1.0 / 140);
    std::vector<ArmPose> poses;
    for (int i = 0; i < 700; ++i) {
        Pose pose = skeleton.zeroPose();
        const double swing = 0.4 * std::sin(i / 30.0);
        pose.q_parent_joint[static_cast<size_t>(skeleton.find("RightArm"))] =
            axisAngle(Vector3d::UnitZ(), radians(80) + swing);
        pose.q_parent_joint[static_cast<size_t>(skeleton.find("RightForeArm"))] =
            axisAngle(Vector3d::UnitY(), radians(90) + 2 * swing);
        poses.push_back(
            performer->at(globalPose(skeleton, pose)).in_chest[static_cast<size_t>(Side::kRight)]);
    }
    follower.settle(poses.front());
    size_t i = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(follower.follow(poses[i]));
        i = (i + 1) % poses.size();
    }
}
BENCHMARK(followOneFrame)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace noctule::robot

BENCHMARK_MAIN();
