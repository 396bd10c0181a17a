// SPDX-License-Identifier: Apache-2.0
#include "core/render/body_scene.h"

#include <gtest/gtest.h>

#include "core/body/actor.h"
#include "core/math/rotation.h"
#include "core/suit/default_suit.h"

namespace noctule {
namespace {

class BodyScene : public testing::Test {
protected:
    void SetUp() override {
        pose_ = actor_.restPose();
        pose_.q_parent_joint[0] = axisAngle(Vector3d::UnitY(), 0.7);
        const auto arm = static_cast<size_t>(actor_.skeleton.find("LeftArm"));
        pose_.q_parent_joint[arm] = axisAngle(Vector3d::UnitZ(), -1.1);
        joints_ = globalPose(actor_.skeleton, pose_);
    }
    Vector3d worldPoint(const std::string& segment, const Vector3d& p) const {
        const auto joint = static_cast<size_t>(actor_.skeleton.find(segment));
        return joints_.p_world_joint[joint] + joints_.q_world_joint[joint] * p;
    }

    Actor actor_ = defaultActor();
    Suit suit_ = defaultSuit();
    Pose pose_;
    GlobalPose joints_;
};

TEST_F(BodyScene, BoardsAndSourcesMoveWithTheirSegments) {
    const BodyPlaces places = placeBody(actor_.skeleton, pose_, suit_, nullptr);
    ASSERT_EQ(places.boards.size(), suit_.boards.size());
    ASSERT_EQ(places.sources.size(), suit_.sources.size());
    for (size_t i = 0; i < suit_.boards.size(); ++i) {
        const Board& board = suit_.boards[i];
        EXPECT_TRUE(places.boards[i].p_m.isApprox(worldPoint(board.segment, board.p_segment_board_m), 1e-9))
            << board.id;
        const auto joint = static_cast<size_t>(actor_.skeleton.find(board.segment));
        EXPECT_LT(places.boards[i].q_world_board.angularDistance(joints_.q_world_joint[joint] *
                                                                 board.q_segment_board),
                  1e-7);
    }
    for (size_t i = 0; i < suit_.sources.size(); ++i) {
        const Source& source = suit_.sources[i];
        EXPECT_TRUE(
            places.sources[i].p_m.isApprox(worldPoint(source.segment, source.p_segment_source_m), 1e-9));
        EXPECT_NEAR(places.sources[i].normal.norm(), 1, 1e-9);
    }
}

TEST_F(BodyScene, CalibrationCorrectsTheMounting) {
    Calibration calibration = nominalCalibration(suit_);
    calibration.boards[5].p_segment_board_m = Vector3d(0.1, 0.2, 0.3);
    const BodyPlaces places = placeBody(actor_.skeleton, pose_, suit_, &calibration);
    const Board& board = suit_.boards[5];
    EXPECT_TRUE(places.boards[5].p_m.isApprox(worldPoint(board.segment, {0.1, 0.2, 0.3}), 1e-9));
    EXPECT_TRUE(places.boards[6].p_m.isApprox(
        worldPoint(suit_.boards[6].segment, suit_.boards[6].p_segment_board_m), 1e-9));
}

TEST_F(BodyScene, WhatIsFixedInTheRoomStays) {
    suit_.sources[0].segment.clear();
    suit_.sources[0].p_segment_source_m = {1, 2, 3};
    const BodyPlaces places = placeBody(actor_.skeleton, pose_, suit_, nullptr);
    EXPECT_TRUE(places.sources[0].p_m.isApprox(Vector3d(1, 2, 3)));
}

TEST_F(BodyScene, UnknownSegmentsSitAtTheRoot) {
    suit_.boards[0].segment = "Tail";
    const BodyPlaces places = placeBody(actor_.skeleton, pose_, suit_, nullptr);
    EXPECT_TRUE(places.boards[0].p_m.isApprox(worldPoint("Hips", suit_.boards[0].p_segment_board_m), 1e-9));
}

TEST_F(BodyScene, BonesJoinTheJoints) {
    const BodyPlaces places = placeBody(actor_.skeleton, pose_, {}, nullptr);
    size_t tips = 0;
    for (const Joint& joint : actor_.skeleton.joints())
        tips += joint.end_m.has_value();
    EXPECT_EQ(places.bones.size(), static_cast<size_t>(actor_.skeleton.size()) - 1 + tips);
    for (const BonePlace& bone : places.bones)
        EXPECT_TRUE(bone.from_m.isApprox(joints_.p_world_joint[static_cast<size_t>(bone.joint)]));
    EXPECT_NEAR(places.box().min().y(), 0, 1e-6);
    EXPECT_TRUE(BodyPlaces{}.box().isEmpty());
}

}  // namespace
}  // namespace noctule
