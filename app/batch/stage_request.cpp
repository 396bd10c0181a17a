// SPDX-License-Identifier: Apache-2.0
#include "app/batch/stage_request.h"

#include "app/batch/files.h"
#include "app/batch/motion_file.h"
#include "app/batch/program.h"
#include "core/suit/default_suit.h"
#include "devices/machine/clock.h"

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

/// The one that Noctule comes with. What a bag is for, its boards can read.
Suit usualSuit(const std::optional<RigKind>& rig) {
    Suit suit = defaultSuit();
    for (Board& board : suit.boards)
        board.has_magnetometer = rig == RigKind::kBag;
    return suit;
}

std::optional<RigKind> rigNamed(const std::string& name) {
    for (const RigKind kind : {RigKind::kJig, RigKind::kLevelPlate, RigKind::kTurntable, RigKind::kBag})
        if (name == nameOf(kind))
            return kind;
    return std::nullopt;
}

}  // namespace

std::vector<Option> stageOptions() {
    std::vector<Option> options = {
        inputFile("motion", "M.bvh|M.fbx|M.glb", "the motion, with any human hierarchy"),
        choice("rig", {"rest", "jig", "level", "turntable", "bag"},
               "no motion: the performer stands in the rest pose, or nobody wears the suit, it is on a "
               "rig of calibration"),
        choice("scenario", {"ideal", "nominal", "realistic"}, "how good the world is").orElse("nominal"),
        inputFile("suit", "S.json",
                  "the suit; the one of 18 boards and 8 sources when not given, in a bag with magnetometers"),
        inputFile("actor", "A.json", "the performer; one with the motion's measures when not given"),
        number("rest-seconds", "S", 0, 3600, "rest pose before the motion").orElse("3")};
    for (Option& option : motionOptions("motion"))
        options.push_back(std::move(option));
    return options;
}

Result<StageRequest> stageRequest(const Arguments& arguments, Console& console, nlohmann::json* understood) {
    StageRequest request;
    request.rig = rigNamed(arguments.text("rig"));
    request.suit = usualSuit(request.rig);
    if (request.rig)
        for (const char* name : {"actor", "rest-seconds"})
            if (arguments.given(name))
                return Error{ErrorKind::kUsage,
                             "--" + std::string(name) + " does not go with --rig " + arguments.text("rig") +
                                 ", where nobody wears the suit",
                             "Leave it out, or take --rig rest"};
    if (Status fits = checkMotionOptions(arguments, "motion"); !fits)
        return fits.error();
    if (arguments.given("motion")) {
        auto motion = readUnderstood(arguments.text("motion"), arguments, console);
        if (!motion)
            return motion.error();
        if (understood)
            *understood = figure::toJson(*motion);
        request.joints = std::move(motion->joints);
        request.clip = std::move(motion->clip);
    }
    if (const Status read = readGiven(arguments, "suit", readSuit, request.suit); !read)
        return read.error();
    if (const Status read = readGiven(arguments, "actor", readActor, request.actor); !read)
        return read.error();
    if (arguments.given("suit") && !request.rig)
        if (Status fits = checkSuit(request, arguments.text("suit")); !fits)
            return fits.error();
    auto scenario = Scenario::named(arguments.text("scenario"));
    if (!scenario)
        return scenario.error();
    request.scenario = *scenario;
    request.rest_seconds = arguments.number("rest-seconds");
    request.seed = static_cast<uint64_t>(*arguments.whole("seed"));
    return request;
}

simulation::TakeRequest takeRequest(const Arguments& arguments) {
    simulation::TakeRequest take;
    take.out_path = arguments.text("out");
    take.level = arguments.text("level") == "readings" ? Level::kReadings : Level::kSignal;
    take.overwrite = arguments.given("overwrite");
    take.name = takeName(take.out_path);
    take.created_utc = utcNow();
    take.software = softwareName();
    return take;
}

}  // namespace noctule::batch
