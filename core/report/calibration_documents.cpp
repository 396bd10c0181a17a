// SPDX-License-Identifier: Apache-2.0
#include "core/report/calibration_documents.h"

#include <cmath>

#include "core/body/text.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kMillimetres = 1e3;
/// Of sound, to say a time as a length.
constexpr double kRoughSpeed_m_per_s = 343;

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
    return {procedure, summary, "", {}, findings, tables, {}, {}};
}

/// `within` in the unit of `limit`, which is the good one.
CalibrationNumber number(double within, double limit, int decimals, const std::string& unit,
                         const std::string& what) {
    const std::string bound = text::number(limit, decimals) + unit;
    return {text::number(within, decimals) + unit, what, "under " + bound,
            within <= limit ? Grade::kGood : Grade::kUsable};
}

CalibrationNumber numberOfParts(const std::string& counted_parts, const std::string& what) {
    return {counted_parts, what, "", Grade::kGood};
}

/// Of a person who stands as before: what straps and breathing allow.
constexpr double kStillGood_deg = 5, kStillGood_mm = 20;

/// Of the boards that have values.
template <class Reported>
double worstOf(const std::vector<Reported>& boards, double (Reported::*sigma)() const) {
    double worst = 0;
    for (const Reported& board : boards)
        worst = std::max(worst, board.axes ? (board.*sigma)() : 0);
    return worst;
}

double magnitude(double value) {
    return std::abs(value);
}
double magnitude(const Vector3d& axes) {
    return axes.cwiseAbs().maxCoeff();
}

/// A dot per thing that was measured of a board, in the unit that `scale` makes.
template <class Reported, class Measured, class Residual>
std::vector<CalibrationErrors::Row> errorRows(const std::vector<Reported>& boards,
                                              std::vector<Measured> Reported::*measured, double scale,
                                              std::optional<Residual> Measured::*before,
                                              Residual Measured::*after) {
    std::vector<CalibrationErrors::Row> rows;
    for (const Reported& board : boards) {
        rows.push_back({board.board.id, {}, {}});
        for (const Measured& one : board.*measured) {
            if (const auto& residual = one.*before)
                rows.back().before.push_back(magnitude(*residual) * scale);
            rows.back().after.push_back(magnitude(one.*after) * scale);
        }
    }
    return rows;
}

/// The paper's own mean and deviation (section 4.3).
constexpr double kPaperMean_mm = 2.35, kPaperDeviation_mm = 1.92;

CalibrationErrors offsetErrors(const SourceOffsetReport& report) {
    CalibrationErrors errors{"Error of every distance", "mm", kPaperMean_mm, {}};
    for (const SourceOffset& source : report.sources)
        errors.rows.push_back({source.id, {}, {}});
    for (const JigMeasurement& m : report.measurements) {
        const SourceOffset& source = report.sources[static_cast<size_t>(m.source)];
        auto& row = errors.rows[static_cast<size_t>(m.source)];
        if (source.calibrated)
            row.after.push_back(std::abs(m.left_out_m) * kMillimetres);
        if (source.calibrated && source.before_s)
            row.before.push_back(std::abs(m.residual_m + (source.offset_s - *source.before_s) * m.c_m_per_s) *
                                 kMillimetres);
    }
    return errors;
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
        table.rows.push_back({which, std::to_string(errors.count)});
        for (const double error_m : {errors.mean_m, errors.deviation_m, errors.worst_m})
            table.rows.back().push_back(errors.count > 0 ? millimetres(error_m) : "–");
    };
    add("used", report.leave_one_out);
    add("with outliers", report.all_left_out);
    return table;
}

}  // namespace

CalibrationDocument documentOf(const SourceOffsetReport& report) {
    const std::string judged =
        report.leave_one_out.count > 0
            ? "a distance is right within " + millimetres(report.leave_one_out.mean_m) + " mm in the mean"
            : "no distance could be judged";
    const std::string summary =
        "Offsets of " + counted(report.sources, &SourceOffset::calibrated) + " sources; " + judged;
    CalibrationDocument found = document("Source offsets", summary, report.findings,
                                         {offsetTable(report), distanceErrorTable(report)});
    double worst_sigma_s = 0;
    for (const SourceOffset& source : report.sources)
        worst_sigma_s = std::max(worst_sigma_s, source.sigma_s);
    found.numbers = {number(report.leave_one_out.mean_m * kMillimetres, kPaperMean_mm, 2, " mm",
                            "error of a distance left out, mean"),
                     number(report.leave_one_out.deviation_m * kMillimetres, kPaperDeviation_mm, 2, " mm",
                            "its deviation"),
                     number(worst_sigma_s * kRoughSpeed_m_per_s * kMillimetres, 0.3, 2, " mm",
                            "offset known to, worst source"),
                     numberOfParts(counted(report.sources, &SourceOffset::calibrated), "sources")};
    found.errors = offsetErrors(report);
    return found;
}

CalibrationDocument documentOf(const AccelerometerReport& report) {
    CalibrationTable table{
        "Boards",
        "Standard deviations of the worst axis. Good: zeros within 2 mg, slopes within 0.04 %.",
        {"board", "positions", "σ of zero, mg", "σ of slope, %", "worst deviation from g, m/s²"},
        {}};
    for (const AccelerometerBoard& board : report.boards) {
        double worst = 0;
        for (const AccelerometerPosition& position : board.positions)
            worst = std::max(worst, std::abs(position.residual_m_per_s2));
        table.rows.push_back({board.board.id, std::to_string(board.positions.size()),
                              board.axes ? milliG(board.sigmaZero_m_per_s2()) : "–",
                              board.axes ? percent3(board.sigmaSlope()) : "–", text::number(worst, 4)});
    }
    const std::string calibrated =
        counted(report.boards, [](const AccelerometerBoard& board) { return board.axes.has_value(); });
    CalibrationDocument found =
        document("Accelerometers", "Accelerometers of " + calibrated + " boards", report.findings, {table});
    const double to_mg = 1e3 / kStandardGravity_m_per_s2;
    found.numbers = {number(worstOf(report.boards, &AccelerometerBoard::sigmaZero_m_per_s2) * to_mg, 2, 2,
                            " mg", "zero known to, worst axis"),
                     number(worstOf(report.boards, &AccelerometerBoard::sigmaSlope) * 100, 0.04, 3, " %",
                            "scale known to, worst axis"),
                     numberOfParts(calibrated, "boards")};
    found.errors = {"Error of gravity in every position", "mg", 2,
                    errorRows(report.boards, &AccelerometerBoard::positions, to_mg,
                              &AccelerometerPosition::residual_before_m_per_s2,
                              &AccelerometerPosition::residual_m_per_s2)};
    return found;
}

CalibrationDocument documentOf(const GyroscopeReport& report) {
    CalibrationTable table{
        "Boards",
        "Standard deviations of the worst axis. Good: zeros within 0.02 °/s, slopes within 0.03 %.",
        {"board", "turns and rests", "σ of zero, °/s", "σ of slope, %"},
        {}};
    for (const GyroscopeBoard& board : report.boards)
        table.rows.push_back({board.board.id, std::to_string(board.turns.size()),
                              board.axes ? text::number(degrees(board.sigmaZero_rad_per_s()), 4) : "–",
                              board.axes ? percent3(board.sigmaSlope()) : "–"});
    const std::string calibrated =
        counted(report.boards, [](const GyroscopeBoard& board) { return board.axes.has_value(); });
    const std::string summary =
        "Gyroscopes of " + calibrated + " boards; the table turned at " + text::number(report.rpm, 3) +
        " rpm" + (report.speed_measured ? ", measured by the accelerometers" : ", its nominal speed");
    CalibrationDocument found = document("Gyroscopes", summary, report.findings, {table});
    found.numbers = {
        number(degrees(worstOf(report.boards, &GyroscopeBoard::sigmaZero_rad_per_s)), 0.02, 3, " °/s",
               "zero known to, worst axis"),
        number(worstOf(report.boards, &GyroscopeBoard::sigmaSlope) * 100, 0.03, 3, " %",
               "scale known to, worst axis"),
        {text::number(report.rpm, 3) + " rpm",
         report.speed_measured ? "the table, measured by the accelerometers" : "the table, nominal", "",
         Grade::kGood},
        numberOfParts(calibrated, "boards")};
    found.errors = {"Error of the rate in every turn and rest", "°/s", 0.05,
                    errorRows(report.boards, &GyroscopeBoard::turns, degrees(1),
                              &GyroscopeTurn::residual_before_rad_per_s, &GyroscopeTurn::residual_rad_per_s)};
    return found;
}

CalibrationDocument documentOf(const RestPoseReport& report) {
    CalibrationTable boards{
        "Boards",
        "How each sits on its segment. A turn about the vertical cannot be seen in a rest pose: headings "
        "stay as the suit's file has them.",
        {"board", "leans, °", "sigma, °", "heading, sigma, °", "gyroscope's zero, counts"},
        {}};
    for (const BoardAtRest& board : report.boards)
        if (board.measured)
            boards.rows.push_back({board.id, inDegrees(board.tilt_from_suit_rad),
                                   inDegrees(board.sigma_mounting_tilt_rad),
                                   inDegrees(board.sigma_turn_rad, 0),
                                   text::number(board.gyro_zero_counts.x(), 0) + " " +
                                       text::number(board.gyro_zero_counts.y(), 0) + " " +
                                       text::number(board.gyro_zero_counts.z(), 0)});
    CalibrationTable joints{"Pose",
                            "How the performer stood, against the rest pose asked for.",
                            {"joint", "off, °", "sigma, °"},
                            {}};
    for (const JointAtRest& joint : report.joints)
        joints.rows.push_back({text::jointLabel(joint.joint), inDegrees(joint.deviation_rad.norm()),
                               inDegrees(joint.sigma_rad)});
    const std::string aligned = counted(report.boards, &BoardAtRest::measured);
    const std::string summary = report.distances == 0
                                    ? "Boards aligned by gravity alone: " + aligned
                                    : "Boards aligned: " + aligned + " with " +
                                          text::plural(report.distances, "distance", "distances");
    CalibrationDocument found = document("Rest pose", summary, report.findings, {boards, joints});
    CalibrationErrors errors{"How far each board leans from its place on the performer", "°", 10, {}};
    double worst_sigma_deg = 0, worst_lean_deg = 0, heading_deg = 0;
    for (const BoardAtRest& board : report.boards)
        if (board.measured) {
            errors.rows.push_back({board.id, {}, {degrees(board.tilt_from_suit_rad)}});
            worst_sigma_deg = std::max(worst_sigma_deg, degrees(board.sigma_tilt_rad));
            worst_lean_deg = std::max(worst_lean_deg, degrees(board.tilt_from_suit_rad));
            heading_deg = std::max(heading_deg, degrees(board.sigma_turn_rad));
        }
    const bool lacks_distances = report.sources > 0 && report.distances == 0;
    found.numbers = {
        number(worst_sigma_deg, 0.5, 2, "°", "uncertainty of the vertical, worst board"),
        number(worst_lean_deg, 10, 1, "°", "the board that leans most"),
        {text::number(heading_deg, 0) + "°", "sigma of headings, which are the suit file's", "",
         Grade::kGood},
        {std::to_string(report.distances), "distances heard", report.sources > 0 ? "at least 1" : "",
         lacks_distances ? Grade::kUsable : Grade::kGood}};
    found.errors = std::move(errors);
    return found;
}

namespace {

/// Three numbers of a board's axes.
std::string axesText(const Vector3d& values, int decimals) {
    return text::number(values.x(), decimals) + " " + text::number(values.y(), decimals) + " " +
           text::number(values.z(), decimals);
}

CalibrationTable motionBoards(const MotionReport& report) {
    CalibrationTable table{
        "Boards",
        "How each sits on its segment. A turn that no movement shows keeps the sigma that the rest pose "
        "leaves it: of hands, feet and head, and of a limb about its own bone.",
        {"board", "turned, °", "sigma about x y z, °", "axes seen", "place, sigma, mm", "tissue, °"},
        {}};
    for (const BoardInMotion& board : report.boards)
        if (board.measured)
            table.rows.push_back(
                {board.id, inDegrees(board.turned_rad), axesText(board.sigma_turn_rad * degrees(1), 2),
                 std::to_string(board.observed[0] + board.observed[1] + board.observed[2]),
                 axesText(board.sigma_place_m * kMillimetres, 1), inDegrees(board.tissue_spread_rad)});
    return table;
}

CalibrationTable motionBody(const MotionReport& report) {
    CalibrationTable table{"Bones",
                           "Factor on the length that the performer's measures give.",
                           {"joint at the lower end", "factor", "sigma"},
                           {}};
    for (const BoneInMotion& bone : report.bones)
        table.rows.push_back(
            {text::jointLabel(bone.joint), text::number(bone.scale, 4), text::number(bone.sigma, 4)});
    return table;
}

CalibrationTable motionSources(const MotionReport& report) {
    CalibrationTable table{"Sources",
                           "Where each sits on its segment, and what its distances are too long by.",
                           {"source", "place, mm", "sigma, mm", "too long, mm", "sigma, mm"},
                           {}};
    for (const SourceInMotion& source : report.sources)
        table.rows.push_back({source.id, axesText(source.p_segment_source_m * kMillimetres, 1),
                              axesText(source.sigma_place_m * kMillimetres, 1), millimetres(source.offset_m),
                              millimetres(source.sigma_offset_m)});
    return table;
}

}  // namespace

CalibrationDocument documentOf(const MotionReport& report) {
    const std::string moved = text::number(report.moved_s, 0) + " s of movement";
    if (!report.fitted())
        return document("Movement", "Nothing could be found from " + moved, report.findings, {});
    CalibrationDocument found =
        document("Movement",
                 "Mounting of " + counted(report.boards, &BoardInMotion::measured) + " boards from " + moved +
                     " with " + text::plural(report.distances, "distance", "distances") + " and " +
                     text::plural(report.rests, "rest pose", "rest poses"),
                 report.findings, {motionBoards(report), motionBody(report), motionSources(report)});
    CalibrationErrors errors{"What is left over of each board's distances", "mm", 5, {}};
    double seen_square = 0, seen = 0, axes = 0;
    for (const BoardInMotion& board : report.boards) {
        if (!board.measured)
            continue;
        errors.rows.push_back(
            {board.id, {board.before.distance_m * kMillimetres}, {board.after.distance_m * kMillimetres}});
        for (int axis = 0; axis < 3; ++axis, ++axes)
            if (board.observed[axis]) {
                seen_square += board.sigma_turn_rad[axis] * board.sigma_turn_rad[axis];
                ++seen;
            }
    }
    found.numbers = {number(degrees(std::sqrt(seen_square / std::max(1.0, seen))), 0.7, 2, "°",
                            "sigma of the turns that the movement shows"),
                     numberOfParts(text::number(seen, 0) + " of " + text::number(axes, 0), "turns shown"),
                     {text::number(100 * (report.sound_scale - 1), 2) + " %", "change of the speed of sound",
                      "", Grade::kGood},
                     {std::to_string(report.distances), "distances heard", "", Grade::kGood}};
    found.errors = std::move(errors);
    return found;
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
    const Grade grade = gradeOf(report.findings);
    const std::string summary = !report.unchecked.empty()    ? "Cannot be checked: " + report.unchecked
                                : grade == Grade::kNotUsable ? "The calibration no longer holds"
                                                             : "Nothing has moved";
    CalibrationDocument found = document("Still check", summary, report.findings, {boards});
    if (!report.unchecked.empty()) {
        found.tables.clear();
        return found;
    }
    CalibrationErrors errors{"Tilt of each board against the calibration", "°", kStillGood_deg, {}};
    double worst_deg = 0, worst_mm = 0;
    int ranges = 0;
    for (const BoardStillCheck& board : report.boards)
        if (board.heard) {
            errors.rows.push_back({board.id, {}, {degrees(board.tilt_change_rad)}});
            worst_deg = std::max(worst_deg, degrees(board.tilt_change_rad));
            worst_mm = std::max(worst_mm, board.range_residual_m * kMillimetres);
            ranges += board.ranges;
        }
    found.numbers = {number(worst_deg, kStillGood_deg, 1, "°", "the board that has tilted most"),
                     ranges > 0 ? number(worst_mm, kStillGood_mm, 0, " mm", "the largest change of distances")
                                : CalibrationNumber{"–", "no distances to compare", "", Grade::kGood},
                     numberOfParts(counted(report.boards, &BoardStillCheck::heard), "boards heard")};
    found.errors = std::move(errors);
    return found;
}

}  // namespace noctule
