// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/motion_fit.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <numbers>

#include "core/simulation/low_pass.h"
#include "core/simulation/motion_cleaning.h"
#include "tests/core/simulation/simulated_body.h"

namespace noctule::simulation {
namespace {

MotionClip readClip(const std::string& path) {
    const Result<BvhDocument> document = readBvh(path);
    EXPECT_TRUE(document) << document.error().text();
    return toClip(document.value()).value();
}

TEST(MotionFit, AMotionThatTheActorCanMakeIsMetExactly) {
    const MotionClip clip = madeMotion();
    const Actor actor = actorFromClip(clip).value();
    const FittedMotion fitted = fitMotion(clip, {actor, actor.skeleton, 1e3}).value();
    for (const FitQuality& q : fitted.quality)
        EXPECT_LT(q.max_rad, 0.02) << q.joint;
    const Joint& shin = actor.skeleton.joint(actor.skeleton.find("LeftFoot"));
    EXPECT_NEAR(shin.offset_m.norm(), 0.43, 1e-9);
    EXPECT_NEAR(actor.height_m, 1.75, 1e-6);
}

TEST(MotionFit, FirstFrameFacesForwardAboveTheOriginAndFeetStandOnTheFloor) {
    const MotionClip clip = madeMotion();
    const Actor actor = actorFromClip(clip).value();
    const Coordinates coordinates(actor.skeleton);
    const FittedMotion fitted = fitMotion(clip, {actor, actor.skeleton}).value();
    const Pose first = coordinates.toPose(fitted.rows[0]);
    EXPECT_NEAR(first.p_world_root.x(), 0, 1e-12);
    EXPECT_NEAR(first.p_world_root.z(), 0, 1e-12);
    const Vector3d forward = first.q_parent_joint[0] * Vector3d::UnitZ();
    EXPECT_NEAR(forward.x(), 0, 1e-9);
    EXPECT_GT(forward.z(), 0.9);
    int below = 0;
    for (const auto& row : fitted.rows)
        below += lowestPoint(coordinates, row) < -1e-9;
    EXPECT_LE(below, static_cast<int>(fitted.rows.size()) / 20 + 1);
}

TEST(MotionFit, InstalledMotionsAreFollowed) {
    for (const char* name : {"01_01.bvh", "01_03.bvh", "Boxing_Toes.bvh"}) {
        const std::string path = installedMotion(name);
        if (path.empty())
            GTEST_SKIP() << "assimp-testmodels is not installed";
        const MotionClip clip = readClip(path);
        const Actor actor = actorFromClip(clip).value();
        const FittedMotion fitted = fitMotion(clip, {actor, actor.skeleton}).value();
        double sum = 0;
        for (const FitQuality& q : fitted.quality) {
            std::printf("%s %-14s mean %5.2f deg, largest %6.2f deg\n", name, q.joint.c_str(),
                        degrees(q.mean_rad), degrees(q.max_rad));
            sum += degrees(q.mean_rad);
        }
        const double mean = sum / static_cast<double>(fitted.quality.size());
        std::printf("%s: mean over joints %.2f deg, height %.2f m, %d frames bridged%s\n", name, mean,
                    actor.height_m, fitted.repaired_frames,
                    fitted.dropped_first_frame ? ", first frame dropped" : "");
        EXPECT_LT(mean, 10) << name;
        EXPECT_GT(actor.height_m, 1.4);
        EXPECT_LT(actor.height_m, 2.1);
    }
}

TEST(MotionFit, EveryNamingIsRecognised) {
    const std::string folder = NOCTULE_SOURCE_DIR "/../shared/data/bvh/";
    if (!std::filesystem::exists(folder))
        GTEST_SKIP() << "no folder " << folder;
    for (const char* name :
         {"cmu/02_01.bvh", "cmu/131_01.bvh", "peers/bvh-toolbox/test_freebvh.bvh",
          "peers/bvh-toolbox/test_mocapbank.bvh", "peers/bvh-toolbox/walk01.bvh", "peers/makehuman/walk1.bvh",
          "peers/pybvh/bvh_data__bvh_test2.bvh", "peers/pybvh/bvh_data__bvh_example.bvh"}) {
        const MotionClip clip = readClip(folder + name);
        const Result<Actor> actor = actorFromClip(clip);
        ASSERT_TRUE(actor) << name << ": " << actor.error().text();
        const Result<FittedMotion> fitted = fitMotion(clip, {*actor, actor->skeleton});
        ASSERT_TRUE(fitted) << name << ": " << fitted.error().text();
        double sum = 0;
        for (const FitQuality& q : fitted->quality)
            sum += degrees(q.mean_rad);
        std::printf("%s: %zu joints, mean %.2f deg, height %.2f m\n", name, fitted->quality.size(),
                    sum / static_cast<double>(fitted->quality.size()), actor->height_m);
        EXPECT_LT(sum / static_cast<double>(fitted->quality.size()), 15) << name;
    }
}

TEST(MotionFit, MissingJointsAreNamed) {
    MotionClip clip = madeMotion(0.1);
    std::vector<Joint> joints = clip.skeleton.joints();
    joints[clip.skeleton.find("LeftForeArm")].name = "tentacle";
    clip.skeleton = Skeleton::make(joints).value();
    const Result<Actor> actor = actorFromClip(clip);
    ASSERT_FALSE(actor);
    EXPECT_EQ(actor.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(actor.error().message.find("LeftForeArm"), std::string::npos);
}

TEST(MotionFit, ValuesThatAreNoNumbersAreNamed) {
    MotionClip clip = madeMotion(0.5);
    clip.frames[30].q_parent_joint[clip.skeleton.find("RightArm")].x() =
        std::numeric_limits<double>::quiet_NaN();
    const Result<CleanedMotion> cleaned = cleanMotion(clip);
    ASSERT_FALSE(cleaned);
    EXPECT_EQ(cleaned.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(cleaned.error().message.find("frame 31"), std::string::npos) << cleaned.error().message;
    EXPECT_NE(cleaned.error().message.find("RightArm"), std::string::npos);
}

TEST(MotionFit, SingleFramesThatJumpAreBridged) {
    MotionClip clip = madeMotion(1);
    const Quaterniond good = clip.frames[50].q_parent_joint[3];
    clip.frames[50].q_parent_joint[3] = axisAngle(Vector3d::UnitX(), 2.5);
    clip.frames[80].p_world_root.x() += 1;
    const CleanedMotion cleaned = cleanMotion(clip).value();
    EXPECT_EQ(cleaned.repaired_frames, 2);
    EXPECT_LT(angleBetween(cleaned.clip.frames[50].q_parent_joint[3], good), 0.01);
}

TEST(LowPass, PassesSlowStopsFastAndShiftsNothing) {
    const double rate_hz = 120;
    std::vector<std::vector<double>> rows;
    for (int i = 0; i < 1200; ++i)
        rows.push_back({std::sin(2 * std::numbers::pi * 1 * i / rate_hz),
                        std::sin(2 * std::numbers::pi * 7 * i / rate_hz),
                        std::sin(2 * std::numbers::pi * 30 * i / rate_hz)});
    const auto original = rows;
    lowPassZeroPhase(rows, rate_hz, 7);
    double error = 0, in = 0, out = 0, fast = 0, product = 0;
    for (size_t i = 200; i < 1000; ++i) {
        error = std::max(error, std::abs(rows[i][0] - original[i][0]));
        in += original[i][1] * original[i][1];
        out += rows[i][1] * rows[i][1];
        product += rows[i][1] * original[i][1];
        fast = std::max(fast, std::abs(rows[i][2]));
    }
    EXPECT_LT(error, 2e-3);
    EXPECT_NEAR(std::sqrt(out / in), std::sqrt(0.5), 0.01);
    EXPECT_NEAR(product / std::sqrt(in * out), 1, 1e-6);  // in phase
    EXPECT_LT(fast, 0.003);
}

}  // namespace
}  // namespace noctule::simulation
