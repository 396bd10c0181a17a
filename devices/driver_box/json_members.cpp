// SPDX-License-Identifier: Apache-2.0
#include "devices/driver_box/json_members.h"

#include <cmath>

#include "core/job/limits.h"
#include "core/job/outside_text.h"
#include "core/math/json.h"
#include "devices/driver_box/hello.h"

namespace noctule::link {

namespace {

using Json = nlohmann::json;

}  // namespace

Json parseObject(ByteView payload) {
    const auto shallow = [](int depth, Json::parse_event_t, Json&) { return depth <= limits::kBoxJsonDepth; };
    Json json = Json::parse(payload.begin(), payload.end(), shallow, false);
    if (!json.is_object())
        json = Json::value_t::discarded;
    return json;
}

Bytes toBytes(const Json& json) {
    const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return {text.begin(), text.end()};
}

Error damagedMessage(const std::string& where, const std::string& what) {
    return {ErrorKind::kUnreadable, where + ": " + what, "Check the cable and update the box's firmware"};
}

std::optional<Error> refusedProtocol(const Json& json, const std::string& where, const std::string& message) {
    const auto protocol = json::number(json, "protocol");
    if (!protocol)
        return damagedMessage(where, message + " names no protocol");
    if (*protocol == kProtocol)
        return std::nullopt;
    return Error{ErrorKind::kUnusable,
                 where + ": the box speaks protocol " + json["protocol"].dump() + ", this program speaks 1",
                 "Update this program or the box's firmware"};
}

const Json* JsonMembers::find(const char* name) const {
    const auto found = object_.find(name);
    return found == object_.end() || found->is_null() ? nullptr : &*found;
}

void JsonMembers::bad(const char* name) {
    if (first_bad_.empty())
        first_bad_ = name;
}

double JsonMembers::checked(const Json* value, const char* name, double fallback, double lowest,
                            double highest) {
    const double number = value ? json::number(*value).value_or(NAN) : fallback;
    if (number >= lowest && number <= highest)
        return number;
    bad(name);
    return lowest;
}

int JsonMembers::whole(const Json* value, const char* name, int fallback, int lowest, int highest) {
    const double number = checked(value, name, fallback, lowest, highest);
    if (number != std::floor(number))
        bad(name);
    return static_cast<int>(number);
}

std::string JsonMembers::text(const char* name) {
    const Json* found = find(name);
    if (found && !found->is_string())
        bad(name);
    return found && found->is_string() ? shortText(found->get_ref<const std::string&>(), limits::kBoxText)
                                       : std::string();
}

std::string JsonMembers::requiredText(const char* name) {
    std::string value = text(name);
    if (value.empty())
        bad(name);
    return value;
}

double JsonMembers::real(const char* name, double fallback, double lowest, double highest) {
    return checked(find(name), name, fallback, lowest, highest);
}

int JsonMembers::integer(const char* name, int fallback, int lowest, int highest) {
    return whole(find(name), name, fallback, lowest, highest);
}

const Json& JsonMembers::array(const char* name, size_t most) {
    static const Json kNone = Json::array();
    const Json* found = find(name);
    if (!found || (found->is_array() && found->size() <= most))
        return found ? *found : kNone;
    bad(name);
    return kNone;
}

std::vector<int> JsonMembers::integers(const char* name, int lowest, int highest, size_t most) {
    std::vector<int> values;
    for (const Json& entry : array(name, most))
        values.push_back(whole(&entry, name, lowest, lowest, highest));
    return values;
}

std::vector<std::string> JsonMembers::texts(const char* name, size_t most) {
    std::vector<std::string> values;
    for (const Json& entry : array(name, most))
        if (entry.is_string())
            values.push_back(entry.get<std::string>());
    return values;
}

bool JsonMembers::flag(const char* name) {
    const Json* found = find(name);
    if (found && !found->is_boolean())
        bad(name);
    return found && found->is_boolean() && found->get<bool>();
}

}  // namespace noctule::link
