// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/gyroscope/gyroscope_turns.h"

#include <algorithm>

#include "core/body/text.h"
#include "core/calibration/gyroscope/gyroscope_calibration.h"
#include "core/calibration/worn_part_names.h"

namespace noctule {
namespace {

constexpr double kShortestTurn_s = 1.5, kShortestRest_s = 1;
/// Zeros turn the nominal rate by some 10 degrees; farther off it is none of the board's axes.
constexpr double kAlongAxis = 0.9;

bool reachesEnd(const SteadyStretch& stretch) {
    return std::ranges::any_of(stretch.readings, [](const CountReading& reading) {
        return reading.clipped &&
               (reading.gyro_counts.minCoeff() <= 0 || reading.gyro_counts.maxCoeff() >= 4095);
    });
}

double accelAlong(const TableStretch& turn) {
    double sum = 0;
    for (const CountReading& reading : turn.steady.readings)
        sum += reading.accel_counts[turn.about->axis];
    return sum / static_cast<double>(turn.steady.readings.size());
}

/// An axis that stood both ways has its accelerometer's zero in the middle, else the calibration must know.
void findSidesUp(TableBoard& table, int axis) {
    const Board& board = table.record->board;
    const BoardCalibration* known = table.record->in_force->findBoard(board.id);
    const AxisCalibration accel =
        known ? known->accel : AxisCalibration::nominal(board.accel_full_scale_m_per_s2);
    std::vector<double> counts;
    for (const TableStretch& stretch : table.stretches)
        if (stretch.about && stretch.about->axis == axis)
            counts.push_back(accelAlong(stretch));
    if (counts.empty())
        return;
    const auto [least, most] = std::ranges::minmax(counts);
    const double slope = accel.matrix(axis, axis);
    const bool both = (most - least) * slope > kStandardGravity_m_per_s2;
    const double zero = both ? (least + most) / 2 : accel.zero_counts[axis];
    for (TableStretch& stretch : table.stretches)
        if (stretch.about && stretch.about->axis == axis)
            stretch.up = BoardSide{axis, (accelAlong(stretch) - zero) * slope < 0 ? -1 : +1};
}

const char* const kSlowerRemedy = "Set the table to a slower speed, 33 1/3 or 45 rpm, and repeat";

Finding turnFinding(const TableBoard& table, Grade grade, const std::string& what,
                    const std::string& remedy) {
    return {grade, table.record->id, table.record->words + ": " + what, remedy};
}

/// Of an axis that turned in one direction only.
Finding oneWayFinding(const TableBoard& table, int axis) {
    std::vector<BoardSide> ups;
    for (const TableStretch& stretch : table.stretches)
        if (stretch.about && stretch.about->axis == axis && std::ranges::count(ups, *stretch.up) == 0)
            ups.push_back(*stretch.up);
    const std::string what = std::string("turned about its ") + "xyz"[axis] + " axis in one direction only";
    if (ups.size() == 1)
        return turnFinding(
            table, Grade::kNotUsable, what + ", with its " + ups[0].name() + " side up",
            "Turn it with its " + ups[0].opposite().name() + " side up as well, the table turning as before");
    return turnFinding(table, Grade::kNotUsable,
                       what + ", as the table turned the other way when the board was turned over",
                       "Repeat both sides with the table turning one way");
}

}  // namespace

double nearestTableSpeed_rpm(double rpm) {
    constexpr std::array kTableSpeeds_rpm{100.0 / 3, 45.0, 78.0};
    return *std::ranges::min_element(kTableSpeeds_rpm, {},
                                     [rpm](double usual_rpm) { return std::abs(usual_rpm - rpm); });
}

double turningRate_rad_per_s(double rpm) {
    return rpm * 2 * std::numbers::pi / 60;
}

std::string speedWords(double rpm) {
    return text::number(rpm, std::abs(rpm - std::round(rpm)) < 0.05 ? 0 : 1) + " rpm";
}

bool TableBoard::turned(BoardSide about) const {
    return std::ranges::any_of(stretches,
                               [&](const TableStretch& stretch) { return stretch.about == about; });
}

std::vector<double> TableBoard::speeds_rad_per_s() const {
    std::vector<double> speeds;
    for (const TableStretch& stretch : stretches)
        if (stretch.about)
            speeds.push_back(stretch.steady.rate_rad_per_s.dot(stretch.about->up()));
    return speeds;
}

TableBoard tableBoard(const BoardRecord& record) {
    TableBoard table;
    table.record = &record;
    std::vector<std::span<const CountReading>> readings;
    for (const SteadyStretch& steady : record.steadyStretches()) {
        TableStretch stretch{steady, {}, std::nullopt, std::nullopt};
        if (reachesEnd(steady)) {
            table.clipped = true;
            continue;
        }
        if (steady.length_s() < (steady.turns ? kShortestTurn_s : kShortestRest_s))
            continue;
        if (steady.turns) {
            const BoardSide about = BoardSide::nearest(steady.rate_rad_per_s);
            if (steady.rate_rad_per_s.dot(about.up()) < kAlongAxis * steady.rate_rad_per_s.norm())
                continue;
            stretch.about = about;
        }
        table.stretches.push_back(stretch);
        readings.push_back(steady.readings);
    }
    const std::vector<CountMean> means = countMeans(readings, &CountReading::gyro_counts);
    for (size_t k = 0; k < means.size(); ++k)
        table.stretches[k].gyro = means[k];
    for (int axis = 0; axis < 3; ++axis)
        findSidesUp(table, axis);
    return table;
}

std::vector<Finding> turnFindings(const TableBoard& table, double nominal_rpm) {
    const double range_rad_per_s = table.record->board.gyro_full_scale_rad_per_s;
    if (table.record->readingCount() == 0)
        return {turnFinding(table, Grade::kNotUsable, "sent no readings",
                            "Push its plug in until it clicks, then repeat its six turns")};
    if (turningRate_rad_per_s(nominal_rpm) > GyroscopeLimits::kFastest * range_rad_per_s)
        return {turnFinding(table, Grade::kNotUsable,
                            speedWords(nominal_rpm) + " is more than 80 % of its gyroscope's range of " +
                                text::number(degrees(range_rad_per_s), 0) + " °/s",
                            kSlowerRemedy)};
    std::vector<Finding> findings;
    if (table.clipped)
        findings.push_back(turnFinding(
            table, Grade::kUsable, "its gyroscope reached the end of its range in a turn, which was left out",
            kSlowerRemedy));
    for (int axis = 0; axis < 3; ++axis) {
        const bool forward = table.turned({axis, +1}), backward = table.turned({axis, -1});
        const std::string name(1, "xyz"[axis]);
        if (!forward && !backward)
            findings.push_back(turnFinding(
                table, Grade::kNotUsable, "was never turned evenly about its " + name + " axis",
                "Turn it with its +" + name + " side up and again with its -" + name + " side up"));
        else if (!forward || !backward)
            findings.push_back(oneWayFinding(table, axis));
    }
    return findings;
}

}  // namespace noctule
