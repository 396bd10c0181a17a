// SPDX-License-Identifier: Apache-2.0
#include "core/report/calibration_comparison.h"

#include <algorithm>
#include <cmath>

#include "core/body/text.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr const char* kUnknown = "–";

/// "–" unless both are known.
template <class Value, class Difference>
std::string between(const std::optional<Value>& one, const std::optional<Value>& other, int decimals,
                    Difference difference) {
    return one && other ? text::number(difference(*one, *other), decimals) : kUnknown;
}

double millimetresBetween(const Vector3d& a, const Vector3d& b) {
    return (a - b).norm() * 1e3;
}

double percentBetween(const AxisCalibration& a, const AxisCalibration& b) {
    const Matrix3d change = a.matrix.inverse() * b.matrix - Matrix3d::Identity();
    return change.cwiseAbs().maxCoeff() * 100;
}

/// What the zeros differ by, as a reading.
double zeroBetween(const AxisCalibration& a, const AxisCalibration& b) {
    return (a.matrix * (a.zero_counts - b.zero_counts)).norm();
}

std::vector<std::string> rowOf(const BoardCalibration& one, const BoardCalibration& other) {
    return {one.id,
            between(one.q_segment_board, other.q_segment_board, 2,
                    [](const Quaterniond& a, const Quaterniond& b) { return degrees(angleBetween(a, b)); }),
            between(one.p_segment_board_m, other.p_segment_board_m, 1, millimetresBetween),
            text::number(degrees(zeroBetween(one.gyro, other.gyro)), 3),
            text::number(percentBetween(one.gyro, other.gyro), 3),
            text::number(zeroBetween(one.accel, other.accel) / kStandardGravity_m_per_s2 * 1e3, 1),
            text::number(percentBetween(one.accel, other.accel), 3)};
}

std::vector<std::string> rowOf(const SourceCalibration& one, const SourceCalibration& other) {
    std::string offset = kUnknown;
    for (const auto& [detector, offset_s] : one.offsets_s)
        if (const auto same = other.offsets_s.find(detector); same != other.offsets_s.end()) {
            offset = text::number((same->second - offset_s) * 1e6, 1);
            break;
        }
    return {one.id, offset, between(one.p_segment_source_m, other.p_segment_source_m, 1, millimetresBetween)};
}

bool differs(const std::vector<std::string>& row) {
    return std::any_of(row.begin() + 1, row.end(), [](const std::string& cell) {
        return cell.find_first_of("123456789") != std::string::npos;
    });
}

/// What only one of two says of a part.
bool isOneSided(const BoardCalibration& one, const BoardCalibration& other) {
    return one.q_segment_board.has_value() != other.q_segment_board.has_value() ||
           one.p_segment_board_m.has_value() != other.p_segment_board_m.has_value();
}
bool isOneSided(const SourceCalibration& one, const SourceCalibration& other) {
    const auto detectors = [](const SourceCalibration& source) {
        std::vector<std::string> names;
        for (const auto& [detector, offset_s] : source.offsets_s)
            names.push_back(detector);
        return names;
    };
    return detectors(one) != detectors(other) ||
           one.p_segment_source_m.has_value() != other.p_segment_source_m.has_value();
}

template <class Part>
void addRows(const std::vector<Part>& ones, const std::vector<Part>& others, CalibrationTable table,
             std::vector<CalibrationTable>& tables) {
    const auto addUnknown = [&table](const std::string& id) {
        table.rows.push_back({id});
        table.rows.back().resize(table.columns.size(), kUnknown);
    };
    for (const Part& one : ones) {
        const auto other = std::ranges::find(others, one.id, &Part::id);
        if (other == others.end())
            addUnknown(one.id);
        else if (auto row = rowOf(one, *other); differs(row) || isOneSided(one, *other))
            table.rows.push_back(std::move(row));
    }
    for (const Part& other : others)
        if (std::ranges::find(ones, other.id, &Part::id) == ones.end())
            addUnknown(other.id);
    if (!table.rows.empty())
        tables.push_back(std::move(table));
}

/// Only of boards where they differ; most suits have none.
void addMagnetometers(const Calibration& one, const Calibration& other,
                      std::vector<CalibrationTable>& tables) {
    CalibrationTable table{"Magnetometers",
                           "How far the values are apart.",
                           {"board", "magnetometer's zero, µT", "its slopes, %"},
                           {}};
    for (const BoardCalibration& board : one.boards) {
        const BoardCalibration* same = other.findBoard(board.id);
        if (!same || (!board.mag && !same->mag))
            continue;
        std::vector<std::string> row = {board.id, between(board.mag, same->mag, 2, zeroBetween),
                                        between(board.mag, same->mag, 3, percentBetween)};
        if (differs(row) || board.mag.has_value() != same->mag.has_value())
            table.rows.push_back(std::move(row));
    }
    if (!table.rows.empty())
        tables.push_back(std::move(table));
}

}  // namespace

std::vector<CalibrationTable> compareCalibrations(const Calibration& one, const Calibration& other) {
    std::vector<CalibrationTable> tables;
    addRows(one.boards, other.boards,
            {"Boards",
             "How far the values are apart.",
             {"board", "mounting, °", "place, mm", "gyroscope's zero, °/s", "its slopes, %",
              "accelerometer's zero, mg", "its slopes, %"},
             {}},
            tables);
    addMagnetometers(one, other, tables);
    addRows(one.sources, other.sources,
            {"Sources",
             "How much later the other one takes each for; 1 µs is a third of a millimetre.",
             {"source", "offset, µs", "place, mm"},
             {}},
            tables);
    return tables;
}

}  // namespace noctule
