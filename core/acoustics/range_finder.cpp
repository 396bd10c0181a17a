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

constexpr PulseShape kTypicalShape{40000, 25};
/// An envelope names the cycle by itself when half a cycle is four of its sigmas.
constexpr double kSureCycle = 8;

std::optional<double> find(const std::map<std::string, double>& values, const std::string& name) {
    const auto found = values.find(name);
    return found == values.end() ? std::nullopt : std::optional(found->second);
}

/// Of a source whose shape is not known: of a typical one. The matched detector reports the first motion.
DetectorResponse responseTo(const std::optional<PulseShape>& shape, Detector detector,
                            const PulseTrain& train) {
    if (detector == Detector::kMatched)
        return {};
    const auto made = makeDetector(detector, train);
    require(made.ok(), "a train that was received before");
    const PulseShape pulse = shape.value_or(kTypicalShape);
    return detectorResponse(**made, train, pulse.resonance_hz, pulse.q);
}

/// From the drive's start to the first motion, as another detector's offset tells it.
std::optional<double> startOf(const SourceCalibration& known, const std::optional<PulseShape>& shape,
                              const PulseTrain& train) {
    if (const auto start_s = find(known.offsets_s, "start"))
        return start_s;
    for (const Detector other : {Detector::kMatched, Detector::kInflection})
        if (const auto offset_s = find(known.offsets_s, detectorName(other)))
            return *offset_s - responseTo(shape, other, train).delay_s;
    return std::nullopt;
}

}  // namespace

std::optional<PulseShape> shapeOf(const SourceCalibration& source) {
    if (!source.resonance_hz || !source.q || !(*source.resonance_hz > 0 && *source.q > 0))
        return std::nullopt;
    return PulseShape{*source.resonance_hz, *source.q};
}

PulseShapes shapesOf(const Suit& suit, const Calibration& calibration) {
    PulseShapes shapes;
    for (const Source& source : suit.sources) {
        const SourceCalibration* known = calibration.findSource(source.id);
        shapes.push_back(known ? shapeOf(*known) : std::nullopt);
    }
    return shapes;
}

Result<RangeFinder> RangeFinder::create(const Suit& suit, const Calibration& calibration,
                                        const PulseTrain& train, Detector detector,
                                        const RangeSettings& settings) {
    if (const auto made = makeDetector(detector, train); !made)
        return made.error();
    RangeFinder finder(suit, calibration, train, settings);
    for (const Source& source : suit.sources)
        finder.timeSource(source.id, calibration, detector, train);
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

void RangeFinder::timeSource(const std::string& id, const Calibration& calibration, Detector detector,
                             const PulseTrain& train) {
    const SourceCalibration* known = calibration.findSource(id);
    const auto shape = known ? shapeOf(*known) : std::nullopt;
    auto offset_s = known ? find(known->offsets_s, detectorName(detector)) : std::nullopt;
    const DetectorResponse response = responseTo(shape, detector, train);
    if (!offset_s && shape)
        if (const auto start_s = startOf(*known, shape, train))
            offset_s = *start_s + response.delay_s;
    if (offset_s && (shape || detector != Detector::kMatched)) {
        sources_.push_back(SourceTiming{*offset_s, response.scatter_s});
        return;
    }
    const std::string lacks = !known ? "no such source"
                              : !shape && detector == Detector::kMatched
                                  ? "not the shape of its pulse (resonance_hz and q)"
                                  : std::string("neither its offset for detector ") + detectorName(detector) +
                                        " nor its start, resonance_hz and q";
    problems_.push_back(
        {int(sources_.size()), "Source " + id + " yields no ranges: the calibration has " + lacks});
    sources_.push_back(std::nullopt);
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
    range.sigma_m = c * std::hypot(timing.scatter_s, kNoise_s / detection.snr());
    if (detection.carrier)
        addCarrier(*detection.carrier, c / sample_rate_hz_, range);
    auto& neighbour = neighbours_[size_t(pulse.source) * mic_delay_s_.size() + size_t(detection.board)];
    range.w_s = strengthConfidence(detection.peak_power, range.distance_m);
    range.w_t = continuityConfidence(neighbour, range);
    neighbour = Neighbour{pulse.sample, range.distance_m};
    return range;
}

void RangeFinder::addCarrier(const CarrierArrival& arrival, double m_per_sample, RangeMeasurement& range) {
    CarrierRange& carrier = range.carrier;
    carrier.m_per_sample = m_per_sample;
    carrier.cycle_m = m_per_sample * arrival.cycle_samples;
    carrier.distance_m = range.distance_m + m_per_sample * (arrival.sample - range.arrival_sample);
    carrier.sigma_m = m_per_sample * arrival.sigma_samples;
    carrier.envelope_m = range.distance_m;
    carrier.envelope_sigma_m = m_per_sample * arrival.envelope_sigma_samples;
    range.sigma_m = carrier.envelope_sigma_m;
    if (carrier.cycle_m < kSureCycle * carrier.envelope_sigma_m)
        return;
    range.arrival_sample = arrival.sample;
    range.distance_m = carrier.distance_m;
    range.sigma_m = carrier.sigma_m;
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
