// SPDX-License-Identifier: Apache-2.0
#include "app/batch/simulate_cast.h"

#include "app/batch/cast_request.h"
#include "app/batch/files.h"
#include "app/batch/stage_request.h"
#include "core/math/conventions.h"

namespace noctule::batch {
namespace {

using namespace simulation;

nlohmann::json suitsJson(const Cast& cast) {
    nlohmann::json suits = nlohmann::json::array();
    for (size_t i = 0; i < cast.suits.size(); ++i) {
        const Stage& stage = cast.suits[i].stage;
        nlohmann::json suit{{"suit", i + 1},
                            {"boards", stage.suit.boards.size()},
                            {"sources", stage.suit.sources.size()},
                            {"carrier_hz", stage.scenario.drive_hz},
                            {"pulse_interval_samples", stage.scenario.schedule().interval_samples}};
        if (cast.suits[i].isRoom()) {
            suit["room"] = true;
        } else {
            suit["name"] = cast.suits[i].name;
            suit["place"] = {{"x_m", cast.places[i].x_m},
                             {"z_m", cast.places[i].z_m},
                             {"yaw_deg", degrees(cast.places[i].yaw_rad)}};
        }
        suits.push_back(std::move(suit));
    }
    return suits;
}

Outcome castOutcome(const VerbContext& context, const Cast& cast, const SimulationSummary& summary) {
    const std::string path = context.arguments.text("out"), level = context.arguments.text("level");
    const Stage& first = cast.suits.front().stage;
    std::string names;
    for (const CastSuit& suit : cast.suits)
        names += (names.empty() ? "" : ", ") + (suit.isRoom() ? "the room" : suit.name);
    Outcome outcome;
    outcome.json = {{"take", path},
                    {"name", takeName(path)},
                    {"duration_s", summary.duration_s},
                    {"samples", summary.samples},
                    {"pulses", summary.pulses},
                    {"inertial_rows", summary.inertial_rows},
                    {"range_rows", summary.range_rows},
                    {"scenario", first.scenario.name},
                    {"level", level},
                    {"seed", first.truth.seed},
                    {"suits", suitsJson(cast)},
                    {"notes", cast.notes}};
    char text[100];
    std::snprintf(text, sizeof text, ": %.1f s, scenario %s, level %s: ", summary.duration_s,
                  first.scenario.name.c_str(), level.c_str());
    outcome.text = path + text + names + ".\n";
    return outcome;
}

/// Options that say of one performer what the cast says of each.
Status checkCastOptions(const Arguments& arguments) {
    for (const char* name :
         {"motion", "rig", "suit", "actor", "up", "height", "bones", "calibration-out", "digitizer-out"})
        if (arguments.given(name))
            return Error{
                ErrorKind::kUsage,
                "--" + std::string(name) + " does not go with --cast, which speaks of several performers",
                "Leave it out; what a subject has stands in the cast"};
    return Done{};
}

}  // namespace

Result<Outcome> runSimulateCast(const VerbContext& context) {
    const Arguments& arguments = context.arguments;
    const bool overwrite = arguments.given("overwrite");
    const std::string out = arguments.text("out"), truth_out = arguments.text("truth-out");
    if (Status fits = checkCastOptions(arguments); !fits)
        return fits.error();
    if (Status free = checkOutputs(arguments, {"out", "truth-out"}); !free)
        return free.error();
    context.console.progress(0, "Preparing the motions");
    const auto request = castRequest(arguments.text("cast"), arguments, context.console,
                                     arguments.number("duration").value_or(0));
    if (!request)
        return request.error();
    const auto cast = prepareCast(*request);
    if (!cast)
        return cast.error();
    for (const std::string& note : cast->notes)
        context.console.tell(note);
    if (context.cancel.cancelled())
        return JobContext::cancelledError();
    const simulation::TakeRequest take = takeRequest(arguments);
    const auto summary = writeTake(*cast, take, context.job());
    if (!summary)
        return summary.error();
    if (!truth_out.empty())
        if (Status written = writeJson(truth_out, cast->truthJson(), overwrite); !written)
            return written.error();
    return castOutcome(context, *cast, *summary);
}

}  // namespace noctule::batch
