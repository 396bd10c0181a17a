// SPDX-License-Identifier: Apache-2.0
// The tables robot_drive, robot_command and robot_state: written by TakeTables, read by Take.
#include "core/recording/robot_rows.h"

#include <cmath>
#include <cstring>

#include "core/math/json.h"
#include "core/recording/row_reader.h"
#include "core/recording/take.h"
#include "core/recording/take_tables.h"

namespace noctule {
namespace {

constexpr const char* kDriveFormat = "noctule-robot-drive";

std::vector<std::byte> packed(const std::vector<double>& values) {
    const auto bytes = std::as_bytes(std::span(values));
    return {bytes.begin(), bytes.end()};
}

std::vector<std::byte> packed(const std::vector<Vector3d>& places) {
    std::vector<double> values;
    for (const Vector3d& place : places)
        values.insert(values.end(), place.begin(), place.end());
    return packed(values);
}

/// Nothing: another size, or a value that is none or beyond the limit.
std::optional<std::vector<double>> unpacked(const std::optional<std::span<const std::byte>>& blob,
                                            size_t count) {
    if (!blob || blob->size() != count * sizeof(double))
        return std::nullopt;
    std::vector<double> values(count);
    if (count > 0)
        std::memcpy(values.data(), blob->data(), blob->size());
    for (const double value : values)
        if (!(std::abs(value) <= kLargestJointValue))
            return std::nullopt;
    return values;
}

std::optional<std::vector<Vector3d>> unpackedPlaces(const std::optional<std::span<const std::byte>>& blob,
                                                    size_t count) {
    const auto values = unpacked(blob, 3 * count);
    if (!values)
        return std::nullopt;
    std::vector<Vector3d> places;
    for (size_t i = 0; i < count; ++i)
        places.emplace_back(values->data() + 3 * i);
    return places;
}

bool allSound(const std::vector<double>& values) {
    return std::ranges::all_of(values, [](double v) { return std::abs(v) <= kLargestJointValue; });
}

std::string toText(const RobotDriveRow& row) {
    const nlohmann::json json{{"format", kDriveFormat}, {"version", 1},           {"software", row.software},
                              {"robot", row.robot},     {"address", row.address}, {"leader", row.leader},
                              {"rate_hz", row.rate_hz}, {"joints", row.joints},   {"arms", row.arms}};
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Nothing: no list of texts, or a longer one.
std::optional<std::vector<std::string>> namesIn(const nlohmann::json& json, const char* member, size_t most) {
    const auto found = json.is_object() ? json.find(member) : json.end();
    if (found == json.end() || !found->is_array() || found->size() > most)
        return std::nullopt;
    std::vector<std::string> names;
    for (const nlohmann::json& name : *found) {
        if (!name.is_string())
            return std::nullopt;
        names.push_back(name.get<std::string>().substr(0, limits::kName));
    }
    return names;
}

RowVerdict readAbout(const nlohmann::json& json, RobotDriveRow& row) {
    const auto text = [&](const char* member) {
        return json::text(json, member).value_or("").substr(0, limits::kName);
    };
    const auto joints = namesIn(json, "joints", kRobotJoints), arms = namesIn(json, "arms", kRobotArms);
    if (!joints || joints->empty() || !arms)
        return "its joints or arms are not listed, or are too many";
    row.software = text("software");
    row.robot = text("robot");
    row.address = text("address");
    row.leader = text("leader");
    row.rate_hz = json::number(json, "rate_hz").value_or(0);
    row.joints = *joints;
    row.arms = *arms;
    return "";
}

std::string rowsOfDrive(const TakeSchema& schema, const std::string& table,
                        const std::vector<std::string>& columns, int64_t drive, const char* order) {
    return schema.select(table, columns) +
           (schema.has(table) ? " WHERE " + schema.expression(table, "drive") + "=" + std::to_string(drive) +
                                    " ORDER BY " + schema.expression(table, order)
                              : "");
}

/// Counts rows, and says when they are too many.
class RowCount {
public:
    explicit RowCount(int64_t most) : most_(most) {}
    RowVerdict next() {
        return ++count_ > most_ ? "there are more than " + std::to_string(most_) + " rows" : "";
    }

private:
    int64_t most_, count_ = 0;
};

/// 0 to a week.
bool isDriveTime(const std::optional<int64_t>& time_ns) {
    return time_ns && *time_ns >= 0 && *time_ns <= limits::kLongestTake_s * 1'000'000'000;
}

}  // namespace

Result<int64_t> TakeTables::addRobotDrive(const RobotDriveRow& row) {
    require(row.joints.size() <= kRobotJoints && row.arms.size() <= kRobotArms,
            "a drive has at most 64 joints and 8 arms");
    auto insert = insertInto("robot_drive");
    if (!insert)
        return insert.error();
    (*insert)->bindNull(0).bind(1, std::string_view(row.created_utc));
    (*insert)->bind(2, std::string_view(toText(row))).bind(3, row.take_time_ns).bind(4, row.lost_rows);
    if (const Status done = (*insert)->run(); !done)
        return done.error();
    const int64_t drive = database_->lastInsertId();
    const auto version = database_->queryInteger("PRAGMA user_version");
    if (!version)
        return version.error();
    if (version->value_or(0) < kTakeNewestVersion)
        if (const Status noted =
                database_->execute("PRAGMA user_version=" + std::to_string(kTakeNewestVersion));
            !noted)
            return noted.error();
    return drive;
}

Status TakeTables::addRobotRows(int64_t drive, const RobotRows& rows) {
    for (const RobotCommandRow& row : rows.commands)
        if (Status added = addRobotCommand(drive, row); !added)
            return added;
    for (const RobotStateRow& row : rows.states)
        if (Status added = addRobotState(drive, row); !added)
            return added;
    auto update = database_->prepare("UPDATE robot_drive SET take_time_ns=?, lost_rows=? WHERE drive=?");
    if (!update)
        return update.error();
    return update->bind(0, rows.take_time_ns).bind(1, rows.lost_rows).bind(2, drive).run();
}

Status TakeTables::addRobotCommand(int64_t drive, const RobotCommandRow& row) {
    require(allSound(row.q), "a command's values are finite and within 1000");
    auto insert = insertInto("robot_command");
    if (!insert)
        return insert.error();
    const auto q = packed(row.q), tips = packed(row.tips_m);
    (*insert)->bind(0, drive).bind(1, row.sequence).bind(2, row.time_ns);
    (*insert)->bind(3, row.pose_time_ns).bind(4, row.pose_arrived_ns).bind(5, std::string_view(row.state));
    if (row.trouble.empty())
        (*insert)->bindNull(6);
    else
        (*insert)->bind(6, std::string_view(row.trouble));
    return (*insert)->bindBlob(7, q).bindBlob(8, tips).run();
}

Status TakeTables::addRobotState(int64_t drive, const RobotStateRow& row) {
    require(allSound(row.q) && allSound(row.v), "a state's values are finite and within 1000");
    auto insert = insertInto("robot_state");
    if (!insert)
        return insert.error();
    const auto q = packed(row.q), v = packed(row.v), tips = packed(row.tips_m);
    (*insert)->bindNull(0).bind(1, drive).bind(2, row.time_ns).bind(3, row.obeyed_sequence);
    return (*insert)->bind(4, int64_t{row.refuses}).bindBlob(5, q).bindBlob(6, v).bindBlob(7, tips).run();
}

Result<std::vector<RobotDriveRow>> Take::robotDrives() const {
    const std::string sql =
        schema_->select("robot_drive", {"drive", "created_utc", "json", "take_time_ns", "lost_rows"}) +
        " ORDER BY 1";
    return collectRows<RobotDriveRow>(
        *database_, *log_, "robot_drive", sql,
        [count = RowCount(kMostRobotDrives)](const Statement& row, RobotDriveRow& out) mutable -> RowVerdict {
            if (RowVerdict many = count.next(); !many.empty())
                return many;
            out.drive = row.integer(0).value_or(0);
            if (out.drive < 1 || out.drive > kHighestRun)
                return "drive is not 1, 2, ...";
            out.created_utc = row.shortened(1, limits::kName);
            out.take_time_ns = row.integer(3);
            if (out.take_time_ns && std::abs(static_cast<double>(*out.take_time_ns)) >
                                        1e9 * static_cast<double>(limits::kLongestTake_s))
                return "take_time_ns is beyond a week";
            out.lost_rows = std::max<int64_t>(0, row.integer(4).value_or(0));
            return readAbout(json::parse(row.text(2).value_or("")), out);
        });
}

Result<std::vector<RobotCommandRow>> Take::robotCommands(const RobotDriveRow& drive) const {
    const std::string sql = rowsOfDrive(
        *schema_, "robot_command",
        {"sequence", "time_ns", "pose_time_ns", "pose_arrived_ns", "state", "trouble", "q", "tips"},
        drive.drive, "sequence");
    return collectRows<RobotCommandRow>(
        *database_, *log_, "robot_command", sql,
        [&, count = RowCount(kMostRobotCommands)](const Statement& row,
                                                  RobotCommandRow& out) mutable -> RowVerdict {
            if (RowVerdict many = count.next(); !many.empty())
                return many;
            const auto sequence = row.integer(0), time = row.integer(1);
            auto q = unpacked(row.blob(6), drive.joints.size());
            auto tips = unpackedPlaces(row.blob(7), drive.arms.size());
            if (!sequence || !isDriveTime(time))
                return "sequence or time is missing or out of range";
            if (!q || !tips)
                return "q or tips do not fit the drive's joints and arms";
            out = {*sequence,
                   *time,
                   row.integer(2),
                   row.integer(3),
                   row.shortened(4, limits::kName),
                   row.shortened(5, limits::kName),
                   std::move(*q),
                   std::move(*tips)};
            return "";
        });
}

Result<std::vector<RobotStateRow>> Take::robotStates(const RobotDriveRow& drive) const {
    const std::string sql = rowsOfDrive(*schema_, "robot_state",
                                        {"id", "time_ns", "obeyed_sequence", "refuses", "q", "v", "tips"},
                                        drive.drive, "time_ns");
    return collectRows<RobotStateRow>(*database_, *log_, "robot_state", sql,
                                      [&, count = RowCount(kMostRobotStates)](
                                          const Statement& row, RobotStateRow& out) mutable -> RowVerdict {
                                          if (RowVerdict many = count.next(); !many.empty())
                                              return many;
                                          const auto time = row.integer(1);
                                          auto q = unpacked(row.blob(4), drive.joints.size()),
                                               v = unpacked(row.blob(5), drive.joints.size());
                                          auto tips = unpackedPlaces(row.blob(6), drive.arms.size());
                                          if (!isDriveTime(time))
                                              return "time is missing or out of range";
                                          if (!q || !v || !tips)
                                              return "q, v or tips do not fit the drive's joints and arms";
                                          out = {
                                              *time,         row.integer(2), row.integer(3).value_or(0) != 0,
                                              std::move(*q), std::move(*v),  std::move(*tips)};
                                          return "";
                                      });
}

}  // namespace noctule
