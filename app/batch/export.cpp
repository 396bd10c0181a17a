// SPDX-License-Identifier: Apache-2.0
#include "app/batch/files.h"
#include "app/batch/takes.h"
#include "app/batch/verb.h"
#include "core/processing/export_program.h"
#include "core/processing/export_take.h"

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

/// The formats by their options, and where each of them stands in a request.
std::vector<std::pair<const char*, std::string*>> pathsIn(ExportRequest& request) {
    return {{"bvh", &request.bvh_path}, {"fbx", &request.fbx_path}, {"glb", &request.glb_path},
            {"csv", &request.csv_path}, {"mot", &request.mot_path}, {"sto", &request.sto_path}};
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
    for (const auto& [format, path] : pathsIn(request))
        *path = pathFor(arguments.text(format), take_path);
    request.metres_per_unit = preset.metres_per_unit;
    request.names = preset.names;
    request.root_name = preset.root_name;
    request.with_body = arguments.text("mesh") != "none";
    request.angles = arguments.given("angles");
    request.overwrite = arguments.given("overwrite");
    return request;
}

Status checkRequests(const Arguments& arguments, const std::vector<ExportRequest>& requests) {
    if (requests.empty() || outputsOf(requests.front()).empty())
        return Error{ErrorKind::kUsage, "export has nothing to write",
                     "Give any of --bvh F, --fbx F, --glb F, --csv F, --mot F and --sto F"};
    if (arguments.given("angles") && !arguments.given("csv"))
        return Error{ErrorKind::kUsage, "--angles adds columns to a CSV file, and none is written",
                     "Give --csv F too"};
    if (arguments.given("from") && arguments.given("to") &&
        *arguments.number("from") > *arguments.number("to"))
        return Error{ErrorKind::kUsage, "--from lies after --to", "Give --from S before --to S"};
    std::vector<std::string> paths;
    for (const ExportRequest& request : requests)
        for (const std::string& path : outputsOf(request))
            paths.push_back(path);
    if (Status free = checkOutputs(paths, requests.front().overwrite, arguments.operands()); !free) {
        if (requests.size() == 1)
            return free;
        return Error{free.error().kind, free.error().message,
                     free.error().remedy + "; {name} in a path stands for the take's name"};
    }
    return Done{};
}

Outcome outcomeOf(const ExportRequest& request, const ExportSummary& summary) {
    Outcome outcome;
    outcome.json = {{"take", request.take_path},        {"run", summary.run},
                    {"frames", summary.frames},         {"fps", request.frames_per_second},
                    {"duration_s", summary.duration_s}, {"files", summary.files}};
    for (const std::string& file : summary.files)
        outcome.text +=
            file + ": " + std::to_string(summary.frames) + " frames of run " + summary.run + ".\n";
    return outcome;
}

Result<Outcome> runExport(const VerbContext& context) {
    std::vector<ExportRequest> requests;
    for (const std::string& take : context.arguments.operands())
        requests.push_back(requestFor(context.arguments, take));
    if (Status sensible = checkRequests(context.arguments, requests); !sensible)
        return sensible.error();
    return forEachTake(context, 1, [&](const std::string& take, const JobContext& job) -> Result<Outcome> {
        const ExportRequest request = requestFor(context.arguments, take);
        const auto summary = exportTake(request, job);
        return summary ? outcomeOf(request, *summary) : Result<Outcome>(summary.error());
    });
}

}  // namespace

Verb exportVerb() {
    Verb verb;
    verb.name = "export";
    verb.summary = "write a run as animation files";
    verb.operands = "T.noctule...";
    verb.min_operands = 1;
    verb.max_operands = kAnyNumber;
    verb.example = "noctule --batch export hops_001.noctule --fbx hops.fbx --preset blender";
    verb.options = {
        text("run", "NAME", "the run to write; the last one when not given"),
        text("bvh", "F", "animation with its skeleton; {name} in F stands for the take's name"),
        text("fbx", "F", "skeleton, motion and body as binary FBX 7.4"),
        text("glb", "F", "the same as binary glTF"),
        text("csv", "F", "world positions of all joints in metres"),
        text("mot", "F", "joint angles for OpenSim, in degrees"),
        text("sto", "F", "orientations of the segments for OpenSim's OpenSense"),
        flag("angles", "adds the named degrees of freedom to the CSV, in degrees"),
        choice("preset", {"blender", "motionbuilder", "unity", "unreal"},
               "who the files are for; motionbuilder is Maya too. Sets unit, names and frame rate"),
        number("fps", "N", 1, 1000, "frames per second; 120, or what the preset's program likes"),
        choice("mesh", {"mannequin", "none"}, "FBX and GLB: the default body, or the skeleton alone")
            .orElse("mannequin"),
        number("from", "S", 0, 86400, "first second of the take"),
        number("to", "S", 0, 86400, "last second of the take"),
        choice("root", {"moving", "in-place", "heading"},
               "as captured; over one spot; over one spot and always facing forward")
            .orElse("moving"),
        later("video", "F", "a rendered film"),
        later("png", "F", "a rendered picture"),
        later("size", "WxH", "of film and picture"),
        later("camera", "front|follow|turn", "of film and picture")};
    verb.remarks = {
        "Every file is written aside and read again before it gets its name. With several takes "
        "the paths must contain {name}."};
    verb.run = runExport;
    return verb;
}

}  // namespace noctule::batch
