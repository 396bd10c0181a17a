// SPDX-License-Identifier: Apache-2.0
// The sound of one board, shifted from the drive's frequency to zero and thinned out: complex, about 25 kHz
// instead of 150 kHz of real samples, flat within 3.5 kHz of the drive, 60 dB down where thinning would fold
// something into that band (the boards' digital stream below 13 kHz lies there too). Filter, mixer and
// decimator are one: only the outputs that stay are ever computed (polyphase), in 16-bit integers whose
// products the compiler sums eight at a time.
#pragma once

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

#include "core/acoustics/pulse_model.h"

namespace noctule {

class BasebandFilter {
public:
    explicit BasebandFilter(const PulseTrain& train);

    /// Samples from one output to the next.
    int factor() const { return factor_; }
    /// Where the first output lies, in samples after the first input: the filter's middle.
    double delay() const { return (static_cast<double>(taps_) - 1) / 2; }
    int outputs(int inputs) const { return inputs < taps_ ? 0 : (inputs - taps_) / factor_ + 1; }
    /// Of white noise of density 1 per Hz: 25 kHz outputs hold this much.
    double noiseBandwidth_hz() const { return noise_bandwidth_hz_; }

    /// A tone a sin(2 pi drive t + p), t from the sample `origin`, becomes a exp(i p). out.size() outputs.
    void run(std::span<const int16_t> samples, double origin, std::span<std::complex<float>> out) const;

    /// The low-pass, one weight per sample; their sum is 1.
    const std::vector<double>& weights() const { return weights_; }

private:
    double rad_per_sample_;
    int factor_, taps_;
    double noise_bandwidth_hz_ = 0, scale_ = 1;
    std::vector<double> weights_;            ///< the low-pass, sum 1
    std::vector<int16_t> real_, imaginary_;  /// the low-pass times the mixer
};

}  // namespace noctule
