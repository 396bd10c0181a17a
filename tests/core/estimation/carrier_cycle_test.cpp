// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/carrier_cycle.h"

#include <gtest/gtest.h>

namespace noctule {
namespace {

constexpr double kCycle_m = 0.0086;

/// True at 0.5 m; the envelope says `pulled_m` more, and the nearest cycle follows it.
CarrierRange heard(double pulled_m, double envelope_sigma_m) {
    CarrierRange carrier;
    carrier.cycle_m = kCycle_m;
    carrier.envelope_m = 0.5 + pulled_m;
    carrier.envelope_sigma_m = envelope_sigma_m;
    carrier.distance_m = 0.5 + kCycle_m * std::round(pulled_m / kCycle_m);
    carrier.sigma_m = 5e-5;
    return carrier;
}

TEST(CarrierCycle, ThePoseMendsAPulledEnvelope) {
    for (const double pulled_m : {-0.010, -0.006, 0.0, 0.003, 0.006, 0.012}) {
        const auto distance_m = carrierDistance(heard(pulled_m, 0.004), 0.501, 1e-6);
        ASSERT_TRUE(distance_m) << pulled_m;
        EXPECT_NEAR(*distance_m, 0.5, 1e-9) << pulled_m;
    }
}

TEST(CarrierCycle, TheEnvelopeMendsAPoorPose) {
    const auto distance_m = carrierDistance(heard(0.0008, 0.0008), 0.55, 0.05 * 0.05);
    ASSERT_TRUE(distance_m);
    EXPECT_NEAR(*distance_m, 0.5, 1e-9);
}

TEST(CarrierCycle, NothingIsSaidInDoubt) {
    EXPECT_FALSE(carrierDistance(heard(0.001, 0.004), 0.55, 0.05 * 0.05));  // neither knows
    EXPECT_FALSE(carrierDistance(heard(0, 0.001), 0.5 + kCycle_m, 1e-6));   // they contradict each other
    EXPECT_FALSE(carrierDistance({}, 0.5, 1e-6));                           // no carrier
}

}  // namespace
}  // namespace noctule
