// SPDX-License-Identifier: Apache-2.0
#include "core/import/segment_map.h"

#include <algorithm>

#include "core/body/actor.h"
#include "core/formats/number_text.h"
#include "core/math/json.h"

namespace noctule {

namespace {

constexpr size_t kMostMapSensors = 100;

Error segmentMapError(const std::string& what, const std::string& remedy) {
    return {ErrorKind::kUsage, "The map: " + what, remedy};
}

std::string joinedNames(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names)
        if (list.size() < 600)
            list += (list.empty() ? "" : ", ") + name;
    return list;
}

std::vector<std::string> idsOf(const ImportedRecording& recording) {
    std::vector<std::string> ids;
    for (const ImportedSensor& sensor : recording.sensors)
        ids.push_back(sensor.id);
    return ids;
}

/// "" is a sensor that is left without a segment.
Result<std::string> segmentIn(const nlohmann::json& entry, const std::string& id) {
    const auto member = entry.find("segment");
    if (member == entry.end() || member->is_null())
        return std::string();
    const std::string segment = member->is_string() ? member->get<std::string>() : member->dump();
    const auto& known = canonicalJointNames();
    if (segment.empty() || std::find(known.begin(), known.end(), segment) != known.end())
        return segment;
    return segmentMapError(
        "sensor " + id + " is put on " + inQuotes(segment.substr(0, 60)) + ", which no body has",
        "Segments are: " + joinedNames(known));
}

Status placeSensor(const nlohmann::json& entry, ImportedRecording& recording, std::vector<char>& named) {
    const std::string id = json::text(entry, "id").value_or("");
    const auto sensor = std::find_if(recording.sensors.begin(), recording.sensors.end(),
                                     [&](const ImportedSensor& one) { return one.id == id; });
    if (id.empty() || sensor == recording.sensors.end())
        return segmentMapError(id.empty()
                                   ? "a sensor has no id"
                                   : "sensor " + inQuotes(id.substr(0, 60)) + " is not in the recording",
                               "Its sensors are: " + joinedNames(idsOf(recording)));
    const auto index = size_t(sensor - recording.sensors.begin());
    if (named[index])
        return segmentMapError("sensor " + id + " stands there twice", "Give each sensor one segment");
    named[index] = 1;
    const auto segment = segmentIn(entry, id);
    if (!segment)
        return segment.error();
    sensor->segment = *segment;
    return Done{};
}

}  // namespace

bool describesColumns(const nlohmann::json& map) {
    if (!map.is_object())
        return false;
    if (map.contains("time"))
        return true;
    const auto sensors = map.find("sensors");
    return sensors != map.end() && sensors->is_array() &&
           std::any_of(sensors->begin(), sensors->end(), [](const nlohmann::json& sensor) {
               return sensor.is_object() && (sensor.contains("gyro") || sensor.contains("accel") ||
                                             sensor.contains("mag") || sensor.contains("quaternion"));
           });
}

Status applySegmentMap(const nlohmann::json& map, ImportedRecording& recording) {
    const auto list = map.find("sensors");
    if (list == map.end() || !list->is_array() || list->empty() || list->size() > kMostMapSensors)
        return segmentMapError(
            "it has no list of 1 to 100 sensors",
            "Write \"sensors\": [{\"id\": \"" + recording.sensors.front().id + "\", \"segment\": \"Hips\"}]");
    std::vector<char> named(recording.sensors.size(), 0);
    for (const nlohmann::json& entry : *list)
        if (Status placed = placeSensor(entry, recording, named); !placed)
            return placed;
    for (size_t s = 0; s < recording.sensors.size(); ++s)
        for (size_t other = 0; other < s && !recording.sensors[s].segment.empty(); ++other) {
            ImportedSensor &one = recording.sensors[s], &two = recording.sensors[other];
            if (one.segment != two.segment)
                continue;
            if (named[s] && named[other])
                return segmentMapError(
                    "sensors " + two.id + " and " + one.id + " are both put on " + one.segment,
                    "Put one sensor on each segment");
            (named[s] ? two : one).segment.clear();
        }
    recording.notes.push_back("Segments are those of the map");
    return Done{};
}

nlohmann::json segmentMapTemplate(const ImportedRecording& recording) {
    nlohmann::json map = {{"format", "noctule-import-map"},
                          {"version", 1},
                          {"sensors", nlohmann::json::array()},
                          {"x_segments", canonicalJointNames()}};
    for (const ImportedSensor& sensor : recording.sensors)
        map["sensors"].push_back(
            {{"id", sensor.id},
             {"segment", sensor.segment.empty() ? nlohmann::json(nullptr) : nlohmann::json(sensor.segment)}});
    return map;
}

std::vector<std::string> sensorsWithoutSegment(const ImportedRecording& recording) {
    std::vector<std::string> ids;
    for (const ImportedSensor& sensor : recording.sensors)
        if (sensor.segment.empty())
            ids.push_back(sensor.id);
    return ids;
}

}  // namespace noctule
