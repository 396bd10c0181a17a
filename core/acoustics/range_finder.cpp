// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/range_finder.h"

#include <algorithm>
#include <cmath>

namespace noctule {
namespace {

/// sigma_t^2 = scatter^2 + (kNoise_s / snr)^2. Measured on synthetic pulses (pulse model, white noise of 8
/// counts rms between 37.5 and 42.5 kHz, snr 15 to 750, 1920 pulses each): deviation * snr is 1.37e-4 s for a
/// resonance with Q 15 and up to 1.72e-4 s for Q 35, whatever the snr. The test repeats it.
constexpr double kNoise_s = 1.55e-4;

constexpr double kTypicalResonance_hz = 40000, kTypicalQ = 25;

std::optional<double> find(const std::map<std::string, double>& values, const std::string& name) {
    const auto found = values.find(name);
    return found == values.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

Result<RangeFinder> RangeFinder::create(const Suit& suit, const Calibration& calibration,
                                        const PulseTrain& train, Detector detector,
                                        const RangeSettings& settings) {
    auto made = makeDetector(detector, train);
    if (!made)
        return made.error();
    RangeFinder finder(suit, calibration, train, settings);
    for (const Source& source : suit.sources)
        finder.timeSource(source.id, calibration, detectorName(detector), *made.value(), train);
    return finder;
}

RangeFinder::RangeFinder(const Suit& suit, const Calibration& calibration, const PulseTrain& train,
                         const RangeSettings& settings)
    : settings_(settings),
      sample_rate_hz_(train.sample_rate_hz),
      sound_speed_(calibration.sound),
      neighbours_(suit.sources.size() * suit.boards.size()) {
    for (const Board& board : suit.boards) {
        const BoardCalibration* known = calibration.findBoard(board.id);
        mic_delay_s_.push_back(known ? known->mic_delay_s : 0);
    }
}

void RangeFinder::timeSource(const std::string& id, const Calibration& calibration,
                             const std::string& detector_name, PulseDetector& detector,
                             const PulseTrain& train) {
    const SourceCalibration* known = calibration.findSource(id);
    const bool resonator =
        known && known->resonance_hz && known->q && *known->resonance_hz > 0 && *known->q > 0;
    const auto offset_s = known ? find(known->offsets_s, detector_name) : std::nullopt;
    const auto start_s = known ? find(known->offsets_s, "start") : std::nullopt;
    const DetectorResponse response =
        resonator ? detectorResponse(detector, train, *known->resonance_hz, *known->q)
                  : detectorResponse(detector, train, kTypicalResonance_hz, kTypicalQ);
    if (offset_s)
        sources_.push_back(SourceTiming{*offset_s, response.scatter_s});
    else if (start_s && resonator)
        sources_.push_back(SourceTiming{*start_s + response.delay_s, response.scatter_s});
    else {
        problems_.push_back(
            {int(sources_.size()), "Source " + id + " yields no ranges: the calibration has " +
                                       (known ? "neither its offset for detector " + detector_name +
                                                    " nor its start, resonance_hz and q"
                                              : "no such source")});
        sources_.push_back(std::nullopt);
    }
}

std::optional<RangeMeasurement> RangeFinder::process(const PulseDetection& detection) {
    const Pulse& pulse = detection.pulse;
    if (detection.gap || detection.clipped || pulse.source < 0 || pulse.source >= int(sources_.size()) ||
        detection.board < 0 || detection.board >= int(mic_delay_s_.size()) || !sources_[pulse.source] ||
        !(detection.snr() >= settings_.min_snr))
        return std::nullopt;
    const SourceTiming& timing = *sources_[pulse.source];
    const double c = sound_speed_.at(pulse.sample);
    const double flight_s = (detection.arrival_sample - double(pulse.sample)) / sample_rate_hz_ -
                            timing.offset_s - mic_delay_s_[detection.board];
    RangeMeasurement range{.pulse = pulse.id, .pulse_sample = pulse.sample, .source = pulse.source};
    range.board = detection.board;
    range.arrival_sample = detection.arrival_sample;
    range.distance_m = c * flight_s;
    if (!(range.distance_m >= settings_.min_distance_m && range.distance_m <= settings_.max_distance_m))
        return std::nullopt;
    auto& neighbour = neighbours_[size_t(pulse.source) * mic_delay_s_.size() + size_t(detection.board)];
    range.w_s = strengthConfidence(detection.peak_power, range.distance_m);
    range.w_t = continuityConfidence(neighbour, range);
    range.sigma_m = c * std::hypot(timing.scatter_s, kNoise_s / detection.snr());
    neighbour = Neighbour{pulse.sample, range.distance_m};
    return range;
}

double RangeFinder::strengthConfidence(double peak_power, double distance_m) const {
    const double strength = peak_power * distance_m * distance_m;
    if (strength >= settings_.full_strength)
        return 1;
    const double deficit_db = 10 * std::log10(settings_.full_strength / strength);
    const double falls = deficit_db / settings_.strength_fall_db;
    return 1 / (1 + falls * falls);
}

double RangeFinder::continuityConfidence(const std::optional<Neighbour>& previous,
                                         const RangeMeasurement& range) const {
    if (!previous)
        return 1;
    const double pause_s = double(range.pulse_sample - previous->pulse_sample) / sample_rate_hz_;
    if (pause_s > settings_.max_pause_s)
        return 1;
    const double plausible_m = settings_.max_speed_m_per_s * pause_s;
    const double change_m = std::abs(range.distance_m - previous->distance_m);
    return change_m <= plausible_m ? 1 : std::max(0.0, 2 - change_m / plausible_m);
}

}  // namespace noctule
