// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <filesystem>

#include "app/batch/files.h"
#include "app/batch/program.h"
#include "app/batch/signals.h"
#include "app/batch/verb.h"
#include "core/import/import_take.h"
#include "core/import/mat_recording.h"
#include "core/import/unit_check.h"
#include "core/job/atomic_file.h"
#include "devices/device/clock.h"
#include "devices/device/random_uuid.h"

namespace noctule::batch {
namespace {

Result<ImportedRecording> readRecording(const std::string& path, double rate_hz) {
    ReadOptions options;
    options.cancel = &signalFlag();
    auto bytes = readWholeFile(path, options);
    if (!bytes)
        return bytes.error();
    auto arrays = parseMat(*bytes, path);
    if (!arrays)
        return arrays.error();
    return recordingFromMat(*arrays, std::filesystem::path(path).stem().string(), rate_hz);
}

std::string foundText(const ImportSummary& summary, const ImportedRecording& recording) {
    char text[240];
    std::snprintf(text, sizeof text, "%zu %s, %.3f Hz, %.1f s, %s, %s; %zu of %zu readings missing\n",
                  summary.sensors, summary.sensors == 1 ? "sensor" : "sensors", summary.rate_hz,
                  summary.duration_s, summary.has_magnetometer ? "with magnetometer" : "no magnetometer",
                  summary.has_reference ? "with an optical reference" : "no reference", summary.missing,
                  summary.readings);
    std::string names;
    for (const ImportedSensor& sensor : recording.sensors)
        names += (names.empty() ? "" : ", ") + sensor.id;
    return text + ("  " + names + "\n");
}

Result<Outcome> runImport(const VerbContext& context) {
    const Arguments& arguments = context.arguments;
    const std::string path = arguments.operands()[0], out = arguments.text("out");
    if (Status free = checkOutputs({out}, arguments.given("overwrite"), {path}); !free)
        return free.error();
    auto recording = readRecording(path, arguments.number("rate").value_or(0));
    if (!recording)
        return recording.error();
    convertToSi(*recording);
    for (const std::string& warning : recording->warnings)
        context.console.warn(path + ": " + warning);
    ImportRequest request{
        out, takeName(out), utcNow(), softwareName(), randomUuid(), arguments.given("overwrite")};
    const auto summary = writeImportedTake(*recording, request, context.job());
    if (!summary)
        return summary.error();
    nlohmann::json sensors = nlohmann::json::array();
    for (const ImportedSensor& sensor : recording->sensors)
        sensors.push_back(sensor.id);
    return Outcome{{{"take", out},
                    {"sensors", sensors},
                    {"rate_hz", summary->rate_hz},
                    {"duration_s", summary->duration_s},
                    {"readings", summary->readings},
                    {"missing", summary->missing},
                    {"magnetometer", summary->has_magnetometer},
                    {"reference", summary->has_reference},
                    {"warnings", recording->warnings}},
                   out + ": " + foundText(*summary, *recording),
                   std::nullopt};
}

}  // namespace

Verb importVerb() {
    Verb verb;
    verb.name = "import";
    verb.summary = "make a take of a recording of other sensors (MATLAB files of level 5)";
    verb.operands = "FILE.mat";
    verb.min_operands = verb.max_operands = 1;
    verb.example = "noctule --batch import 02_undisturbed_slow_rotation_B.mat --out slow_001.noctule";
    verb.options = {text("out", "T.noctule", "the take to make").needed(),
                    choice("as", {"mat"}, "the kind of file").orElse("mat"),
                    number("rate", "HZ", 1, 10000, "readings a second, in place of what the file says")};
    verb.remarks = {
        "Sensors are found by the names of their N x 3 arrays: gyr, acc, mag, alone, with a prefix or "
        "as members of a struct. Units are checked by what gravity shows; a conversion is said. BROAD's "
        "opt_quat, opt_pos and movement become the reference."};
    verb.run = runImport;
    return verb;
}

}  // namespace noctule::batch
