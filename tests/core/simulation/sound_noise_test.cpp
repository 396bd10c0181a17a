// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/sound_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "core/simulation/sound_click.h"
#include "tests/support/rate.h"

namespace noctule::simulation {
namespace {

using test::kRate_hz;

/// Rms of what lies between two frequencies, from the discrete Fourier transforms of pieces of 20 ms.
double bandRms(const std::vector<float>& samples, double low_hz, double high_hz) {
    constexpr size_t kLength = 3000;
    double power = 0;
    const size_t pieces = samples.size() / kLength;
    for (size_t piece = 0; piece < pieces; ++piece) {
        for (auto bin = static_cast<int>(low_hz / kRate_hz * kLength); bin < high_hz / kRate_hz * kLength;
             ++bin) {
            const std::complex<double> step = std::polar(1.0, -2 * std::numbers::pi * bin / kLength);
            std::complex<double> sum = 0, turn = 1;
            for (size_t i = 0; i < kLength; ++i) {
                sum += static_cast<double>(samples[piece * kLength + i]) * turn;
                turn = {turn.real() * step.real() - turn.imag() * step.imag(),
                        turn.real() * step.imag() + turn.imag() * step.real()};
            }
            power += std::norm(sum) * (bin == 0 ? 1 : 2) / (1.0 * kLength * kLength);
        }
    }
    return std::sqrt(power / static_cast<double>(pieces));
}

std::vector<float> noise(const AmbientNoise::Levels& levels, size_t count, int board = 0) {
    AmbientNoise source(levels, kRate_hz, 2, 17);
    std::vector<float> samples(count);
    source.add(board, samples);
    return samples;
}

TEST(AmbientNoise, HasTheStatedLevelInEachBand) {
    const std::vector<float> nominal = noise({8, 30}, 150000);
    EXPECT_NEAR(bandRms(nominal, 37500, 42500), 8, 0.02 * 8);
    EXPECT_NEAR(bandRms(nominal, 0, 13000), 30, 0.02 * 30);
    const std::vector<float> realistic = noise({15, 30}, 150000);
    EXPECT_NEAR(bandRms(realistic, 37500, 42500), 15, 0.02 * 15);
    EXPECT_NEAR(bandRms(realistic, 0, 13000), 30, 0.02 * 30);
}

TEST(AmbientNoise, KeepsEachPartInItsBand) {
    const std::vector<float> ultrasound = noise({10, 0}, 60000), low = noise({0, 30}, 60000);
    EXPECT_LT(bandRms(ultrasound, 0, 13000), 0.25 * 10);
    EXPECT_LT(bandRms(low, 37500, 42500), 0.03 * 30);
}

TEST(AmbientNoise, IsNormalAndWithoutMemoryOfOtherBoards) {
    for (const AmbientNoise::Levels levels : {AmbientNoise::Levels{8, 0}, AmbientNoise::Levels{0, 30}}) {
        constexpr size_t kCount = 1500000;
        const std::vector<float> a = noise(levels, kCount, 0), b = noise(levels, kCount, 1);
        double m1 = 0, m2 = 0, m4 = 0, both = 0;
        for (size_t i = 0; i < kCount; ++i) {
            m1 += a[i];
            m2 += a[i] * a[i];
            m4 += std::pow(a[i], 4);
            both += a[i] * b[i];
        }
        EXPECT_NEAR(m1 / kCount, 0, 0.01 * std::sqrt(m2 / kCount));
        EXPECT_NEAR(m4 * kCount / (m2 * m2), 3, 0.1);
        EXPECT_NEAR(both / m2, 0, 0.02);
    }
}

TEST(AmbientNoise, PartsDrawFromStreamsOfTheirOwn) {
    const std::vector<float> both = noise({8, 30}, 5000), ultrasound = noise({8, 0}, 5000),
                             low = noise({0, 30}, 5000);
    for (size_t i = 0; i < both.size(); ++i)
        ASSERT_EQ(both[i], ultrasound[i] + low[i]);
}

TEST(AmbientNoise, GoesOnWhereItStopped) {
    AmbientNoise source({8, 30}, kRate_hz, 1, 17);
    const std::vector<float> whole = noise({8, 30}, 1000);
    std::vector<float> first(313), second(687);
    source.add(0, first);
    source.add(0, second);
    first.insert(first.end(), second.begin(), second.end());
    EXPECT_EQ(first, whole);
}

TEST(ClickProcess, ComesAtItsRateInOrder) {
    ClickProcess clicks(2, 3);
    int count = 0;
    double before_s = 0;
    for (double t_s = 0; t_s < 2000; t_s += 0.008) {
        while (const auto click = clicks.nextBefore(t_s + 0.008)) {
            EXPECT_GE(click->t_s, t_s - 1e-9);
            EXPECT_GE(click->t_s, before_s);
            EXPECT_GE(click->from_middle_m.norm(), 0.5);
            EXPECT_LE(click->from_middle_m.norm(), 3);
            before_s = click->t_s;
            ++count;
        }
    }
    EXPECT_NEAR(count, 4000, 4 * std::sqrt(4000.0));
    EXPECT_FALSE(ClickProcess(0, 3).nextBefore(1e9).has_value());
}

TEST(ClickProcess, ShapesDoNotDependOnTheRate) {
    const auto rare = ClickProcess(0.2, 3).nextBefore(1e9), often = ClickProcess(5, 3).nextBefore(1e9);
    EXPECT_NE(rare->t_s, often->t_s);
    EXPECT_EQ(rare->from_middle_m, often->from_middle_m);
    EXPECT_EQ(rare->tones[0].amplitude, often->tones[0].amplitude);
}

}  // namespace
}  // namespace noctule::simulation
