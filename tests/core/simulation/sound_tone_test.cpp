// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/sound_tone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace noctule::simulation {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

/// The resonator by force: the drive convolved with a exp(-a t) exp(i 2 pi f t), whose imaginary part answers
/// it.
double convolved(double u, double drive_hz, int cycles, double resonance_hz, double q) {
    const double a = pi * resonance_hz / q, end = std::min(u, cycles / drive_hz);
    constexpr int kSteps = 20000;
    const double step = end / kSteps;
    Complex sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double v = (i + 0.5) * step;
        sum += std::exp(Complex(0, 2 * pi * drive_hz * v)) * a *
               std::exp(Complex(-a, 2 * pi * resonance_hz) * (u - v)) * step;
    }
    return sum.imag();
}

TEST(ReceivedPulse, IsTheDriveThroughTheResonator) {
    const ToneSum pulse = receivedPulse(40000, 10, 40450, 31);
    const double scale = toneValue(pulse, 2.4e-4) / convolved(2.4e-4, 40000, 10, 40450, 31);
    for (double u = 3e-6; u < 1e-3; u += 7.3e-6)
        EXPECT_NEAR(toneValue(pulse, u), scale * convolved(u, 40000, 10, 40450, 31), 1e-5) << u;
}

TEST(ReceivedPulse, PeaksAtOneAndBeginsAtZero) {
    for (const double q : {15.0, 25.0, 35.0}) {
        const ToneSum pulse = receivedPulse(40000, 10, 39800, q);
        double peak = 0;
        for (double u = 0; u < 1e-3; u += 2e-8)
            peak = std::max(peak, std::abs(toneValue(pulse, u)));
        EXPECT_NEAR(peak, 1, 1e-4);
        EXPECT_NEAR(toneValue(pulse, 0), 0, 1e-12);
        EXPECT_EQ(toneValue(pulse, -1e-6), 0);
        const double end = 10 / 40000.0;
        EXPECT_NEAR(toneValue(pulse, end - 1e-12), toneValue(pulse, end + 1e-12), 1e-6);
    }
}

TEST(AddTones, SamplesTheDefinition) {
    const ToneSum pulse = receivedPulse(40000, 10, 40450, 31);
    const Placement placement{.begin_sample = 123.4, .samples_per_second = 149000, .gain = 1500};
    std::vector<float> samples(10, 1.0f);
    addTones(pulse, placement, samples);
    ASSERT_GT(samples.size(), 500u);
    for (size_t i = 0; i < samples.size(); ++i) {
        const double u = (static_cast<double>(i) - placement.begin_sample) / placement.samples_per_second;
        EXPECT_NEAR(samples[i], 1500 * toneValue(pulse, u) + (i < 10 ? 1 : 0), 1e-3) << i;
    }
    // What was left off at the end would have been inaudible.
    const double u_end =
        (static_cast<double>(samples.size()) - placement.begin_sample) / placement.samples_per_second;
    EXPECT_LT(1500 * std::abs(toneValue(pulse, u_end)), 0.06);
}

TEST(AddTones, IgnoresWhatLiesBeforeTheBuffer) {
    const ToneSum pulse = receivedPulse(40000, 10, 40000, 25);
    std::vector<float> samples;
    addTones(pulse, {.begin_sample = -50.25, .samples_per_second = 150000, .gain = 100}, samples);
    ASSERT_FALSE(samples.empty());
    for (size_t i = 0; i < samples.size(); ++i)
        EXPECT_NEAR(samples[i], 100 * toneValue(pulse, (static_cast<double>(i) + 50.25) / 150000), 1e-4);
}

TEST(AddTones, ASilentSoundAddsNothing) {
    std::vector<float> samples;
    addTones(receivedPulse(40000, 10, 40000, 25), {.samples_per_second = 150000, .gain = 0}, samples);
    EXPECT_TRUE(samples.empty());
}

}  // namespace
}  // namespace noctule::simulation
