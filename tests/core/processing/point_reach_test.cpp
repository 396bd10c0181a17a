// SPDX-License-Identifier: Apache-2.0
#include "core/processing/point_reach.h"

#include <gtest/gtest.h>

#include <random>

namespace noctule {
namespace {

TEST(PointReach, HoldsInEveryPose) {
    const Actor actor = defaultActor();
    const GlobalPose rest = globalPose(actor.skeleton, actor.restPose());
    const std::vector<std::string> segments{"Hips",     "Hips",      "LeftUpLeg", "LeftLeg",
                                            "LeftFoot", "RightFoot", "LeftHand"};
    std::mt19937 random(3);
    std::normal_distribution<double> normal(0, 1);
    std::vector<WornPoint> worn;
    std::vector<Vector3d> local_m;
    for (const std::string& segment : segments) {
        const auto joint = static_cast<size_t>(actor.skeleton.find(segment));
        local_m.push_back(0.1 * Vector3d{normal(random), normal(random), normal(random)});
        worn.push_back({segment, rest.p_world_joint[joint] + rest.q_world_joint[joint] * local_m.back()});
    }
    const auto reaches = pointReaches(actor, worn);
    const double fixed_m = (local_m[0] - local_m[1]).norm();
    EXPECT_NEAR(reaches[0][1].least_m, fixed_m, 1e-9) << "of one segment";
    EXPECT_NEAR(reaches[0][1].most_m, fixed_m, 1e-9);
    EXPECT_LT(reaches[3][4].most_m, 0.8) << "shin and foot";
    double nearest_to_bound_m = 1;
    for (int trial = 0; trial < 500; ++trial) {
        Pose pose = actor.restPose();
        for (Quaterniond& q : pose.q_parent_joint)
            q = Quaterniond{normal(random), normal(random), normal(random), normal(random)}.normalized();
        const GlobalPose posed = globalPose(actor.skeleton, pose);
        std::vector<Vector3d> p_m;
        for (size_t i = 0; i < segments.size(); ++i) {
            const auto joint = static_cast<size_t>(actor.skeleton.find(segments[i]));
            p_m.push_back(posed.p_world_joint[joint] + posed.q_world_joint[joint] * local_m[i]);
        }
        for (size_t a = 0; a < p_m.size(); ++a)
            for (size_t b = 0; b < p_m.size(); ++b) {
                const double apart_m = (p_m[a] - p_m[b]).norm();
                EXPECT_LE(apart_m, reaches[a][b].most_m + 1e-9) << segments[a] << " " << segments[b];
                EXPECT_GE(apart_m, reaches[a][b].least_m - 1e-9) << segments[a] << " " << segments[b];
                if (segments[a] == "LeftLeg" && segments[b] == "LeftFoot")
                    nearest_to_bound_m = std::min(nearest_to_bound_m, reaches[a][b].most_m - apart_m);
            }
    }
    EXPECT_LT(nearest_to_bound_m, 0.02) << "the bound is tight";
}

}  // namespace
}  // namespace noctule
