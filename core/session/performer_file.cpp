// SPDX-License-Identifier: Apache-2.0
#include "core/session/performer_file.h"

#include <utility>

#include "core/suit/json_object.h"

namespace noctule {
namespace {

/// 0, "in proportion", is left out of the file.
constexpr std::pair<const char*, double BodyMeasures::*> kLengths[] = {
    {"upper_arm_m", &BodyMeasures::upper_arm_m}, {"forearm_m", &BodyMeasures::forearm_m},
    {"hand_m", &BodyMeasures::hand_m},           {"shoulder_width_m", &BodyMeasures::shoulder_width_m},
    {"thigh_m", &BodyMeasures::thigh_m},         {"shin_m", &BodyMeasures::shin_m},
    {"foot_m", &BodyMeasures::foot_m},           {"hip_width_m", &BodyMeasures::hip_width_m},
    {"trunk_m", &BodyMeasures::trunk_m},
};

}  // namespace

UnknownMembers unknownMembers(const nlohmann::json& json, std::initializer_list<const char*> known) {
    UnknownMembers unknown = json.is_object() ? json : UnknownMembers::object();
    for (const char* member : known)
        unknown.erase(member);
    return unknown;
}

nlohmann::json toJson(const Performer& performer) {
    nlohmann::json measures{{"height_m", performer.measures.height_m}};
    for (const auto& [member, length] : kLengths)
        if (performer.measures.*length > 0)
            measures[member] = performer.measures.*length;
    nlohmann::json json = performer.unknown;
    json["name"] = performer.name;
    json["measures"] = std::move(measures);
    json["suit"] = toJson(performer.suit);
    json["notes"] = performer.notes;
    return json;
}

Result<Performer> performerFromJson(const nlohmann::json& json, const std::string& where) {
    std::optional<Error> error;
    JsonObject object(json, where, error);
    Performer performer;
    performer.name = object.text("name");
    const std::string who = where + " '" + performer.name + "'";
    object.setWhat(who);
    performer.notes = object.textOr("notes", "");
    const nlohmann::json measures = object.objectOrEmpty("measures");
    JsonObject lengths(measures, who, error);
    performer.measures.height_m = lengths.positiveOr("height_m", performer.measures.height_m);
    for (const auto& [member, length] : kLengths)
        performer.measures.*length = lengths.optionalPositive(member).value_or(0);
    if (error)
        return *error;
    Result<Suit> suit = suitFromJson(object.objectOrEmpty("suit"), who);
    if (!suit)
        return suit.error();
    performer.suit = std::move(*suit);
    performer.unknown = unknownMembers(json, {"name", "measures", "suit", "notes"});
    return performer;
}

}  // namespace noctule
