// SPDX-License-Identifier: Apache-2.0
// The motion of the virtual suit, on the default body: within what joints can do, smooth, feet on the floor.
#include <gtest/gtest.h>

#include "core/body/actor.h"
#include "core/formats/bvh.h"
#include "core/math/rotation.h"
#include "core/mesh/import/glb_reader.h"
#include "core/mesh/skinning.h"

namespace noctule {
namespace {

const MotionClip& sample() {
    static const MotionClip clip = [] {
        const auto document = readBvh(NOCTULE_SOURCE_DIR "/resources/motions/sample.bvh");
        return toClip(document.value(), BvhUnit::kCentimetre).value();
    }();
    return clip;
}

/// Joint of the file for a joint of the actor.
size_t inClip(const Joint& joint) {
    return static_cast<size_t>(sample().skeleton.find(joint.name));
}

TEST(SampleMotion, LiesOnTheDefaultActor) {
    const Skeleton actor = defaultActor().skeleton;
    ASSERT_EQ(sample().skeleton.size(), actor.size());
    for (const Joint& joint : actor.joints()) {
        const int index = sample().skeleton.find(joint.name);
        ASSERT_GE(index, 0) << joint.name;
        EXPECT_LT((sample().skeleton.joint(index).offset_m - joint.offset_m).norm(), 1e-6) << joint.name;
    }
    EXPECT_NEAR(sample().duration_s(), 14, 1e-3);
    EXPECT_NEAR(sample().frame_time_s, 1.0 / 60, 1e-8);
}

TEST(SampleMotion, BeginsAndEndsInTheRestPose) {
    const Actor actor = defaultActor();
    const Pose rest = actor.restPose();
    for (const Pose* pose : {&sample().frames.front(), &sample().frames.back()}) {
        for (const Joint& joint : actor.skeleton.joints())
            EXPECT_LT(angleBetween(pose->q_parent_joint[inClip(joint)],
                                   rest.q_parent_joint[static_cast<size_t>(actor.skeleton.find(joint.name))]),
                      0.002)
                << joint.name;
        EXPECT_LT((pose->p_world_root - rest.p_world_root).norm(), 1e-3);
    }
}

TEST(SampleMotion, EveryJointCanMakeIt) {
    const Skeleton actor = defaultActor().skeleton;
    for (const Pose& pose : sample().frames)
        for (const Joint& joint : actor.joints()) {
            const Quaterniond& q = pose.q_parent_joint[inClip(joint)];
            ASSERT_LT(angleBetween(q, projectOntoJoint(joint, q, true).q_parent_joint), 1e-5) << joint.name;
        }
}

TEST(SampleMotion, NothingTurnsFasterThanASuitMeasures) {
    double fastest_rad_per_s = 0;
    for (size_t f = 1; f < sample().frames.size(); ++f) {
        const GlobalPose before = globalPose(sample(), f - 1), after = globalPose(sample(), f);
        for (size_t j = 0; j < before.q_world_joint.size(); ++j)
            fastest_rad_per_s =
                std::max(fastest_rad_per_s, angleBetween(before.q_world_joint[j], after.q_world_joint[j]) /
                                                sample().frame_time_s);
    }
    EXPECT_LT(fastest_rad_per_s, 8);
    EXPECT_GT(fastest_rad_per_s, 2) << "something has to move";
}

/// Changes of velocity from frame to frame, as accelerations, stay those of a person.
TEST(SampleMotion, IsSmooth) {
    double largest_m_per_s2 = 0;
    for (size_t f = 1; f + 1 < sample().frames.size(); ++f) {
        const GlobalPose a = globalPose(sample(), f - 1), b = globalPose(sample(), f),
                         c = globalPose(sample(), f + 1);
        for (size_t j = 0; j < b.p_world_joint.size(); ++j)
            largest_m_per_s2 = std::max(
                largest_m_per_s2, (a.p_world_joint[j] - 2 * b.p_world_joint[j] + c.p_world_joint[j]).norm() /
                                      (sample().frame_time_s * sample().frame_time_s));
    }
    EXPECT_LT(largest_m_per_s2, 25);
}

TEST(SampleMotion, OneFootAlwaysStandsAndNoneSinksIn) {
    const auto body = readSkinnedMesh(NOCTULE_SOURCE_DIR "/resources/bodies/mannequin.glb");
    ASSERT_TRUE(body) << body.error().text();
    for (size_t f = 0; f < sample().frames.size(); f += 6) {
        const PosedSurface surface =
            skinned(*body, skinMatrices(*body, sample().skeleton, globalPose(sample(), f)));
        float lowest_m = 1;
        for (const Eigen::Vector3f& p : surface.points_m)
            lowest_m = std::min(lowest_m, p.y());
        ASSERT_NEAR(lowest_m, 0, 0.012) << "at " << static_cast<double>(f) / 60 << " s";
    }
}

/// A standing ankle does not slide: over every tenth of a second the slower one moves three millimetres at
/// most, and that only where one foot lands as the other leaves.
TEST(SampleMotion, TheStandingFootDoesNotSlide) {
    const size_t feet[] = {static_cast<size_t>(sample().skeleton.find("LeftFoot")),
                           static_cast<size_t>(sample().skeleton.find("RightFoot"))};
    for (size_t f = 6; f < sample().frames.size(); f += 6) {
        const GlobalPose before = globalPose(sample(), f - 6), after = globalPose(sample(), f);
        double least_m = 1;
        for (const size_t foot : feet)
            least_m = std::min(least_m, (after.p_world_joint[foot] - before.p_world_joint[foot]).norm());
        ASSERT_LT(least_m, 3e-3) << "at " << static_cast<double>(f) / 60 << " s";
    }
}

}  // namespace
}  // namespace noctule
