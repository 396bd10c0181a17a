// SPDX-License-Identifier: Apache-2.0
// One board's sound of one pulse window, taken to baseband, and the first rise in it that matters. It is
// sought in the power of the sum over as long as the drive lasts: nearly the pulse's own filter, for the
// price of two additions. A rise matters when its peak has a tenth of the amplitude of the loudest and stands
// out of the noise: a resonator's pulse has nothing before its rise that could be mistaken for one.
#pragma once

#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "core/acoustics/baseband_filter.h"
#include "core/acoustics/path_fit.h"

namespace noctule {

class BurstFinder {
public:
    explicit BurstFinder(const PulseTrain& train);

    int marginSamples() const { return margin_; }
    int windowSamples() const { return window_; }
    const BasebandFilter& filter() const { return filter_; }

    /// A window, sample-interleaved.
    void load(std::span<const int16_t> window, size_t boards);
    /// What follows is of this board until the next.
    void hear(size_t board);
    bool clipped() const { return clipped_; }
    std::span<const std::complex<float>> baseband() const { return baseband_; }
    /// When an output of the filter is, in samples since the pulse's emission.
    double instant(double output) const { return first_instant_ + output * filter_.factor(); }
    /// What is looked at of a pulse that begins about there: 0.25 ms before it, 0.4 ms of it.
    Baseband around(double onset, double noise_power) const;

    /// counts^2 of one complex output: of the window's quietest quarter, taken as Gaussian noise; at least
    /// that of rounding.
    double noisePower();
    /// `noise_power` of an output, as real noise between 37.5 and 42.5 kHz.
    double inBand(double noise_power) const;

    struct Rise {
        double instant = 0;  ///< where a quarter of the peak's power is passed
        double power = 0;    ///< of the peak
    };
    std::optional<Rise> firstRise(double noise_power) const;
    /// How long after the first motion a pulse of this shape rises.
    double riseOf(const PulseTemplate& pulse);

private:
    size_t outputAt(double instant) const;
    void sumBursts();
    Rise riseBefore(size_t peak) const;

    double sample_rate_hz_;
    BasebandFilter filter_;
    int margin_, window_;
    size_t burst_;
    double first_instant_;
    bool clipped_ = false;
    std::vector<int16_t> planes_;  // the window, board after board
    std::vector<std::complex<float>> baseband_;
    std::vector<float> power_, quiet_;  // of bursts, by their first output
};

}  // namespace noctule
