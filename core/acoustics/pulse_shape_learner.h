// SPDX-License-Identifier: Apache-2.0
// Learns the sources' pulses (resonance and quality, see PulseModel) from sound: of each source it keeps the
// loudest first arrivals, at most a few of one board so that no single echo is in many of them, and finds the
// resonator that explains them best. The better half of them decides: the others are overlapped by echoes or
// move. Stands in a PulseReceiver like any detector; itself it reports nothing.
#pragma once

#include <vector>

#include "core/acoustics/burst_finder.h"
#include "core/acoustics/pulse_detector.h"

namespace noctule {

class PulseShapeLearner final : public PulseDetector {
public:
    /// `train` as makeDetector() checks it.
    PulseShapeLearner(const PulseTrain& train, int sources);

    int marginSamples() const override { return finder_.marginSamples(); }
    int windowSamples() const override { return finder_.windowSamples(); }
    void detect(std::span<const int16_t> window, std::span<PulseArrival> boards, const Pulse& pulse) override;

    /// None for a source that was heard clearly less than six times. Takes about 0.1 s per source.
    PulseShapes learn() const;

private:
    struct Arrival {
        int board = 0;
        double power = 0, rise = 0, first = 0, noise_power = 0;
        std::vector<std::complex<float>> baseband;
    };
    void keep(std::vector<Arrival>& arrivals, Arrival arrival) const;
    double misfit(const std::vector<Arrival>& arrivals, const PulseShape& shape) const;
    PulseShape fit(const std::vector<Arrival>& arrivals) const;

    PulseTrain train_;
    BurstFinder finder_;
    std::vector<std::vector<Arrival>> sources_;
};

}  // namespace noctule
