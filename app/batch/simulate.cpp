// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/simulate.h"

#include "app/batch/files.h"
#include "app/batch/program.h"
#include "app/batch/verb.h"
#include "core/math/conventions.h"
#include "core/suit/default_suit.h"

namespace noctule::batch {
namespace {

using namespace simulation;

/// A suit that does not fit the performer is named by its file.
Status checkSuit(const StageRequest& request, const std::string& path) {
    std::vector<std::string> segments = canonicalJointNames();
    if (request.actor) {
        segments.clear();
        for (const Joint& joint : request.actor->skeleton.joints())
            segments.push_back(joint.name);
    }
    return checkSegments(request.suit, segments, path);
}

Result<StageRequest> stageRequest(const VerbContext& context) {
    const Arguments& arguments = context.arguments;
    StageRequest request;
    request.suit = defaultSuit();
    if (arguments.given("motion") == arguments.given("rig"))
        return Error{
            ErrorKind::kUsage,
            std::string("simulate needs ") + (arguments.given("rig") ? "one of --motion and --rig, not both"
                                                                     : "--motion M.bvh or --rig rest"),
            "`noctule --batch simulate --help` shows an example"};
    if (arguments.given("motion")) {
        auto clip = readMotion(arguments.text("motion"), arguments.text("bvh-unit"), context.console);
        if (!clip)
            return clip.error();
        request.clip = std::move(*clip);
    }
    if (arguments.given("suit")) {
        auto suit = readSuit(arguments.text("suit"));
        if (!suit)
            return suit.error();
        request.suit = std::move(*suit);
    }
    if (arguments.given("actor")) {
        auto actor = readActor(arguments.text("actor"));
        if (!actor)
            return actor.error();
        request.actor = std::move(*actor);
    }
    if (arguments.given("suit"))
        if (Status fits = checkSuit(request, arguments.text("suit")); !fits)
            return fits.error();
    auto scenario = Scenario::named(arguments.text("scenario"));
    if (!scenario)
        return scenario.error();
    request.scenario = *scenario;
    request.rest_seconds = arguments.number("rest-seconds");
    request.duration_s = arguments.number("duration").value_or(0);
    request.seed = static_cast<uint64_t>(*arguments.whole("seed"));
    return request;
}

nlohmann::json fitJson(const Stage& stage) {
    nlohmann::json fit = nlohmann::json::array();
    for (const FitQuality& quality : stage.motion.quality)
        fit.push_back({{"name", quality.joint},
                       {"mean_deg", degrees(quality.mean_rad)},
                       {"max_deg", degrees(quality.max_rad)}});
    return fit;
}

Outcome outcome(const VerbContext& context, const Stage& stage, const SimulationSummary& summary) {
    const Arguments& arguments = context.arguments;
    const std::string path = arguments.text("out");
    Outcome outcome;
    outcome.json = {{"take", path},
                    {"name", takeName(path)},
                    {"duration_s", summary.duration_s},
                    {"samples", summary.samples},
                    {"pulses", summary.pulses},
                    {"inertial_rows", summary.inertial_rows},
                    {"range_rows", summary.range_rows},
                    {"scenario", stage.scenario.name},
                    {"level", arguments.text("level")},
                    {"seed", stage.truth.seed},
                    {"repaired_frames", stage.motion.repaired_frames},
                    {"dropped_first_frame", stage.motion.dropped_first_frame},
                    {"fit", fitJson(stage)}};
    char text[200];
    std::snprintf(text, sizeof text, ": %.1f s, %zu boards, %zu sources, scenario %s, level %s.\n",
                  summary.duration_s, stage.suit.boards.size(), stage.suit.sources.size(),
                  stage.scenario.name.c_str(), arguments.text("level").c_str());
    outcome.text = path + text;
    return outcome;
}

Result<Outcome> runSimulate(const VerbContext& context) {
    const Arguments& arguments = context.arguments;
    const bool overwrite = arguments.given("overwrite");
    const std::string out = arguments.text("out"), calibration_out = arguments.text("calibration-out"),
                      truth_out = arguments.text("truth-out");
    if (Status free = checkOutputs({out, calibration_out, truth_out}, overwrite); !free)
        return free.error();
    auto request = stageRequest(context);
    if (!request)
        return request.error();
    context.console.progress(0, "Preparing the motion");
    const auto stage = prepareStage(*request);
    if (!stage)
        return stage.error();
    if (context.cancel.cancelled())
        return JobContext::cancelledError();
    TakeRequest take;
    take.out_path = out;
    take.level = arguments.text("level") == "readings" ? Level::kReadings : Level::kSignal;
    take.overwrite = overwrite;
    take.name = takeName(out);
    take.created_utc = utcNow();
    take.software = softwareName();
    const auto summary = writeTake(*stage, take, context.job());
    if (!summary)
        return summary.error();
    Calibration calibration = stage->calibration;
    calibration.created_utc = take.created_utc;
    if (!calibration_out.empty())
        if (Status written = writeJson(calibration_out, toJson(calibration), overwrite); !written)
            return written.error();
    if (!truth_out.empty())
        if (Status written = writeJson(truth_out, stage->truthJson(), overwrite); !written)
            return written.error();
    return outcome(context, *stage, *summary);
}

}  // namespace

Verb simulateVerb() {
    Verb verb;
    verb.name = "simulate";
    verb.summary = "make the take that a suit worn on a recorded motion would have recorded";
    verb.example =
        "noctule --batch simulate --motion /usr/share/assimp/models/BVH/01_01.bvh --out hops_001.noctule";
    verb.options = {
        text("motion", "M.bvh", "the motion, with any human hierarchy"),
        choice("rig", {"rest"}, "no motion: the performer stands in the rest pose")
            .laterOn({"jig", "level", "turntable"}),
        text("out", "T.noctule", "the take to write").needed(),
        choice("scenario", {"ideal", "nominal", "realistic"}, "how good the world is").orElse("nominal"),
        choice("level", {"signal", "readings"}, "sampled sound, or inertial and range rows at once (quick)")
            .orElse("signal"),
        text("suit", "S.json", "the suit; the one of 18 boards and 8 sources when not given"),
        text("actor", "A.json", "the performer; one with the motion's measures when not given"),
        number("rest-seconds", "S", 0, 3600, "rest pose before the motion").orElse("3"),
        number("duration", "S", 0.1, 86400, "of the whole take; a longer one repeats the motion"),
        text("calibration-out", "C.json", "write what a laboratory would know of this suit"),
        text("truth-out", "F.json", "write every hidden value"),
        bvhUnitOption(),
        later("digitizer-out", "D.csv", "measured points of the jig")};
    verb.run = runSimulate;
    return verb;
}

}  // namespace noctule::batch
