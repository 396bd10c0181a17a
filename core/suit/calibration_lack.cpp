// SPDX-License-Identifier: Apache-2.0
#include "core/suit/calibration_lack.h"

#include <algorithm>

namespace noctule {
namespace {

bool hasHistory(const Calibration& calibration) {
    const auto told = [](const auto& part) { return !part.made.empty(); };
    return std::ranges::any_of(calibration.boards, told) || std::ranges::any_of(calibration.sources, told);
}

bool hasOffsets(const SourceCalibration* source) {
    return source && !source->offsets_s.empty();
}

bool isNominalMatrix(const AxisCalibration& axis, double full_scale) {
    return axis.matrix.isApprox(AxisCalibration::nominal(full_scale).matrix, 1e-12);
}

/// A rest pose finds zeros of sensors, so only the matrix tells a sensor's own calibration.
bool isCalibrated(const BoardCalibration& board, const char* task, const AxisCalibration& axis,
                  double full_scale) {
    return board.made.contains(task) || !isNominalMatrix(axis, full_scale);
}

bool hasRestPose(const BoardCalibration& board) {
    return board.made.contains("rest-pose") || board.made.contains("motion") || board.q_segment_board ||
           board.p_segment_board_m;
}

/// "gyroscopes of 3 boards"; "gyroscopes" of all boards.
std::string partWords(const std::string& what, const std::vector<int>& lacking, int all,
                      const std::string& part) {
    if (lacking.empty() || static_cast<int>(lacking.size()) == all)
        return lacking.empty() ? "" : what;
    return what + " of " + std::to_string(lacking.size()) + " " + part + (lacking.size() == 1 ? "" : "s");
}

}  // namespace

bool knowsAccelerometer(const Board& board, const BoardCalibration* known) {
    return known && isCalibrated(*known, "accelerometers", known->accel, board.accel_full_scale_m_per_s2);
}
bool knowsGyroscope(const Board& board, const BoardCalibration* known) {
    return known && isCalibrated(*known, "gyroscopes", known->gyro, board.gyro_full_scale_rad_per_s);
}

bool CalibrationLack::isNone() const {
    return sources.empty() && accelerometers.empty() && gyroscopes.empty() && rest_pose.empty();
}

bool CalibrationLack::ofAllOffsets() const {
    return source_count > 0 && static_cast<int>(sources.size()) == source_count;
}

bool CalibrationLack::ofMostGyroscopes() const {
    return board_count > 0 && 2 * static_cast<int>(gyroscopes.size()) > board_count;
}

bool CalibrationLack::isTotal() const {
    const auto all = [this](const std::vector<int>& boards) {
        return static_cast<int>(boards.size()) == board_count;
    };
    return !isNone() && static_cast<int>(sources.size()) == source_count && all(accelerometers) &&
           all(gyroscopes) && all(rest_pose);
}

CalibrationLack lackOf(const Suit& suit, const Calibration& calibration) {
    CalibrationLack lack;
    lack.source_count = static_cast<int>(suit.sources.size());
    lack.board_count = static_cast<int>(suit.boards.size());
    for (int s = 0; s < lack.source_count; ++s)
        if (!hasOffsets(calibration.findSource(suit.sources[static_cast<size_t>(s)].id)))
            lack.sources.push_back(s);
    if (suit.isFixed())
        return lack;  // nothing of it moves
    const bool believed = !hasHistory(calibration) && !lack.ofAllOffsets();
    for (int b = 0; b < lack.board_count; ++b) {
        const Board& board = suit.boards[static_cast<size_t>(b)];
        const BoardCalibration* known = calibration.findBoard(board.id);
        if (known && believed)
            continue;
        if (!knowsAccelerometer(board, known))
            lack.accelerometers.push_back(b);
        if (!knowsGyroscope(board, known))
            lack.gyroscopes.push_back(b);
        if (!known || !hasRestPose(*known))
            lack.rest_pose.push_back(b);
    }
    return lack;
}

std::string lackInWords(const CalibrationLack& lack) {
    std::vector<std::string> parts{
        partWords("source offsets", lack.sources, lack.source_count, "source"),
        partWords("accelerometers", lack.accelerometers, lack.board_count, "board"),
        partWords("gyroscopes", lack.gyroscopes, lack.board_count, "board"),
        partWords("rest pose", lack.rest_pose, lack.board_count, "board")};
    std::erase(parts, "");
    std::string words;
    for (size_t i = 0; i < parts.size(); ++i)
        words += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
    return words;
}

Grade gradeOf(const CalibrationLack& lack, const std::string& sensors) {
    const auto uses = [&sensors](char sensor) { return sensors.find(sensor) != std::string::npos; };
    if ((uses('D') && lack.ofAllOffsets()) || (uses('G') && lack.ofMostGyroscopes()))
        return Grade::kNotUsable;
    const bool suffers = (uses('D') && !lack.sources.empty()) || (uses('G') && !lack.gyroscopes.empty()) ||
                         (uses('A') && !lack.accelerometers.empty()) || !lack.rest_pose.empty();
    return suffers ? Grade::kUsable : Grade::kGood;
}

std::string lackClause(const CalibrationLack& lack) {
    if (lack.isNone())
        return "";
    if (lack.isTotal())
        return "this take has no calibration. Process it with one.";
    return "this take was made without calibration of " + lackInWords(lack) +
           ". Process it with a calibration that has them.";
}

std::string lackSentence(const CalibrationLack& lack) {
    const std::string clause = lackClause(lack);
    return clause.empty() ? clause : "T" + clause.substr(1);
}

}  // namespace noctule
