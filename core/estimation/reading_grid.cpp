// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/reading_grid.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace noctule {
namespace {

constexpr double kLongestGap = 2.5, kReach = 1.001;  // intervals; one reading may be missing
constexpr double kSame_s = 1e-6;
constexpr ptrdiff_t kBefore = 3;  ///< readings that the cubic takes from before

/// Which of three nearly perpendicular axes.
size_t indexOf(const Vector3d& sensitive_axis) {
    Eigen::Index index = 0;
    sensitive_axis.cwiseAbs().maxCoeff(&index);
    return static_cast<size_t>(index);
}

/// The polynomial through the samples (time_s, reading.value).
template <class Iterator>
double interpolate(Iterator begin, Iterator end, double time_s) {
    double value = 0;
    for (Iterator i = begin; i != end; ++i) {
        double weight = 1;
        for (Iterator j = begin; j != end; ++j)
            if (j != i)
                weight *= (time_s - j->time_s) / (i->time_s - j->time_s);
        value += weight * i->reading.value;
    }
    return value;
}

}  // namespace

ReadingGrid::ReadingGrid(const std::vector<double>& rates_hz) : reach_s_(kReach / kInertialFramesPerSecond) {
    for (const double rate_hz : rates_hz) {
        Board& board = boards_.emplace_back();
        board.longest_gap_s = kLongestGap / rate_hz;
        board.reach_s = rate_hz == kInertialFramesPerSecond ? kReach / rate_hz : board.longest_gap_s;
        board.noise_factor = std::sqrt(std::max(1.0, kInertialFramesPerSecond / rate_hz));
        reach_s_ = std::max(reach_s_, board.reach_s);
    }
}

void ReadingGrid::add(const InertialMeasurement& measurement) {
    Board& board = boards_[static_cast<size_t>(measurement.board)];
    const auto addAll = [&](const TriadReading& triad, size_t first) {
        for (int i = 0; i < triad.count; ++i) {
            const AxisReading& axis = triad.axes[static_cast<size_t>(i)];
            addTo(board.axes[first + indexOf(axis.sensitive_axis_board)], measurement.time_s, axis);
        }
    };
    addAll(measurement.gyro, 0);
    addAll(measurement.accel, 3);
}

void ReadingGrid::addTo(Track& track, double time_s, const AxisReading& reading) {
    if (track.empty() || time_s > track.back().time_s)
        track.push_back({time_s, reading});
}

bool ReadingGrid::readAt(const Board& board, Track& track, double time_s, AxisReading& reading) {
    const auto is_later = [](double t, const Sample& sample) { return t < sample.time_s; };
    auto next = std::upper_bound(track.begin(), track.end(), time_s + kSame_s, is_later);
    if (next - track.begin() > kBefore)
        next = track.erase(track.begin(), next - kBefore) + kBefore;
    if (next == track.begin())
        return false;
    const Sample& last = *std::prev(next);
    if (std::abs(last.time_s - time_s) <= kSame_s) {
        reading = last.reading;
        return true;
    }
    if (next == track.end() || next->time_s > time_s + board.reach_s ||
        next->time_s - last.time_s > board.longest_gap_s)
        return false;
    const Sample& nearest = next->time_s - time_s < time_s - last.time_s ? *next : last;
    reading = nearest.reading;
    if (last.reading.beyond != 0 || next->reading.beyond != 0)
        return nearest.reading.beyond != 0;
    auto first = std::prev(next);
    while (first != track.begin() && std::prev(first)->reading.beyond == 0 &&
           first->time_s - std::prev(first)->time_s <= board.longest_gap_s)
        --first;
    reading.value = interpolate(first, std::next(next), time_s);
    reading.sigma = std::max(last.reading.sigma, next->reading.sigma);
    return true;
}

std::vector<InertialMeasurement> ReadingGrid::at(double time_s) {
    std::vector<InertialMeasurement> all;
    for (size_t b = 0; b < boards_.size(); ++b) {
        InertialMeasurement measurement{static_cast<int>(b), time_s, {}, {}};
        for (size_t i = 0; i < 6; ++i) {
            AxisReading reading;
            if (!readAt(boards_[b], boards_[b].axes[i], time_s, reading))
                continue;
            reading.sigma *= boards_[b].noise_factor;
            (i < 3 ? measurement.gyro : measurement.accel).add(reading);
        }
        if (measurement.gyro.count + measurement.accel.count > 0)
            all.push_back(measurement);
    }
    return all;
}

}  // namespace noctule
