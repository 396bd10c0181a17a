// SPDX-License-Identifier: Apache-2.0
#include "core/suit/suit.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/math/json.h"
#include "core/suit/json_object.h"

namespace noctule {

namespace {

nlohmann::json toJson(const Board& board) {
    nlohmann::json members{{"id", board.id},
                           {"serial", json::textOrNull(board.serial)},
                           {"segment", json::textOrNull(board.segment)},
                           {"p_segment_board_m", json::fromVector(board.p_segment_board_m)},
                           {"q_segment_board", json::fromQuaternion(board.q_segment_board)},
                           {"stream", board.has_magnetometer ? "imu9" : "imu6"},
                           {"gyro_full_scale_rad_s", board.gyro_full_scale_rad_per_s},
                           {"accel_full_scale_m_s2", board.accel_full_scale_m_per_s2}};
    if (!board.p_board_mic_m.isZero(0))
        members["p_board_mic_m"] = json::fromVector(board.p_board_mic_m);
    if (board.rate_hz != kUsualBoardRate_hz)
        members["rate_hz"] = board.rate_hz;
    if (board.gyro_noise_rad_per_s)
        members["gyro_noise_rad_per_s"] = *board.gyro_noise_rad_per_s;
    if (board.accel_noise_m_per_s2)
        members["accel_noise_m_per_s2"] = *board.accel_noise_m_per_s2;
    return members;
}

nlohmann::json toJson(const Source& source) {
    nlohmann::json members{{"id", source.id},
                           {"serial", json::textOrNull(source.serial)},
                           {"segment", json::textOrNull(source.segment)},
                           {"p_segment_source_m", json::fromVector(source.p_segment_source_m)},
                           {"normal_segment", json::fromVector(source.normal_segment)},
                           {"nominal_hz", source.nominal_hz}};
    if (!source.board.empty())
        members["board"] = source.board;
    return members;
}

Board readBoard(JsonObject& json) {
    Board board;
    board.id = json.name("id");
    json.setWhat(json.what() + " '" + board.id + "'");
    board.serial = json.nameOr("serial", "");
    board.segment = json.nullableName("segment");
    board.p_segment_board_m = json.vector("p_segment_board_m");
    board.q_segment_board = json.quaternion("q_segment_board");
    board.p_board_mic_m = json.optionalVector("p_board_mic_m").value_or(Vector3d::Zero());
    const std::string stream = json.textOr("stream", "imu6");
    if (stream != "imu6" && stream != "imu9")
        json.fail(ErrorKind::kUnusable, "stream", "must be imu6 or imu9");
    board.has_magnetometer = stream == "imu9";
    board.gyro_full_scale_rad_per_s =
        json.positiveOr("gyro_full_scale_rad_s", board.gyro_full_scale_rad_per_s);
    board.accel_full_scale_m_per_s2 =
        json.positiveOr("accel_full_scale_m_s2", board.accel_full_scale_m_per_s2);
    board.rate_hz = json.numberOr("rate_hz", board.rate_hz);
    if (!(board.rate_hz >= kLeastBoardRate_hz && board.rate_hz <= kMostBoardRate_hz))
        json.fail(ErrorKind::kUnreadable, "rate_hz", "must be 10 to 1000 readings a second");
    board.gyro_noise_rad_per_s = json.optionalPositive("gyro_noise_rad_per_s");
    board.accel_noise_m_per_s2 = json.optionalPositive("accel_noise_m_per_s2");
    return board;
}

Source readSource(JsonObject& json) {
    Source source;
    source.id = json.name("id");
    json.setWhat(json.what() + " '" + source.id + "'");
    source.serial = json.nameOr("serial", "");
    source.segment = json.nullableName("segment");
    source.p_segment_source_m = json.vector("p_segment_source_m");
    source.normal_segment = json.unitVector("normal_segment");
    source.nominal_hz = json.positiveOr("nominal_hz", source.nominal_hz);
    source.board = json.nameOr("board", "");
    return source;
}

/// Reads `member` of the suit with `readOne`; the first mistake lands in `error`.
template <class Part>
std::vector<Part> readParts(JsonObject& suit, const char* member, const std::string& singular,
                            const std::string& where, Part (*readOne)(JsonObject&),
                            std::optional<Error>& error) {
    const nlohmann::json list = suit.array(member, true);
    if (list.size() > Suit::kMaxPerSuit) {
        suit.fail(ErrorKind::kUnusable, member, "must not have more than 32 entries");
        return {};
    }
    std::vector<Part> parts;
    std::set<std::string> ids;
    for (const nlohmann::json& entry : list) {
        const std::string what = where + ": " + singular + " " + std::to_string(parts.size() + 1);
        JsonObject json(entry, what, error);
        parts.push_back(readOne(json));
        if (!ids.insert(parts.back().id).second)
            json.fail(ErrorKind::kUnusable, "id", "is there twice");
    }
    return parts;
}

/// A whole number; what is none counts as missing.
std::optional<int64_t> readCount(JsonObject& json, const char* member) {
    const std::optional<double> number = json.optionalPositive(member);
    constexpr double kMost = 1e9;
    if (number && !(*number >= 1 && *number <= kMost))
        json.fail(ErrorKind::kUnreadable, member, "must be a whole number from 1 on");
    return number && *number <= kMost ? std::optional(std::llround(*number)) : std::nullopt;
}

template <class Part>
int findId(const std::vector<Part>& parts, const std::string& id) {
    const auto found = std::find_if(parts.begin(), parts.end(), [&](const Part& p) { return p.id == id; });
    return found == parts.end() ? -1 : static_cast<int>(found - parts.begin());
}

template <class Part>
Status checkParts(const std::vector<Part>& parts, const std::string& singular,
                  const std::vector<std::string>& joint_names, const std::string& where) {
    for (const Part& part : parts)
        if (!part.segment.empty() &&
            std::find(joint_names.begin(), joint_names.end(), part.segment) == joint_names.end())
            return Error{ErrorKind::kUnusable,
                         where + ": " + singular + " '" + part.id + "' sits on segment '" + part.segment +
                             "', which the actor does not have",
                         "Correct the segment in the suit's description or use an actor that has it"};
    return Done{};
}

}  // namespace

bool Suit::isFixed() const {
    const auto is_fixed = [](const auto& part) { return part.segment.empty(); };
    return std::ranges::all_of(boards, is_fixed) && std::ranges::all_of(sources, is_fixed) &&
           boards.size() + sources.size() > 0;
}

int Suit::findBoard(const std::string& id) const {
    return findId(boards, id);
}

int Suit::findSource(const std::string& id) const {
    return findId(sources, id);
}

std::vector<int> Suit::housings() const {
    std::vector<int> boards_of_sources;
    for (const Source& source : sources)
        boards_of_sources.push_back(source.board.empty() ? -1 : findBoard(source.board));
    return boards_of_sources;
}

nlohmann::json toJson(const Suit& suit) {
    nlohmann::json boards = nlohmann::json::array();
    for (const Board& board : suit.boards)
        boards.push_back(toJson(board));
    nlohmann::json sources = nlohmann::json::array();
    for (const Source& source : suit.sources)
        sources.push_back(toJson(source));
    nlohmann::json json{{"format", "noctule-suit"},
                        {"version", 1},
                        {"name", suit.name},
                        {"boards", boards},
                        {"sources", sources}};
    const auto add = [&json](const char* member, const auto& value) {
        if (value)
            json[member] = *value;
    };
    add("carrier_hz", suit.carrier_hz);
    add("pulse_cycles", suit.pulse_cycles);
    add("pulse_interval_samples", suit.pulse_interval_samples);
    add("sample_rate_hz", suit.sample_rate_hz);
    return json;
}

Result<Suit> suitFromJson(const nlohmann::json& json, const std::string& where) {
    std::optional<Error> error;
    JsonObject object(json, where, error);
    object.expectFormat("noctule-suit", 1, "is not a suit", "Choose a file with the description of a suit");
    Suit suit;
    suit.name = object.nameOr("name", "");
    suit.boards = readParts<Board>(object, "boards", "board", where, readBoard, error);
    suit.sources = readParts<Source>(object, "sources", "source", where, readSource, error);
    suit.carrier_hz = object.optionalPositive("carrier_hz");
    suit.pulse_cycles = object.optionalPositive("pulse_cycles");
    suit.pulse_interval_samples = readCount(object, "pulse_interval_samples");
    suit.sample_rate_hz = readCount(object, "sample_rate_hz");
    if (error)
        return *error;
    for (const Source& source : suit.sources)
        if (!source.board.empty() && suit.findBoard(source.board) < 0)
            return Error{ErrorKind::kUnreadable,
                         where + ": source '" + source.id + "' sits on board '" + source.board +
                             "', which the suit does not have",
                         "Correct the board in the suit's description"};
    return suit;
}

Status checkSegments(const Suit& suit, const std::vector<std::string>& joint_names,
                     const std::string& where) {
    const Status boards = checkParts(suit.boards, "board", joint_names, where);
    return boards.ok() ? checkParts(suit.sources, "source", joint_names, where) : boards;
}

}  // namespace noctule
