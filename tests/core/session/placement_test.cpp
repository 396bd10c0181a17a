// SPDX-License-Identifier: Apache-2.0
// Mirroring boards and sources, moving a suit to another body, and judging measures.
#include "core/session/placement.h"

#include <gtest/gtest.h>

#include "core/math/rotation.h"
#include "core/session/body_measures.h"
#include "core/suit/default_suit.h"

namespace noctule {
namespace {

constexpr double kTiny = 1e-12;

void expectSamePlace(const Board& a, const Board& b) {
    EXPECT_EQ(a.segment, b.segment);
    EXPECT_LT((a.p_segment_board_m - b.p_segment_board_m).norm(), kTiny) << a.id;
    EXPECT_LT(angleBetween(a.q_segment_board, b.q_segment_board), 1e-7) << a.id;
    EXPECT_LT((a.p_board_mic_m - b.p_board_mic_m).norm(), kTiny);
}

TEST(Placement, MirroredTwiceIsTheSameAgain) {
    Suit suit = defaultSuit();
    for (Board& board : suit.boards) {
        board.p_board_mic_m = {0.01, 0.002, -0.003};
        board.q_segment_board = board.q_segment_board * axisAngle(Vector3d(1, 2, 3).normalized(), 0.4);
        expectSamePlace(mirrorBoard(mirrorBoard(board)), board);
    }
    for (const Source& source : suit.sources) {
        const Source twice = mirrorSource(mirrorSource(source));
        EXPECT_EQ(twice.segment, source.segment);
        EXPECT_LT((twice.p_segment_source_m - source.p_segment_source_m).norm(), kTiny);
        EXPECT_LT((twice.normal_segment - source.normal_segment).norm(), kTiny);
    }
}

TEST(Placement, DefaultSuitIsItsOwnMirrorImage) {
    const Suit suit = defaultSuit();
    int mirrored = 0;
    for (int b = 0; b < static_cast<int>(suit.boards.size()); ++b) {
        const int other = boardOnOtherSide(suit, b);
        if (other < 0)
            continue;
        ++mirrored;
        expectSamePlace(mirrorBoard(suit.boards[static_cast<size_t>(b)]),
                        suit.boards[static_cast<size_t>(other)]);
        EXPECT_EQ(boardOnOtherSide(suit, other), b);
    }
    EXPECT_EQ(mirrored, 14);
    EXPECT_EQ(sourceOnOtherSide(suit, suit.findSource("chest_l")), suit.findSource("chest_r"));
    EXPECT_EQ(sourceOnOtherSide(suit, suit.findSource("hat")), -1);
    EXPECT_EQ(boardOnOtherSide(suit, suit.findBoard("chest")), -1);
}

TEST(Placement, MicrophoneMirrorsWithItsBoard) {
    Board board = defaultSuit().boards[6];
    board.p_board_mic_m = {0.01, 0.02, 0.03};
    const Board image = mirrorBoard(board);
    const auto microphone = [](const Board& b) -> Vector3d {
        return b.p_segment_board_m + b.q_segment_board * b.p_board_mic_m;
    };
    const Vector3d expected = microphone(board).cwiseProduct(Vector3d(-1, 1, 1));
    EXPECT_LT((microphone(image) - expected).norm(), kTiny);
}

TEST(Placement, PartnerIsFoundByIdAndElseBySegment) {
    Suit suit;
    const auto add = [&](const char* id, const char* segment) {
        suit.boards.emplace_back();
        suit.boards.back().id = id;
        suit.boards.back().segment = segment;
    };
    add("one", "LeftLeg");
    add("two", "RightLeg");
    add("three", "LeftArm");
    add("four", "RightArm");
    add("five", "RightArm");
    EXPECT_EQ(boardOnOtherSide(suit, 0), 1);
    EXPECT_EQ(boardOnOtherSide(suit, 1), 0);
    EXPECT_EQ(boardOnOtherSide(suit, 2), -1);
    EXPECT_EQ(boardOnOtherSide(suit, 3), 2);
}

TEST(Placement, SuitGrowsWithTheBody) {
    const Suit suit = defaultSuit();
    BodyMeasures tall;
    tall.height_m = 1.75 * 1.1;
    const Suit on_tall = suitOnActor(suit, defaultActor(tall));
    for (size_t b = 0; b < suit.boards.size(); ++b) {
        EXPECT_LT((on_tall.boards[b].p_segment_board_m - 1.1 * suit.boards[b].p_segment_board_m).norm(), 1e-9)
            << suit.boards[b].id;
        EXPECT_EQ(on_tall.boards[b].q_segment_board.coeffs(), suit.boards[b].q_segment_board.coeffs());
    }
    const Suit back = suitOnActor(on_tall, defaultActor(tall), defaultActor());
    for (size_t s = 0; s < suit.sources.size(); ++s)
        EXPECT_LT((back.sources[s].p_segment_source_m - suit.sources[s].p_segment_source_m).norm(), kTiny);
}

TEST(Placement, BoardKeepsItsPlaceAlongALongerBone) {
    const Suit suit = defaultSuit();
    BodyMeasures long_shin;
    long_shin.shin_m = 0.5;
    const Actor actor = defaultActor(long_shin), usual = defaultActor();
    const auto shin = static_cast<size_t>(suit.findBoard("l_leg"));
    const Suit placed = suitOnActor(suit, actor);
    const Vector3d before = suit.boards[shin].p_segment_board_m,
                   after = placed.boards[shin].p_segment_board_m;
    EXPECT_NEAR(after.y() / before.y(), 0.5 / 0.43, 1e-9);
    EXPECT_NEAR(after.z(), before.z(), kTiny);
    const auto arm = static_cast<size_t>(suit.findBoard("l_arm"));
    EXPECT_EQ(placed.boards[arm].p_segment_board_m, suit.boards[arm].p_segment_board_m);
}

TEST(Placement, NewMeasuresTakeTheSuitAlong) {
    Performer performer;
    performer.suit = defaultSuit();
    BodyMeasures measures;
    measures.height_m = 1.6;
    measures.shin_m = 0.45;
    setMeasures(performer, measures);
    EXPECT_EQ(performer.measures.shin_m, 0.45);
    const Suit expected = suitOnActor(defaultSuit(), defaultActor(measures));
    EXPECT_EQ(toJson(performer.suit), toJson(expected));
}

TEST(Placement, DirectionsAreAnglesFromForward) {
    EXPECT_NEAR(directionOf(Vector3d::UnitZ()).left_rad, 0, kTiny);
    EXPECT_NEAR(directionOf(Vector3d::UnitX()).left_rad, radians(90), kTiny);
    EXPECT_NEAR(directionOf(-Vector3d::UnitY()).up_rad, radians(-90), kTiny);
    for (const Source& source : defaultSuit().sources)
        EXPECT_LT((normalFrom(directionOf(source.normal_segment)) - source.normal_segment).norm(), 1e-9);
}

TEST(BodyMeasuresCheck, ProportionsAreThoseOfTheActor) {
    BodyMeasures measures;
    measures.height_m = 1.75;
    EXPECT_NEAR(proportionalLength_m(measures, &BodyMeasures::upper_arm_m), 0.29, 1e-9);
    EXPECT_NEAR(proportionalLength_m(measures, &BodyMeasures::shoulder_width_m), 0.34, 1e-9);
    EXPECT_NEAR(proportionalLength_m(measures, &BodyMeasures::trunk_m), 0.44, 1e-9);
    EXPECT_NEAR(proportionalLength_m(measures, &BodyMeasures::hip_width_m), 0.18, 1e-9);
    EXPECT_NEAR(proportionalLength_m(measures, &BodyMeasures::foot_m), 0.13, 1e-9);
    EXPECT_NEAR(proportionalLength_m(measures, &BodyMeasures::hand_m), 0.18, 1e-9);
    // Every measure set to its proportion changes nothing.
    BodyMeasures all = measures;
    for (const Measure& measure : bodyMeasures())
        all.*measure.length = proportionalLength_m(measures, measure.length);
    const Actor a = defaultActor(measures), b = defaultActor(all);
    for (int j = 0; j < a.skeleton.size(); ++j)
        EXPECT_LT((a.skeleton.joint(j).offset_m - b.skeleton.joint(j).offset_m).norm(), 1e-9);
    EXPECT_EQ(bodyMeasures().size(), 9u);
}

TEST(BodyMeasuresCheck, DoubtsWhatHardlyAnybodyHas) {
    BodyMeasures measures;
    EXPECT_EQ(doubtAbout(measures, &BodyMeasures::forearm_m), MeasureDoubt::kNone);
    measures.forearm_m = 0.26;
    EXPECT_EQ(doubtAbout(measures, &BodyMeasures::forearm_m), MeasureDoubt::kNone);
    measures.forearm_m = 0.35;
    EXPECT_EQ(doubtAbout(measures, &BodyMeasures::forearm_m), MeasureDoubt::kLong);
    measures.forearm_m = 0.15;
    EXPECT_EQ(doubtAbout(measures, &BodyMeasures::forearm_m), MeasureDoubt::kShort);
}

TEST(BodyMeasuresCheck, LegsAndTrunkMustMakeTheHeight) {
    BodyMeasures measures;
    EXPECT_TRUE(checkHeight(measures).fits);
    measures.thigh_m = 0.45;
    EXPECT_TRUE(checkHeight(measures).fits);
    EXPECT_NEAR(checkHeight(measures).sum_m, 1.77, 1e-9);
    measures.thigh_m = measures.shin_m = 0.51;
    EXPECT_FALSE(checkHeight(measures).fits);
}

}  // namespace
}  // namespace noctule
