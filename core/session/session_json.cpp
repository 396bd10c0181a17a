// SPDX-License-Identifier: Apache-2.0
#include "core/session/session_json.h"

#include <cmath>
#include <set>

#include "core/math/json.h"
#include "core/session/performer_file.h"
#include "core/session/shot_list.h"
#include "core/suit/json_object.h"

namespace noctule {
namespace {

constexpr const char* kFormat = "noctule-session";
constexpr int kBestRating = 5;

nlohmann::json toJson(const SessionTake& take) {
    nlohmann::json json = take.unknown;
    json["file"] = take.file;
    json["performer"] = take.performer;
    json["rating"] = take.rating;
    json["notes"] = take.notes;
    json["in_s"] = take.in_s;
    json["out_s"] = take.out_s;
    if (!take.shown_result.empty())
        json["shown_result"] = take.shown_result;
    return json;
}

nlohmann::json toJson(const Shot& shot) {
    nlohmann::json json = shot.unknown;
    json["name"] = shot.name;
    json["takes"] = shot.wanted;
    return json;
}

Result<Shot> shotFromJson(const nlohmann::json& json, const std::string& where) {
    std::optional<Error> error;
    JsonObject object(json, where, error);
    Shot shot;
    shot.name = object.text("name");
    const double wanted = object.numberOr("takes", 1);
    if (wanted < 1 || wanted > kMostTakesOfShot)
        object.fail(ErrorKind::kUnreadable, "takes", "must be 1 to " + std::to_string(kMostTakesOfShot));
    shot.wanted = static_cast<int>(std::lround(wanted));
    shot.unknown = unknownMembers(json, {"name", "takes"});
    if (error)
        return *error;
    return shot;
}

/// Inside takes/, whatever the file says: a session must not reach out of its folder.
bool isInTakes(const std::string& file) {
    const std::filesystem::path path(file);
    return path.parent_path() == "takes" && path.has_stem() && path.filename() != "..";
}

Result<SessionTake> takeFromJson(const nlohmann::json& json, const std::string& where) {
    std::optional<Error> error;
    JsonObject object(json, where, error);
    SessionTake take;
    take.file = object.text("file");
    if (!isInTakes(take.file))
        object.fail(ErrorKind::kUnreadable, "file", "must be in takes/");
    take.name = std::filesystem::path(take.file).stem().string();
    take.performer = object.textOr("performer", "");
    const double rating = object.numberOr("rating", 0);
    if (rating < 0 || rating > kBestRating)
        object.fail(ErrorKind::kUnreadable, "rating", "must be 0 to 5");
    take.rating = static_cast<int>(std::lround(rating));
    take.notes = object.textOr("notes", "");
    take.in_s = object.numberOr("in_s", 0);
    take.out_s = object.numberOr("out_s", 0);
    take.shown_result = object.textOr("shown_result", "");
    take.unknown =
        unknownMembers(json, {"file", "performer", "rating", "notes", "in_s", "out_s", "shown_result"});
    if (error)
        return *error;
    return take;
}

Status checkFormat(const nlohmann::json& json, const std::string& where) {
    const Error not_session{ErrorKind::kUnreadable,
                            where + ": is not a session (format is not " + kFormat + ")",
                            "Choose the folder of a session"};
    if (json::text(json, "format") != kFormat)
        return not_session;
    const double version = json::number(json, "version").value_or(0);
    if (version >= kSessionVersion + 1)
        return Error{ErrorKind::kUnusable,
                     where + ": was written by a newer Noctule (session version " +
                         std::to_string(std::lround(std::floor(version))) + ", this program reads " +
                         std::to_string(kSessionVersion) + ")",
                     "Install a newer Noctule; nothing was changed"};
    return version >= 1 ? Status(Done{}) : Status(not_session);
}

Status readPerformers(JsonObject& object, const std::string& where, Session& session) {
    for (const nlohmann::json& entry : object.array("performers", false)) {
        auto performer =
            performerFromJson(entry, where + ": performer " + std::to_string(session.performers.size() + 1));
        if (!performer)
            return performer.error();
        session.performers.push_back(std::move(*performer));
    }
    return Done{};
}

bool isFileName(const std::string& name) {
    return name == std::filesystem::path(name).filename();
}

void readSuitCalibrations(JsonObject& object, const nlohmann::json& json, Session& session) {
    const auto found = json.find("suit_calibrations");
    if (found == json.end())
        return;
    if (!found->is_object())
        return object.fail(ErrorKind::kUnreadable, "suit_calibrations", "must be an object");
    for (const auto& [serial, file] : found->items()) {
        if (!file.is_string() || !isFileName(file.get<std::string>()))
            return object.fail(ErrorKind::kUnreadable, "suit_calibrations",
                               "must hold names of files in calibration/");
        session.suit_calibrations[serial] = file.get<std::string>();
    }
}

}  // namespace

nlohmann::json toJson(const Session& session) {
    nlohmann::json performers = nlohmann::json::array();
    for (const Performer& performer : session.performers)
        performers.push_back(toJson(performer));
    nlohmann::json takes = nlohmann::json::array();
    for (const SessionTake& take : session.takes)
        takes.push_back(toJson(take));
    nlohmann::json shots = nlohmann::json::array();
    for (const Shot& shot : session.shots)
        shots.push_back(toJson(shot));
    nlohmann::json json = session.unknown;
    json["format"] = kFormat;
    json["version"] = json::number(json, "version").value_or(kSessionVersion);
    json["name"] = session.name;
    json["created_utc"] = session.created_utc;
    json["current_performer"] = session.current_performer;
    json["calibration"] = session.calibration;
    if (!session.suit_calibrations.empty())
        json["suit_calibrations"] = session.suit_calibrations;
    json["notes"] = session.notes;
    json["body"] = toJson(session.body);
    json["performers"] = std::move(performers);
    json["takes"] = std::move(takes);
    json["shots"] = std::move(shots);
    return json;
}

Result<Session> sessionFromJson(const nlohmann::json& json, const std::string& where) {
    if (const Status known = checkFormat(json, where); !known)
        return known.error();
    std::optional<Error> error;
    JsonObject object(json, where, error);
    Session session;
    session.name = object.textOr("name", "");
    session.created_utc = object.textOr("created_utc", "");
    session.current_performer = object.textOr("current_performer", "");
    session.calibration = object.textOr("calibration", "");
    if (!isFileName(session.calibration))
        object.fail(ErrorKind::kUnreadable, "calibration", "must be the name of a file in calibration/");
    readSuitCalibrations(object, json, session);
    session.notes = object.textOr("notes", "");
    auto body = sessionBodyFromJson(json.value("body", nlohmann::json()), where + ": body");
    if (!body)
        return body.error();
    session.body = std::move(*body);
    if (const Status people = readPerformers(object, where, session); !people)
        return people.error();
    std::set<std::string> files;
    for (const nlohmann::json& entry : object.array("takes", false)) {
        auto take = takeFromJson(entry, where + ": take " + std::to_string(session.takes.size() + 1));
        if (!take)
            return take.error();
        if (files.insert(take->file).second)
            session.takes.push_back(std::move(*take));
    }
    for (const nlohmann::json& entry : object.array("shots", false)) {
        auto shot = shotFromJson(entry, where + ": shot " + std::to_string(session.shots.size() + 1));
        if (!shot)
            return shot.error();
        session.shots.push_back(std::move(*shot));
    }
    if (error)
        return *error;
    // `version` stays with the unknown members: a newer minor version is written back as it was.
    session.unknown =
        unknownMembers(json, {"format", "name", "created_utc", "current_performer", "calibration",
                              "suit_calibrations", "notes", "body", "performers", "takes", "shots"});
    return session;
}

Result<Session> sessionFromText(const std::string& text, const std::string& where) {
    const nlohmann::json json = noctule::json::parse(text);
    if (json.is_discarded())
        return Error{ErrorKind::kUnreadable, where + ": is damaged, it is not JSON",
                     "Restore it from a copy"};
    return sessionFromJson(json, where);
}

}  // namespace noctule
