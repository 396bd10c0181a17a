// SPDX-License-Identifier: Apache-2.0
#include "core/processing/board_readings.h"

#include <cmath>
#include <limits>

namespace noctule {

namespace {

constexpr double kLowestRate_hz = 10, kHighestRate_hz = 10'000;

Error readingsError(const Take& take, const std::string& what, const std::string& remedy) {
    return {ErrorKind::kUnusable, take.path() + ": " + what, remedy};
}

Vector3d calibrated(const InertialReading& reading, size_t at, const AxisCalibration& calibration) {
    Vector3d counts;
    for (size_t axis = 0; axis < 3; ++axis)
        counts[Eigen::Index(axis)] =
            reading.counts[at + axis].value_or(std::numeric_limits<double>::quiet_NaN());
    return calibration.apply(counts);
}

}  // namespace

Calibration completedCalibration(const Suit& suit, const Calibration& known) {
    Calibration all = nominalCalibration(suit);
    for (BoardCalibration& board : all.boards)
        if (const BoardCalibration* values = known.findBoard(board.id))
            board = *values;
    return all;
}

Calibration completedCalibration(const Suit& suit, const Take& take) {
    const auto stored = take.calibrationInForce();
    return stored ? completedCalibration(suit, stored->value) : nominalCalibration(suit);
}

Status ReadingsOfBoards::gather(const Take& take, const JobContext& job) {
    auto cursor = take.readings(kPrimaryRun);
    if (!cursor)
        return cursor.error();
    for (size_t n = 0;; ++n) {
        auto next = cursor->next();
        if (!next)
            return next.error();
        if (!*next)
            return Done{};
        rows_[size_t((*next)->board)].push_back(**next);
        if (n % 4096 == 0 && job.cancelled())
            return JobContext::cancelledError();
    }
}

Result<BoardReadings> ReadingsOfBoards::of(size_t board, const Take& take) const {
    const auto& rows = rows_[board];
    BoardReadings out;
    if (rows.size() < 2)
        return out;
    const double step =
        double(rows.back().sample - rows.front().sample) / double(rows.back().frame - rows.front().frame);
    out.samples.rate_hz = sample_rate_hz_ / step;
    if (!(out.samples.rate_hz >= kLowestRate_hz && out.samples.rate_hz <= kHighestRate_hz))
        return readingsError(
            take,
            "board " + suit_.boards[board].id + " reads at " + std::to_string(out.samples.rate_hz) + " Hz",
            "Orientation needs 10 to 10000 readings a second");
    fill(rows, board, step, out);
    return out;
}

void ReadingsOfBoards::fill(const std::vector<InertialReading>& rows, size_t board, double step,
                            BoardReadings& out) const {
    const Vector3d nothing = Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    const auto count = static_cast<size_t>(rows.back().frame - rows.front().frame + 1);
    ImuSamples& samples = out.samples;
    samples.gyro_rad_per_s.assign(count, nothing);
    samples.accel_m_per_s2.assign(count, nothing);
    if (suit_.boards[board].has_magnetometer)
        samples.mag.assign(count, nothing);
    const BoardCalibration* values = calibration_.findBoard(suit_.boards[board].id);
    for (const InertialReading& row : rows) {
        const auto i = static_cast<size_t>(row.frame - rows.front().frame);
        samples.gyro_rad_per_s[i] = calibrated(row, 0, values->gyro);
        samples.accel_m_per_s2[i] = calibrated(row, 3, values->accel);
        for (Eigen::Index axis = 0; axis < 3 && !samples.mag.empty(); ++axis)
            if (row.magnetometer_counts[size_t(axis)])
                samples.mag[i][axis] = *row.magnetometer_counts[size_t(axis)];
        if (values->mag && !samples.mag.empty())
            samples.mag[i] = values->mag->apply(samples.mag[i]);
    }
    for (size_t i = 0; i < count; ++i) {
        out.missing += !samples.gyro_rad_per_s[i].allFinite() || !samples.accel_m_per_s2[i].allFinite();
        out.time_ns.push_back(std::llround((rows.front().sample + double(i) * step) * 1e9 / sample_rate_hz_));
    }
}

}  // namespace noctule
