// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "app/batch/files.h"
#include "app/batch/program.h"
#include "app/batch/takes.h"
#include "core/job/outside_text.h"
#include "core/processing/orient_take.h"
#include "core/processing/orientation_csv.h"
#include "devices/machine/clock.h"

namespace noctule::batch {
namespace {

std::vector<std::string> orientationNames() {
    std::vector<std::string> names;
    for (const OrientationEstimator& estimator : orientationEstimators())
        names.push_back(estimator.name);
    return names;
}

nlohmann::json boardJson(const OrientedBoard& board) {
    return {{"id", board.id},
            {"readings", board.readings},
            {"missing", board.missing},
            {"magnetometer", board.has_magnetometer},
            {"mag_lag_ms", board.mag_lag_ms},
            {"mag_lag_sigma_ms", board.mag_lag_sigma_ms},
            {"heading_sigma_deg", board.heading_sigma_deg}};
}

std::string boardText(const OrientedBoard& board) {
    char text[200];
    std::snprintf(text, sizeof text, "  %-14s %zu readings, %zu missing", shortText(board.id, 40).c_str(),
                  board.readings, board.missing);
    std::string line = text;
    if (!board.has_magnetometer)
        return line + ", no magnetometer: its heading drifts\n";
    if (board.mag_lag_sigma_ms > 0) {
        std::snprintf(text, sizeof text, ", magnetometer %.1f ms late (sigma %.1f)", board.mag_lag_ms,
                      board.mag_lag_sigma_ms);
        line += text;
    }
    return line + "\n";
}

Result<OrientRequest> orientRequest(const Arguments& arguments) {
    OrientRequest request;
    request.created_utc = utcNow();
    request.software = softwareName();
    request.estimator = findOrientationEstimator(arguments.text("estimator"));
    request.choice.smooth = arguments.text("smooth") == "full";
    request.choice.level_reading = arguments.given("level-reading");
    request.choice.gain_per_s = arguments.number("gain");
    if (Status read = readGiven(arguments, "calibration", readCalibration, request.calibration); !read)
        return read.error();
    if (request.choice.smooth && !request.estimator->can_smooth)
        return Error{ErrorKind::kUsage,
                     std::string("Estimator ") + request.estimator->name + " cannot smooth",
                     "Leave --smooth out, or take --estimator noctule"};
    request.run_name = arguments.text("run-name");
    if (request.run_name.empty())
        request.run_name = std::string("orientation ") + request.estimator->name +
                           (request.choice.smooth ? " smoothed" : "");
    return request;
}

Status checkTable(const Arguments& arguments) {
    const std::string path = arguments.text("csv");
    if (path.empty())
        return Done{};
    if (arguments.operands().size() > 1)
        return Error{ErrorKind::kUsage, "--csv is one table, and several takes are given",
                     "Give one take at a time"};
    return checkOutputs(arguments, {"csv"});
}

Status writeTable(const VerbContext& context, const std::string& take, const std::string& run,
                  const JobContext& job) {
    const Arguments& arguments = context.arguments;
    if (!arguments.given("csv"))
        return Done{};
    return writeOrientationCsv({take, run, arguments.text("csv"),
                                *eulerSequenceNamed(arguments.text("angles")), arguments.given("overwrite")},
                               job);
}

Result<Outcome> runOrient(const VerbContext& context) {
    auto request = orientRequest(context.arguments);
    if (!request)
        return request.error();
    if (Status free = checkTable(context.arguments); !free)
        return free.error();
    if (Status distinct = checkDistinct(context.arguments.operands()); !distinct)
        return distinct.error();
    return forEachTake(context, 1, [&](const std::string& path, const JobContext& job) -> Result<Outcome> {
        OrientRequest one = *request;
        one.take_path = path;
        const auto summary = orientTake(one, job);
        if (!summary)
            return summary.error();
        if (Status written = writeTable(context, path, summary->run_name, job); !written)
            return written.error();
        for (const std::string& warning : summary->warnings)
            context.console.warn(path + ": " + warning);
        Outcome outcome{{{"take", path},
                         {"run", summary->run_name},
                         {"estimator", one.estimator->name},
                         {"boards", nlohmann::json::array()}},
                        path + ": result " + summary->run_name + "\n",
                        std::nullopt};
        for (const OrientedBoard& board : summary->boards) {
            outcome.json["boards"].push_back(boardJson(board));
            outcome.text += boardText(board);
        }
        return outcome;
    });
}

}  // namespace

Verb orientVerb() {
    Verb verb;
    verb.name = "orient";
    verb.summary = "orientation of each sensor by itself: gyroscope, accelerometer, magnetometer";
    verb.operands = "T.noctule...";
    verb.min_operands = 1;
    verb.max_operands = kAnyNumber;
    verb.example = "noctule --batch orient trial_02.noctule --smooth full";
    verb.options = {
        choice("estimator", orientationNames(), "whose equations").orElse("noctule"),
        choice("smooth", {"none", "full"}, "use what comes later too (noctule)").orElse("none"),
        number("gain", "PER_S", 0, 10, "correction gain of miller (0.04) and bachmann (0.1)"),
        flag("level-reading", "miller: level the sensed field as its reference is; gain then 0.1"),
        text("csv", "F.csv",
             "the result as a table: attitudes in the world, and relative to the sensor before"),
        choice("angles", eulerSequenceNames(), "order of the Euler angles in the table").orElse("ZXY"),
        inputFile("calibration", "C.json", "the calibration; the one in force in the take when not given"),
        text("run-name", "NAME", "how the result is called")};
    verb.remarks = {
        "It needs a take of inertial sensors; of a driver box's take process gives the motion.",
        "The result is one of kind orientation in the take; evaluate compares it with the take's "
        "reference: total, heading and inclination, root mean square over the phases of movement."};
    verb.run = runOrient;
    return verb;
}

}  // namespace noctule::batch
