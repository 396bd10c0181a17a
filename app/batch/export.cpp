// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <set>

#include "app/batch/export_drive.h"
#include "app/batch/files.h"
#include "app/batch/takes.h"
#include "app/batch/verb.h"
#include "core/film/texture_decoder.h"
#include "core/media/video_file.h"
#include "core/processing/export_program.h"
#include "core/processing/export_take.h"
#include "core/processing/run_subjects.h"

namespace noctule::batch {
namespace {

constexpr const char* kNamePlace = "{name}";

/// The output's path with the take's name put in.
std::string pathFor(const std::string& pattern, const std::string& take_path) {
    std::string path = pattern;
    for (size_t at = 0; (at = path.find(kNamePlace, at)) != std::string::npos;) {
        const std::string name = takeName(take_path);
        path.replace(at, std::string(kNamePlace).size(), name);
        at += name.size();
    }
    return path;
}

RootMotion rootMotion(const std::string& name) {
    return name == "in-place"  ? RootMotion::kInPlace
           : name == "heading" ? RootMotion::kHeading
                               : RootMotion::kMoving;
}

CameraMove cameraMove(const std::string& name) {
    return name == "follow" ? CameraMove::kFollow : name == "turn" ? CameraMove::kTurn : CameraMove::kFront;
}

/// "1280x720"; nothing when it is none.
std::optional<PictureSize> pictureSize(const std::string& text) {
    PictureSize size;
    int end = 0;
    const bool read = std::sscanf(text.c_str(), "%5dx%5d%n", &size.width_px, &size.height_px, &end) == 2 &&
                      end == static_cast<int>(text.size());
    return read && size.width_px > 0 && size.height_px > 0 ? std::optional(size) : std::nullopt;
}

bool namesMeshFile(const Arguments& arguments) {
    return arguments.text("mesh") != "none" && arguments.text("mesh") != "mannequin";
}

ExportRequest requestFor(const Arguments& arguments, const std::string& take_path) {
    ExportRequest request;
    request.take_path = take_path;
    request.run = arguments.text("run");
    const ExportProgram preset = exportProgram(arguments.text("preset"));
    request.frames_per_second = arguments.number("fps").value_or(preset.frames_per_second);
    request.from_s = arguments.number("from");
    request.to_s = arguments.number("to");
    request.root = rootMotion(arguments.text("root"));
    for (const ExportFormatEntry& format : exportFormats())
        request.*format.path = pathFor(arguments.text(format.option), take_path);
    request.metres_per_unit = preset.metres_per_unit;
    request.names = preset.names;
    request.root_name = preset.root_name;
    if (arguments.given("stacks"))
        request.motion_name = takeName(take_path);
    request.with_body = arguments.text("mesh") != "none";
    request.lock_feet = arguments.text("feet") != "free";
    request.film.size = pictureSize(arguments.text("size")).value_or(request.film.size);
    request.film.camera = cameraMove(arguments.text("camera"));
    request.film.frames_per_second = arguments.number("fps").value_or(request.film.frames_per_second);
    request.film.blending =
        arguments.text("blending") == "dual" ? Blending::kDualQuaternion : Blending::kLinear;
    request.angles = arguments.given("angles");
    request.overwrite = arguments.given("overwrite");
    return request;
}

/// One for each subject of the run. A take that cannot be read gets one, whose job names the trouble; of one
/// whose performers go together the trouble is the call's, for a file of one of them would be wrong.
Result<std::vector<ExportRequest>> requestsFor(const Arguments& arguments, const std::string& take_path) {
    const ExportRequest request = requestFor(arguments, take_path);
    if (arguments.given("together"))
        return requestsTogether(request);
    if (arguments.given("stacks"))
        return std::vector{request};
    const auto each = requestsOfSubjects(request);
    return each ? *each : std::vector{request};
}

/// Takes as stacks, or the performers of one take as characters.
bool goesIntoOneFile(const Arguments& arguments) {
    return arguments.given("stacks") || arguments.given("together");
}

Status checkPictures(const Arguments& arguments, const ExportRequest& request) {
    if (arguments.given("size") && !pictureSize(arguments.text("size")))
        return Error{ErrorKind::kUsage, "--size does not take " + arguments.text("size"),
                     "Give width and height in pixels, as in 1280x720"};
    if (!request.video_path.empty() && !isVideoFileName(request.video_path))
        return Error{ErrorKind::kUsage, request.video_path + ": films of this kind cannot be written",
                     "End its name with .mp4, .mkv or .avi"};
    const auto& formats = exportFormats();
    const bool shows_body = std::any_of(formats.begin(), formats.end(), [&](const auto& format) {
        return showsBody(format.format) && arguments.given(format.option);
    });
    if (arguments.given("mesh") && !shows_body)
        return Error{ErrorKind::kUsage, "--mesh is the body of files that have one, and none is written",
                     "Give any of --fbx F, --glb F, --png F and --video F too"};
    if (arguments.given("bones") && !namesMeshFile(arguments))
        return Error{ErrorKind::kUsage, "--bones says which bone of a mesh is which, and no mesh is named",
                     "Give --mesh FILE too"};
    if (arguments.given("feet") && !namesMeshFile(arguments))
        return Error{ErrorKind::kUsage, "--feet is for bodies of other proportions, and no mesh is named",
                     "Give --mesh FILE too"};
    return Done{};
}

/// Programs go by how a name ends, and would refuse an FBX file that is called .glb.
Status checkEndings(const ExportRequest& request) {
    for (const ExportFormatEntry& format : exportFormats()) {
        const std::string& path = request.*format.path;
        std::string ending = std::filesystem::path(path).extension().string();
        std::transform(ending.begin(), ending.end(), ending.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        const std::string wanted = std::string(".") + format.extension;
        if (format.format != ExportFormat::kVideo && !ending.empty() && ending != wanted)
            return Error{ErrorKind::kUsage, path + ": --" + format.option + " writes no file of this kind",
                         "End its name with " + wanted};
    }
    return Done{};
}

/// One FBX or GLB file and nothing else.
Status checkOneFile(const Arguments& arguments, const std::vector<ExportRequest>& requests) {
    if (!goesIntoOneFile(arguments))
        return Done{};
    const bool together = arguments.given("together");
    const std::string option = together ? "--together" : "--stacks";
    const std::string what = together ? "all performers" : "all takes";
    const ExportRequest& first = requests.front();
    if (together && arguments.given("stacks"))
        return Error{ErrorKind::kUsage, "--together is for one take, and --stacks for several",
                     "Give the one or the other"};
    if (together && arguments.operands().size() > 1)
        return Error{ErrorKind::kUsage, "--together puts the performers of one take into a file",
                     "Export the takes one by one"};
    const std::vector<std::string> paths = outputsOf(first);
    if (paths.size() != 1 || !holdsSeveral(formatOf(first, paths[0])))
        return Error{ErrorKind::kUsage,
                     option + " puts " + what + " into one FBX or GLB file, and nothing else",
                     "Give --fbx F or --glb F, and write other files without " + option};
    if (outputsOf(requests.back()) != paths)
        return Error{ErrorKind::kUsage, "--stacks writes one file, and {name} in its path would make several",
                     "Leave {name} out"};
    for (const ExportRequest& request : requests)
        if (const auto subjects = subjectsOfRun(request.take_path, request.run);
            !together && subjects && subjects->size() > 1)
            return Error{ErrorKind::kUnusable, request.take_path + ": holds several performers",
                         "Export it by itself with --together, or without --stacks"};
    return Done{};
}

/// Every path once.
std::vector<std::string> allOutputs(const Arguments& arguments, const std::vector<ExportRequest>& requests) {
    if (goesIntoOneFile(arguments))
        return outputsOf(requests.front());
    std::vector<std::string> paths;
    for (const ExportRequest& request : requests)
        for (const std::string& path : outputsOf(request))
            paths.push_back(path);
    return paths;
}

Status checkRequests(const Arguments& arguments, const std::vector<ExportRequest>& requests) {
    if (requests.empty() || outputsOf(requests.front()).empty())
        return Error{
            ErrorKind::kUsage, "export has nothing to write",
            "Give any of --bvh F, --fbx F, --glb F, --csv F, --mot F, --sto F, --png F and --video F"};
    for (const Status& sensible : {checkEndings(requests.front()), checkPictures(arguments, requests.front()),
                                   checkOneFile(arguments, requests)})
        if (!sensible)
            return sensible;
    if (arguments.given("angles") && !arguments.given("csv"))
        return Error{ErrorKind::kUsage, "--angles adds columns to a CSV file, and none is written",
                     "Give --csv F too"};
    if (arguments.given("from") && arguments.given("to") &&
        *arguments.number("from") > *arguments.number("to"))
        return Error{ErrorKind::kUsage, "--from lies after --to", "Give --from S before --to S"};
    const bool is_single = requests.size() == 1 || goesIntoOneFile(arguments);
    if (Status free =
            checkOutputs(allOutputs(arguments, requests), requests.front().overwrite, arguments.inputFiles());
        !free) {
        if (is_single)
            return free;
        return Error{free.error().kind, free.error().message,
                     free.error().remedy + "; {name} in a path stands for the take's name"};
    }
    return Done{};
}

std::string describe(const ExportRequest& request, const ExportSummary& summary, const std::string& file) {
    const ExportFormat format = formatOf(request, file);
    if (format == ExportFormat::kPng)
        return "a picture";
    return std::to_string(format == ExportFormat::kVideo ? summary.film_frames : summary.frames) + " frames";
}

/// Who stands still where no pose was captured.
void tellHeld(const ExportSummary& summary, Outcome& outcome) {
    if (!summary.held.empty())
        outcome.json["held"] = summary.held;
    for (const std::string& notice : summary.held)
        outcome.text += notice + "\n";
}

Outcome outcomeOf(const ExportRequest& request, const ExportSummary& summary) {
    Outcome outcome;
    outcome.json = {{"take", request.take_path},        {"run", summary.run},
                    {"frames", summary.frames},         {"fps", request.frames_per_second},
                    {"duration_s", summary.duration_s}, {"files", summary.files}};
    if (!request.video_path.empty())
        outcome.json["film"] = {{"frames", summary.film_frames}, {"fps", request.film.frames_per_second}};
    if (request.worn)
        outcome.json["bones"] = request.worn->bones.node_of_joint;
    for (const std::string& file : summary.files) {
        outcome.text += file + ": " + describe(request, summary, file) + " of result " + summary.run;
        const ExportFormat format = formatOf(request, file);
        if (format != ExportFormat::kPng && format != ExportFormat::kVideo) {
            outcome.json["begin_s"][file] = summary.begin_s;
            char begin[64];
            std::snprintf(begin, sizeof begin, ", from second %.3f of the take", summary.begin_s);
            outcome.text += request.from_s ? begin : "";
        }
        outcome.text += ".\n";
    }
    tellHeld(summary, outcome);
    return outcome;
}

/// The files of another performer.
void merge(const nlohmann::json& one, nlohmann::json& all) {
    all["files"].insert(all["files"].end(), one["files"].begin(), one["files"].end());
    if (one.contains("begin_s"))
        all["begin_s"].update(one["begin_s"]);
    if (one.contains("held"))
        for (const nlohmann::json& notice : one["held"])
            all["held"].push_back(notice);
}

/// The body that --mesh names; null for ours.
Result<std::shared_ptr<const WearableBody>> readBody(const VerbContext& context) {
    const Arguments& arguments = context.arguments;
    if (!namesMeshFile(arguments))
        return std::shared_ptr<const WearableBody>();
    WearingChoices choices;
    if (arguments.given("bones")) {
        auto bones = readBoneMap(arguments.text("bones"));
        if (!bones)
            return bones.error();
        choices.bones = std::move(*bones);
    }
    auto body = readWearable(arguments.text("mesh"), choices, context.job());
    const bool is_drawn = arguments.given("png") || arguments.given("video");
    if (body && is_drawn)
        if (const auto undrawn = undrawnTextures((*body)->mesh, arguments.text("mesh")))
            context.console.warn(undrawn->text() + ".");
    return body;
}

Result<Outcome> writeOneFile(const VerbContext& context, const std::vector<ExportRequest>& requests) {
    const auto summary = exportStacks(requests, context.job());
    if (!summary)
        return summary.error();
    Outcome outcome;
    const bool together = context.arguments.given("together");
    outcome.json = {{"takes", context.arguments.operands()},
                    {together ? "performers" : "stacks", requests.size()},
                    {"frames", summary->frames},
                    {"fps", requests.front().frames_per_second},
                    {"duration_s", summary->duration_s},
                    {"files", summary->files}};
    if (requests.front().worn)
        outcome.json["bones"] = requests.front().worn->bones.node_of_joint;
    outcome.text = summary->files.front() + ": " + std::to_string(requests.size()) +
                   (together ? " performers, " : " stacks, ") + std::to_string(summary->frames) + " frames";
    if (together && requests.front().from_s && requests.front().to_s) {
        outcome.json["from_s"] = *requests.front().from_s;
        outcome.json["to_s"] = *requests.front().to_s;
        char span[96];
        std::snprintf(span, sizeof span, ", seconds %.3f to %.3f of the take", *requests.front().from_s,
                      *requests.front().to_s);
        outcome.text += span;
    }
    outcome.text += ".\n";
    tellHeld(*summary, outcome);
    return outcome;
}

/// Motions and a robot's files come from different tables; each call writes the one or the other.
Status checkKinds(const Arguments& arguments) {
    if (!exportsDrive(arguments))
        return arguments.given("drive")
                   ? Status(Error{ErrorKind::kUsage, "--drive belongs to a robot's files",
                                  "Give --robot-csv F or another of them, too"})
                   : Status(Done{});
    for (const ExportFormatEntry& format : exportFormats())
        if (arguments.given(format.option))
            return Error{ErrorKind::kUsage,
                         std::string("--") + format.option + " and a robot's files are written one by one",
                         "Call export twice"};
    return Done{};
}

Result<Outcome> runExport(const VerbContext& context) {
    if (Status sensible = checkKinds(context.arguments); !sensible)
        return sensible.error();
    if (exportsDrive(context.arguments))
        return exportDrive(context);
    std::vector<ExportRequest> requests;
    for (const std::string& take : context.arguments.operands()) {
        auto each = requestsFor(context.arguments, take);
        if (!each)
            return each.error();
        std::move(each->begin(), each->end(), std::back_inserter(requests));
    }
    if (Status sensible = checkRequests(context.arguments, requests); !sensible)
        return sensible.error();
    const auto body = readBody(context);
    if (!body)
        return body.error();
    for (ExportRequest& request : requests)
        request.worn = *body;
    if (goesIntoOneFile(context.arguments))
        return writeOneFile(context, requests);
    return forEachTake(context, 1, [&](const std::string& take, const JobContext& job) -> Result<Outcome> {
        Outcome outcome;
        auto each = requestsFor(context.arguments, take);
        if (!each)
            return each.error();
        for (ExportRequest& request : *each) {
            request.worn = *body;
            const auto summary = exportTake(request, job);
            if (!summary)
                return summary.error();
            Outcome one = outcomeOf(request, *summary);
            if (outcome.json.is_null())
                outcome.json = one.json;
            else
                merge(one.json, outcome.json);
            outcome.text += one.text;
        }
        return outcome;
    });
}

std::vector<Option> fileOptions() {
    return {
        text("run", "NAME", "the result to write; the last one when not given"),
        text("bvh", "F", "animation with its skeleton; {name} in F stands for the take's name"),
        text("fbx", "F", "skeleton, motion and body as binary FBX 7.4"),
        text("glb", "F", "the same as binary glTF"),
        flag("stacks", "all takes in one FBX or GLB file, each as an animation with its name"),
        flag("together", "all performers of a take in one FBX or GLB file, each as a character of its own"),
        text("csv", "F", "world positions of all joints in metres"),
        text("mot", "F", "joint angles for OpenSim, in degrees"),
        text("sto", "F", "orientations of the segments for OpenSim's OpenSense"),
        flag("angles", "adds the named degrees of freedom to the CSV, in degrees"),
        choice("preset", {"blender", "motionbuilder", "unity", "unreal"},
               "who the files are for; motionbuilder is Maya too. Sets unit, names and frame rate"),
        number("fps", "N", 1, 1000, "frames per second; 120, or what the preset's program likes"),
        text("png", "F", "a picture of the second --from, else of the middle"),
        text("video", "F", "a film, .mp4, .mkv or .avi; 30 frames per second unless --fps says so")};
}

std::vector<Option> partOptions() {
    return {number("from", "S", 0, 86400,
                   "first second of the take; the first pose from there on is time 0 of what is written (a "
                   "CSV has the take's time)"),
            number("to", "S", 0, 86400, "last second of the take"),
            choice("root", {"moving", "in-place", "heading"},
                   "as captured; over one spot; over one spot and always facing forward")
                .orElse("moving")};
}

/// Of files that show a body.
std::vector<Option> lookOptions() {
    return {inputFile("mesh", "mannequin|none|M",
                      "the body: the default one; the skeleton alone; that of a .glb, .gltf, .vrm, .fbx, "
                      ".dae, .obj or .ply file, on its own bones or on some made for it")
                .orElse("mannequin"),
            inputFile("bones", "MAP.json",
                      "which bone of M is which joint, where they are not found by themselves"),
            choice("feet", {"locked", "free"},
                   "of M: feet that stand keep their place; or legs turn as ours, and may slide")
                .orElse("locked"),
            text("size", "WxH", "of film and picture in pixels").orElse("1280x720"),
            choice("camera", {"front", "follow", "turn"},
                   "stands before the performer; goes along; goes along and once around")
                .orElse("front"),
            choice("blending", {"linear", "dual"},
                   "how skin bends in film and picture: as other programs do, or by dual quaternions")
                .orElse("linear")};
}

}  // namespace

Verb exportVerb() {
    Verb verb;
    verb.name = "export";
    verb.summary = "write a result as animation files, pictures and films, or a robot's drive as tables";
    verb.operands = "T.noctule...";
    verb.min_operands = 1;
    verb.max_operands = kAnyNumber;
    verb.example = "noctule --batch export hops_001.noctule --fbx hops.fbx --preset blender";
    verb.options = fileOptions();
    for (std::vector<Option> more : {partOptions(), lookOptions(), driveExportOptions()})
        verb.options.insert(verb.options.end(), more.begin(), more.end());
    verb.remarks = {
        "Every file is written aside and read again before it gets its name. With several takes "
        "the paths must contain {name}, unless --stacks puts them into one FBX or GLB file."};
    verb.run = runExport;
    return verb;
}

}  // namespace noctule::batch
