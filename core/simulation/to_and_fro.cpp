// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/to_and_fro.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/fade.h"

namespace noctule::simulation {
namespace {

/// Of a turn's length: how far it leads beyond where it begins, its middle (below).
constexpr double kReach = 0.34375;

/// On the way towards a turn of length 1, x of it gone: the rate 1 fades to -1, and this is its integral.
double wayInTurn(double x) {
    return x - x * x * x * x * (5 + x * (-6 + 2 * x));
}

}  // namespace

PlayedTime toAndFro(double t_s, double once_s) {
    const double turning_s = std::min(kTurning_s, once_s), reach_s = kReach * turning_s;
    const double straight_s = once_s - 2 * reach_s, half_s = straight_s + turning_s;
    const double first_turn_s = once_s - reach_s;
    if (t_s <= first_turn_s)
        return {t_s, 1, 0};
    const double since_s = t_s - first_turn_s;
    const bool at_end = std::fmod(since_s, 2 * half_s) < half_s;
    const double within_s = std::fmod(since_s, half_s);
    const double from_s = at_end ? first_turn_s : reach_s, forth = at_end ? 1 : -1;
    if (within_s >= turning_s)
        return {from_s - forth * (within_s - turning_s), -forth, 0};
    const Jet faded = fadeWeight<Jet>(within_s, turning_s);
    return {from_s + forth * turning_s * wayInTurn(within_s / turning_s), forth * (1 - 2 * faded.value),
            forth * -2 * faded.rate};
}

}  // namespace noctule::simulation
