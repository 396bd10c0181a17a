// SPDX-License-Identifier: Apache-2.0
// The default suit on the default actor: this is the first room that knows both.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/body/actor.h"
#include "core/suit/default_suit.h"

namespace noctule {
namespace {

double depthInside(const Capsule& capsule, const Vector3d& p) {
    const Vector3d axis = capsule.b_m - capsule.a_m;
    const double length2 = axis.squaredNorm();
    const double along = length2 > 0 ? std::clamp((p - capsule.a_m).dot(axis) / length2, 0.0, 1.0) : 0;
    return capsule.radius_m - (p - capsule.a_m - along * axis).norm();
}

TEST(DefaultSuitFit, EverySegmentIsThere) {
    EXPECT_TRUE(checkSegments(defaultSuit(), canonicalJointNames(), "default"));
}

TEST(DefaultSuitFit, EverythingSitsOnTheSkin) {
    const Actor actor = defaultActor();
    const Suit suit = defaultSuit();
    const GlobalPose zero = globalPose(actor.skeleton, actor.skeleton.zeroPose());
    const auto height_above_skin = [&](const std::string& segment, const Vector3d& p_segment) {
        const auto joint = static_cast<size_t>(actor.skeleton.find(segment));
        const Vector3d p = zero.p_world_joint[joint] + p_segment;  // all frames are parallel in the zero pose
        double deepest = -1;
        for (const Capsule& capsule : actor.capsules) {
            const auto carrier = static_cast<size_t>(actor.skeleton.find(capsule.segment));
            deepest = std::max(deepest, depthInside(capsule, p - zero.p_world_joint[carrier]));
        }
        return -deepest;
    };
    for (const Board& board : suit.boards) {
        const double height_m = height_above_skin(board.segment, board.p_segment_board_m);
        EXPECT_GT(height_m, 0.002) << board.id;
        EXPECT_LT(height_m, 0.06) << board.id;
    }
    for (const Source& source : suit.sources)
        EXPECT_GT(height_above_skin(source.segment, source.p_segment_source_m), 0.002) << source.id;
}

}  // namespace
}  // namespace noctule
