// SPDX-License-Identifier: Apache-2.0
// Two people with eight housings each, whose boxes' clocks are known to 10 ms: every arrival is given to some
// pulse, as a receiver that knows nothing would.
#include "core/cooperative/coarse_clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/math/conventions.h"

namespace noctule::cooperative {
namespace {

constexpr double kSpeed_m_per_s = 341;  // not what the estimator believes

struct Pair {
    std::vector<Vector3d> first_m, second_m;
};

/// Chest, hands, feet, shoulders and head, facing each other.
Pair standing(double apart_m) {
    Pair pair;
    for (const double side : {1.0, -1.0}) {
        std::vector<Vector3d>& places = side > 0 ? pair.first_m : pair.second_m;
        const double z = side * apart_m / 2;
        places = {{0, 1.3, z},
                  {side * 0.45, 1.0, z - side * 0.2},
                  {-side * 0.35, 0.9, z},
                  {side * 0.15, 0.1, z},
                  {0.1, 1.45, z - 0.1},
                  {-0.1, 1.2, z - 0.1},
                  {0.05, 1.7, z},
                  {-0.12, 0.5, z}};
    }
    return pair;
}

Direction heard(
    const std::vector<Vector3d>& sources_m, const std::vector<Vector3d>& boards_m, double interval_s,
    double ahead_s, unsigned seed,
    const std::function<double(size_t source)>& lost = [](size_t) { return 0.3; }) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise_s(0, 20e-6);
    std::uniform_real_distribution<double> share(0, 1);
    Direction direction;
    direction.interval_s = interval_s;
    direction.places_m = sources_m;
    direction.boards_m = boards_m;
    const auto count = static_cast<int>(sources_m.size());
    for (int housing = 0; housing < count; ++housing)
        direction.board_near.push_back(housing);
    constexpr int kPulses = 120;
    for (int pulse = 0; pulse < kPulses; ++pulse)
        direction.sources.push_back(pulse % count);
    for (int pulse = 0; pulse < kPulses; ++pulse)
        for (int board = 0; board < static_cast<int>(boards_m.size()); ++board) {
            const auto source = static_cast<size_t>(pulse % count);
            const double delay_s =
                (sources_m[source] - boards_m[static_cast<size_t>(board)]).norm() / kSpeed_m_per_s + ahead_s +
                noise_s(random);
            const int late = static_cast<int>(std::floor(delay_s / interval_s));
            if (share(random) > lost(source) && pulse + late >= 0 && pulse + late < kPulses)
                direction.arrivals.push_back({pulse + late, board, delay_s - late * interval_s});
        }
    return direction;
}

TEST(CoarseClock, IsFoundWhateverTheGuessAndTheDistance) {
    for (const double apart_m : {0.6, 1.7, 2.8, 4.0})
        for (const double ahead_s : {-0.0097, -0.0043, 0.0, 0.0021, 0.0088}) {
            const Pair pair = standing(apart_m);
            const auto found = coarseClock(heard(pair.first_m, pair.second_m, 0.008, ahead_s, 1),
                                           heard(pair.second_m, pair.first_m, 0.0082, -ahead_s, 2));
            ASSERT_TRUE(found) << apart_m << " m, " << ahead_s << " s";
            EXPECT_NEAR(found->ahead_s, ahead_s, 50e-6) << apart_m << " m";
            for (int source = 0; source < std::ssize(pair.first_m); ++source)
                for (int board = 0; board < std::ssize(pair.second_m); ++board)
                    EXPECT_NEAR(found->there_s(source, board) * kSpeed_m_per_s,
                                (pair.first_m[static_cast<size_t>(source)] -
                                 pair.second_m[static_cast<size_t>(board)])
                                    .norm(),
                                0.05)
                        << ahead_s << " s";
        }
}

/// Of four sources nobody could tell the order, were their places not known.
TEST(CoarseClock, OfARoomRestsOnItsAnchors) {
    std::vector<Vector3d> anchors_m;
    for (const double x : {-2.3, 2.3})
        for (const double z : {-2.3, 2.3})
            anchors_m.emplace_back(x, 2.7, z);
    for (const double ahead_s : {-0.0046, 0.0003, 0.0041}) {
        const Pair pair = standing(1.1);
        std::vector<Vector3d> believed_m;  // of the body, wherever it stands
        for (const Vector3d& place : pair.first_m)
            believed_m.emplace_back(Eigen::AngleAxisd(2.1, Vector3d::UnitY()) * place +
                                    Vector3d(0.4, 0, -0.7));
        Direction there = heard(pair.first_m, anchors_m, 0.008, ahead_s, 1);
        there.places_m = believed_m;
        there.boards_m = anchors_m;
        Direction back = heard(anchors_m, pair.first_m, 0.0084, -ahead_s, 2);
        back.boards_m = believed_m;
        back.from_room = true;
        Direction silent = back;
        silent.arrivals.clear();
        for (const auto& found : {coarseClock(there, back), coarseClock(there, silent)}) {
            ASSERT_TRUE(found) << ahead_s;
            EXPECT_NEAR(found->ahead_s, ahead_s, 0.0003);
        }
    }
}

/// Sound of one anchor comes within a pulse interval, that of another after two of them.
TEST(CoarseClock, OfARoomKnowsHowFarEachAnchorIs) {
    const std::vector<Vector3d> anchors_m{
        {-2.8, 2.7, -2.2}, {2.9, 2.6, -2.4}, {-2.7, 0.9, 2.5}, {2.6, 2.7, 2.8}};
    const Vector3d stands_m(-1.9, 0, -1.2);
    const Pair pair = standing(1.1);
    std::vector<Vector3d> worn_m;
    for (const Vector3d& place : pair.first_m)
        worn_m.emplace_back(Eigen::AngleAxisd(0.7, Vector3d::UnitY()) * place + stands_m);
    for (const double ahead_s : {-0.0079, 0.0061}) {
        Direction back = heard(anchors_m, worn_m, 0.008, -ahead_s, 3);
        back.boards_m = pair.first_m;  // where the file has the body
        back.from_room = true;
        Direction silent;
        silent.interval_s = 0.008;
        silent.places_m = pair.first_m;
        silent.boards_m = anchors_m;
        const auto found = coarseClock(silent, back);
        ASSERT_TRUE(found) << ahead_s;
        EXPECT_NEAR(found->ahead_s, ahead_s, 0.0003);
        for (int anchor = 0; anchor < std::ssize(anchors_m); ++anchor)
            for (int board = 0; board < std::ssize(worn_m); ++board)
                EXPECT_NEAR(
                    found->back_s(anchor, board) * kSpeed_m_per_s,
                    (worn_m[static_cast<size_t>(board)] - anchors_m[static_cast<size_t>(anchor)]).norm(), 0.1)
                    << anchor << ", " << board;
    }
}

/// Two anchors of four are hardly heard. The cell beside the true place need not have the most votes then: a
/// body once stood 4 m off.
TEST(CoarseClock, OfARoomFindsTheBodyWhereverItStands) {
    const std::vector<Vector3d> anchors_m{
        {2.3, 2.7, 2.3}, {-2.3, 2.7, 2.3}, {-2.3, 2.7, -2.3}, {2.3, 2.7, -2.3}};
    const Pair pair = standing(1.1);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place_m(-2, 2), turn_rad(-3.1, 3.1);
    constexpr double kQuarterSlot_m = 0.7;  // of half a slot an arrival may be early or late
    for (int trial = 0; trial < 40; ++trial) {
        const Vector3d stands_m{place_m(random), 0, place_m(random)};
        const double turn = turn_rad(random);
        std::vector<Vector3d> worn_m;
        for (const Vector3d& place : pair.first_m)
            worn_m.emplace_back(Eigen::AngleAxisd(turn, Vector3d::UnitY()) * place + stands_m);
        const auto seed = static_cast<unsigned>(trial);
        Direction back = heard(anchors_m, worn_m, 0.0082, -0.0019, seed,
                               [](size_t anchor) { return anchor < 2 ? 0.3 : 0.93; });
        back.boards_m = pair.first_m;
        back.from_room = true;
        Direction there = heard(worn_m, anchors_m, 0.008, 0.0019, seed + 100, [](size_t) { return 0.9; });
        there.places_m = pair.first_m;
        CoarseClock known;
        known.ahead_s = 0.0015;
        const auto found = coarseClock(there, back, known);
        ASSERT_TRUE(found) << trial;
        EXPECT_NEAR(found->ahead_s, 0.0019, 0.001) << trial;
        for (int anchor = 0; anchor < std::ssize(anchors_m); ++anchor)
            for (int board = 0; board < std::ssize(worn_m); ++board)
                EXPECT_NEAR(
                    found->back_s(anchor, board) * kSpeed_m_per_s,
                    (worn_m[static_cast<size_t>(board)] - anchors_m[static_cast<size_t>(anchor)]).norm(),
                    kQuarterSlot_m)
                    << trial << ": " << anchor << ", " << board;
    }
}

/// One anchor later and a quarter turn further everything is as before: then only the recorder's guess tells.
TEST(CoarseClock, OfASquareOfAnchorsIsNotGuessedFromOneDirection) {
    std::vector<Vector3d> anchors_m{{2.3, 2.7, 2.3}, {-2.3, 2.7, 2.3}, {-2.3, 2.7, -2.3}, {2.3, 2.7, -2.3}};
    const Pair pair = standing(1.1);
    std::vector<Vector3d> worn_m;
    for (const Vector3d& place : pair.first_m)
        worn_m.emplace_back(Eigen::AngleAxisd(0.4, Vector3d::UnitY()) * place + Vector3d(0.3, 0, -0.9));
    for (const double ahead_s : {0.0, 0.004}) {  // 8 ms on, the next anchor sounds
        Direction back = heard(anchors_m, worn_m, 0.008, -ahead_s, 5);
        back.boards_m = pair.first_m;
        back.from_room = true;
        Direction there = heard(worn_m, anchors_m, 0.0082, ahead_s, 6);
        there.places_m = pair.first_m;
        there.boards_m = anchors_m;
        const auto found = coarseClock(there, back);
        ASSERT_TRUE(found) << ahead_s;
        EXPECT_NEAR(found->ahead_s, ahead_s, 0.0003);
        there.arrivals.clear();
        const auto alone = coarseClock(there, back);
        EXPECT_EQ(alone.has_value(), ahead_s == 0) << "of 0 and 8 ms one can be the guess, of 4 and -4 both";
        EXPECT_NEAR(alone ? alone->ahead_s : ahead_s, ahead_s, 0.0003);
    }
}

TEST(CoarseClock, IsNotGuessedFromOneDirection) {
    const Pair pair = standing(1.5);
    const Direction there = heard(pair.first_m, pair.second_m, 0.008, 0.002, 1);
    Direction silent = there;
    silent.arrivals.clear();
    EXPECT_FALSE(coarseClock(there, silent));
    EXPECT_FALSE(coarseClock(silent, there));
}

TEST(CoarseClock, NoiseIsNoClock) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> delay_s(0, 0.008);
    const Pair pair = standing(1.5);
    Direction there = heard(pair.first_m, pair.second_m, 0.008, 0, 1);
    Direction back = heard(pair.second_m, pair.first_m, 0.0082, 0, 2);
    for (Direction* direction : {&there, &back})
        for (LooseArrival& arrival : direction->arrivals)
            arrival.delay_s = delay_s(random);
    const auto found = coarseClock(there, back);
    EXPECT_FALSE(found) << found->ahead_s << " s, spread " << found->spread_s;
}

}  // namespace
}  // namespace noctule::cooperative
