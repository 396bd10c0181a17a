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

/// "17 of 18": of the parts for which the test holds.
template <class Parts, class Test>
std::string counted(const Parts& parts, Test test) {
    return std::to_string(std::ranges::count_if(parts, test)) + " of " + std::to_string(parts.size());
}

/// Without date and takes.
CalibrationDocument document(const std::string& procedure, const std::string& summary,
                             const std::vector<Finding>& findings,
                             const std::vector<CalibrationTable>& tables) {
    return {procedure, summary, "", {}, findings, tables};
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
    const std::string summary = "Offsets of " + counted(report.sources, &SourceOffset::calibrated) +
                                " sources; a distance is right within " +
                                millimetres(report.leave_one_out.mean_m) + " mm in the mean";
    return document("Source offsets", summary, report.findings,
                    {offsetTable(report), distanceErrorTable(report)});
}

CalibrationDocument documentOf(const AccelerometerReport& report) {
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
    const std::string summary =
        "Accelerometers of " +
        counted(report.boards, [](const AccelerometerBoard& board) { return board.axes.has_value(); }) +
        " boards";
    return document("Accelerometers", summary, report.findings, {table});
}

CalibrationDocument documentOf(const GyroscopeReport& report) {
    CalibrationTable table{
        "Boards",
        "Standard deviations of the worst axis. Good: zeros within 0.02 °/s, slopes within 0.03 %.",
        {"board", "turns and rests", "zero, °/s", "slope, %"},
        {}};
    for (const GyroscopeBoard& board : report.boards)
        table.rows.push_back({board.board.id, std::to_string(board.turns.size()),
                              board.axes ? text::number(degrees(board.sigmaZero_rad_per_s()), 4) : "–",
                              board.axes ? percent3(board.sigmaSlope()) : "–"});
    const std::string summary =
        "Gyroscopes of " +
        counted(report.boards, [](const GyroscopeBoard& board) { return board.axes.has_value(); }) +
        " boards; the table turned at " + text::number(report.rpm, 3) + " rpm" +
        (report.speed_measured ? " by gravity's ripple" : ", its nominal speed");
    return document("Gyroscopes", summary, report.findings, {table});
}

CalibrationDocument documentOf(const RestPoseReport& report) {
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
    const std::string summary = "Boards aligned: " + counted(report.boards, &BoardAtRest::measured) +
                                " with " + text::plural(report.distances, "distance", "distances");
    return document("Rest pose", summary, report.findings, {boards, joints});
}

CalibrationDocument documentOf(const StillCheckReport& report) {
    CalibrationTable boards{"Boards",
                            "Against the calibration in force.",
                            {"board", "tilt, °", "gyroscope's zero, °/s", "distances, mm"},
                            {}};
    for (const BoardStillCheck& board : report.boards)
        if (board.heard)
            boards.rows.push_back({board.id, inDegrees(board.tilt_change_rad),
                                   inDegrees(board.gyro_change_rad_per_s.norm(), 3),
                                   board.ranges > 0 ? millimetres(board.range_residual_m) : "–"});
    const bool moved = gradeOf(report.findings) == Grade::kNotUsable;
    return document("Still check", moved ? "The calibration no longer holds" : "Nothing has moved",
                    report.findings, {boards});
}

}  // namespace noctule
