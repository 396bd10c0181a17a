// SPDX-License-Identifier: Apache-2.0
// Offsets, speed of sound and delays of microphones against values that are known, and what one measurement
// left out leaves.
#include "core/calibration/source_offsets/offset_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/simulation/random.h"

namespace noctule {
namespace {

constexpr int kSources = 4, kBoards = 6, kPlacements = 3;
constexpr double kNoise_s = 3e-7, kStretch = 2e-3, kPlacement = 3e-4, kMic_s = 1e-6;

/// Every source heard by every board in every placement; each effect drawn as the settings expect it.
struct KnownOffsets {
    std::vector<double> offset_s, mic_s;
    double stretch = 0;
    std::vector<OffsetSample> samples;

    KnownOffsets(uint64_t seed, double noise_s, const OffsetFitSettings& settings) {
        simulation::Random random(seed, "known offsets");
        for (int s = 0; s < kSources; ++s)
            offset_s.push_back(random.uniform(2e-5, 8e-5));
        for (int b = 0; b < kBoards; ++b)
            mic_s.push_back(random.gaussian(settings.mic_sigma_s));
        stretch = random.gaussian(settings.stretch_sigma);
        for (int p = 0; p < kPlacements; ++p) {
            const double excess = stretch + random.gaussian(settings.placement_sigma);
            for (int s = 0; s < kSources; ++s)
                for (int b = 0; b < kBoards; ++b) {
                    OffsetSample sample{s, b, p, random.uniform(1e-3, 4e-3), 0, kNoise_s};
                    sample.delay_s = offset_s[static_cast<size_t>(s)] + mic_s[static_cast<size_t>(b)] +
                                     excess * sample.travel_s + random.gaussian(noise_s);
                    samples.push_back(sample);
                }
        }
    }
};

OffsetFitSettings tolerant() {
    return {kSources, kBoards, kPlacements, kStretch, false, kPlacement, kMic_s, false};
}

TEST(OffsetFit, IsExactWithoutNoise) {
    OffsetFitSettings settings{kSources, kBoards, kPlacements, kStretch, true, 0, 0, false};
    const KnownOffsets truth(1, 0, settings);
    settings.stretch_sigma = 1;
    const OffsetFit fit = fitOffsets(truth.samples, settings);
    for (size_t s = 0; s < kSources; ++s)
        EXPECT_NEAR(fit.offset_s[s], truth.offset_s[s], 1e-9);
    EXPECT_NEAR(fit.stretch, truth.stretch, 1e-6);
    EXPECT_GT(std::abs(truth.stretch), 1e-4) << "else the test shows nothing";
}

TEST(OffsetFit, SigmasAreHonest) {
    constexpr int kRuns = 400;
    double offsets = 0, stretches = 0;
    for (int run = 1; run <= kRuns; ++run) {
        const KnownOffsets truth(static_cast<uint64_t>(run), kNoise_s, tolerant());
        const OffsetFit fit = fitOffsets(truth.samples, tolerant());
        for (size_t s = 0; s < kSources; ++s)
            offsets += std::pow((fit.offset_s[s] - truth.offset_s[s]) / fit.offset_sigma_s[s], 2) / kSources;
        stretches += std::pow((fit.stretch - truth.stretch) / fit.stretch_sigma, 2);
    }
    // The sources of one run err nearly alike: 3 sigma of one a run.
    EXPECT_NEAR(offsets / kRuns, 1, 3 * std::sqrt(2.0 / kRuns));
    EXPECT_NEAR(stretches / kRuns, 1, 3 * std::sqrt(2.0 / kRuns));
}

TEST(OffsetFit, WhatIsLeftOutIsThatOfAFitWithoutIt) {
    KnownOffsets truth(5, kNoise_s, tolerant());
    for (OffsetSample& sample : truth.samples)
        sample.sigma_s = 100 * kNoise_s;  // no weight and no spread depends on the one
    const OffsetFitSettings settings{kSources, kBoards, kPlacements, 1, true, 0.1, 1e-3, true};
    const OffsetFit whole = fitOffsets(truth.samples, settings);
    double largest_s = 0;
    for (size_t i = 0; i < truth.samples.size(); i += 7) {
        std::vector<OffsetSample> others = truth.samples;
        others[i].left_out = true;
        const OffsetFit without = fitOffsets(others, settings);
        EXPECT_EQ(without.weight[i], 0);
        EXPECT_NEAR(whole.left_out_s[i], without.residual_s[i], 1e-11) << "sample " << i;
        largest_s = std::max(largest_s, std::abs(whole.left_out_s[i] - whole.residual_s[i]));
    }
    EXPECT_GT(largest_s, 1e-8) << "else the test shows nothing";
}

TEST(OffsetFit, AWildMeasurementHasNoSay) {
    KnownOffsets truth(6, kNoise_s, tolerant());
    truth.samples[10].delay_s += 1e-4;  // 3 cm
    std::vector<OffsetSample> others = truth.samples;
    others[10].left_out = true;
    const OffsetFit fit = fitOffsets(truth.samples, tolerant()), without = fitOffsets(others, tolerant());
    EXPECT_EQ(fit.weight[10], 0);
    for (size_t s = 0; s < kSources; ++s)
        EXPECT_NEAR(fit.offset_s[s], without.offset_s[s], 0.1 * fit.offset_sigma_s[s]);
    EXPECT_NEAR(fit.left_out_s[10], without.residual_s[10], 1e-7);
    EXPECT_GT(fit.left_out_s[10], 9e-5);
}

}  // namespace
}  // namespace noctule
