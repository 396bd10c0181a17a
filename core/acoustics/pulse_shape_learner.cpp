// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/pulse_shape_learner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace noctule {
namespace {

constexpr size_t kMostArrivals = 16, kLeastArrivals = 6;
constexpr int kMostOfOneBoard = 3;
constexpr double kClearPower = 1000;           // of a burst over its noise: 30 dB
constexpr StretchPrior kNearlyStill{0, 1e-3};  // 0.35 m/s
constexpr PulseShape kLeastShape{39000, 8}, kMostShape{41500, 60};

PulseShape within(const PulseShape& shape) {
    return {std::clamp(shape.resonance_hz, kLeastShape.resonance_hz, kMostShape.resonance_hz),
            std::clamp(shape.q, kLeastShape.q, kMostShape.q)};
}

}  // namespace

PulseShapeLearner::PulseShapeLearner(const PulseTrain& train, int sources)
    : train_(train), finder_(train), sources_(static_cast<size_t>(sources)) {}

void PulseShapeLearner::detect(std::span<const int16_t> window, std::span<PulseArrival> boards,
                               const Pulse& pulse) {
    std::fill(boards.begin(), boards.end(), PulseArrival{});
    if (pulse.source < 0 || pulse.source >= std::ssize(sources_))
        return;
    finder_.load(window, boards.size());
    for (size_t board = 0; board < boards.size(); ++board) {
        finder_.hear(board);
        const double noise = finder_.noisePower();
        const auto rise = finder_.firstRise(noise);
        if (finder_.clipped() || !rise || rise->power < kClearPower * noise)
            continue;
        // A quarter of the peak's power comes 0.1 to 0.2 ms after the first motion.
        const double onset = rise->instant - 0.15e-3 * train_.sample_rate_hz;
        const Baseband sound = finder_.around(onset, noise);
        keep(sources_[static_cast<size_t>(pulse.source)],
             {static_cast<int>(board), rise->power, onset, sound.first, noise,
              std::vector(sound.values.begin(), sound.values.end())});
    }
}

/// The loudest stay.
void PulseShapeLearner::keep(std::vector<Arrival>& arrivals, Arrival arrival) const {
    const auto softer = [](const Arrival& a, const Arrival& b) { return a.power < b.power; };
    const auto same_board = [&](const Arrival& other) { return other.board == arrival.board; };
    auto replaced = arrivals.end();
    if (std::ranges::count_if(arrivals, same_board) >= kMostOfOneBoard)
        replaced =
            std::min_element(arrivals.begin(), arrivals.end(), [&](const Arrival& a, const Arrival& b) {
                return same_board(a) != same_board(b) ? same_board(a) : softer(a, b);
            });
    else if (arrivals.size() >= kMostArrivals)
        replaced = std::min_element(arrivals.begin(), arrivals.end(), softer);
    if (replaced == arrivals.end())
        arrivals.push_back(std::move(arrival));
    else if (softer(*replaced, arrival))
        *replaced = std::move(arrival);
}

PulseShapes PulseShapeLearner::learn() const {
    PulseShapes shapes;
    for (const std::vector<Arrival>& arrivals : sources_)
        shapes.push_back(arrivals.size() < kLeastArrivals ? std::nullopt : std::optional(fit(arrivals)));
    return shapes;
}

/// What stays unexplained of the better half, as a share of their energy.
double PulseShapeLearner::misfit(const std::vector<Arrival>& arrivals, const PulseShape& shape) const {
    const PulseTemplate pulse(finder_.filter(), train_, shape);
    const PathFitter fitter(pulse, 2 * std::numbers::pi * train_.drive_hz / train_.sample_rate_hz);
    std::vector<double> unexplained;
    for (const Arrival& arrival : arrivals) {
        double energy = 0;
        for (const std::complex<float>& value : arrival.baseband)
            energy += std::norm(value);
        const Baseband sound{arrival.baseband, arrival.first, static_cast<double>(finder_.filter().factor()),
                             arrival.noise_power};
        const PathFit fit = fitter.fitAlone(sound, arrival.rise, kNearlyStill);
        unexplained.push_back(fit.misfit * arrival.noise_power / energy);
    }
    const auto half = unexplained.begin() + std::ssize(unexplained) / 2;
    std::nth_element(unexplained.begin(), half, unexplained.end());
    double sum = 0;
    for (auto share = unexplained.begin(); share <= half; ++share)
        sum += *share;
    return sum;
}

/// A coarse grid, then steps that halve where no neighbour is better.
PulseShape PulseShapeLearner::fit(const std::vector<Arrival>& arrivals) const {
    PulseShape best;
    double least = std::numeric_limits<double>::infinity();
    const auto tryShape = [&](const PulseShape& shape) {
        const double share = misfit(arrivals, shape);
        if (share >= least)
            return false;
        least = share;
        best = shape;
        return true;
    };
    for (double resonance_hz = 39400; resonance_hz <= 41000; resonance_hz += 400)
        for (const double q : {14.0, 22.0, 34.0})
            tryShape({resonance_hz, q});
    for (double step_hz = 200, step = 0.2; step_hz > 3;) {
        const PulseShape from = best;
        bool better = false;
        for (const auto& [d_hz, d] : std::array<std::pair<double, double>, 4>{
                 {{step_hz, 0.0}, {-step_hz, 0.0}, {0.0, step}, {0.0, -step}}})
            better |= tryShape(within({from.resonance_hz + d_hz, from.q * std::exp(d)}));
        if (!better) {
            step_hz /= 2;
            step /= 2;
        }
    }
    return best;
}

}  // namespace noctule
