// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <set>

#include "app/batch/files.h"
#include "app/batch/takes.h"
#include "app/batch/verb.h"
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

ExportRequest requestFor(const Arguments& arguments, const std::string& take_path) {
    ExportRequest request;
    request.take_path = take_path;
    request.run = arguments.text("run");
    request.frames_per_second = *arguments.number("fps");
    request.from_s = arguments.number("from");
    request.to_s = arguments.number("to");
    request.root = rootMotion(arguments.text("root"));
    request.bvh_path = pathFor(arguments.text("bvh"), take_path);
    request.metres_per_unit = arguments.text("preset") == "blender" ? 1 : 0.01;
    request.csv_path = pathFor(arguments.text("csv"), take_path);
    request.angles = arguments.given("angles");
    request.overwrite = arguments.given("overwrite");
    return request;
}

Status checkRequests(const Arguments& arguments, const std::vector<ExportRequest>& requests) {
    if (!arguments.given("bvh") && !arguments.given("csv"))
        return Error{ErrorKind::kUsage, "export has nothing to write", "Give --bvh F, --csv F or both"};
    if (arguments.given("angles") && !arguments.given("csv"))
        return Error{ErrorKind::kUsage, "--angles adds columns to a CSV file, and none is written",
                     "Give --csv F too"};
    if (arguments.given("from") && arguments.given("to") &&
        *arguments.number("from") > *arguments.number("to"))
        return Error{ErrorKind::kUsage, "--from lies after --to", "Give --from S before --to S"};
    std::set<std::string> paths;
    for (const ExportRequest& request : requests)
        for (const std::string& path : {request.bvh_path, request.csv_path}) {
            if (!path.empty() && !paths.insert(std::filesystem::path(path).lexically_normal()).second)
                return Error{ErrorKind::kUsage, "two outputs would be " + path,
                             requests.size() > 1 ? "Write {name} into the path; it stands for the take's name"
                                                 : "Give different paths"};
            if (Status free = checkOutputs({path}, request.overwrite); !free)
                return free;
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
    verb.example = "noctule --batch export hops_001.noctule --bvh hops.bvh --preset blender";
    verb.options = {
        text("run", "NAME", "the run to write; the last one when not given"),
        text("bvh", "F", "animation with its skeleton; {name} in F stands for the take's name"),
        text("csv", "F", "world positions of all joints in metres"),
        flag("angles", "adds the named degrees of freedom to the CSV, in degrees"),
        choice("preset", {"motionbuilder", "blender"}, "BVH in centimetres (Maya too) or in metres")
            .orElse("motionbuilder")
            .laterOn({"unity", "unreal"}),
        number("fps", "N", 1, 1000, "frames per second").orElse("120"),
        number("from", "S", 0, 86400, "first second of the take"),
        number("to", "S", 0, 86400, "last second of the take"),
        choice("root", {"moving", "in-place", "heading"},
               "as captured; over one spot; over one spot and always facing forward")
            .orElse("moving"),
        later("fbx", "F", "FBX"),
        later("glb", "F", "binary glTF"),
        later("mot", "F", "OpenSim joint angles"),
        later("sto", "F", "OpenSim orientations"),
        later("video", "F", "a rendered film"),
        later("png", "F", "a rendered picture"),
        later("mesh", "M", "the body to put on the skeleton"),
        later("size", "WxH", "of film and picture"),
        later("camera", "front|follow|turn", "of film and picture")};
    verb.remarks = {
        "Every file is written aside and read again before it gets its name. With several takes "
        "the paths must contain {name}."};
    verb.run = runExport;
    return verb;
}

}  // namespace noctule::batch
