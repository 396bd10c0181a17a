// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/pulse_detector.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/acoustics/inflection_detector.h"
#include "core/acoustics/matched_detector.h"

namespace noctule {
namespace {

constexpr double kMinSampleRate_hz = 100e3, kMaxSampleRate_hz = 1e6;
constexpr double kMinInterval_s = 1e-3, kMaxInterval_s = 1;

constexpr double kLongestMatched_s =
    0.45e-3;  // of a burst: the matched detector looks so far before an onset

}  // namespace

Status checkTrain(const PulseTrain& train, Detector detector) {
    const double fs = train.sample_rate_hz, interval_s = train.interval_samples / fs;
    if (!(fs >= kMinSampleRate_hz && fs <= kMaxSampleRate_hz))
        return Error{ErrorKind::kUnusable,
                     "The sample rate of " + std::to_string(std::llround(fs)) +
                         " Hz does not suit 40 kHz pulses (100 kHz to 1 MHz do)",
                     "Check sample_rate_hz; 150000 is usual"};
    if (!(interval_s >= kMinInterval_s && interval_s <= kMaxInterval_s))
        return Error{
            ErrorKind::kUnusable,
            "A pulse interval of " + std::to_string(train.interval_samples) + " samples is not 1 ms to 1 s",
            "Check pulse_interval_samples; 8 ms (1200 at 150 kHz) is usual"};
    if (!(train.drive_hz > 0 && train.cycles > 0))
        return Error{ErrorKind::kUnusable, "The pulses have no drive frequency or no cycles",
                     "Check drive_hz and pulse_cycles; 40000 and 10 are usual"};
    if (detector == Detector::kMatched && train.cycles / train.drive_hz > kLongestMatched_s)
        return Error{ErrorKind::kUnusable,
                     "Pulses of " + std::to_string(train.cycles) +
                         " cycles are too long for the matched detector (0.45 ms at most)",
                     "Use the inflection detector, or shorter pulses; 10 cycles of 40 kHz are usual"};
    return Done{};
}

const char* detectorName(Detector detector) {
    return detector == Detector::kMatched ? "matched" : "inflection";
}

std::optional<Detector> detectorFromName(const std::string& name) {
    for (const Detector detector : {Detector::kInflection, Detector::kMatched})
        if (name == detectorName(detector))
            return detector;
    return std::nullopt;
}

Result<std::unique_ptr<PulseDetector>> makeDetector(Detector detector, const PulseTrain& train,
                                                    const PulseShapes& shapes) {
    if (const Status status = checkTrain(train, detector); !status)
        return status.error();
    if (detector == Detector::kMatched)
        return std::unique_ptr<PulseDetector>(std::make_unique<MatchedDetector>(train, shapes));
    return std::unique_ptr<PulseDetector>(std::make_unique<InflectionDetector>(train));
}

DetectorResponse detectorResponse(PulseDetector& detector, const PulseTrain& train, double resonance_hz,
                                  double q) {
    constexpr int kPositions = 32;  // as many channels, each a fraction of a sample later than the one before
    constexpr double kAmplitude = 2e4;  // counts: far above what rounding adds
    const PulseModel pulse(train, resonance_hz, q);
    const int margin = detector.marginSamples();
    std::vector<int16_t> window(size_t(detector.windowSamples()) * kPositions);
    for (size_t i = 0; i < window.size(); ++i) {
        const double delay_samples = double(i % kPositions) / kPositions;
        const double u_s = (double(i / kPositions) - margin - delay_samples) / train.sample_rate_hz;
        window[i] = int16_t(std::lround(kAmplitude * pulse.at(u_s)));
    }
    std::vector<PulseArrival> arrivals(kPositions);
    detector.detect(window, arrivals);
    double sum = 0, sum_squared = 0;
    for (int i = 0; i < kPositions; ++i) {
        const double delay = arrivals[i].sample - double(i) / kPositions;
        sum += delay;
        sum_squared += delay * delay;
    }
    const double mean = sum / kPositions;
    const double variance = std::max(0.0, sum_squared / kPositions - mean * mean);
    return {mean / train.sample_rate_hz, std::sqrt(variance) / train.sample_rate_hz};
}

}  // namespace noctule
