// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/batch/files.h"
#include "app/batch/program.h"
#include "app/batch/signals.h"
#include "app/batch/verb.h"
#include "core/assignment/assign_segments.h"
#include "core/import/import_format.h"
#include "core/import/import_take.h"
#include "core/import/segment_map.h"
#include "core/import/sensor_findings.h"
#include "core/job/outside_text.h"
#include "devices/machine/clock.h"
#include "devices/machine/random_uuid.h"

namespace noctule::batch {
namespace {

std::vector<std::string> formatNames() {
    std::vector<std::string> names = {"auto"};
    for (const ImportFormat* format : importFormats())
        names.push_back(format->name);
    return names;
}

/// What --map says: null without.
Result<nlohmann::json> givenMap(const Arguments& arguments) {
    if (!arguments.given("map"))
        return nlohmann::json(nullptr);
    auto map = readJson(arguments.text("map"));
    if (!map)
        return map.error();
    if (!map->is_object() || map->value("format", nlohmann::json()) != "noctule-import-map")
        return Error{
            ErrorKind::kUnreadable, arguments.text("map") + ": is no import map",
            "Begin it with \"format\": \"noctule-import-map\", \"version\": 1, or let --map-template "
            "write one"};
    if (!describesColumns(*map) && arguments.text("assign") != "names")
        return Error{ErrorKind::kUsage,
                     "--map and --assign " + arguments.text("assign") + " both place sensors",
                     "Leave one of them out"};
    return map;
}

Error unknownKind(const std::vector<ImportFile>& files) {
    const std::string extension = files.front().extension();
    if (extension == ".mtb")
        return {ErrorKind::kUnreadable, files.front().path + ": is a log that only Xsens' own programs read",
                "Export it as text in MT Manager, and import that"};
    if (extension == ".c3d" || extension == ".trc")
        return {ErrorKind::kUnusable, files.front().path + ": holds markers, no sensors",
                "Import the sensors' recording, then attach the markers: noctule --batch attach T.noctule "
                "--reference " +
                    files.front().fileName()};
    std::string kinds;
    for (const ImportFormat* format : importFormats())
        kinds += (kinds.empty() ? "" : "; ") + std::string(format->name) + ": " + format->summary;
    return {ErrorKind::kUnreadable, files.front().path + ": is of no kind that can be imported",
            "Kinds are: " + kinds};
}

Result<ImportedRecording> readRecording(const VerbContext& context) {
    const Arguments& arguments = context.arguments;
    const auto map = givenMap(arguments);
    if (!map)
        return map.error();
    ImportChoice choice;
    choice.rate_hz = arguments.number("rate").value_or(0);
    choice.world = worldFrameNamed(arguments.text("world"));
    if (describesColumns(*map))
        choice.map = *map;
    const auto files = readImportFiles(arguments.operands(), &signalFlag());
    if (!files)
        return files.error();
    const ImportFormat* format = choice.map.is_object()           ? findImportFormat("csv")
                                 : arguments.text("as") == "auto" ? importFormatOf(*files)
                                                                  : findImportFormat(arguments.text("as"));
    if (!format)
        return unknownKind(*files);
    auto recording = readImport(*format, *files, choice, context.job());
    if (recording && map->is_object() && !describesColumns(*map))
        if (Status placed = applySegmentMap(*map, *recording); !placed)
            return placed.error();
    return recording;
}

/// Segments by movement, with a confidence for each.
Result<nlohmann::json> assignByMovement(ImportedRecording& recording, const JobContext& job) {
    std::vector<ImuSamples> samples;
    for (const ImportedSensor& sensor : recording.sensors)
        samples.push_back(sensor.samples);
    const auto found = assignment::assignSegments(samples, job);
    if (!found)
        return found.error();
    nlohmann::json sensors = nlohmann::json::array();
    for (size_t s = 0; s < found->sensors.size(); ++s) {
        const auto& [segment, confidence] = found->sensors[s];
        recording.sensors[s].segment = segment;
        char note[120];
        std::snprintf(note, sizeof note, " by movement, confidence %.2f", confidence);
        recording.notes.push_back(recording.sensors[s].id + " sits on " + segment + note);
        sensors.push_back(
            {{"id", recording.sensors[s].id}, {"segment", segment}, {"confidence", confidence}});
    }
    recording.warnings.insert(recording.warnings.end(), found->warnings.begin(), found->warnings.end());
    return nlohmann::json{
        {"sensors", sensors}, {"legs_side", found->legs_side}, {"arms_side", found->arms_side}};
}

std::string partsOf(const SensorFindings& found) {
    std::string parts;
    for (const auto& [there, name] :
         {std::pair{found.gyroscope, "gyroscope"}, std::pair{found.accelerometer, "accelerometer"},
          std::pair{found.magnetometer, "magnetometer"}, std::pair{found.attitude, "attitude"}})
        if (there)
            parts += (parts.empty() ? "" : ", ") + std::string(name);
    return parts.empty() ? "nothing" : parts;
}

std::string sensorText(const ImportedSensor& sensor) {
    const SensorFindings found = findingsOf(sensor);
    char text[200];
    std::snprintf(text, sizeof text, "  %-20s %8.3f Hz %9.2f s, %zu rows, %zu missing, ",
                  shortText(sensor.id, 40).c_str(), sensor.samples.rate_hz, found.duration_s, found.rows,
                  found.missing);
    return text + partsOf(found) + (sensor.segment.empty() ? "; segment not known" : "; " + sensor.segment) +
           "\n";
}

nlohmann::json sensorJson(const ImportedSensor& sensor) {
    const SensorFindings found = findingsOf(sensor);
    return {{"id", sensor.id},
            {"rate_hz", sensor.samples.rate_hz},
            {"duration_s", found.duration_s},
            {"offset_s", sensor.offset_s},
            {"rows", found.rows},
            {"missing", found.missing},
            {"holds", partsOf(found)},
            {"segment", sensor.segment.empty() ? nlohmann::json(nullptr) : nlohmann::json(sensor.segment)}};
}

std::string foundText(const ImportedRecording& recording) {
    std::string text =
        recording.format + ", " + std::to_string(recording.sensors.size()) +
        (recording.sensors.size() == 1 ? " sensor" : " sensors") +
        (recording.reference || !recording.q_world_sensor.empty() ? ", with a reference\n" : "\n");
    for (const ImportedSensor& sensor : recording.sensors)
        text += sensorText(sensor);
    for (const std::string& note : recording.notes)
        text += "  " + note + ".\n";
    return text;
}

/// By movement or not at all, when --assign says so; what `auto` found, else null.
Result<nlohmann::json> assignAsAsked(const VerbContext& context, ImportedRecording& recording) {
    const std::string asked = context.arguments.text("assign");
    if (asked == "auto")
        return assignByMovement(recording, context.job());
    for (ImportedSensor& sensor : recording.sensors)
        if (asked == "none")
            sensor.segment.clear();
    return nlohmann::json(nullptr);
}

/// One sensor needs no segment: its orientation is all that can be asked of it.
void warnOfOpenSegments(const ImportedRecording& recording, const Arguments& arguments,
                        std::vector<std::string>& warnings) {
    const std::vector<std::string> open = sensorsWithoutSegment(recording);
    if (open.empty() || recording.sensors.size() == 1 || arguments.text("assign") == "none")
        return;
    std::string names;
    for (size_t i = 0; i < open.size() && i < 32; ++i)
        names += (i > 0 ? ", " : "") + open[i];
    warnings.push_back(
        std::to_string(open.size()) + " of " + std::to_string(recording.sensors.size()) +
        " sensors have no segment, so that poses leave them out: " + names +
        ". Write a map with --map-template MAP.json, fill it in and give it with --map, or try "
        "--assign auto");
}

Result<Outcome> runImport(const VerbContext& context) {
    const Arguments& arguments = context.arguments;
    const std::string path = arguments.operands()[0], out = arguments.text("out");
    const std::string map_template = arguments.text("map-template");
    const bool list = arguments.given("list") || (out.empty() && !map_template.empty());
    if (!list && out.empty())
        return Error{ErrorKind::kUsage, "--out is missing",
                     "Name the take to make, or look first with --list"};
    if (Status free = checkOutputs(arguments, {"out", "map-template"}); !free)
        return free.error();
    auto recording = readRecording(context);
    if (!recording)
        return recording.error();
    auto assigned = assignAsAsked(context, *recording);
    if (!assigned)
        return assigned.error();
    warnOfOpenSegments(*recording, arguments, recording->warnings);
    if (!map_template.empty())
        if (Status written =
                writeJson(map_template, segmentMapTemplate(*recording), arguments.given("overwrite"));
            !written)
            return written.error();
    for (const std::string& warning : recording->warnings)
        context.console.warn(path + ": " + warning);
    nlohmann::json found = {{"format", recording->format},
                            {"sensors", nlohmann::json::array()},
                            {"notes", recording->notes},
                            {"warnings", recording->warnings}};
    if (!assigned->is_null())
        found["assigned"] = std::move(*assigned);
    for (const ImportedSensor& sensor : recording->sensors)
        found["sensors"].push_back(sensorJson(sensor));
    if (list)
        return Outcome{found, path + ": " + foundText(*recording), std::nullopt};
    ImportRequest request{
        out, takeName(out), utcNow(), softwareName(), randomUuid(), arguments.given("overwrite")};
    const auto summary = writeImportedTake(*recording, request, context.job());
    if (!summary)
        return summary.error();
    found.update({{"take", out},
                  {"rate_hz", summary->rate_hz},
                  {"duration_s", summary->duration_s},
                  {"readings", summary->readings},
                  {"missing", summary->missing},
                  {"magnetometer", summary->has_magnetometer},
                  {"attitudes", summary->has_attitudes},
                  {"reference", summary->has_reference}});
    return Outcome{found, out + ": " + foundText(*recording), std::nullopt};
}

}  // namespace

Verb importVerb() {
    Verb verb;
    verb.name = "import";
    verb.summary = "make a take of a recording of other sensors";
    verb.operands = "FILE|FOLDER...";
    verb.min_operands = 1;
    verb.max_operands = kAnyNumber;
    verb.example = "noctule --batch import walk/MT_*.txt --out walk_001.noctule";
    verb.options = {
        text("out", "T.noctule", "the take to make"),
        flag("list", "show what was found and make no take"),
        choice("as", formatNames(), "the kind of recording; auto: by its content").orElse("auto"),
        number("rate", "HZ", 1, 10000, "rows a second, in place of what the file says"),
        choice("world", worldFrameNames(),
               "axes of the recording's attitudes, in place of what the file says"),
        inputFile("map", "MAP.json",
                  "segments of the sensors, or columns, units and axes of a table of any program"),
        text("map-template", "MAP.json", "write the sensors as a map of segments to fill in"),
        choice("assign", {"names", "auto", "none"},
               "segments of the sensors: by their names, by movement or left open")
            .orElse("names")};
    verb.remarks = {
        "Kinds: MATLAB level 5 (BROAD, qmt), MVNX, MT Manager's text (one file per sensor), x-IMU3 (folders "
        "or .ximu3), OpenSense .sto, and any table with --map.",
        "Sensors, rates, units, axes and gaps are shown before the take is made. Units are checked by what "
        "gravity shows; every conversion and assumption is said.",
        "A table's map: {\"format\": \"noctule-import-map\", \"version\": 1, \"time\": {\"column\": \"t\", "
        "\"unit\": \"ms\"}, \"sensors\": [{\"id\": \"wrist\", \"segment\": \"LeftForeArm\", \"gyro\": "
        "[\"gx\", \"gy\", \"gz\"], \"gyro_unit\": \"deg/s\", \"accel\": [\"ax\", \"ay\", \"az\"], "
        "\"accel_unit\": \"g\"}]}. Columns are names of the header or numbers from 1; rate_hz may stand for "
        "time.",
        "--map-template writes {\"sensors\": [{\"id\": \"42268\", \"segment\": null}]}: write the segments, "
        "and give the file with --map.",
        "--assign auto tells by walking or free movement of ten seconds and more which of 7, 8 or 16 sensors "
        "sits where, however it is mounted and turned.",
        "The maker's own attitudes become a result of kind orientation; an optical system's or MVN's result "
        "becomes the reference."};
    verb.run = runImport;
    return verb;
}

}  // namespace noctule::batch
