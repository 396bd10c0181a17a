// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/inflection_detector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace noctule {
namespace {

// The filters start from rest at the window's edges; in 1 ms the band-pass forgets a step to 1e-5.
constexpr double kMargin_s = 1e-3;
constexpr float kFullScale = 32767;

/// Runs kCount sections in a row over `rows`, from begin in steps of `step`.
template <size_t kCount, class Lanes>
void filter(const std::vector<Biquad>& sections, Lanes* row, ptrdiff_t count, ptrdiff_t step) {
    struct Section {
        float b0, b1, b2, a1, a2;
    };
    std::array<Section, kCount> c;
    std::array<Lanes, kCount> s1, s2;
    for (size_t k = 0; k < kCount; ++k) {
        const Biquad& b = sections[k];
        c[k] = {float(b.b0), float(b.b1), float(b.b2), float(b.a1), float(b.a2)};
        s1[k].setZero();
        s2[k].setZero();
    }
    for (; count > 0; --count, row += step) {
        Lanes x = *row;
        for (size_t k = 0; k < kCount; ++k) {
            const Lanes y = c[k].b0 * x + s1[k];
            s1[k] = c[k].b1 * x - c[k].a1 * y + s2[k];
            s2[k] = c[k].b2 * x - c[k].a2 * y;
            x = y;
        }
        *row = x;
    }
}

template <size_t kCount, class Lanes>
void filterBothWays(const std::vector<Biquad>& sections, std::vector<Lanes>& rows) {
    filter<kCount>(sections, rows.data(), std::ssize(rows), 1);
    filter<kCount>(sections, rows.data() + rows.size() - 1, std::ssize(rows), -1);
}

/// Twice a higher carrier folds to where the low-pass lets it through.
constexpr double kSquaredUpTo_hz = 45000;

}  // namespace

InflectionDetector::InflectionDetector(const PulseTrain& train)
    : interval_(train.interval_samples),
      margin_(int(std::ceil(kMargin_s * train.sample_rate_hz))),
      band_pass_(butterworthBandPass(2, train.drive_hz - 2500, train.drive_hz + 2500, train.sample_rate_hz)),
      low_pass_(butterworthLowPass(2, 30000, train.sample_rate_hz)),
      quadrature_gain_(
          train.drive_hz <= kSquaredUpTo_hz
              ? 0
              : float(0.5 / std::sin(2 * std::numbers::pi * train.drive_hz / train.sample_rate_hz))),
      rows_(windowSamples()) {}

void InflectionDetector::detect(std::span<const int16_t> window, std::span<PulseArrival> boards,
                                const Pulse& /*pulse*/) {
    require(window.size() == boards.size() * windowSamples(), "a window of another size than the detector's");
    for (size_t first = 0; first < boards.size(); first += kLanes) {
        load(window, boards.size(), first);
        envelope();
        for (size_t board = first; board < std::min(first + kLanes, boards.size()); ++board)
            boards[board] = find(int(board - first));
    }
}

void InflectionDetector::load(std::span<const int16_t> window, size_t boards, size_t first_board) {
    const size_t used = std::min<size_t>(kLanes, boards - first_board);
    const int16_t* values = window.data() + first_board;
    loudest_.setZero();
    for (Lanes& row : rows_) {
        row.setZero();
        for (size_t lane = 0; lane < used; ++lane)
            row[lane] = values[lane];
        loudest_ = loudest_.max(row.abs());
        values += boards;
    }
}

void InflectionDetector::envelope() {
    filterBothWays<2>(band_pass_, rows_);
    if (quadrature_gain_ == 0) {
        for (Lanes& row : rows_)
            row = row.square();
    } else {
        // In the band the sound's quadrature is its slope, scaled: half the analytic signal's square.
        Lanes before = rows_.front();
        for (size_t i = 0; i < rows_.size(); ++i) {
            const Lanes now = rows_[i], after = i + 1 < rows_.size() ? rows_[i + 1] : now;
            rows_[i] = (now.square() + (quadrature_gain_ * (after - before)).square()) / 2;
            before = now;
        }
    }
    filterBothWays<1>(low_pass_, rows_);
    highest_.setZero();
    for (int i = margin_; i < margin_ + interval_; ++i)
        highest_ = highest_.max(rows_[i]);
}

PulseArrival InflectionDetector::find(int lane) {
    const int begin = margin_, end = margin_ + interval_;
    PulseArrival arrival{.noise_power = noisePower(lane), .clipped = loudest_[lane] >= kFullScale};
    int i = begin;
    while (i < end - 1 && power(i, lane) <= 0.3f * highest_[lane])
        ++i;
    // To the local maximum of the slope, uphill, whichever way that is.
    while (i < end && slope(i + 1, lane) > slope(i, lane))
        ++i;
    while (i > begin && slope(i - 1, lane) > slope(i, lane))
        --i;
    const double before = slope(i - 1, lane), top = slope(i, lane), after = slope(i + 1, lane);
    const double curvature = before - 2 * top + after;
    const double vertex = curvature < 0 ? 0.5 * (before - after) / curvature : 0;
    arrival.sample = i - margin_ + std::clamp(vertex, -0.5, 0.5);
    while (i < end && power(i + 1, lane) > power(i, lane))
        ++i;
    arrival.peak_power = std::max(0.f, power(i, lane));
    return arrival;
}

/// The envelope of Gaussian noise in a band is exponentially distributed: its lower quartile is ln(4/3) of
/// its mean. A pulse with its echoes fills less than half of a window, so the lower quartile sees little of
/// it.
double InflectionDetector::noisePower(int lane) {
    constexpr int kStride = 16;  // neighbours within the filters' memory tell nothing new
    quiet_.clear();
    for (int i = margin_; i < margin_ + interval_; i += kStride)
        quiet_.push_back(power(i, lane));
    const auto quartile = quiet_.begin() + ptrdiff_t(quiet_.size() / 4);
    std::nth_element(quiet_.begin(), quartile, quiet_.end());
    return std::max(0.0, double(*quartile) / std::log(4.0 / 3.0));
}

}  // namespace noctule
