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
#include "devices/device/clock.h"
#include "devices/device/random_uuid.h"

namespace noctule::batch {
namespace {

std::vector<std::string> formatNames() {
    std::vector<std::string> names = {"auto"};
    for (const ImportFormat* format : importFormats())
        names.push_back(format->name);
    return names;
}

Result<ImportChoice> importChoice(const Arguments& arguments) {
    ImportChoice choice;
    choice.rate_hz = arguments.number("rate").value_or(0);
    choice.world = worldFrameNamed(arguments.text("world"));
    if (!arguments.given("map"))
        return choice;
    auto map = readJson(arguments.text("map"));
    if (!map)
        return map.error();
    if (!map->is_object() || map->value("format", nlohmann::json()) != "noctule-import-map")
        return Error{ErrorKind::kUnreadable, arguments.text("map") + ": is no import map",
                     "Begin it with \"format\": \"noctule-import-map\", \"version\": 1"};
    choice.map = std::move(*map);
    return choice;
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
    const auto choice = importChoice(arguments);
    if (!choice)
        return choice.error();
    const auto files = readImportFiles(arguments.operands(), &signalFlag());
    if (!files)
        return files.error();
    const ImportFormat* format = choice->map.is_object()          ? findImportFormat("csv")
                                 : arguments.text("as") == "auto" ? importFormatOf(*files)
                                                                  : findImportFormat(arguments.text("as"));
    if (!format)
        return unknownKind(*files);
    return readImport(*format, *files, *choice, context.job());
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

std::string partsOf(const ImportedSensor& sensor) {
    const auto any = [](const std::vector<Vector3d>& readings) {
        return std::any_of(readings.begin(), readings.end(),
                           [](const Vector3d& reading) { return reading.allFinite(); });
    };
    std::string parts;
    for (const auto& [there, name] : {std::pair{any(sensor.samples.gyro_rad_per_s), "gyroscope"},
                                      std::pair{any(sensor.samples.accel_m_per_s2), "accelerometer"},
                                      std::pair{any(sensor.samples.mag), "magnetometer"},
                                      std::pair{!sensor.q_world_sensor.empty(), "attitude"}})
        if (there)
            parts += (parts.empty() ? "" : ", ") + std::string(name);
    return parts.empty() ? "nothing" : parts;
}

size_t missingRows(const ImportedSensor& sensor) {
    size_t missing = 0;
    for (size_t i = 0; i < sensor.samples.size(); ++i)
        missing += !sensor.samples.gyro_rad_per_s[i].allFinite() &&
                   !sensor.samples.accel_m_per_s2[i].allFinite() &&
                   (i >= sensor.q_world_sensor.size() || !sensor.q_world_sensor[i].coeffs().allFinite());
    return missing;
}

std::string sensorText(const ImportedSensor& sensor) {
    char text[200];
    std::snprintf(text, sizeof text, "  %-20s %8.3f Hz %9.2f s, %zu rows, %zu missing, ", sensor.id.c_str(),
                  sensor.samples.rate_hz, double(sensor.samples.size()) / sensor.samples.rate_hz,
                  sensor.samples.size(), missingRows(sensor));
    return text + partsOf(sensor) + (sensor.segment.empty() ? "; segment not known" : "; " + sensor.segment) +
           "\n";
}

nlohmann::json sensorJson(const ImportedSensor& sensor) {
    return {{"id", sensor.id},
            {"rate_hz", sensor.samples.rate_hz},
            {"duration_s", double(sensor.samples.size()) / sensor.samples.rate_hz},
            {"offset_s", sensor.offset_s},
            {"rows", sensor.samples.size()},
            {"missing", missingRows(sensor)},
            {"holds", partsOf(sensor)},
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

Result<Outcome> runImport(const VerbContext& context) {
    const Arguments& arguments = context.arguments;
    const std::string path = arguments.operands()[0], out = arguments.text("out");
    const bool list = arguments.given("list");
    if (!list && out.empty())
        return Error{ErrorKind::kUsage, "--out is missing",
                     "Name the take to make, or look first with --list"};
    if (Status free = checkOutputs({out}, arguments.given("overwrite"), arguments.operands()); !free)
        return free.error();
    auto recording = readRecording(context);
    if (!recording)
        return recording.error();
    if (arguments.text("assign") == "none")
        for (ImportedSensor& sensor : recording->sensors)
            sensor.segment.clear();
    nlohmann::json assigned;
    if (arguments.text("assign") == "auto") {
        auto found = assignByMovement(*recording, context.job());
        if (!found)
            return found.error();
        assigned = std::move(*found);
    }
    for (const std::string& warning : recording->warnings)
        context.console.warn(path + ": " + warning);
    nlohmann::json found = {{"format", recording->format},
                            {"sensors", nlohmann::json::array()},
                            {"notes", recording->notes},
                            {"warnings", recording->warnings}};
    if (!assigned.is_null())
        found["assigned"] = std::move(assigned);
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
    verb.options = {text("out", "T.noctule", "the take to make"),
                    flag("list", "show what was found and make no take"),
                    choice("as", formatNames(), "the kind of recording; auto: by its content").orElse("auto"),
                    number("rate", "HZ", 1, 10000, "rows a second, in place of what the file says"),
                    choice("world", worldFrameNames(),
                           "axes of the recording's attitudes, in place of what the file says"),
                    text("map", "MAP.json", "columns, units and axes of a table of any program"),
                    choice("assign", {"names", "auto", "none"},
                           "segments of the sensors: by their names, by movement or left open")
                        .orElse("names")};
    verb.remarks = {
        "Kinds: MATLAB level 5 (BROAD, qmt), MVNX, MT Manager's text (one file per sensor), x-IMU3 (folders "
        "or "
        ".ximu3), OpenSense .sto, and any table with --map.",
        "Sensors, rates, units, axes and gaps are shown before the take is made. Units are checked by what "
        "gravity shows; every conversion and assumption is said.",
        "--assign auto tells by walking or free movement of ten seconds and more which of 7, 8 or 16 sensors "
        "sits "
        "where, however it is mounted and turned.",
        "The maker's own attitudes become a run of kind orientation; an optical system's or MVN's result "
        "becomes "
        "the reference."};
    verb.run = runImport;
    return verb;
}

}  // namespace noctule::batch
