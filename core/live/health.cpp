// SPDX-License-Identifier: Apache-2.0
#include "core/live/health.h"

#include <algorithm>
#include <cmath>

namespace noctule {
namespace {

constexpr int kFullScale_counts = 32767;
constexpr double kCountsPerFullScale = 2048;  // of a reading

}  // namespace

HealthMonitor::BoardWindow::BoardWindow(int64_t window)
    : trusted(window),
      lost(window),
      corrected(window),
      clipped_readings(window),
      ranges(window),
      wire_power(window),
      wire_samples(window),
      wire_clipped(window),
      wire_alive(window),
      wire_peak(window),
      axes(6, SlidingSum(window)) {}

HealthMonitor::HealthMonitor(const Suit& suit, int sample_rate_hz, const HealthSettings& settings)
    : suit_(suit),
      sample_rate_hz_(sample_rate_hz),
      settings_(settings),
      windows_(suit.boards.size(), BoardWindow(sample_rate_hz)),
      heard_at_(suit.boards.size() * suit.sources.size(), -1) {
    report_.boards.resize(suit.boards.size());
    report_.pairs.resize(heard_at_.size());
}

void HealthMonitor::add(const InertialReading& reading) {
    const auto board = static_cast<size_t>(reading.board);
    BoardWindow& window = windows_[board];
    BoardHealth& health = report_.boards[board];
    if (!reading.corrected_bits) {
        window.lost.add(reading.sample, 1);
        ++health.frames_lost_in_all;
        return;
    }
    window.trusted.add(reading.sample, 1);
    window.corrected.add(reading.sample, *reading.corrected_bits);
    health.bits_corrected_in_all += *reading.corrected_bits;
    for (size_t axis = 0; axis < 6; ++axis) {
        const std::optional<double>& counts = reading.counts[axis];
        if (!counts)
            continue;
        window.axes[axis].add(reading.sample, *counts);
        if (*counts <= kCountsMin || *counts >= kCountsMax)
            window.clipped_readings.add(reading.sample, 1);
    }
    const auto& field = reading.magnetometer_counts;
    if (field[0] && field[1] && field[2])
        health.field = BoardHealth::Field{reading.sample, Vector3d(*field[0], *field[1], *field[2])};
}

void HealthMonitor::add(const RangeMeasurement& range) {
    const size_t pair =
        static_cast<size_t>(range.source) * windows_.size() + static_cast<size_t>(range.board);
    windows_[static_cast<size_t>(range.board)].ranges.add(static_cast<double>(range.pulse_sample), 1);
    heard_at_[pair] = static_cast<double>(range.pulse_sample);
    report_.pairs[pair].confidence = range.confidence();
    report_.pairs[pair].heard = range.w_s * range.w_t;
    report_.pairs[pair].distance_m = range.distance_m;
}

void HealthMonitor::addBlock(int64_t first_sample, std::span<const int16_t> interleaved) {
    for (size_t board = 0; board < windows_.size(); ++board)
        addWire(static_cast<int>(board), first_sample, interleaved);
    report_.sample =
        std::max(report_.sample, first_sample + static_cast<int64_t>(interleaved.size() / windows_.size()));
}

void HealthMonitor::addWire(int board, int64_t first_sample, std::span<const int16_t> interleaved) {
    const size_t boards = windows_.size();
    double power = 0;
    int64_t clipped = 0;
    int peak = 0;
    for (size_t i = static_cast<size_t>(board); i < interleaved.size(); i += boards) {
        const int value = interleaved[i];
        power += static_cast<double>(value) * value;
        clipped += std::abs(value) >= kFullScale_counts;
        peak = std::max(peak, std::abs(value));
    }
    BoardWindow& window = windows_[static_cast<size_t>(board)];
    const auto at = static_cast<double>(first_sample);
    window.wire_power.add(at, power);
    window.wire_samples.add(at, static_cast<double>(interleaved.size() / boards));
    window.wire_clipped.add(at, static_cast<double>(clipped));
    window.wire_alive.add(at, peak > 0 ? 1 : 0);
    window.wire_peak.add(at, peak);
}

void HealthMonitor::advance(BoardWindow& window) const {
    for (SlidingSum* sum :
         {&window.trusted, &window.lost, &window.corrected, &window.clipped_readings, &window.ranges,
          &window.wire_power, &window.wire_samples, &window.wire_clipped, &window.wire_alive})
        sum->advanceTo(report_.sample);
    window.wire_peak.advanceTo(report_.sample);
    for (SlidingSum& axis : window.axes)
        axis.advanceTo(report_.sample);
}

std::optional<BoardHealth::Means> HealthMonitor::meansOf(size_t board) const {
    const Board& described = suit_.boards[board];
    BoardHealth::Means means;
    for (int axis = 0; axis < 6; ++axis) {
        const SlidingSum& counts = windows_[board].axes[static_cast<size_t>(axis)];
        if (counts.count() * 2 < kInertialFramesPerSecond)
            return std::nullopt;
        const bool gyro = axis < 3;
        (gyro ? means.gyro_counts : means.accel_counts)[axis % 3] =
            counts.sum() / static_cast<double>(counts.count());
        const double full_scale =
            gyro ? described.gyro_full_scale_rad_per_s : described.accel_full_scale_m_per_s2;
        double& worst = gyro ? means.gyro_deviation_rad_per_s : means.accel_deviation_m_per_s2;
        worst = std::max(worst, counts.deviation() * full_scale / kCountsPerFullScale);
    }
    return means;
}

BoardHealth HealthMonitor::healthOf(size_t board) {
    BoardWindow& window = windows_[board];
    advance(window);
    BoardHealth health = report_.boards[board];
    // The first second is not yet a whole one.
    const double seconds =
        std::clamp(static_cast<double>(report_.sample) / sample_rate_hz_, 1.0 / sample_rate_hz_, 1.0);
    health.frames_per_s = static_cast<double>(window.trusted.count()) / seconds;
    health.frames_lost = window.lost.count();
    health.bits_corrected = std::llround(window.corrected.sum());
    health.clipped_readings = window.clipped_readings.count();
    health.ranges_per_s = static_cast<double>(window.ranges.count()) / seconds;
    health.clipped_samples = std::llround(window.wire_clipped.sum());
    health.silent = window.wire_alive.sum() < 0.5;
    health.signal_counts = window.wire_samples.sum() > 0
                               ? std::sqrt(std::max(0.0, window.wire_power.sum()) / window.wire_samples.sum())
                               : 0;
    health.peak_counts = window.wire_peak.value();
    health.means = meansOf(board);
    health.still = health.means && health.means->gyro_deviation_rad_per_s <= settings_.still_gyro_rad_per_s &&
                   health.means->accel_deviation_m_per_s2 <= settings_.still_accel_m_per_s2;
    return health;
}

HealthReport HealthMonitor::report() {
    for (size_t board = 0; board < windows_.size(); ++board)
        report_.boards[board] = healthOf(board);
    for (size_t pair = 0; pair < heard_at_.size(); ++pair)
        if (heard_at_[pair] >= 0)
            report_.pairs[pair].age_s =
                (static_cast<double>(report_.sample) - heard_at_[pair]) / sample_rate_hz_;
    return report_;
}

}  // namespace noctule
