// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/carrier_cycle.h"

#include <cmath>
#include <limits>

namespace noctule {
namespace {

constexpr int kFarthestCycle = 3;
constexpr double kSureBy = 12;  // twice the logarithm of the odds: 400 to 1

}  // namespace

std::optional<double> carrierDistance(const CarrierRange& carrier, double expected_m, double variance_m2) {
    if (!(carrier.cycle_m > 0))
        return std::nullopt;
    double best = std::numeric_limits<double>::infinity(), second = best, chosen_m = 0;
    for (int cycle = -kFarthestCycle; cycle <= kFarthestCycle; ++cycle) {
        const double distance_m = carrier.distance_m + cycle * carrier.cycle_m;
        const double from_envelope = (distance_m - carrier.envelope_m) / carrier.envelope_sigma_m;
        const double from_pose = distance_m - expected_m;
        const double against = from_envelope * from_envelope + from_pose * from_pose / variance_m2;
        if (against < best) {
            second = best;
            best = against;
            chosen_m = distance_m;
        } else if (against < second) {
            second = against;
        }
    }
    return second - best > kSureBy ? std::optional(chosen_m) : std::nullopt;
}

}  // namespace noctule
