// SPDX-License-Identifier: Apache-2.0
// The paper's receiver (Vlasic 2007, section 4.1) with zero-phase filters, as core/recording/README.md
// section 5 defines `inflection`: band-pass 37.5..42.5 kHz, square, low-pass 30 kHz, steepest rise of the
// first pulse.
//
// It suits sample rates near 150 kHz: squaring leaves a ripple at 80 kHz, which the low-pass removes only
// where sampling folds it close to half the rate. The scatter over all positions between two samples, without
// noise, is up to 0.06 mm of sound path at 150 kHz and 0.15 mm at 180 kHz, but 1 to 4 mm at 140 kHz and below
// and at 200 kHz and above (detectorResponse() tells it for any rate, and the ranges' sigma includes it).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/acoustics/pulse_detector.h"
#include "core/math/butterworth.h"

namespace noctule {

class InflectionDetector final : public PulseDetector {
public:
    /// `train` as makeDetector() checks it.
    explicit InflectionDetector(const PulseTrain& train);

    int marginSamples() const override { return margin_; }
    int windowSamples() const override { return 2 * margin_ + interval_; }
    void detect(std::span<const int16_t> window, std::span<PulseArrival> boards, const Pulse& pulse) override;

private:
    // Eight boards are filtered side by side, one in each lane. A recursive filter cannot be vectorised along
    // time; across boards it can, and eight single-precision lanes hide the latency of the recursion.
    static constexpr int kLanes = 8;
    using Lanes = Eigen::Array<float, kLanes, 1>;

    void load(std::span<const int16_t> window, size_t boards, size_t first_board);
    void envelope();
    PulseArrival find(int lane);
    double noisePower(int lane);
    float power(int i, int lane) const { return rows_[i][lane]; }
    float slope(int i, int lane) const { return (rows_[i + 1][lane] - rows_[i - 1][lane]) / 2; }

    int interval_, margin_;
    std::vector<Biquad> band_pass_, low_pass_;
    float quadrature_gain_;    // 0: the sound is squared as it is
    std::vector<Lanes> rows_;  // one per sample: sound, then its power envelope
    Lanes loudest_;            // counts, anywhere in the loaded window
    Lanes highest_;            // counts^2, of the envelope in the pulse's interval
    std::vector<float> quiet_;
};

}  // namespace noctule
