// SPDX-License-Identifier: Apache-2.0
// ANNOUNCE and SET.
#include <nlohmann/json.hpp>

#include "devices/driver_box/hello.h"
#include "devices/driver_box/json_members.h"

namespace noctule::link {

using Json = nlohmann::json;

Bytes toPayload(const Announcement& announcement) {
    return toBytes({{"protocol", kProtocol},
                    {"serial", announcement.serial},
                    {"name", announcement.name},
                    {"model", announcement.model},
                    {"tcp_port", announcement.tcp_port},
                    {"sample_rate_hz", announcement.sample_rate_hz},
                    {"boards", announcement.boards},
                    {"sources", announcement.sources},
                    {"busy", announcement.busy}});
}

Result<Announcement> readAnnouncement(ByteView payload, const std::string& where) {
    const Json json = parseObject(payload);
    if (json.is_discarded())
        return damagedMessage(where, "ANNOUNCE is no JSON object");
    if (const auto refused = refusedProtocol(json, where, "ANNOUNCE"))
        return *refused;
    JsonMembers members(json);
    Announcement announcement;
    announcement.serial = members.requiredText("serial");
    announcement.name = members.text("name");
    announcement.model = members.text("model");
    announcement.tcp_port = static_cast<uint16_t>(members.integer("tcp_port", kDefaultTcpPort, 1, 65535));
    announcement.sample_rate_hz = members.integer("sample_rate_hz", 150000, 1, kHighestSampleRate_hz);
    announcement.boards = members.integer("boards", 0, 0, static_cast<int>(Suit::kMaxPerSuit));
    announcement.sources = members.integer("sources", 0, 0, static_cast<int>(Suit::kMaxPerSuit));
    announcement.busy = members.flag("busy");
    if (!members.firstBad().empty())
        return damagedMessage(where,
                              "ANNOUNCE: '" + members.firstBad() + "' is missing or not what it should be");
    return announcement;
}

Bytes toPayload(const Settings& settings) {
    Json json = Json::object();
    if (settings.pulse_interval_samples)
        json["pulse_interval_samples"] = *settings.pulse_interval_samples;
    if (settings.enabled_sources)
        json["enabled_sources"] = *settings.enabled_sources;
    if (settings.pulse_cycles)
        json["pulse_cycles"] = *settings.pulse_cycles;
    if (settings.name)
        json["name"] = *settings.name;
    return toBytes(json);
}

Result<Settings> readSettings(ByteView payload) {
    const Json json = parseObject(payload);
    if (json.is_discarded())
        return damagedMessage("SET", "is no JSON object");
    JsonMembers members(json);
    Settings settings;
    if (members.has("pulse_interval_samples"))
        settings.pulse_interval_samples =
            members.integer("pulse_interval_samples", 1, 1, kHighestSampleRate_hz);
    if (members.has("pulse_cycles"))
        settings.pulse_cycles = members.integer("pulse_cycles", 1, 1, 10'000);
    if (members.has("name"))
        settings.name = members.text("name");
    if (members.has("enabled_sources"))
        settings.enabled_sources = members.integers(
            "enabled_sources", 0, static_cast<int>(Suit::kMaxPerSuit) - 1, Suit::kMaxPerSuit);
    if (!members.firstBad().empty())
        return damagedMessage("SET", "'" + members.firstBad() + "' is not what it should be");
    return settings;
}

}  // namespace noctule::link
