// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/matched_detector.h"

#include <cmath>
#include <numbers>

#include "core/suit/suit.h"

namespace noctule {
namespace {

constexpr double kRecent_s = 0.15;
constexpr StretchPrior kUnknownStretch{0, 0.008};  // 2.8 m/s
constexpr double kStretchChange = 0.004;           // between neighbours: 1.4 m/s

size_t pairIndex(const Pulse& pulse, int board) {
    return static_cast<size_t>(pulse.source) * Suit::kMaxPerSuit + static_cast<size_t>(board);
}

/// Of the first path.
CarrierArrival carrierOf(const PathFit& fit, double drive_rad_per_sample) {
    const double cycle = 2 * std::numbers::pi / drive_rad_per_sample;
    const double by_phase = -std::arg(fit.gain[0]) / drive_rad_per_sample;
    const double doubt = std::sqrt(std::max(1.0, fit.misfit));  // what the model does not explain is no noise
    return {by_phase + cycle * std::round((fit.onset[0] - by_phase) / cycle), doubt * fit.sigma_carrier,
            cycle, doubt * fit.sigma_onset};
}

}  // namespace

MatchedDetector::MatchedDetector(const PulseTrain& train, const PulseShapes& shapes)
    : sample_rate_hz_(train.sample_rate_hz),
      drive_(2 * std::numbers::pi * train.drive_hz / train.sample_rate_hz),
      finder_(train),
      noise_(Suit::kMaxPerSuit),
      heard_(shapes.size() * Suit::kMaxPerSuit) {
    for (const std::optional<PulseShape>& shape : shapes) {
        auto& source = sources_.emplace_back();
        if (!shape)
            continue;
        source.emplace(Known{PulseTemplate(finder_.filter(), train, *shape)});
        source->rise = finder_.riseOf(source->pulse);
    }
}

void MatchedDetector::detect(std::span<const int16_t> window, std::span<PulseArrival> boards,
                             const Pulse& pulse) {
    finder_.load(window, boards.size());
    const bool known = pulse.source >= 0 && pulse.source < std::ssize(sources_) &&
                       sources_[static_cast<size_t>(pulse.source)];
    for (size_t board = 0; board < boards.size(); ++board) {
        finder_.hear(board);
        const double ambient = ambientPower(static_cast<int>(board));
        if (known)
            boards[board] =
                find(*sources_[static_cast<size_t>(pulse.source)], static_cast<int>(board), ambient, pulse);
        else
            boards[board] = {.noise_power = finder_.inBand(ambient), .clipped = finder_.clipped()};
    }
}

/// With what the window that is heard adds to it.
double MatchedDetector::ambientPower(int board) {
    NoiseFloor& ambient = noise_[static_cast<size_t>(board)];
    ambient.push(finder_.noisePower());
    return ambient.power();
}

PulseArrival MatchedDetector::find(const Known& known, int board, double ambient_power, const Pulse& pulse) {
    PulseArrival arrival{.clipped = finder_.clipped()};
    arrival.noise_power = finder_.inBand(ambient_power);
    const auto rise = finder_.firstRise(ambient_power);
    if (!rise)
        return arrival;
    const double near_onset = rise->instant - known.rise;
    const PathFitter fitter(known.pulse, drive_);
    const PathFit fit = fitter.fit(finder_.around(near_onset, ambient_power), near_onset,
                                   stretchAt(pulse, board, near_onset));
    if (!std::isfinite(fit.misfit))  // nothing there that a pulse would explain
        return arrival;
    heard_[pairIndex(pulse, board)] = Heard{pulse.sample, fit.onset[0]};
    const double amplitude = std::abs(fit.gain[0]) * known.pulse.peak();
    arrival.sample = fit.onset[0];
    arrival.peak_power = amplitude * amplitude / 2;
    arrival.carrier = carrierOf(fit, drive_);
    return arrival;
}

StretchPrior MatchedDetector::stretchAt(const Pulse& pulse, int board, double onset) const {
    const auto& last = heard_[pairIndex(pulse, board)];
    if (!last)
        return kUnknownStretch;
    const auto pause = static_cast<double>(pulse.sample - last->pulse_sample);
    const double stretch = -(onset - last->onset) / pause;
    if (pause <= 0 || pause > kRecent_s * sample_rate_hz_ || std::abs(stretch) > 4 * kStretchChange)
        return kUnknownStretch;
    return {stretch, kStretchChange};
}

}  // namespace noctule
