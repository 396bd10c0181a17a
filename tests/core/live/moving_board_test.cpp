// SPDX-License-Identifier: Apache-2.0
#include "core/live/moving_board.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/suit/default_suit.h"

namespace noctule {
namespace {

constexpr int kBoardRate_hz = 150000;

/// Seconds in which board 5 swings with one amplitude and all others with another.
std::optional<int> foundAfter(double seconds, double swing_rad_per_s, double others_rad_per_s) {
    const Suit suit = defaultSuit();
    MovingBoard finder(suit, kBoardRate_hz);
    for (int frame = 0; frame < seconds * kInertialFramesPerSecond; ++frame)
        for (int board = 0; board < static_cast<int>(suit.boards.size()); ++board) {
            InertialReading reading;
            reading.board = board;
            reading.sample = frame * static_cast<double>(kBoardRate_hz) / kInertialFramesPerSecond;
            const double swing = (board == 5 ? swing_rad_per_s : others_rad_per_s) * std::sin(frame * 0.05);
            for (size_t axis = 0; axis < 3; ++axis)
                reading.counts[axis] = 2048 + (axis == 1 ? std::round(swing / 17.5 * 2048) : 0);
            reading.corrected_bits = 0;
            finder.add(reading);
            finder.add(reading);
        }
    return finder.found();
}

TEST(MovingBoard, IsTheOneThatTurnsMost) {
    EXPECT_EQ(foundAfter(3, 4, 0.05), 5);
    EXPECT_EQ(foundAfter(3, 4, 1.5), 5);
}

TEST(MovingBoard, NobodyIsNamedWhileAllStandStillOrAllMove) {
    EXPECT_FALSE(foundAfter(3, 0.1, 0.02));
    EXPECT_FALSE(foundAfter(3, 4, 3.5));
    EXPECT_FALSE(foundAfter(0.05, 8, 0.01)) << "too early to be sure";
}

TEST(MovingBoard, LostReadingsSayNothing) {
    MovingBoard finder(defaultSuit(), kBoardRate_hz);
    InertialReading lost;
    for (int frame = 1; frame < 500; ++frame) {
        lost.sample = frame * 1000;
        finder.add(lost);
    }
    EXPECT_FALSE(finder.found());
}

}  // namespace
}  // namespace noctule
