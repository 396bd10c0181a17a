// SPDX-License-Identifier: Apache-2.0
#include "core/math/json.h"
#include "core/report/calibration_documents.h"

namespace noctule {
namespace {

using Json = nlohmann::json;

Json toJson(const DistanceErrors& errors) {
    return {{"count", errors.count},
            {"mean_m", errors.mean_m},
            {"deviation_m", errors.deviation_m},
            {"worst_m", errors.worst_m}};
}

Json toJson(const JigMeasurement& m, const Suit& suit) {
    return {{"placement", m.placement},
            {"source", suit.sources[static_cast<size_t>(m.source)].id},
            {"board", suit.boards[static_cast<size_t>(m.board)].id},
            {"distance_m", m.distance_m},
            {"pulses", m.pulses},
            {"used", m.used},
            {"residual_m", m.residual_m},
            {"left_out_m", m.left_out_m}};
}

Json rowsOf(const Matrix3d& matrix) {
    Json rows = Json::array();
    for (int row = 0; row < 3; ++row)
        rows.push_back(json::fromVector(matrix.row(row)));
    return rows;
}

void addAxes(Json& board, const std::optional<AxisCalibration>& axes, const Matrix3d& sigma_matrix) {
    if (!axes)
        return;
    board["zero_counts"] = json::fromVector(axes->zero_counts);
    if (axes->sigma_zero_counts)
        board["sigma_zero_counts"] = json::fromVector(*axes->sigma_zero_counts);
    board["matrix"] = rowsOf(axes->matrix);
    board["sigma_matrix"] = rowsOf(sigma_matrix);
}

}  // namespace

Json findingsJson(const std::vector<Finding>& findings) {
    Json reasons = Json::array(), objects = Json::array();
    for (const Finding& finding : findings) {
        reasons.push_back(sentenceOf(finding));
        objects.push_back({{"verdict", gradeWord(finding.grade)},
                           {"part", finding.part},
                           {"what", finding.what},
                           {"remedy", finding.remedy}});
    }
    return {{"verdict", gradeWord(gradeOf(findings))}, {"reasons", reasons}, {"findings", objects}};
}

Json toJson(const SourceOffsetReport& report) {
    Json sources = Json::array(), measurements = Json::array();
    for (const SourceOffset& source : report.sources) {
        Json row{{"id", source.id}, {"calibrated", source.calibrated}, {"measurements", source.measurements}};
        if (source.calibrated)
            row.update({{"offset_s", source.offset_s}, {"sigma_s", source.sigma_s}, {"rms_m", source.rms_m}});
        sources.push_back(row);
    }
    for (const JigMeasurement& measurement : report.measurements)
        measurements.push_back(toJson(measurement, report.suit));
    Json json{{"detector", report.detector},
              {"sources", sources},
              {"measurements", measurements},
              {"leave_one_out", toJson(report.leave_one_out)},
              {"all_left_out", toJson(report.all_left_out)},
              {"sound", {{"scale", report.sound.scale}, {"sigma", report.sound_scale_sigma}}}};
    for (const MicDelay& delay : report.mic_delays)
        json["mic_delays"].push_back(
            {{"id", delay.id}, {"delay_s", delay.delay_s}, {"sigma_s", delay.sigma_s}});
    return json;
}

Json toJson(const AccelerometerReport& report) {
    Json boards = Json::array();
    for (const AccelerometerBoard& board : report.boards) {
        Json row{{"id", board.board.id}, {"verdict", gradeWord(board.grade)}, {"positions", Json::array()}};
        addAxes(row, board.axes, board.sigma_matrix);
        for (const AccelerometerPosition& position : board.positions)
            row["positions"].push_back({{"side", position.side ? position.side->name() : "tilted"},
                                        {"begin_s", position.begin_s},
                                        {"end_s", position.end_s},
                                        {"residual_m_per_s2", position.residual_m_per_s2},
                                        {"off_level_deg", degrees(position.off_level_rad)}});
        boards.push_back(row);
    }
    return {{"boards", boards}};
}

Json toJson(const GyroscopeReport& report) {
    Json boards = Json::array();
    for (const GyroscopeBoard& board : report.boards) {
        Json row{{"id", board.board.id}, {"verdict", gradeWord(board.grade)}, {"turns", Json::array()}};
        addAxes(row, board.axes, board.sigma_matrix);
        for (const GyroscopeTurn& turn : board.turns)
            row["turns"].push_back({{"about", turn.about ? turn.about->name() : "rest"},
                                    {"begin_s", turn.begin_s},
                                    {"end_s", turn.end_s},
                                    {"residual_rad_per_s", json::fromVector(turn.residual_rad_per_s)}});
        boards.push_back(row);
    }
    return {{"boards", boards},
            {"turntable",
             {{"nominal_rpm", report.nominal_rpm},
              {"rpm", report.rpm},
              {"sigma_rpm", report.sigma_rpm},
              {"measured", report.speed_measured}}}};
}

Json toJson(const RestPoseReport& report) {
    Json boards = Json::array(), joints = Json::array();
    for (const BoardAtRest& board : report.boards) {
        Json row{{"id", board.id}, {"measured", board.measured}};
        if (board.measured)
            row.update({{"q_segment_board", json::fromQuaternion(board.q_segment_board)},
                        {"leans_deg", degrees(board.tilt_from_suit_rad)},
                        {"sigma_tilt_deg", degrees(board.sigma_mounting_tilt_rad)},
                        {"sigma_turn_deg", degrees(board.sigma_turn_rad)},
                        {"gyro_zero_counts", json::fromVector(board.gyro_zero_counts)},
                        {"sigma_gyro_zero_counts", json::fromVector(board.sigma_gyro_zero_counts)}});
        boards.push_back(row);
    }
    for (const JointAtRest& joint : report.joints)
        joints.push_back({{"joint", joint.joint},
                          {"deviation_deg", json::fromVector(joint.deviation_rad * degrees(1))},
                          {"sigma_deg", degrees(joint.sigma_rad)}});
    return {{"boards", boards},
            {"joints", joints},
            {"distances", report.distances},
            {"distance_rms_m", report.distance_rms_m},
            {"iterations", report.iterations},
            {"converged", report.converged}};
}

Json toJson(const LeftOver& left) {
    return {{"turn_deg", degrees(left.turn_rad)},
            {"force_m_per_s2", left.force_m_per_s2},
            {"distance_m", left.distance_m}};
}

Json toJson(const BoardInMotion& board) {
    Json row{{"id", board.id}, {"measured", board.measured}};
    if (!board.measured)
        return row;
    row.update({{"q_segment_board", json::fromQuaternion(board.q_segment_board)},
                {"sigma_turn_deg", json::fromVector(board.sigma_turn_rad * degrees(1))},
                {"observed", board.observed},
                {"turned_deg", degrees(board.turned_rad)},
                {"p_segment_board_m", json::fromVector(board.p_segment_board_m)},
                {"sigma_place_m", json::fromVector(board.sigma_place_m)},
                {"tissue_mean_deg", degrees(board.tissue_mean_rad)},
                {"tissue_spread_deg", degrees(board.tissue_spread_rad)},
                {"before", toJson(board.before)},
                {"after", toJson(board.after)}});
    return row;
}

Json toJson(const MotionReport& report) {
    Json boards = Json::array(), sources = Json::array(), bones = Json::array();
    for (const BoardInMotion& board : report.boards)
        boards.push_back(toJson(board));
    for (const SourceInMotion& source : report.sources)
        sources.push_back({{"id", source.id},
                           {"p_segment_source_m", json::fromVector(source.p_segment_source_m)},
                           {"sigma_place_m", json::fromVector(source.sigma_place_m)},
                           {"offset_m", source.offset_m},
                           {"sigma_offset_m", source.sigma_offset_m}});
    for (const BoneInMotion& bone : report.bones)
        bones.push_back({{"joint", bone.joint}, {"scale", bone.scale}, {"sigma", bone.sigma}});
    return {{"boards", boards},
            {"sources", sources},
            {"bones", bones},
            {"sound", {{"scale", report.sound_scale}, {"sigma", report.sigma_sound_scale}}},
            {"moved_s", report.moved_s},
            {"distances", report.distances},
            {"iterations", report.iterations},
            {"converged", report.converged}};
}

Json toJson(const StillCheckReport& report) {
    Json boards = Json::array(), pairs = Json::array();
    for (const BoardStillCheck& board : report.boards) {
        Json row{{"id", board.id}, {"heard", board.heard}, {"slipped", board.slipped}};
        if (board.heard)
            row.update({{"tilt_deg", degrees(board.tilt_change_rad)},
                        {"gyro_change_rad_per_s", json::fromVector(board.gyro_change_rad_per_s)},
                        {"range_residual_m", board.range_residual_m},
                        {"ranges", board.ranges}});
        boards.push_back(row);
    }
    for (const PairStillCheck& pair : report.pairs)
        pairs.push_back({{"source", pair.source}, {"board", pair.board}, {"residual_m", pair.residual_m}});
    return {{"boards", boards}, {"pairs", pairs}};
}

}  // namespace noctule
