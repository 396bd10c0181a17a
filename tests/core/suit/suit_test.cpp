// SPDX-License-Identifier: Apache-2.0
#include "core/suit/suit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <set>

#include "core/suit/default_suit.h"
#include "tests/core/suit/damage.h"

namespace noctule {
namespace {

using namespace test;
using Json = nlohmann::json;

Json smallSuit() {
    return Json::parse(R"({"format": "noctule-suit", "version": 1, "name": "small", "x_shop": [1, 2],
        "boards": [{"id": "chest", "serial": "NB-1", "segment": "Chest", "p_segment_board_m": [0, 0.09, 0.13],
                    "q_segment_board": [1, 0, 0, 0], "stream": "imu9", "p_board_mic_m": [0.01, 0, 0]},
                   {"id": "anchor", "serial": null, "segment": null, "p_segment_board_m": [0, 2, 0],
                    "q_segment_board": [0, 1.001, 0, 0], "colour": "red"}],
        "sources": [{"id": "belly", "segment": "Hips", "p_segment_source_m": [0, 0, 0.1],
                     "normal_segment": [0, 0, 5]}]})");
}

TEST(Suit, ReadsMembersAndDefaults) {
    const Result<Suit> suit = suitFromJson(smallSuit(), "small.json");
    ASSERT_TRUE(suit) << suit.error().text();
    ASSERT_EQ(suit->boards.size(), 2u);
    const Board& chest = suit->boards[0];
    EXPECT_EQ(chest.serial, "NB-1");
    EXPECT_TRUE(chest.has_magnetometer);
    EXPECT_EQ(chest.p_board_mic_m, Vector3d(0.01, 0, 0));
    EXPECT_EQ(chest.gyro_full_scale_rad_per_s, 17.5);
    EXPECT_EQ(chest.accel_full_scale_m_per_s2, 156.9064);
    const Board& anchor = suit->boards[1];
    EXPECT_EQ(anchor.segment, "");
    EXPECT_EQ(anchor.q_segment_board.coeffs(), Quaterniond(0, 1, 0, 0).coeffs());
    EXPECT_EQ(suit->sources[0].normal_segment, Vector3d::UnitZ());
    EXPECT_EQ(suit->sources[0].nominal_hz, 40000);
    EXPECT_EQ(suit->findBoard("anchor"), 1);
    EXPECT_EQ(suit->findBoard("nobody"), -1);
    EXPECT_EQ(suit->findSource("belly"), 0);
    EXPECT_EQ(suit->housings(), std::vector<int>{-1});
    Suit housed = *suit;
    housed.sources[0].board = "anchor";
    EXPECT_EQ(housed.housings(), std::vector<int>{1});
}

TEST(Suit, WriteReadEqual) {
    for (const Json& original : {toJson(defaultSuit()), toJson(*suitFromJson(smallSuit(), "s"))}) {
        const Result<Suit> again = suitFromJson(Json::parse(original.dump()), "again");
        ASSERT_TRUE(again) << again.error().text();
        EXPECT_EQ(toJson(*again), original);
    }
}

class DamagedSuit : public testing::TestWithParam<Damage> {};

TEST_P(DamagedSuit, IsRefusedByName) {
    Json suit = smallSuit();
    suit[Json::json_pointer(GetParam().pointer)] = GetParam().value;
    const Result<Suit> result = suitFromJson(suit, "small.json");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, GetParam().kind) << result.error().text();
    EXPECT_NE(result.error().message.find(GetParam().named), std::string::npos) << result.error().text();
    EXPECT_NE(result.error().message.find("small.json"), std::string::npos);
    EXPECT_FALSE(result.error().remedy.empty());
}

const double kInfinity = std::numeric_limits<double>::infinity();

INSTANTIATE_TEST_SUITE_P(
    All, DamagedSuit,
    testing::Values(
        Damage{"/format", "noctule-actor", ErrorKind::kUnreadable, "is not a suit"},
        Damage{"/version", 2, ErrorKind::kUnreadable, "version"},
        Damage{"/boards", nullptr, ErrorKind::kUnreadable, "boards"},
        Damage{"/boards", "many", ErrorKind::kUnreadable, "boards"},
        Damage{"/boards/0", 7, ErrorKind::kUnreadable, "board 1"},
        Damage{"/boards/1/id", "chest", ErrorKind::kUnusable, "board 2 'chest': 'id' is there twice"},
        Damage{"/boards/1/id", "", ErrorKind::kUnreadable, "board 2"},
        Damage{"/boards/0/segment", 3, ErrorKind::kUnreadable, "segment"},
        Damage{"/boards/0/q_segment_board", Json::array({0, 0, 0, 0}), ErrorKind::kUnreadable,
               "board 1 'chest'"},
        Damage{"/boards/0/q_segment_board", Json::array({1, 0, 0}), ErrorKind::kUnreadable,
               "q_segment_board"},
        Damage{"/boards/0/q_segment_board/2", kNan, ErrorKind::kUnreadable, "q_segment_board"},
        Damage{"/boards/0/p_segment_board_m/1", kInfinity, ErrorKind::kUnreadable, "p_segment_board_m"},
        Damage{"/boards/0/p_segment_board_m/1", "up", ErrorKind::kUnreadable, "p_segment_board_m"},
        Damage{"/boards/0/stream", "imu7", ErrorKind::kUnusable, "stream"},
        Damage{"/boards/0/gyro_full_scale_rad_s", 0, ErrorKind::kUnusable, "gyro_full_scale_rad_s"},
        Damage{"/boards/0/accel_full_scale_m_s2", kNan, ErrorKind::kUnreadable, "accel_full_scale_m_s2"},
        Damage{"/sources/0/normal_segment", Json::array({0, 0, 0}), ErrorKind::kUnusable, "source 1 'belly'"},
        Damage{"/sources/0/nominal_hz", -1, ErrorKind::kUnusable, "nominal_hz"},
        Damage{"/sources/0/serial", 12, ErrorKind::kUnreadable, "serial"}));

TEST(Suit, NeedsASegmentButTakesNull) {
    Json suit = smallSuit();
    suit["boards"][1].erase("segment");
    const Result<Suit> result = suitFromJson(suit, "s");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().message, "s: board 2 'anchor': 'segment' is missing");
}

TEST(Suit, HasAtMost32OfEach) {
    Json suit = smallSuit();
    const Json one = suit["sources"][0];
    for (int i = 1; i < 33; ++i) {
        suit["sources"].push_back(one);
        suit["sources"].back()["id"] = "s" + std::to_string(i);
    }
    EXPECT_FALSE(suitFromJson(suit, "s"));
    suit["sources"].erase(32);
    EXPECT_TRUE(suitFromJson(suit, "s"));
}

TEST(Suit, UnknownSegmentIsNamed) {
    const Suit suit = *suitFromJson(smallSuit(), "s");
    EXPECT_TRUE(checkSegments(suit, {"Hips", "Chest"}, "s"));
    const Status no_chest = checkSegments(suit, {"Hips"}, "take.noctule");
    ASSERT_FALSE(no_chest);
    EXPECT_EQ(no_chest.error().kind, ErrorKind::kUnusable);
    EXPECT_EQ(no_chest.error().message,
              "take.noctule: board 'chest' sits on segment 'Chest', which the actor does not have");
    EXPECT_FALSE(checkSegments(suit, {"Chest"}, "s"));
}

TEST(DefaultSuit, HasTheBoardsAndSourcesOfTheDesign) {
    const Suit suit = defaultSuit();
    EXPECT_EQ(suit.name, "Noctule 18/8");
    std::set<std::string> segments;
    for (const Board& board : suit.boards)
        segments.insert(board.segment);
    std::set<std::string> expected{"Hips", "Spine", "Chest", "Head"};
    for (const std::string side : {"Left", "Right"})
        for (const std::string segment : {"Shoulder", "Arm", "ForeArm", "Hand", "UpLeg", "Leg", "Foot"})
            expected.insert(side + segment);
    EXPECT_EQ(segments, expected);
    EXPECT_EQ(suit.boards.size(), 18u);
    ASSERT_EQ(suit.sources.size(), 8u);
    for (size_t i = 0; i < 7; ++i)
        EXPECT_GT(suit.sources[i].normal_segment.z(), 0.6) << suit.sources[i].id << " looks forward";
    EXPECT_EQ(suit.sources[7].segment, "Head");
    EXPECT_LT(suit.sources[7].normal_segment.y(), -0.99);
}

TEST(DefaultSuit, BoardsPointOutAndMirror) {
    const Suit suit = defaultSuit();
    for (const Board& board : suit.boards) {
        const Vector3d z = board.q_segment_board * Vector3d::UnitZ();
        EXPECT_GT(z.dot(board.p_segment_board_m), 0.02) << board.id;
        if (board.id.rfind("l_", 0) != 0)
            continue;
        const Board& right = suit.boards[static_cast<size_t>(suit.findBoard("r_" + board.id.substr(2)))];
        const Matrix3d mirror = Vector3d(-1, 1, 1).asDiagonal();
        EXPECT_EQ(right.p_segment_board_m, mirror * board.p_segment_board_m);
        for (const Vector3d& axis : {Vector3d(Vector3d::UnitX()), Vector3d(Vector3d::UnitZ())})
            EXPECT_TRUE(
                (right.q_segment_board * axis).isApprox(mirror * (board.q_segment_board * axis), 1e-12));
    }
    const Board& thigh = suit.boards[static_cast<size_t>(suit.findBoard("l_upleg"))];
    EXPECT_TRUE((thigh.q_segment_board * Vector3d::UnitX()).isApprox(-Vector3d::UnitY(), 1e-12));
}

TEST(DefaultSuit, ResourcesHoldTheSame) {
    for (const auto& [name, suit] : {std::pair{"default", defaultSuit()}, std::pair{"paper", paperSuit()}}) {
        std::ifstream file(std::string(NOCTULE_SOURCE_DIR "/resources/suits/") + name + ".json");
        const Json written = Json::parse(file, nullptr, false).flatten();
        const Json expected = toJson(suit).flatten();
        ASSERT_EQ(written.size(), expected.size()) << name << ": should be\n" << toJson(suit).dump(1);
        for (const auto& [member, value] : expected.items()) {
            ASSERT_TRUE(written.contains(member)) << member;
            // The last digit of a square root may differ between processors.
            if (value.is_number())
                EXPECT_NEAR(written[member].get<double>(), value.get<double>(), 1e-12) << member;
            else
                EXPECT_EQ(written[member], value) << member;
        }
    }
}

TEST(PaperSuit, DiffersInRangesOnly) {
    Suit suit = paperSuit();
    EXPECT_EQ(suit.name, "Vlasic 2007");
    for (Board& board : suit.boards) {
        EXPECT_EQ(board.gyro_full_scale_rad_per_s, 6.5);
        EXPECT_DOUBLE_EQ(board.accel_full_scale_m_per_s2, 39.2266);
        board.gyro_full_scale_rad_per_s = 17.5;
        board.accel_full_scale_m_per_s2 = 156.9064;
    }
    suit.name = defaultSuit().name;
    EXPECT_EQ(toJson(suit), toJson(defaultSuit()));
}

}  // namespace
}  // namespace noctule
