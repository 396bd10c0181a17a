// SPDX-License-Identifier: Apache-2.0
#include "core/suit/calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/math/json.h"
#include "core/suit/json_object.h"

namespace noctule {

namespace {

constexpr std::array<const char*, 3> kSoundModels{"cramer", "linear", "fixed"};

nlohmann::json fromMatrix(const Matrix3d& m) {
    nlohmann::json rows = nlohmann::json::array();
    for (int row = 0; row < 3; ++row)
        rows.push_back(json::fromVector(m.row(row)));
    return rows;
}

nlohmann::json toJson(const AxisCalibration& axis) {
    nlohmann::json members{{"zero_counts", json::fromVector(axis.zero_counts)},
                           {"matrix", fromMatrix(axis.matrix)}};
    if (axis.sigma_zero_counts)
        members["sigma_zero_counts"] = json::fromVector(*axis.sigma_zero_counts);
    return members;
}

/// Serial number and history, where there are any.
void addOrigin(nlohmann::json& members, const std::string& serial, const CalibrationHistory& history) {
    if (!serial.empty())
        members["serial"] = serial;
    for (const auto& [procedure, made] : history)
        members["made"][procedure] = {{"created_utc", made.created_utc}, {"verdict", made.verdict}};
}

CalibrationHistory readHistory(JsonObject& json, std::optional<Error>& error) {
    CalibrationHistory history;
    const nlohmann::json object = json.objectOrEmpty("made");
    for (const auto& [procedure, value] : object.items()) {
        JsonObject made(value, json.what() + ": made: " + procedure, error);
        history[procedure] = {made.textOr("created_utc", ""), made.textOr("verdict", "")};
    }
    return history;
}

nlohmann::json toJson(const BoardCalibration& board) {
    nlohmann::json members{{"id", board.id}, {"gyro", toJson(board.gyro)}, {"accel", toJson(board.accel)}};
    addOrigin(members, board.serial, board.made);
    if (board.mag)
        members["mag"] = toJson(*board.mag);
    if (board.mic_delay_s != 0)
        members["mic_delay_s"] = board.mic_delay_s;
    if (board.p_segment_board_m)
        members["p_segment_board_m"] = json::fromVector(*board.p_segment_board_m);
    if (board.q_segment_board)
        members["q_segment_board"] = json::fromQuaternion(*board.q_segment_board);
    if (board.sigma_mounting_rad)
        members["sigma_mounting_rad"] = json::fromVector(*board.sigma_mounting_rad);
    if (board.flesh)
        members["flesh"] = toJson(*board.flesh);
    return members;
}

nlohmann::json toJson(const SourceCalibration& source) {
    nlohmann::json members{{"id", source.id}, {"offsets_s", source.offsets_s}};
    addOrigin(members, source.serial, source.made);
    if (!source.sigma_s.empty())
        members["sigma_s"] = source.sigma_s;
    if (source.resonance_hz)
        members["resonance_hz"] = *source.resonance_hz;
    if (source.q)
        members["q"] = *source.q;
    if (source.p_segment_source_m)
        members["p_segment_source_m"] = json::fromVector(*source.p_segment_source_m);
    return members;
}

nlohmann::json toJson(const SoundModel& sound) {
    nlohmann::json members{{"model", kSoundModels[static_cast<size_t>(sound.kind)]}, {"scale", sound.scale}};
    if (sound.kind == SoundModel::Kind::kFixed)
        members["c_m_per_s"] = sound.c_m_per_s;
    return members;
}

SoundModel readSound(JsonObject json) {
    SoundModel sound;
    const std::string model = json.textOr("model", kSoundModels[0]);
    const auto found = std::find(kSoundModels.begin(), kSoundModels.end(), model);
    if (found == kSoundModels.end()) {
        json.fail(ErrorKind::kUnusable, "model", "must be cramer, linear or fixed");
        return sound;
    }
    sound.kind = static_cast<SoundModel::Kind>(found - kSoundModels.begin());
    if (sound.kind == SoundModel::Kind::kFixed) {
        json.number("c_m_per_s");
        sound.c_m_per_s = json.positiveOr("c_m_per_s", sound.c_m_per_s);
    }
    sound.scale = json.positiveOr("scale", 1);
    return sound;
}

/// Detector name -> seconds.
std::map<std::string, double> readSeconds(JsonObject& json, const char* member) {
    std::map<std::string, double> seconds;
    const nlohmann::json object = json.objectOrEmpty(member);
    for (const auto& [detector, value] : object.items()) {
        if (value.is_number() && std::isfinite(value.get<double>()))
            seconds[detector] = value.get<double>();
        else if (!value.is_null())
            json.fail(ErrorKind::kUnreadable, member, "of '" + detector + "' must be a finite number");
    }
    return seconds;
}

SourceCalibration readSourceCalibration(JsonObject& json, std::optional<Error>& error) {
    SourceCalibration source;
    source.id = json.name("id");
    json.setWhat(json.what() + " '" + source.id + "'");
    source.serial = json.nameOr("serial", "");
    source.made = readHistory(json, error);
    source.offsets_s = readSeconds(json, "offsets_s");
    source.sigma_s = readSeconds(json, "sigma_s");
    source.resonance_hz = json.optionalPositive("resonance_hz");
    source.q = json.optionalPositive("q");
    source.p_segment_source_m = json.optionalVector("p_segment_source_m");
    return source;
}

AxisCalibration readAxes(JsonObject& board, const char* member, std::optional<Error>& error) {
    const nlohmann::json entry = board.objectOrEmpty(member);
    JsonObject json(entry, board.what() + ": " + member, error);
    AxisCalibration axes;
    axes.zero_counts = json.vector("zero_counts");
    axes.matrix = json.matrix("matrix");
    axes.sigma_zero_counts = json.optionalVector("sigma_zero_counts");
    return axes;
}

BoardCalibration readBoardCalibration(JsonObject& json, std::optional<Error>& error) {
    BoardCalibration board;
    board.id = json.name("id");
    json.setWhat(json.what() + " '" + board.id + "'");
    board.serial = json.nameOr("serial", "");
    board.made = readHistory(json, error);
    board.gyro = readAxes(json, "gyro", error);
    board.accel = readAxes(json, "accel", error);
    if (!json.objectOrEmpty("mag").empty())
        board.mag = readAxes(json, "mag", error);
    board.mic_delay_s = json.numberOr("mic_delay_s", 0);
    board.p_segment_board_m = json.optionalVector("p_segment_board_m");
    board.q_segment_board = json.optionalQuaternion("q_segment_board");
    board.sigma_mounting_rad = json.optionalVector("sigma_mounting_rad");
    board.flesh = fleshFromJson(json.objectOrEmpty("flesh"), json.what() + ": flesh", error);
    return board;
}

/// Calls readOne(JsonObject&) for every entry of the list; ids must differ.
template <class ReadOne>
void readEntries(const nlohmann::json& list, const std::string& what, std::optional<Error>& error,
                 ReadOne readOne) {
    std::set<std::string> ids;
    for (size_t i = 0; i < list.size(); ++i) {
        JsonObject json(list[i], what + " " + std::to_string(i + 1), error);
        if (!ids.insert(readOne(json)).second)
            json.fail(ErrorKind::kUnusable, "id", "is there twice");
    }
}

template <class Entry>
const Entry* findEntry(const std::vector<Entry>& entries, const std::string& id) {
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.id == id; });
    return found == entries.end() ? nullptr : &*found;
}

}  // namespace

AxisCalibration AxisCalibration::nominal(double full_scale) {
    AxisCalibration axes;
    axes.matrix = Matrix3d::Identity() * (full_scale / 2048);
    return axes;
}

const BoardCalibration* Calibration::findBoard(const std::string& id) const {
    return findEntry(boards, id);
}

const SourceCalibration* Calibration::findSource(const std::string& id) const {
    return findEntry(sources, id);
}

Calibration nominalCalibration(const Suit& suit) {
    Calibration calibration;
    for (const Board& board : suit.boards) {
        BoardCalibration nominal;
        nominal.id = board.id;
        nominal.gyro = AxisCalibration::nominal(board.gyro_full_scale_rad_per_s);
        nominal.accel = AxisCalibration::nominal(board.accel_full_scale_m_per_s2);
        calibration.boards.push_back(nominal);
    }
    return calibration;
}

nlohmann::json toJson(const Calibration& calibration) {
    nlohmann::json sources = nlohmann::json::array();
    for (const SourceCalibration& source : calibration.sources)
        sources.push_back(toJson(source));
    nlohmann::json boards = nlohmann::json::array();
    for (const BoardCalibration& board : calibration.boards)
        boards.push_back(toJson(board));
    nlohmann::json members{
        {"format", "noctule-calibration"},    {"version", 1},       {"created_utc", calibration.created_utc},
        {"sound", toJson(calibration.sound)}, {"sources", sources}, {"boards", boards}};
    if (!calibration.box_serial.empty())
        members["box_serial"] = calibration.box_serial;
    return members;
}

Result<Calibration> calibrationFromJson(const nlohmann::json& json, const std::string& where) {
    std::optional<Error> error;
    JsonObject object(json, where, error);
    object.expectFormat("noctule-calibration", 1, "is not a calibration",
                        "Choose a file that was exported as a calibration");
    Calibration calibration;
    calibration.created_utc = object.textOr("created_utc", "");
    calibration.box_serial = object.nameOr("box_serial", "");
    const nlohmann::json sound = object.objectOrEmpty("sound");
    calibration.sound = readSound(JsonObject(sound, where + ": sound", error));
    readEntries(object.array("sources", false), where + ": source", error, [&](JsonObject& entry) {
        return calibration.sources.emplace_back(readSourceCalibration(entry, error)).id;
    });
    readEntries(object.array("boards", false), where + ": board", error, [&](JsonObject& entry) {
        return calibration.boards.emplace_back(readBoardCalibration(entry, error)).id;
    });
    if (error)
        return *error;
    return calibration;
}

}  // namespace noctule
