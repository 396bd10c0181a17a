// SPDX-License-Identifier: Apache-2.0
#include "ui/models/part_names.h"

#include <gtest/gtest.h>

#include <set>

#include "core/body/actor.h"
#include "core/suit/default_suit.h"

namespace noctule::ui {
namespace {

TEST(PartNames, BoardsAreCalledAsTheOperatorSeesThem) {
    const Suit suit = defaultSuit();
    const int shin = suit.findBoard("l_leg");
    EXPECT_EQ(boardName(suit.boards[static_cast<size_t>(shin)]), "Left shin");
    EXPECT_EQ(boardTitle(suit, shin), QString("Left shin (board %1)").arg(shin + 1));
    EXPECT_EQ(boardInside(suit, shin), QString("board %1 (left shin)").arg(shin + 1));
    EXPECT_EQ(sourceName(suit, 7), "source 8 (hat)");
    EXPECT_EQ(sourceTitle(suit, 0), "Source 1 (chest, left)");
    EXPECT_EQ(pairName(suit, 7, shin), "source 8 (hat) to left shin");
}

TEST(PartNames, EveryCanonicalJointHasItsOwnNames) {
    std::set<QString> segments, joints;
    for (const std::string& joint : canonicalJointNames()) {
        segments.insert(segmentName(joint));
        joints.insert(jointName(joint));
        EXPECT_NE(segmentName(joint), segmentName(joint, NameCase::kInside)) << joint;
    }
    EXPECT_EQ(segments.size(), canonicalJointNames().size());
    EXPECT_EQ(joints.size(), canonicalJointNames().size());
    EXPECT_EQ(jointName("LeftLeg"), "Left knee");
    EXPECT_EQ(jointName("Head"), "Neck");
}

TEST(PartNames, UnknownNamesAreShownAsTheyAre) {
    Board tail;
    tail.segment = "Tail_Base";
    EXPECT_EQ(boardName(tail), "Tail Base");
    EXPECT_EQ(segmentName(""), "Room");
}

TEST(PartNames, AnchorsOfTheRoomAreToldApart) {
    Suit room;
    room.boards.resize(2);
    room.boards[0].id = "ceiling_1";
    room.boards[1].id = "ceiling_2";
    EXPECT_EQ(boardName(room.boards[0]), "ceiling 1");
    EXPECT_EQ(boardTitle(room, 1), "ceiling 2 (board 2)");
    EXPECT_EQ(boardInside(room, 1), "board 2 (ceiling 2)");
    EXPECT_EQ(partNames(room).boards.at("ceiling_2"), "ceiling 2");
}

TEST(PartNames, ABoardAndASourceMayHaveOneId) {
    Suit suit = defaultSuit();
    suit.sources[0].id = suit.boards[0].id;
    const PartNames names = partNames(suit);
    EXPECT_EQ(names.boards.at(suit.boards[0].id), boardName(suit.boards[0]));
    EXPECT_EQ(names.sources.at(suit.boards[0].id), sourceTitle(suit, 0));
    std::string board = suit.boards[0].id, source = board, joint = "Left knee";
    names.apply("board", board);
    names.apply("source", source);
    names.apply("joint", joint);
    EXPECT_EQ(board, boardName(suit.boards[0]).toStdString());
    EXPECT_EQ(source, sourceTitle(suit, 0).toStdString());
    EXPECT_EQ(joint, "Left knee");
}

TEST(PartNames, GroupsHoldEveryBoardOnce) {
    Suit suit = defaultSuit();
    suit.boards.push_back(Board{"room", "", "", {}, {}, {}, false, 1, 1});
    std::set<int> seen;
    for (const NamedBoards& group : boardGroups(suit)) {
        EXPECT_FALSE(groupName(group.group).isEmpty());
        EXPECT_FALSE(group.boards.empty());
        for (const int board : group.boards) {
            EXPECT_TRUE(seen.insert(board).second);
            EXPECT_EQ(groupOfSegment(suit.boards[static_cast<size_t>(board)].segment), group.group);
        }
    }
    EXPECT_EQ(seen.size(), suit.boards.size());
    EXPECT_EQ(boardGroups(suit).front().group, BodyGroup::kTrunk);
    EXPECT_EQ(boardGroups(suit).front().boards.size(), 4u);
    EXPECT_EQ(boardGroups(suit).back().group, BodyGroup::kElsewhere);
}

}  // namespace
}  // namespace noctule::ui
