// SPDX-License-Identifier: Apache-2.0
// The verbs that begin with `calibrate`, and `check`: what they share, and the options of each.
#include <charconv>
#include <cmath>

#include "app/batch/files.h"
#include "app/batch/photographs.h"
#include "app/batch/signals.h"
#include "app/batch/verb.h"
#include "core/formats/text_file.h"
#include "core/job/atomic_file.h"
#include "core/processing/calibrate_sensors.h"
#include "core/processing/survey_room.h"
#include "devices/machine/clock.h"

namespace noctule::batch {
namespace {

constexpr double kHighestAnchor_m = 100;
constexpr int kReasonsNamed = 3;  // in the message; the report has them all

/// One of these verbs.
struct Plan {
    std::string verb;
    Result<CalibrationResult> (*solve)(const CalibrateRequest&, const Arguments&,
                                       const JobContext&) = nullptr;
    bool hears = false;            ///< --detector
    bool knows_performer = false;  ///< --actor
    bool measures = false;         ///< --actor-out
    bool checks_only = false;      ///< --calibration, and nothing but a report is written
    bool stores = false;           ///< --store
    bool surveys = false;          ///< no --base; a room's file comes out
};

Result<CalibrateRequest> requestOf(const Arguments& arguments, const Plan& plan) {
    CalibrateRequest request;
    request.take_paths = arguments.operands();
    request.created_utc = utcNow();
    if (plan.hears)
        request.detector = *detectorFromName(arguments.text("detector"));
    if (plan.surveys)
        return request;
    if (const Status read =
            readGiven(arguments, plan.checks_only ? "calibration" : "base", readCalibration, request.base);
        !read)
        return read.error();
    if (plan.knows_performer)
        if (const Status read = readGiven(arguments, "actor", readActor, request.actor); !read)
            return read.error();
    return request;
}

struct Outputs {
    std::string calibration, report, actor;  ///< empty: not wanted
    bool overwrite = false, force = false;
};

Outputs outputsOf(const Arguments& arguments, const Plan& plan) {
    Outputs outputs{"", arguments.text("report"), "", arguments.given("overwrite"), false};
    if (plan.measures)
        outputs.actor = arguments.text("actor-out");
    if (!plan.checks_only) {
        outputs.calibration = arguments.text("out");
        outputs.force = arguments.given("force");
    }
    return outputs;
}

Status write(const CalibrationResult& result, const Outputs& outputs, bool refused) {
    if (!outputs.report.empty())
        if (Status done =
                writeFileAtomically(outputs.report, calibrationHtml(result.document), outputs.overwrite);
            !done)
            return done;
    if (refused)
        return Done{};
    if (result.actor && !outputs.actor.empty())
        if (Status done = writeJson(outputs.actor, toJson(*result.actor), outputs.overwrite); !done)
            return done;
    if (outputs.calibration.empty())
        return Done{};
    return writeJson(outputs.calibration, result.room ? toJson(*result.room) : toJson(result.calibration),
                     outputs.overwrite);
}

/// In force in the takes that it was made from.
Status store(const CalibrateRequest& request, CalibrationResult& result) {
    if (!result.room)
        return storeCalibration(request.take_paths, result.calibration);
    return placeAnchors(request.take_paths.front(), *result.room, request.created_utc, result.warnings);
}

Error refusal(const CalibrationResult& result, const Plan& plan) {
    std::string reasons;
    int count = 0;
    for (const Finding& finding : result.document.findings)
        if (finding.grade == Grade::kNotUsable && ++count <= kReasonsNamed)
            reasons += (reasons.empty() ? "" : "; ") + finding.what;
    if (count > kReasonsNamed)
        reasons += "; and " + std::to_string(count - kReasonsNamed) + " more";
    return {ErrorKind::kUnusable, plan.verb + ": not usable: " + reasons,
            plan.checks_only ? "Put right what is named, or calibrate again"
                             : "Nothing is written; repeat what is named, or add --force"};
}

Result<Outcome> run(const VerbContext& context, const Plan& plan) {
    const auto request = requestOf(context.arguments, plan);
    if (!request)
        return request.error();
    const Outputs outputs = outputsOf(context.arguments, plan);
    std::vector<std::string> files{"report"};
    if (plan.measures)
        files.emplace_back("actor-out");
    if (!plan.checks_only)
        files.emplace_back("out");
    if (Status free = checkOutputs(context.arguments, files, {"base", "actor"}); !free)
        return free.error();
    auto result = plan.solve(*request, context.arguments, context.job());
    if (!result)
        return result.error();
    const bool refused = result->grade() == Grade::kNotUsable && !outputs.force;
    if (Status written = write(*result, outputs, refused); !written)
        return written.error();
    const bool stored = plan.stores && context.arguments.given("store") && !refused;
    if (stored)
        if (Status done = store(*request, *result); !done)
            return done.error();
    for (const std::string& warning : result->warnings)
        context.console.warn(warning);
    Outcome outcome{result->json, calibrationText(result->document), std::nullopt};
    if (refused) {
        outcome.failure = refusal(*result, plan);
        context.console.error(*outcome.failure);
        outcome.json["error"] = errorJson(*outcome.failure);
    } else if (!outputs.calibration.empty()) {
        outcome.json[result->room ? "room" : "calibration"] = outputs.calibration;
        outcome.text += "\nWritten: " + outputs.calibration + "\n";
        if (stored)
            outcome.text += "In force in the takes now\n";
    }
    if (!result->warnings.empty())
        outcome.json["warnings"] = result->warnings;
    return outcome;
}

Option detectorOption() {
    return choice("detector", {"inflection", "matched"},
                  "what finds the pulses in the sound; each detector has offsets of its own")
        .orElse("inflection");
}

Option byHandOption() {
    return flag("by-hand",
                "without plate and turntable: finds gyroscopes and accelerometers, as calibrate inertial");
}

Option actorOption() {
    return inputFile("actor", "A.json", "the performer; the one in the take when not given");
}

Option reportOption() {
    return text("report", "R.html", "what was found, as a page that opens anywhere");
}

/// Options that every calibration has, behind its own.
std::vector<Option> withCommon(std::vector<Option> own) {
    own.push_back(
        text("out", "C.json", "the calibration, with the values of --base where nothing new was found")
            .needed());
    own.push_back(
        inputFile("base", "C0.json",
                  "the calibration to start from; the one in force in the first take when not given"));
    own.push_back(reportOption());
    own.push_back(flag("force", "write the calibration even when it is not usable"));
    return own;
}

Verb calibrationVerb(const std::string& kind, const std::string& summary, const std::string& operands,
                     const std::string& example, std::vector<Option> own) {
    Verb verb;
    verb.name = "calibrate " + kind;
    verb.summary = summary;
    verb.operands = operands;
    verb.min_operands = 1;
    verb.max_operands = operands.ends_with("...") ? kAnyNumber : 1;
    verb.example = "noctule --batch calibrate " + kind + " " + example;
    verb.options = withCommon(std::move(own));
    verb.remarks = {
        "Exit code 4 and nothing written when the result is not usable; the reasons name part and remedy."};
    return verb;
}

Result<KnownDistances> readTable(const Arguments& arguments, const char* option) {
    const std::string path = arguments.text(option);
    const auto text = readTextFile(path, &signalFlag());
    if (!text)
        return text.error();
    return std::string(option) == "digitizer" ? readDigitizerCsv(*text, path)
                                              : readTapeMeasureCsv(*text, path);
}

Result<CalibrationResult> solveSources(const CalibrateRequest& request, const Arguments& arguments,
                                       const JobContext& job) {
    if (arguments.given("digitizer") + arguments.given("distances") + arguments.given("photos") != 1)
        return Error{ErrorKind::kUsage,
                     "calibrate sources needs one of --digitizer, --distances and --photos",
                     "Give the file of points, the file of distances or the photographs"};
    SourceOffsetSettings settings;
    if (arguments.text("speed-of-sound") == "estimate")
        settings.speed_of_sound = SourceOffsetSettings::SpeedOfSound::kEstimate;
    if (!arguments.given("photos")) {
        const auto known = readTable(arguments, arguments.given("digitizer") ? "digitizer" : "distances");
        return known ? calibrateSources(request, *known, settings, job)
                     : Result<CalibrationResult>(known.error());
    }
    const auto found = measurePhotographs(arguments, job);
    if (!found)
        return found.error();
    auto result = calibrateSources(request, found->known, settings, job);
    if (result)
        result->json["photographs"] = photographsJson(*found);
    return result;
}

/// "ceiling_1=2.41"
Result<std::pair<std::string, double>> heightOf(const std::string& word) {
    const size_t equals = word.rfind('=');
    double height_m = 0;
    const char* end = word.data() + word.size();
    const char* begin = equals == std::string::npos ? end : word.data() + equals + 1;
    const auto [rest, error] = std::from_chars(begin, end, height_m);
    if (equals == 0 || error != std::errc() || rest != end || !(std::abs(height_m) <= kHighestAnchor_m))
        return Error{ErrorKind::kUsage, "--height cannot be '" + word + "'",
                     "Give the anchor's name and metres: --height ceiling_1=2.41"};
    return std::pair(word.substr(0, equals), height_m);
}

Result<CalibrationResult> solveRoom(const CalibrateRequest& request, const Arguments& arguments,
                                    const JobContext& job) {
    RoomRequest room{request.take_paths.front(),
                     arguments.text("subject"),
                     {},
                     request.created_utc,
                     arguments.texts("without")};
    for (const std::string& word : arguments.texts("height")) {
        auto height = heightOf(word);
        if (!height)
            return height.error();
        room.heights_m.push_back(std::move(*height));
    }
    auto surveyed = calibrateRoom(room, job);
    if (!surveyed)
        return surveyed.error();
    return std::move(surveyed->result);
}

}  // namespace

Verb calibrateSourcesVerb() {
    std::vector<Option> options = {
        inputFile("digitizer", "D.csv", "points on the jig: placement,kind,id,x_m,y_m,z_m (or x_mm...)"),
        inputFile("distances", "D.csv", "tape measure: placement,source,board,distance_m (or distance_mm)"),
        detectorOption(),
        choice("speed-of-sound", {"temperature", "estimate"},
               "from the take's thermometer, or from the distances")
            .orElse("temperature")};
    const std::vector<Option> photographs = photographOptions();
    options.insert(options.begin() + 2, photographs.begin(), photographs.end());
    Verb verb =
        calibrationVerb("sources", "find every source's offset from a take on the jig", "J.noctule...",
                        "jig_001.noctule --digitizer jig.csv --out suit.json", std::move(options));
    for (const std::string& remark : photographRemarks())
        verb.remarks.push_back(remark);
    verb.alone = "print-markers";
    verb.run = [](const VerbContext& context) -> Result<Outcome> {
        if (const Status fits = checkPhotographOptions(context.arguments); !fits)
            return fits.error();
        if (context.arguments.given("print-markers"))
            return printMarkers(context);
        return run(context, {.verb = "calibrate sources", .solve = solveSources, .hears = true});
    };
    return verb;
}

Verb calibrateAccelerometersVerb() {
    Verb verb = calibrationVerb("accelerometers", "find zeros and slopes from level positions, in any order",
                                "L.noctule...", "level_001.noctule --out suit.json", {byHandOption()});
    verb.run = [](const VerbContext& context) {
        const auto solve = [](const CalibrateRequest& request, const Arguments& arguments,
                              const JobContext& job) {
            return arguments.given("by-hand") ? calibrateInertial(request, job)
                                              : calibrateAccelerometers(request, job);
        };
        return run(context, {.verb = "calibrate accelerometers", .solve = solve});
    };
    return verb;
}

Verb calibrateGyroscopesVerb() {
    Verb verb = calibrationVerb(
        "gyroscopes", "find zeros and slopes from turns on a turntable, up and down for each axis",
        "S.noctule...", "spin_001.noctule --rpm 45 --out suit.json",
        {number("rpm", "N", 1, 1000, "nominal speed of the table; as the take states it when not given"),
         byHandOption()});
    verb.run = [](const VerbContext& context) {
        const auto solve = [](const CalibrateRequest& request, const Arguments& arguments,
                              const JobContext& job) {
            return arguments.given("by-hand")
                       ? calibrateInertial(request, job)
                       : calibrateGyroscopes(request, arguments.number("rpm").value_or(0), job);
        };
        return run(context, {.verb = "calibrate gyroscopes", .solve = solve});
    };
    return verb;
}

Verb calibrateMagnetometersVerb() {
    Verb verb = calibrationVerb(
        "magnetometers", "find hard and soft iron from boards turned through all directions", "M.noctule...",
        "turned_001.noctule --out suit.json --store",
        {number("strength", "UT", 10, 100,
                "strength of the field there in microtesla; as the readings have it when not given"),
         flag("store", "put the calibration in force in these takes too")});
    verb.remarks.push_back(
        "Turn each board, or the whole suit in a bag, slowly through all directions in one "
        "place; directions that are missing are named. Stretches in which the field is bent "
        "stand in --json.");
    verb.run = [](const VerbContext& context) {
        const auto solve = [](const CalibrateRequest& request, const Arguments& arguments,
                              const JobContext& job) {
            return calibrateMagnetometers(request, arguments.number("strength"), job);
        };
        return run(context, {.verb = "calibrate magnetometers", .solve = solve, .stores = true});
    };
    return verb;
}

Verb calibrateInertialVerb() {
    Verb verb =
        calibrationVerb("inertial", "calibrate gyroscopes and accelerometers by hand, without a turntable",
                        "H.noctule...", "by_hand_001.noctule --out suit.json --store",
                        {flag("store", "put the calibration in force in these takes too")});
    verb.remarks.push_back(
        "Lay the sensor down still for two seconds in 12 positions and more, and turn it about "
        "all axes between them (Tedaldi 2014).");
    verb.run = [](const VerbContext& context) {
        const auto solve = [](const CalibrateRequest& request, const Arguments&, const JobContext& job) {
            return calibrateInertial(request, job);
        };
        return run(context, {.verb = "calibrate inertial", .solve = solve, .stores = true});
    };
    return verb;
}

Verb calibrateRestPoseVerb() {
    Verb verb = calibrationVerb("rest-pose", "align the boards from a performer who stands still",
                                "T.noctule", "rest_001.noctule --base suit.json --out worn.json",
                                {actorOption(), detectorOption()});
    verb.run = [](const VerbContext& context) {
        const auto solve = [](const CalibrateRequest& request, const Arguments&, const JobContext& job) {
            return calibrateRestPose(request, job);
        };
        return run(context,
                   {.verb = "calibrate rest-pose", .solve = solve, .hears = true, .knows_performer = true});
    };
    return verb;
}

Verb calibrateMotionVerb() {
    Verb verb = calibrationVerb(
        "motion", "find mounting, bones and sources from 30 to 60 s of movement that begins in the rest pose",
        "T.noctule...", "moves_001.noctule --base worn.json --out moved.json --actor-out performer.json",
        {actorOption(), text("actor-out", "A.json", "the performer with the bones found"), detectorOption()});
    verb.run = [](const VerbContext& context) {
        const auto solve = [](const CalibrateRequest& request, const Arguments&, const JobContext& job) {
            return calibrateMotion(request, job);
        };
        return run(context, {.verb = "calibrate motion",
                             .solve = solve,
                             .hears = true,
                             .knows_performer = true,
                             .measures = true});
    };
    return verb;
}

Verb calibrateRoomVerb() {
    Verb verb;
    verb.name = "calibrate room";
    verb.summary = "find the places of a room's anchors from a take in which somebody walks past them";
    verb.operands = "T.noctule";
    verb.min_operands = verb.max_operands = 1;
    verb.example = "noctule --batch calibrate room room_001.noctule --out room.json --store";
    verb.options = {
        text("out", "ROOM.json",
             "the room's file with the places found, for attach, record and simulate --cast")
            .needed(),
        text("subject", "NAME", "who walked; the one whom most distances concern when not given"),
        texts("height", "ANCHOR=M", "heights above the floor that were measured, in metres"),
        texts("without", "ANCHOR", "anchors to leave out, by name or number; three must be left"),
        flag("store", "put the places in force in this take too"),
        reportOption(),
        flag("force", "write the room's file even when it is not usable; it lacks anchors without a place")};
    verb.remarks = {
        "Stand still in the rest pose in the middle of the room, then walk slowly past all anchors and turn. "
        "The origin becomes where you stood, +z where you faced.",
        "In a take of sound the room's file says which pulse was heard: each place in it must be right to "
        "0.2 m.",
        "Without a performer, anchors that hear each other keep place and heading of the room's file, and "
        "three heights make it level.",
        "Exit code 4 and nothing written when the result is not usable; the reasons name part and remedy."};
    verb.run = [](const VerbContext& context) {
        return run(context, {.verb = "calibrate room", .solve = solveRoom, .stores = true, .surveys = true});
    };
    return verb;
}

Verb checkVerb() {
    Verb verb;
    verb.name = "check";
    verb.summary = "compare a still pose with the calibration in force: good, or what has moved";
    verb.operands = "T.noctule";
    verb.min_operands = verb.max_operands = 1;
    verb.example = "noctule --batch check still_001.noctule --calibration worn.json";
    verb.options = {inputFile("calibration", "C.json", "the one in force in the take when not given"),
                    actorOption(), detectorOption(), reportOption()};
    verb.remarks = {"Exit code 4 when something has moved; the reasons name part and remedy."};
    verb.run = [](const VerbContext& context) {
        const auto solve = [](const CalibrateRequest& request, const Arguments&, const JobContext& job) {
            return checkStill(request, job);
        };
        return run(
            context,
            {.verb = "check", .solve = solve, .hears = true, .knows_performer = true, .checks_only = true});
    };
    return verb;
}

}  // namespace noctule::batch
