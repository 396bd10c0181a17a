// SPDX-License-Identifier: Apache-2.0
// Finds the first arrival of a known pulse: at the first rise that matters (BurstFinder) the pulse is fitted
// to the sound's baseband, with an echo close behind it where one path does not explain what was heard.
// Reports the pulse's first motion, so its offset at distance 0 is the calibration's `start` and nothing
// else, by the envelope and, up to whole cycles, by the phase of the carrier.
//
// Only what has arrived by 0.4 ms after the first motion is looked at: later sound adds 1 to 5 % to the
// accuracy and most of the echoes. The Doppler effect is fitted too (5 m/s are a quarter of a cycle over the
// pulse), held by how fast the pair's onsets have been moving.
#pragma once

#include <optional>
#include <vector>

#include "core/acoustics/burst_finder.h"
#include "core/acoustics/noise_floor.h"
#include "core/acoustics/path_fit.h"
#include "core/acoustics/pulse_detector.h"

namespace noctule {

class MatchedDetector final : public PulseDetector {
public:
    /// `train` as makeDetector() checks it; shapes by source.
    MatchedDetector(const PulseTrain& train, const PulseShapes& shapes);

    int marginSamples() const override { return finder_.marginSamples(); }
    int windowSamples() const override { return finder_.windowSamples(); }
    void detect(std::span<const int16_t> window, std::span<PulseArrival> boards, const Pulse& pulse) override;

private:
    struct Known {
        PulseTemplate pulse;
        double rise = 0;  ///< of its bursts, after the first motion; samples
    };
    /// What came last from a source to a board.
    struct Heard {
        int64_t pulse_sample;
        double onset;
    };

    double ambientPower(int board);
    PulseArrival find(const Known& known, int board, double ambient_power, const Pulse& pulse);
    StretchPrior stretchAt(const Pulse& pulse, int board, double onset) const;

    double sample_rate_hz_, drive_;  // drive: rad per sample
    BurstFinder finder_;
    std::vector<std::optional<Known>> sources_;
    std::vector<NoiseFloor> noise_;            // per board: counts^2 of one output
    std::vector<std::optional<Heard>> heard_;  // source * 32 + board
};

}  // namespace noctule
