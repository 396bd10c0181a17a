// SPDX-License-Identifier: Apache-2.0
// A performer who stands in the rest pose, wearing the default suit otherwise than its description says.
#pragma once

#include <functional>

#include "core/math/rotation.h"
#include "core/simulation/random.h"
#include "tests/support/observed_take.h"

namespace noctule::test {

inline constexpr double kStanding_s = 3;

/// `wear` changes the request, for instance its suit; the observer knows nothing of that and believes in the
/// default suit and the default actor.
inline Result<ObservedTake> standing(uint64_t seed,
                                     const std::function<void(simulation::StageRequest&)>& wear = {}) {
    simulation::StageRequest request = stageOf(std::nullopt, seed);
    request.duration_s = kStanding_s;
    if (wear)
        wear(request);
    auto take = observe(request);
    if (take) {
        take->observations.suit = defaultSuit();
        take->observations.actor = defaultActor();
    }
    return take;
}

/// Every board off by exactly this angle about a random axis.
inline void turnBoards(Suit& suit, double angle_rad, uint64_t seed) {
    simulation::Random random(seed, "boards off");
    for (Board& board : suit.boards)
        board.q_segment_board = board.q_segment_board * axisAngle(random.direction(), angle_rad);
}

/// Worn the one as the other; every board keeps its own readings and calibration.
inline void exchangePlaces(Suit& suit, int a, int b) {
    Board &first = suit.boards[static_cast<size_t>(a)], &second = suit.boards[static_cast<size_t>(b)];
    std::swap(first.segment, second.segment);
    std::swap(first.p_segment_board_m, second.p_segment_board_m);
    std::swap(first.q_segment_board, second.q_segment_board);
}

/// Plugged in the one as the other: the readings come with the other's calibration.
inline void exchangePlugs(Observations& take, int a, int b) {
    std::swap(take.boards[static_cast<size_t>(a)], take.boards[static_cast<size_t>(b)]);
    for (FlightTime& flight : take.flights)
        flight.board = flight.board == a ? b : flight.board == b ? a : flight.board;
}

/// Two different boards.
inline std::pair<int, int> anyTwo(uint64_t seed, int boards) {
    simulation::Random random(seed, "any two");
    const auto a = static_cast<int>(random.below(boards));
    const auto b = static_cast<int>(random.below(boards - 1));
    return {std::min(a, b + (b >= a)), std::max(a, b + (b >= a))};
}

}  // namespace noctule::test
