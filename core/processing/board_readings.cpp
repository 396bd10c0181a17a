// SPDX-License-Identifier: Apache-2.0
#include "core/processing/board_readings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace noctule {

namespace {

constexpr double kLowestRate_hz = 10, kHighestRate_hz = 10'000;
/// Share of a board's readings; stamps of which more is wrong say nothing of the others.
constexpr double kMostLeftOut = 0.1;

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

/// The median of samples per frame.
double usualStep(const std::vector<InertialReading>& rows) {
    std::vector<double> steps;
    for (size_t i = 1; i < rows.size(); ++i)
        steps.push_back((rows[i].sample - rows[i - 1].sample) / double(rows[i].frame - rows[i - 1].frame));
    // The lower middle: packets of two equal stamps count as equal stamps.
    const auto middle = steps.begin() + (std::ssize(steps) - 1) / 2;
    std::ranges::nth_element(steps, middle);
    return *middle;
}

/// The rows of a longest sequence of rising instants: outliers, alone or several in a row, are not of it.
std::vector<bool> longestRise(const std::vector<InertialReading>& rows) {
    std::vector<size_t> ends;  // by length: the row at which the lowest sequence of that length ends
    std::vector<size_t> before(rows.size());
    for (size_t i = 0; i < rows.size(); ++i) {
        const auto place =
            std::ranges::lower_bound(ends, rows[i].sample, {}, [&](size_t row) { return rows[row].sample; });
        before[i] = place == ends.begin() ? i : *std::prev(place);
        if (place == ends.end())
            ends.push_back(i);
        else
            *place = i;
    }
    std::vector<bool> kept(rows.size(), false);
    for (size_t i = ends.back();; i = before[i]) {
        kept[i] = true;
        if (before[i] == i)
            return kept;
    }
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

/// Which row each reading fills, and the instant of every row.
struct ReadingsOfBoards::Placement {
    static constexpr size_t kNoRow = size_t(-1);
    std::vector<size_t> row_of;  ///< kNoRow: left out
    std::vector<double> sample;
    bool is_even = true;
};

ReadingsOfBoards::Placement ReadingsOfBoards::onLine(const std::vector<InertialReading>& rows, double step) {
    Placement out;
    for (const InertialReading& row : rows)
        out.row_of.push_back(static_cast<size_t>(row.frame - rows.front().frame));
    for (size_t i = 0; i <= out.row_of.back(); ++i)
        out.sample.push_back(rows.front().sample + double(i) * step);
    return out;
}

ReadingsOfBoards::Placement ReadingsOfBoards::byStamps(const std::vector<InertialReading>& rows,
                                                       double usual_step) const {
    Placement out{{}, {}, false};
    const double longest = ImuSamples::kLongestStep_s * sample_rate_hz_;
    const std::vector<bool> kept = longestRise(rows);
    int64_t last_frame = 0;
    for (size_t i = 0; i < rows.size(); ++i) {
        if (!kept[i]) {
            out.row_of.push_back(Placement::kNoRow);
            continue;
        }
        const double at = rows[i].sample;
        if (!out.sample.empty()) {
            const double gap = at - out.sample.back(), before = out.sample.back();
            // As many lost ones as the frames count, unless the time has no room for them.
            const double frames =
                std::min(double(rows[i].frame - last_frame), std::max(1.0, std::round(2 * gap / usual_step)));
            if (gap / frames <= longest)
                for (double lost = 1; lost < frames; ++lost)
                    out.sample.push_back(before + gap * lost / frames);
        }
        last_frame = rows[i].frame;
        out.row_of.push_back(out.sample.size());
        out.sample.push_back(at);
    }
    return out;
}

Result<BoardReadings> ReadingsOfBoards::of(size_t board, const Take& take) const {
    const auto& rows = rows_[board];
    BoardReadings out;
    if (rows.size() < 2)
        return out;
    const InertialReading &first = rows.front(), &last = rows.back();
    const double step = (last.sample - first.sample) / double(last.frame - first.frame);
    const bool is_regular = std::ranges::all_of(rows, [&](const InertialReading& row) {
        return std::abs(row.sample - first.sample - double(row.frame - first.frame) * step) <= step / 2;
    });
    const double usual = is_regular ? step : usualStep(rows);
    const bool by_line = is_regular || !(usual > 0);  // packets of equal stamps: the frames tell the instants
    const double usual_step = by_line ? step : usual;
    out.samples.rate_hz = sample_rate_hz_ / usual_step;
    if (!(out.samples.rate_hz >= kLowestRate_hz && out.samples.rate_hz <= kHighestRate_hz))
        return readingsError(
            take,
            "board " + suit_.boards[board].id + " reads at " + std::to_string(out.samples.rate_hz) + " Hz",
            "Orientation needs 10 to 10000 readings a second");
    fill(rows, board, by_line ? onLine(rows, step) : byStamps(rows, usual_step), out);
    if (double(out.left_out) > kMostLeftOut * double(rows.size()))
        return readingsError(take,
                             "board " + suit_.boards[board].id +
                                 ": the time stamps stand still or jump back, which would leave out " +
                                 std::to_string(out.left_out) + " of " + std::to_string(rows.size()) +
                                 " readings",
                             "Record again or import a file whose time rises from row to row");
    return out;
}

void ReadingsOfBoards::fill(const std::vector<InertialReading>& rows, size_t board,
                            const Placement& placement, BoardReadings& out) const {
    const Vector3d nothing = Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    const size_t count = placement.sample.size();
    ImuSamples& samples = out.samples;
    samples.gyro_rad_per_s.assign(count, nothing);
    samples.accel_m_per_s2.assign(count, nothing);
    if (suit_.boards[board].has_magnetometer)
        samples.mag.assign(count, nothing);
    const BoardCalibration* values = calibration_.findBoard(suit_.boards[board].id);
    for (size_t r = 0; r < rows.size(); ++r) {
        const InertialReading& row = rows[r];
        const size_t i = placement.row_of[r];
        if (i == Placement::kNoRow) {
            ++out.left_out;
            continue;
        }
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
        out.time_ns.push_back(std::llround(placement.sample[i] * 1e9 / sample_rate_hz_));
        if (!placement.is_even)
            samples.step_s.push_back(i == 0
                                         ? 1 / samples.rate_hz
                                         : (placement.sample[i] - placement.sample[i - 1]) / sample_rate_hz_);
    }
}

}  // namespace noctule
