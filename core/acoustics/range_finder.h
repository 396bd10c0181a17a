// SPDX-License-Identifier: Apache-2.0
// Detections -> distances with confidence (Vlasic 2007, section 4.1). The factor w_a is left at 1: only an
// estimator knows the angle.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/acoustics/pulse_receiver.h"
#include "core/acoustics/speed_of_sound.h"
#include "core/suit/calibration.h"

namespace noctule {

struct RangeSettings {
    /// Amplitude ratio of a pulse to the ambient noise below which nothing was heard. At 8 noise leads the
    /// detector astray (by more than 15 mm) in 2 to 4 % of the pulses, at 11 in 1 %, at 6 in 15 %, from 15 on
    /// never.
    double min_snr = 8;
    /// peak power * distance^2 from which on w_s = 1, counts^2 m^2. A source with 1500 counts at 1 m gives
    /// about 1e6 on its axis. 17 dB less is what direct sound still has 60 to 90 degrees off the axis,
    /// depending on the source; what comes around the body or from a source's back has lost 20 dB and more.
    double full_strength = 2e4;
    /// How far below full_strength w_s has fallen to one half, dB: w_s = 1 / (1 + (deficit / this)^2).
    double strength_fall_db = 3;
    /// Fastest that microphone and source plausibly approach. w_t = 1 for changes up to this * time between
    /// the two neighbouring measurements (0.32 m in 64 ms), then falls linearly to 0 at twice that.
    double max_speed_m_per_s = 5;
    /// Measurements further apart than this are not neighbours: w_t = 1.
    double max_pause_s = 0.25;
    double min_distance_m = 0.03, max_distance_m = 2.75;
};

/// What the calibration knows of the sources' pulses.
std::optional<PulseShape> shapeOf(const SourceCalibration& source);
PulseShapes shapesOf(const Suit& suit, const Calibration& calibration);

/// A source that yields no ranges.
struct SourceProblem {
    int source = 0;
    std::string reason;  ///< names the source
};

class RangeFinder {
public:
    /// A source's offset is the calibration's for this detector; without it, and with resonance and q, the
    /// pulse model turns `start` or another detector's offset into it. Fails (kUnusable) only for a train
    /// that cannot be received.
    static Result<RangeFinder> create(const Suit& suit, const Calibration& calibration,
                                      const PulseTrain& train, Detector detector,
                                      const RangeSettings& settings = {});

    const std::vector<SourceProblem>& problems() const { return problems_; }
    SpeedOfSound& soundSpeed() { return sound_speed_; }

    /// Nothing when the pulse was not heard, or the distance is impossible, or its source has a problem; nor
    /// when the window is clipped, since a pulse at twice full scale seems 4 mm too near. Detections come in
    /// the order of their pulses.
    std::optional<RangeMeasurement> process(const PulseDetection& detection);

private:
    struct SourceTiming {
        double offset_s, scatter_s;
    };
    struct Neighbour {
        int64_t pulse_sample;
        double distance_m;
    };

    RangeFinder(const Suit& suit, const Calibration& calibration, const PulseTrain& train,
                const RangeSettings& settings);
    void timeSource(const std::string& id, const Calibration& calibration, Detector detector,
                    const PulseTrain& train);
    static void addCarrier(const CarrierArrival& arrival, double m_per_sample, RangeMeasurement& range);
    double strengthConfidence(double peak_power, double distance_m) const;
    double continuityConfidence(const std::optional<Neighbour>& previous,
                                const RangeMeasurement& range) const;

    RangeSettings settings_;
    double sample_rate_hz_;
    SpeedOfSound sound_speed_;
    std::vector<std::optional<SourceTiming>> sources_;
    std::vector<double> mic_delay_s_;                   // per board
    std::vector<std::optional<Neighbour>> neighbours_;  // source * boards + board: last range of the pair
    std::vector<SourceProblem> problems_;
};

}  // namespace noctule
