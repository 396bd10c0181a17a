// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <cmath>

#include "app/batch/files.h"
#include "app/batch/motion_file.h"
#include "app/batch/verb.h"
#include "core/formats/positions_csv.h"
#include "core/import/markers.h"
#include "core/processing/attach_reference.h"
#include "core/processing/survey_room.h"
#include "devices/machine/clock.h"

namespace noctule::batch {
namespace {

/// "auto" or milliseconds.
Result<std::optional<double>> shiftSeconds(const std::string& text) {
    if (text == "auto")
        return std::optional<double>();
    double ms = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), ms);
    const bool whole_text = error == std::errc() && end == text.data() + text.size();
    if (!whole_text || !(std::abs(ms) <= 86400e3))
        return Error{ErrorKind::kUsage, "--align cannot be '" + text + "'",
                     "Give auto, or milliseconds within a day"};
    return std::optional(ms / 1000);
}

/// Options of motions with what is none.
Status refuseOptions(const VerbContext& context, std::initializer_list<const char*> options,
                     const std::string& what_it_is) {
    for (const char* option : options)
        if (context.arguments.given(option))
            return Error{ErrorKind::kUsage, "--" + std::string(option) + " is for motions, and " + what_it_is,
                         "Leave it out"};
    return Done{};
}

Status readMarkerSource(const VerbContext& context, AttachRequest& request) {
    const auto markers = readMarkers(request.source_name, context.job());
    if (!markers)
        return markers.error();
    nlohmann::json map = nlohmann::json::object();
    if (context.arguments.given("markers")) {
        auto given = readJson(context.arguments.text("markers"));
        if (!given)
            return given.error();
        map = std::move(*given);
    }
    if (Status fits = refuseOptions(context, {"height", "bones"}, request.source_name + " holds markers");
        !fits)
        return fits;
    const std::string up = context.arguments.text("up");
    auto table = jointsOfMarkers(*markers, map,
                                 up == "auto" ? ""
                                 : up == "y"  ? "Y"
                                              : "Z",
                                 request.source_name);
    if (!table)
        return table.error();
    for (const std::string& warning : table->warnings)
        context.console.warn(warning);
    request.positions = std::move(*table);
    return Done{};
}

Status readSource(const VerbContext& context, AttachRequest& request, nlohmann::json& understood) {
    request.source_name = context.arguments.text("reference");
    if (isPositionsFile(request.source_name)) {
        if (Status fits = refuseOptions(context, {"up", "height", "bones"},
                                        request.source_name + " is a table of positions");
            !fits)
            return fits;
        auto table = readPositionsCsv(request.source_name, &context.cancel);
        if (!table)
            return table.error();
        for (const std::string& warning : table->warnings)
            context.console.warn(warning);
        request.positions = std::move(*table);
        return Done{};
    }
    if (isMarkerFile(request.source_name))
        return readMarkerSource(context, request);
    auto motion = readReference(request.source_name, context.arguments, context.console, understood);
    if (!motion)
        return motion.error();
    request.motion = std::move(*motion);
    return Done{};
}

std::string attachedText(const AttachSummary& summary, const std::string& as) {
    char text[240];
    std::snprintf(text, sizeof text, ": %lld rows attached as %s, starting %.1f ms into the take",
                  static_cast<long long>(summary.rows), as.c_str(), 1000 * summary.shift_s);
    std::string line = text;
    if (summary.shift_sigma_s) {
        std::snprintf(text, sizeof text, " (+-%.1f ms, correlation %.2f)", 1000 * *summary.shift_sigma_s,
                      summary.correlation.value_or(0));
        line += text;
    }
    line += ".\n";
    std::string renamed;
    for (const auto& [joint, theirs] : summary.matched)
        if (joint != theirs)
            renamed += (renamed.empty() ? "" : ", ") + joint + " = " + theirs;
    if (!renamed.empty())
        line += "joints matched        " + renamed + "\n";
    return line;
}

/// The places of a room's anchors, as surveyed.
Result<Outcome> attachRoom(const VerbContext& context) {
    const Arguments& arguments = context.arguments;
    const std::string take_path = arguments.operands()[0], path = arguments.text("room");
    const auto room = readSuit(path);
    if (!room)
        return room.error();
    std::vector<std::string> warnings;
    if (Status placed = placeAnchors(take_path, *room, utcNow(), warnings); !placed)
        return placed.error();
    for (const std::string& warning : warnings)
        context.console.warn(warning);
    Outcome outcome;
    outcome.json = {{"take", take_path}, {"room", path}, {"warnings", warnings}};
    outcome.text = take_path + ": the places of " + path + " are in force.\n";
    return outcome;
}

Result<Outcome> runAttach(const VerbContext& context) {
    const Arguments& arguments = context.arguments;
    if (arguments.given("room") == arguments.given("reference"))
        return Error{ErrorKind::kUsage, "attach needs one of --reference and --room",
                     "Give the recording of another system, or the file of a surveyed room"};
    if (arguments.given("room"))
        return attachRoom(context);
    AttachRequest request;
    request.take_path = arguments.operands()[0];
    request.as = arguments.text("as") == "external-root" ? AttachAs::kExternalRoot : AttachAs::kReference;
    request.overwrite = arguments.given("overwrite");
    const auto shift_s = shiftSeconds(arguments.text("align"));
    if (!shift_s)
        return shift_s.error();
    request.shift_s = *shift_s;
    nlohmann::json understood;
    if (Status read = readSource(context, request, understood); !read)
        return read.error();
    const auto summary = attachReference(request, context.job());
    if (!summary)
        return summary.error();
    for (const std::string& warning : summary->warnings)
        context.console.warn(warning);
    nlohmann::json matched = nlohmann::json::object();
    for (const auto& [joint, theirs] : summary->matched)
        matched[joint] = theirs;
    Outcome outcome;
    outcome.json = {{"take", request.take_path},
                    {"as", arguments.text("as")},
                    {"rows", summary->rows},
                    {"rows_outside", summary->rows_outside},
                    {"shift_ms", summary->shift_s * 1000},
                    {"shift_sigma_ms", summary->shift_sigma_s ? nlohmann::json(*summary->shift_sigma_s * 1000)
                                                              : nlohmann::json(nullptr)},
                    {"matched", std::move(matched)},
                    {"correlation",
                     summary->correlation ? nlohmann::json(*summary->correlation) : nlohmann::json(nullptr)},
                    {"aligned_with", summary->aligned_with.empty() ? nlohmann::json(nullptr)
                                                                   : nlohmann::json(summary->aligned_with)}};
    outcome.json["motion"] = std::move(understood);
    outcome.text = request.take_path + attachedText(*summary, arguments.text("as"));
    return outcome;
}

}  // namespace

Verb attachVerb() {
    Verb verb;
    verb.name = "attach";
    verb.summary = "put another system's recording of the same performance, or a surveyed room, into a take";
    verb.operands = "T.noctule";
    verb.min_operands = verb.max_operands = 1;
    verb.example = "noctule --batch attach hops_001.noctule --reference optical.bvh --align auto";
    verb.options = {
        inputFile("reference", "M.bvh|M.fbx|M.glb|P.csv|M.c3d|M.trc",
                  "the recording; CSV: time_s or time_ms, and JOINT.x, .y, .z in metres"),
        inputFile("room", "ROOM.json", "instead: places of the room's anchors, as calibrate room found them"),
        inputFile("markers", "MAP.json",
                  "C3D, TRC: which markers surround which joint, {\"Hips\": [\"LASI\", ...]}"),
        text("align", "auto|MILLISECONDS",
             "time of the take at which the file's time 0 is; auto: found from the last result's motion")
            .orElse("auto"),
        choice("as", {"reference", "external-root"},
               "what evaluate compares with, or the root that process --root given reads")
            .orElse("reference")};
    for (Option& option : motionOptions("reference"))
        verb.options.push_back(std::move(option));
    verb.remarks = {
        "Positions (CSV, markers) do not say how limbs are twisted: they serve as external-root, from the "
        "joints that sit on the hips, with --align MILLISECONDS.",
        "With auto, a motion that repeats itself is refused, since several shifts fit."};
    verb.run = runAttach;
    return verb;
}

}  // namespace noctule::batch
