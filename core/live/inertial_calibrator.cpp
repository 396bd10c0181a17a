// SPDX-License-Identifier: Apache-2.0
#include "core/live/inertial_calibrator.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/inertial/step_table.h"

namespace noctule {
namespace {

/// How far beyond the end of the range motion may be.
constexpr double kClippedGyro_rad_per_s = 4, kClippedAccel_m_per_s2 = 40;

/// What one frame rounds away the next pays back: a reading's error is the difference of two roundings, and
/// little of it is slow. It counts as white noise that is as strong as it at the end of human motion.
constexpr double kMotionEnds_hz = 13;
const double kNotPaidBack =
    std::sqrt(1 - std::cos(2 * std::numbers::pi * kMotionEnds_hz / kInertialFramesPerSecond));

constexpr double kLargeStep_counts = 58;  // inertial stream, section 1: near the ends such a step is suspect

}  // namespace

InertialCalibrator::InertialCalibrator(const Suit& suit, const Calibration& calibration,
                                       double sample_rate_hz, const SensorNoise& noise)
    : sample_rate_hz_(sample_rate_hz) {
    const Calibration nominal = nominalCalibration(suit);
    for (const Board& board : suit.boards) {
        const BoardCalibration* known = calibration.findBoard(board.id);
        if (!known)
            known = nominal.findBoard(board.id);
        BoardAxes axes;
        for (int i = 0; i < 6; ++i) {
            const AxisCalibration& triad = i < 3 ? known->gyro : known->accel;
            // counts - zero = M^-1 value: axis i senses along row i of M^-1.
            const Vector3d row = triad.matrix.inverse().row(i % 3).transpose();
            axes.axes[i] = {row.normalized(),
                            triad.zero_counts[i % 3],
                            1 / row.norm(),
                            i < 3 ? board.gyro_noise_rad_per_s.value_or(noise.gyro_rad_per_s)
                                  : board.accel_noise_m_per_s2.value_or(noise.accel_m_per_s2),
                            std::nullopt,
                            codecRoundingSigmaCounts(0),
                            triad.isOfCounts(),
                            board.rate_hz == kInertialFramesPerSecond};
        }
        boards_.push_back(axes);
    }
}

InertialMeasurement InertialCalibrator::convert(const InertialReading& reading) {
    InertialMeasurement measurement{reading.board, reading.sample / sample_rate_hz_, {}, {}};
    BoardAxes& board = boards_[static_cast<size_t>(reading.board)];
    for (size_t i = 0; i < 6; ++i) {
        Axis& axis = board.axes[i];
        const std::optional<double>& counts = reading.counts[i];
        if (!counts)
            continue;
        TriadReading& triad = i < 3 ? measurement.gyro : measurement.accel;
        if (!axis.counts) {
            triad.add({axis.sensitive_axis, (*counts - axis.zero_counts) * axis.per_count, axis.noise});
            continue;
        }
        const bool clipped = *counts <= kCountsMin || *counts >= kCountsMax;
        if (!axis.coded && !clipped) {
            triad.add({axis.sensitive_axis, (*counts - axis.zero_counts) * axis.per_count,
                       std::hypot(axis.noise, axis.per_count / std::sqrt(12.0))});
            continue;
        }
        const double step = axis.last_counts ? std::abs(*counts - *axis.last_counts) : 0;
        const double rounding = codecRoundingSigmaCounts(step);
        const double last_rounding = std::exchange(axis.last_rounding, rounding);
        const double both = std::hypot(rounding, last_rounding) * axis.per_count;
        axis.last_counts = counts;
        if (clipped) {
            ++board.clipped;
            triad.add({axis.sensitive_axis, (*counts - axis.zero_counts) * axis.per_count,
                       (i < 3 ? kClippedGyro_rad_per_s : kClippedAccel_m_per_s2),
                       *counts <= kCountsMin ? -1 : 1});
            continue;
        }
        const double reach = std::sqrt(12.0) * rounding;
        if (step >= kLargeStep_counts && (*counts - reach <= kCountsMin || *counts + reach >= kCountsMax))
            continue;  // within one step of the end after a large one: may stand for a clipped value
        triad.add({axis.sensitive_axis, (*counts - axis.zero_counts) * axis.per_count,
                   std::hypot(axis.noise, kNotPaidBack * both)});
    }
    return measurement;
}

}  // namespace noctule
