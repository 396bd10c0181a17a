// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/motion/motion_held_out.h"

#include <gtest/gtest.h>

namespace noctule {
namespace {

TEST(HeldOutSlice, KeepsTheRestPoseAndDropsWhatStraddlesTheSeam) {
    MotionEvidence evidence;
    evidence.nodes = 30;
    evidence.rests = {{0, 8}, {20, 4}};
    evidence.turns = {std::vector<BoardTurn>(29, BoardTurn{true})};
    evidence.forces = {std::vector<BoardForce>(30, BoardForce{true})};
    evidence.heard_share = {1};
    std::vector<MotionNode> nodes(30);
    for (int k = 0; k < 30; ++k) {
        nodes[static_cast<size_t>(k)].p_world_root_m.x() = k;
        evidence.distances.push_back({k, 0, 0.1, 0, 0, 1, 1});
    }
    const MotionEvidence slice = slicedEvidence(evidence, 18, 30, nodes);
    ASSERT_EQ(slice.nodes, 20);
    ASSERT_EQ(nodes.size(), 20u);
    EXPECT_EQ(nodes[7].p_world_root_m.x(), 7);
    EXPECT_EQ(nodes[8].p_world_root_m.x(), 18);
    ASSERT_EQ(slice.rests.size(), 2u);
    EXPECT_EQ(slice.rests[1].first, 10);
    ASSERT_EQ(slice.turns[0].size(), 19u);
    ASSERT_EQ(slice.forces[0].size(), 20u);
    for (int k = 0; k < 19; ++k)
        EXPECT_EQ(slice.turns[0][static_cast<size_t>(k)].heard, k != 7) << k;
    EXPECT_FALSE(slice.forces[0][7].heard || slice.forces[0][8].heard);
    EXPECT_TRUE(slice.forces[0][6].heard && slice.forces[0][9].heard);
    for (const HeardDistance& heard : slice.distances)
        EXPECT_GT(std::abs(heard.node - 8), 1);
    EXPECT_EQ(slice.distances.front().node, 1);
    EXPECT_EQ(slice.distances.back().node, 18);
}

}  // namespace
}  // namespace noctule
