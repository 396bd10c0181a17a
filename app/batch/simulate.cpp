// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/simulate.h"

#include "app/batch/files.h"
#include "app/batch/program.h"
#include "app/batch/simulate_cast.h"
#include "app/batch/stage_request.h"
#include "app/batch/verb.h"
#include "core/job/atomic_file.h"
#include "core/math/conventions.h"
#include "devices/machine/clock.h"

namespace noctule::batch {
namespace {

using namespace simulation;

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
    if (arguments.given("cast"))
        return runSimulateCast(context);
    const bool overwrite = arguments.given("overwrite");
    const std::string out = arguments.text("out"), calibration_out = arguments.text("calibration-out"),
                      truth_out = arguments.text("truth-out"),
                      digitizer_out = arguments.text("digitizer-out");
    if (Status free = checkOutputs(arguments, {"out", "calibration-out", "truth-out", "digitizer-out"});
        !free)
        return free.error();
    if (arguments.given("motion") == arguments.given("rig"))
        return Error{ErrorKind::kUsage,
                     std::string("simulate needs ") +
                         (arguments.given("rig") ? "one of --motion and --rig, not both"
                                                 : "--motion M.bvh, --cast CAST.json or --rig rest, jig, "
                                                   "level or turntable"),
                     "`noctule --batch simulate --help` shows an example"};
    if (!digitizer_out.empty() && arguments.text("rig") != nameOf(RigKind::kJig))
        return Error{ErrorKind::kUsage, "--digitizer-out is for the jig", "Give --rig jig, or leave it out"};
    nlohmann::json understood;
    auto request = stageRequest(arguments, context.console, &understood);
    if (!request)
        return request.error();
    request->duration_s = arguments.number("duration").value_or(0);
    context.console.progress(0, "Preparing the motion");
    const auto stage = prepareStage(*request);
    if (!stage)
        return stage.error();
    if (context.cancel.cancelled())
        return JobContext::cancelledError();
    const simulation::TakeRequest take = takeRequest(arguments);
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
    if (!digitizer_out.empty())
        if (Status written = writeFileAtomically(
                digitizer_out,
                digitizerCsv(*stage->rig, stage->suit, stage->scenario.rigs.digitizer_sigma_m, request->seed),
                overwrite);
            !written)
            return written.error();
    Outcome made = outcome(context, *stage, *summary);
    if (!understood.is_null())
        made.json["motion"] = std::move(understood);
    return made;
}

}  // namespace

Verb simulateVerb() {
    Verb verb;
    verb.name = "simulate";
    verb.summary = "make the take that a suit worn on a recorded motion, or on a rig, would have recorded";
    verb.example =
        "noctule --batch simulate --motion /usr/share/assimp/models/BVH/01_01.bvh --out hops_001.noctule";
    verb.options = {
        text("out", "T.noctule", "the take to write").needed(),
        inputFile("cast", "CAST.json",
                  "several performers in one room, each with motion and suit, in one take"),
        choice("level", {"signal", "readings"}, "sampled sound, or inertial and range rows at once (quick)")
            .orElse("signal"),
        number("duration", "S", 0.1, 86400, "of the whole take; a longer one repeats the motion"),
        text("calibration-out", "C.json", "write what a laboratory would know of this suit"),
        text("truth-out", "F.json", "write every hidden value"),
        text("digitizer-out", "D.csv", "write what a digitizer measures on the jig")};
    const std::vector<Option> stage = stageOptions();
    verb.options.insert(verb.options.begin(), stage.begin(), stage.end());
    verb.run = runSimulate;
    return verb;
}

}  // namespace noctule::batch
