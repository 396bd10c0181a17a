// SPDX-License-Identifier: Apache-2.0
#include "core/report/calibration_documents.h"

#include <cmath>

#include "core/body/text.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kMillimetres = 1e3;

std::string millimetres(double value_m) {
    return text::number(value_m * kMillimetres, 2);
}

std::string milliG(double value_m_per_s2) {
    return text::number(value_m_per_s2 / kStandardGravity_m_per_s2 * 1e3, 2);
}

std::string percent3(double share) {
    return text::number(share * 100, 3);
}

std::string inDegrees(double angle_rad, int decimals = 2) {
    return text::number(degrees(angle_rad), decimals);
}

/// "18 of 18 boards"
std::string counted(size_t found, size_t all, const char* what) {
    return std::to_string(found) + " of " + std::to_string(all) + " " + what;
}

template <class Parts, class Test>
size_t countOf(const Parts& parts, Test test) {
    return static_cast<size_t>(std::ranges::count_if(parts, test));
}

CalibrationTable offsetTable(const SourceOffsetReport& report) {
    CalibrationTable table{"Offsets",
                           "From the start of the drive to what the detector reports at distance 0.",
                           {"source", "offset, µs", "sigma, mm", "pairs", "residual rms, mm"},
                           {}};
    const double c_m_per_s = report.measurements.empty() ? 343 : report.measurements.front().c_m_per_s;
    for (const SourceOffset& source : report.sources) {
        const bool found = source.calibrated;
        table.rows.push_back({source.id, found ? text::number(source.offset_s * 1e6, 2) : "–",
                              found ? millimetres(source.sigma_s * c_m_per_s) : "–",
                              std::to_string(source.measurements), found ? millimetres(source.rms_m) : "–"});
    }
    return table;
}

CalibrationTable distanceErrorTable(const SourceOffsetReport& report) {
    CalibrationTable table{"Errors of distances that took no part",
                           "Each distance measured with offsets made without it. The paper had 2.35 mm in "
                           "the mean, 1.92 mm deviation.",
                           {"which", "distances", "mean, mm", "deviation, mm", "worst, mm"},
                           {}};
    const auto add = [&table](const char* which, const DistanceErrors& errors) {
        table.rows.push_back({which, std::to_string(errors.count), millimetres(errors.mean_m),
                              millimetres(errors.deviation_m), millimetres(errors.worst_m)});
    };
    add("used", report.leave_one_out);
    add("with outliers", report.all_left_out);
    return table;
}

}  // namespace

CalibrationDocument documentOf(const SourceOffsetReport& report) {
    CalibrationDocument document;
    document.procedure = "Source offsets";
    document.summary =
        "Offsets of " +
        counted(countOf(report.sources, [](const SourceOffset& source) { return source.calibrated; }),
                report.sources.size(), "sources") +
        "; a distance is right within " + millimetres(report.leave_one_out.mean_m) + " mm in the mean";
    document.findings = report.findings;
    document.tables = {offsetTable(report), distanceErrorTable(report)};
    return document;
}

CalibrationDocument documentOf(const AccelerometerReport& report) {
    CalibrationDocument document;
    document.procedure = "Accelerometers";
    CalibrationTable table{
        "Boards",
        "Standard deviations of the worst axis. Good: zeros within 2 mg, slopes within 0.04 %.",
        {"board", "positions", "zero, mg", "slope, %", "worst |a| − g, m/s²"},
        {}};
    for (const AccelerometerBoard& board : report.boards) {
        double worst = 0;
        for (const AccelerometerPosition& position : board.positions)
            worst = std::max(worst, std::abs(position.residual_m_per_s2));
        table.rows.push_back({board.board.id, std::to_string(board.positions.size()),
                              board.axes ? milliG(board.sigmaZero_m_per_s2()) : "–",
                              board.axes ? percent3(board.sigmaSlope()) : "–", text::number(worst, 4)});
    }
    document.summary =
        "Accelerometers of " +
        counted(
            countOf(report.boards, [](const AccelerometerBoard& board) { return board.axes.has_value(); }),
            report.boards.size(), "boards");
    document.findings = report.findings;
    document.tables = {table};
    return document;
}

CalibrationDocument documentOf(const GyroscopeReport& report) {
    CalibrationDocument document;
    document.procedure = "Gyroscopes";
    CalibrationTable table{
        "Boards",
        "Standard deviations of the worst axis. Good: zeros within 0.02 °/s, slopes within 0.03 %.",
        {"board", "turns and rests", "zero, °/s", "slope, %"},
        {}};
    for (const GyroscopeBoard& board : report.boards)
        table.rows.push_back({board.board.id, std::to_string(board.turns.size()),
                              board.axes ? text::number(degrees(board.sigmaZero_rad_per_s()), 4) : "–",
                              board.axes ? percent3(board.sigmaSlope()) : "–"});
    document.summary =
        "Gyroscopes of " +
        counted(countOf(report.boards, [](const GyroscopeBoard& board) { return board.axes.has_value(); }),
                report.boards.size(), "boards") +
        "; the table turned at " + text::number(report.rpm, 3) + " rpm" +
        (report.speed_measured ? " by gravity's ripple" : ", its nominal speed");
    document.findings = report.findings;
    document.tables = {table};
    return document;
}

CalibrationDocument documentOf(const RestPoseReport& report) {
    CalibrationDocument document;
    document.procedure = "Rest pose";
    CalibrationTable boards{
        "Boards",
        "How each sits on its segment. A turn about the vertical cannot be seen in a rest pose.",
        {"board", "leans, °", "sigma, °", "gyroscope's zero, counts"},
        {}};
    for (const BoardAtRest& board : report.boards)
        if (board.measured)
            boards.rows.push_back({board.id, inDegrees(board.tilt_from_suit_rad),
                                   inDegrees(board.sigma_mounting_tilt_rad),
                                   text::number(board.gyro_zero_counts.x(), 1) + " " +
                                       text::number(board.gyro_zero_counts.y(), 1) + " " +
                                       text::number(board.gyro_zero_counts.z(), 1)});
    CalibrationTable joints{"Pose",
                            "How the performer stood, against the rest pose asked for.",
                            {"joint", "off, °", "sigma, °"},
                            {}};
    for (const JointAtRest& joint : report.joints)
        joints.rows.push_back({text::jointLabel(joint.joint), inDegrees(joint.deviation_rad.norm()),
                               inDegrees(joint.sigma_rad)});
    document.summary =
        "Boards aligned: " +
        counted(countOf(report.boards, [](const BoardAtRest& board) { return board.measured; }),
                report.boards.size(), "") +
        "with " + text::plural(report.distances, "distance", "distances");
    document.findings = report.findings;
    document.tables = {boards, joints};
    return document;
}

CalibrationDocument documentOf(const StillCheckReport& report) {
    CalibrationDocument document;
    document.procedure = "Still check";
    CalibrationTable boards{"Boards",
                            "Against the calibration in force.",
                            {"board", "tilt, °", "gyroscope's zero, °/s", "distances, mm"},
                            {}};
    for (const BoardStillCheck& board : report.boards)
        if (board.heard)
            boards.rows.push_back({board.id, inDegrees(board.tilt_change_rad),
                                   inDegrees(board.gyro_change_rad_per_s.norm(), 3),
                                   board.ranges > 0 ? millimetres(board.range_residual_m) : "–"});
    const size_t slipped = countOf(report.boards, [](const BoardStillCheck& board) { return board.slipped; });
    document.summary =
        slipped == 0 ? "Nothing has moved" : counted(slipped, report.boards.size(), "boards moved");
    document.findings = report.findings;
    document.tables = {boards};
    return document;
}

}  // namespace noctule
