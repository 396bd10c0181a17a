// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <set>
#include <sstream>
#include <thread>

#include "app/batch/files.h"
#include "app/batch/parameters.h"
#include "app/batch/program.h"
#include "app/batch/takes.h"
#include "core/estimation/paper_parameters.h"
#include "core/job/atomic_file.h"
#include "core/live/point_estimators.h"
#include "core/processing/points_table.h"
#include "core/processing/process_take.h"
#include "core/recording/take_copy.h"
#include "devices/machine/clock.h"

namespace noctule::batch {
namespace {

Result<SensorSelection> sensorSelection(const std::string& letters) {
    SensorSelection sensors{false, false, false};
    for (const char letter : letters) {
        bool* sensor = letter == 'A' || letter == 'a'   ? &sensors.accelerometers
                       : letter == 'G' || letter == 'g' ? &sensors.gyroscopes
                       : letter == 'D' || letter == 'd' ? &sensors.distances
                                                        : nullptr;
        if (!sensor || *sensor)
            return Error{ErrorKind::kUsage,
                         "--sensors cannot be '" + letters + "': '" + letter + "' " +
                             (sensor ? "stands there twice" : "is no sensor"),
                         "Give any of A (accelerometers), G (gyroscopes) and D (distances)"};
        *sensor = true;
    }
    return sensors;
}

Wanted wantedFrom(const std::string& word) {
    return word == "on" ? Wanted::kOn : word == "off" ? Wanted::kOff : Wanted::kAuto;
}

/// "A,B"; blanks around a name are left out.
std::vector<std::string> splitNames(const std::string& text) {
    std::vector<std::string> names;
    std::istringstream from(text);
    for (std::string name; std::getline(from, name, ',');) {
        const size_t begin = name.find_first_not_of(' '), end = name.find_last_not_of(' ');
        if (begin != std::string::npos)
            names.push_back(name.substr(begin, end - begin + 1));
    }
    return names;
}

/// --params, then --param, then --paper-sigma.
Result<ParameterValues> parametersOf(const Arguments& arguments, const EstimatorEntry& estimator) {
    ParameterValues values;
    if (arguments.given("params"))
        if (Status read = addParameterFile(arguments.text("params"), estimator, values); !read)
            return read.error();
    for (const std::string& setting : arguments.texts("param"))
        if (Status read = addParameter(setting, values); !read)
            return read.error();
    if (const auto sigma = arguments.number("paper-sigma")) {
        if (estimator.name != kPaperEstimator)
            return Error{ErrorKind::kUsage, "--paper-sigma belongs to the paper's estimator",
                         "Add --estimator paper, or leave it out"};
        values[kPaperProcessSigma] = *sigma;
    }
    if (Status known = checkParameters(estimator.parameters, values, estimator.name); !known)
        return known.error();
    return values;
}

Result<ProcessRequest> requestOf(const Arguments& arguments) {
    ProcessRequest request;
    const auto sensors = sensorSelection(arguments.text("sensors"));
    if (!sensors)
        return sensors.error();
    request.tracker.sensors = *sensors;
    request.tracker.root_given = arguments.text("root") == "given";
    request.tracker.estimator = arguments.text("estimator");
    const EstimatorEntry& estimator = *findEstimator(request.tracker.estimator);
    request.tracker.smoother = *smootherFromName(arguments.text("smooth"));
    if (estimator.whole_take && estimator.smooths && !arguments.given("smooth"))
        request.tracker.smoother = Smoother::kFull;
    if (estimator.whole_take && estimator.smooths && request.tracker.smoother != Smoother::kFull &&
        request.tracker.smoother != Smoother::kNone)
        return Error{ErrorKind::kUsage,
                     "--smooth " + arguments.text("smooth") + " does not go with estimator " + estimator.name,
                     "Take --smooth full, which is its default, or none"};
    if (request.tracker.smoother != Smoother::kNone && !estimator.smooths)
        return Error{ErrorKind::kUsage,
                     "--smooth " + arguments.text("smooth") + " does not go with estimator " +
                         estimator.name + ", which has no smoother",
                     "Leave out --smooth, or --estimator " + estimator.name};
    request.tracker.ground = *groundFromName(arguments.text("ground"));
    if (arguments.given("detector"))
        request.detector = *detectorFromName(arguments.text("detector"));
    auto parameters = parametersOf(arguments, estimator);
    if (!parameters)
        return parameters.error();
    request.tracker.parameters = std::move(*parameters);
    if (const Status read = readGiven(arguments, "calibration", readCalibration, request.calibration); !read)
        return read.error();
    if (const Status read = readGiven(arguments, "actor", readActor, request.actor); !read)
        return read.error();
    request.subjects = splitNames(arguments.text("subjects"));
    request.between = wantedFrom(arguments.text("between"));
    request.room = wantedFrom(arguments.text("room"));
    request.select = arguments.number("select").value_or(1);
    if (arguments.given("select") && request.between == Wanted::kOff && request.room == Wanted::kOff)
        return Error{ErrorKind::kUsage,
                     "--select chooses among ranges that --between off and --room off leave out",
                     "Leave out --select"};
    request.run_name = arguments.text("run-name");
    request.software = softwareName();
    request.created_utc = utcNow();
    return request;
}

/// Where results go; the take itself without --out-dir.
std::string resultPath(const Arguments& arguments, const std::string& take) {
    return arguments.given("out-dir")
               ? (std::filesystem::path(arguments.text("out-dir")) / std::filesystem::path(take).filename())
                     .string()
               : take;
}

Status checkTakes(const Arguments& arguments) {
    if (Status distinct = checkDistinct(arguments.operands()); !distinct || !arguments.given("out-dir"))
        return distinct;
    std::set<std::string> paths;
    for (const std::string& take : arguments.operands()) {
        const std::string path = resultPath(arguments, take);
        if (!paths.insert(path).second)
            return Error{ErrorKind::kUsage, "two takes would become " + path, "Process them one by one"};
        if (Status free = checkOutputs({path}, arguments.given("overwrite")); !free)
            return free;
    }
    return Done{};
}

nlohmann::json rangesJson(const RangeTally& ranges) {
    return {{"heard", ranges.heard},
            {"used", ranges.used},
            {"gated", ranges.gated},
            {"behind", ranges.behind},
            {"left_out", ranges.left_out}};
}

/// What became of each that was heard.
std::string rangesText(const RangeTally& ranges) {
    return "of " + std::to_string(ranges.heard) + " ranges heard " + std::to_string(ranges.used) +
           " were used, " + std::to_string(ranges.gated) + " rejected by the gate, " +
           std::to_string(ranges.behind) + " came from behind their source, " +
           std::to_string(ranges.left_out) + " were too doubtful or not needed";
}

Outcome outcomeOf(const std::string& path, const ProcessSummary& s) {
    Outcome outcome;
    outcome.json = {{"take", path},
                    {"run", s.run_name},
                    {"runs", {{"pose", s.pose_run}, {"range", s.range_run}, {"inertial", s.inertial_run}}},
                    {"poses", s.poses},
                    {"duration_s", s.duration_s},
                    {"ranges", rangesJson(s.ranges)},
                    {"frames", {{"seen", s.frames_seen}, {"lost", s.frames_lost}}},
                    {"contacts", {{"found", s.contacts}, {"edited", s.contacts_edited}}},
                    {"clipped_readings", s.clipped_readings},
                    {"resets", s.resets},
                    {"calibrated", gradeWord(s.calibrated)},
                    {"warnings", s.warnings}};
    if (s.subjects.size() > 1)
        for (const ProcessSummary::Subject& subject : s.subjects)
            outcome.json["subjects"].push_back({{"name", subject.name},
                                                {"suit", subject.suit},
                                                {"poses", subject.poses},
                                                {"ranges", rangesJson(subject.ranges)}});
    if (s.together)
        outcome.json["together"] = {{"between", s.together->between},
                                    {"room", s.together->room},
                                    {"unjoined", s.together->unjoined},
                                    {"ranges", rangesJson(s.together->ranges)}};
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%.1f", s.duration_s);
    outcome.text = path + ": result " + s.run_name + ", " + std::to_string(s.poses) + " poses over " +
                   seconds + " s; " + rangesText(s.ranges) + "; " + std::to_string(s.frames_lost) + " of " +
                   std::to_string(s.frames_seen) + " frames lost.\n";
    if (s.subjects.size() > 1)
        for (const ProcessSummary::Subject& subject : s.subjects)
            outcome.text += path + ": " + subject.name + ", suit " + std::to_string(subject.suit) + ": " +
                            std::to_string(subject.poses) + " poses; " + rangesText(subject.ranges) + ".\n";
    if (s.together)
        outcome.text += path + ": between suits" + (s.together->room ? " and the room" : "") + " " +
                        rangesText(s.together->ranges) + ".\n";
    if (s.contacts_edited)
        outcome.text += path + ": contacts of the feet as they were edited, none were looked for.\n";
    return outcome;
}

Result<ProcessSummary> processOne(const Arguments& arguments, ProcessRequest request, const std::string& take,
                                  const JobContext& job) {
    request.take_path = take;
    if (!arguments.given("out-dir"))
        return processTake(request, job);
    auto copy = TakeCopy::make(take, resultPath(arguments, take), job);
    if (!copy)
        return copy.error();
    request.take_path = copy->path();
    const auto summary = processTake(request, job);
    if (!summary)
        return copy->named(summary.error());
    if (Status published = copy->publish(arguments.given("overwrite")); !published)
        return published.error();
    return summary;
}

/// Points are a table beside the take: nothing that belongs to poses goes with them.
Status checkPointOptions(const Arguments& arguments) {
    const std::string estimator = arguments.text("estimator");
    if (!givesPoints(estimator))
        return arguments.given("points")
                   ? Status(Error{ErrorKind::kUsage,
                                  "--points does not go with estimator " + estimator + ", which gives poses",
                                  "Leave out --points, or take --estimator comocap"})
                   : Done{};
    for (const char* name : {"run-name", "out-dir", "select"})
        if (arguments.given(name))
            return Error{ErrorKind::kUsage,
                         "--" + std::string(name) + " does not go with estimator " + estimator +
                             ", which gives points and writes no result",
                         "Leave it out" + std::string(name == std::string("select")
                                                          ? "; --param share=0.5 chooses ranges of ms-comocap"
                                                          : "")};
    if (arguments.text("root") == "given" || !arguments.given("points"))
        return Error{ErrorKind::kUsage,
                     "estimator " + estimator + " gives places of points, not poses" +
                         (arguments.given("points") ? ": --root given means nothing to it" : ""),
                     arguments.given("points") ? "Leave out --root" : "Add --points P.csv, where they go"};
    if (arguments.operands().size() > 1)
        return Error{ErrorKind::kUsage, "--points names one table, there are several takes",
                     "Process them one by one"};
    return checkOutputs(arguments, {"points"});
}

Result<Outcome> runPoints(const VerbContext& context, ProcessRequest request) {
    const Arguments& arguments = context.arguments;
    request.take_path = arguments.operands()[0];
    const std::string path = arguments.text("points");
    if (const auto folder = std::filesystem::path(path).parent_path(); !folder.empty())
        request.tracker.spool_folder = folder.string();
    PointsTableWriter table;
    const auto summary = trackPoints(request, table.sink(), context.job());
    if (!summary)
        return summary.error();
    for (const std::string& warning : summary->warnings)
        context.console.warn(request.take_path + ": " + warning);
    if (Status written = writeFileAtomically(path, table.text(), arguments.given("overwrite")); !written)
        return written.error();
    Outcome outcome;
    outcome.json = {{"take", request.take_path},
                    {"estimator", request.tracker.estimator},
                    {"points", path},
                    {"devices", summary->points.size()},
                    {"instants", summary->frames},
                    {"ranges",
                     {{"heard", summary->heard},
                      {"used", summary->used},
                      {"gated", summary->gated},
                      {"room", summary->of_room},
                      {"own", summary->own},
                      {"between", summary->between}}},
                    {"warnings", summary->warnings}};
    outcome.text = path + ": " + std::to_string(summary->points.size()) + " points at " +
                   std::to_string(summary->frames) + " instants; of " + std::to_string(summary->heard) +
                   " ranges (" + std::to_string(summary->of_room) + " with the room, " +
                   std::to_string(summary->own) + " within, " + std::to_string(summary->between) +
                   " between subjects) " + std::to_string(summary->used) + " were used, " +
                   std::to_string(summary->gated) + " rejected by the gate, " +
                   std::to_string(summary->heard - summary->used - summary->gated) +
                   " not needed or of points that were lost.\n";
    return outcome;
}

Result<Outcome> runProcess(const VerbContext& context) {
    const Arguments& arguments = context.arguments;
    if (Status points = checkPointOptions(arguments); !points)
        return points.error();
    if (Status sensible = checkTakes(arguments); !sensible)
        return sensible.error();
    const auto request = requestOf(arguments);
    if (!request)
        return request.error();
    if (givesPoints(request->tracker.estimator))
        return runPoints(context, *request);
    const size_t cores = std::max(1U, std::thread::hardware_concurrency());
    const size_t jobs = static_cast<size_t>(arguments.whole("jobs").value_or(static_cast<int64_t>(cores)));
    return forEachTake(context, jobs, [&](const std::string& take, const JobContext& job) -> Result<Outcome> {
        const auto summary = processOne(arguments, *request, take, job);
        if (!summary)
            return summary.error();
        for (const std::string& warning : summary->warnings)
            context.console.warn(take + ": " + warning);
        if (!request->run_name.empty() && summary->run_name != request->run_name)
            context.console.warn(take + ": there was a result '" + request->run_name +
                                 "' already; this one is '" + summary->run_name + "'.");
        return outcomeOf(resultPath(arguments, take), *summary);
    });
}

}  // namespace

Verb processVerb() {
    Verb verb;
    verb.name = "process";
    verb.summary = "turn a take's sound and inertia into joint angles, as a new result in it";
    verb.operands = "T.noctule...";
    verb.min_operands = 1;
    verb.max_operands = kAnyNumber;
    verb.example = "noctule --batch process hops_001.noctule --sensors AGD --root free";
    verb.options = {
        inputFile("calibration", "C.json",
                  "the calibration, in force in the take from now on; when not given, the one in force"),
        inputFile("actor", "A.json",
                  "the performer, in force in the take from now on; when not given, the one in force"),
        text("sensors", "AGD", "any of A accelerometers, G gyroscopes, D distances").orElse("AGD"),
        choice("root", {"free", "given"}, "given: by another system, from the take's external_root")
            .orElse("free"),
        choice(
            "ground", {"level", "uneven", "treadmill", "none"},
            "what holds feet that stand while the root is free: level holds their height, too; a treadmill "
            "nothing, though contacts are found; none: no contacts")
            .orElse("level"),
        choice("detector", {"matched", "inflection"},
               "what finds the pulses in the sound: matched, or the paper's inflection, which is the default "
               "with --estimator paper"),
        choice("estimator", estimatorNames(),
               "paper: Vlasic 2007 to the letter; orientation: poses of other makers' sensors; comocap, "
               "ms-comocap, environment: Welch 2018, points of several people (--points)")
            .orElse(kManifoldEstimator),
        texts("param", "NAME=VALUE", "sets a parameter of the estimator; `estimators` lists them"),
        inputFile("params", "F.json", "parameters by name, or the settings of a result"),
        number("paper-sigma", "X", 1e-6, 1e6,
               "process sigma of the paper's estimator, rad/s^2 (default 0.04)"),
        choice("smooth", {"none", "lag", "full", "batch"},
               "poses that know what came later: half a second of it (lag) or all (full); batch: all, "
               "linearised again until the most probable motion is found, several times as long")
            .orElse("none"),
        text("subjects", "A,B", "whose poses, of a take of several; all of them when not given"),
        choice("between", {"auto", "on", "off"},
               "one estimate of all subjects from the ranges between them; auto: where there are any")
            .orElse("auto"),
        choice("room", {"auto", "on", "off"},
               "ranges to and from the anchors of the room hold place and heading; auto: where there are any")
            .orElse("auto"),
        number("select", "SHARE", 0, 1,
               "share of the ranges between suits that is used, most informative first (default 1)"),
        text("points", "P.csv", "where the points of comocap, ms-comocap and environment go"),
        text("run-name", "NAME",
             "name of the new result; from sensors, estimator and smoother when not given"),
        text("out-dir", "D", "copy the take there and write into the copy")};
    verb.remarks = {"Nothing is replaced: every call adds a result, and the raw data stay as they are."};
    verb.run = runProcess;
    return verb;
}

}  // namespace noctule::batch
