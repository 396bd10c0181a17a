// SPDX-License-Identifier: Apache-2.0
#include "app/batch/motion_file.h"

#include "app/batch/files.h"
#include "app/batch/signals.h"
#include "core/formats/motion_document.h"
#include "core/mesh/rig/bone_map.h"

namespace noctule::batch {
namespace {

void sayUnderstood(const figure::UnderstoodMotion& motion, Console& console) {
    console.tell(figure::describe(motion));
    for (const std::string& note : motion.notes)
        console.tell(motion.clip.name + ": " + note);
    for (const std::string& warning : motion.warnings)
        console.warn(motion.clip.name + ": " + warning);
}

Result<BvhDocument> readDocumentOf(const std::string& path, Console& console) {
    auto document = readMotionDocument(path, {nullptr, &signalFlag()});
    if (document)
        for (const BvhWarning& warning : document->warnings)
            console.warn(path + ": " + toText(warning));
    return document;
}

}  // namespace

std::vector<Option> motionOptions(const std::string& whose) {
    return {bvhUnitOption(),
            choice("up", {"y", "z", "auto"},
                   "axis of the " + whose + "'s file that points up; auto: as the body stands")
                .orElse("auto"),
            number("height", "M", 0.3, 3, "height of the " + whose + "'s person; goes before the unit"),
            inputFile("bones", "MAP.json",
                      "which joint of the " + whose + " is which of ours, where names do not say it")};
}

Status checkMotionOptions(const Arguments& arguments, const std::string& whose) {
    for (const char* name : {"up", "height", "bones"})
        if (arguments.given(name) && !arguments.given(whose))
            return Error{ErrorKind::kUsage,
                         "--" + std::string(name) + " speaks of a " + whose + ", and none is given",
                         "Give --" + whose + " M.bvh too, or leave it out"};
    return Done{};
}

Result<figure::MotionHints> motionHints(const Arguments& arguments) {
    figure::MotionHints hints;
    const auto unit = bvhUnitFromText(arguments.text("bvh-unit"));
    if (!unit)
        return unit.error();
    hints.unit = *unit;
    const auto up = figure::upAxisFromText(arguments.text("up"));
    if (!up)
        return up.error();
    hints.up = *up;
    hints.height_m = arguments.number("height").value_or(0);
    if (arguments.given("bones")) {
        const auto bones = readBoneMap(arguments.text("bones"));
        if (!bones)
            return bones.error();
        hints.joints = bones->node_of_joint;
    }
    return hints;
}

Result<figure::UnderstoodMotion> readUnderstood(const std::string& path, const Arguments& arguments,
                                                Console& console) {
    const auto hints = motionHints(arguments);
    if (!hints)
        return hints.error();
    auto document = readDocumentOf(path, console);
    if (!document)
        return document.error();
    auto motion = figure::understandMotion(std::move(*document), *hints);
    if (motion)
        sayUnderstood(*motion, console);
    return motion;
}

Result<OutsideMotion> readReference(const std::string& path, const Arguments& arguments, Console& console,
                                    nlohmann::json& understood) {
    const auto hints = motionHints(arguments);
    if (!hints)
        return hints.error();
    const auto document = readDocumentOf(path, console);
    if (!document)
        return document.error();
    auto motion = figure::understandMotion(*document, *hints);
    if (motion) {
        sayUnderstood(*motion, console);
        understood = figure::toJson(*motion);
        return OutsideMotion(std::move(*motion));
    }
    std::vector<std::string> warnings;
    auto as_it_is = partialMotion(*document, *hints, motion.error(), warnings);
    for (const std::string& warning : warnings)
        console.warn(warning);
    return as_it_is;
}

}  // namespace noctule::batch
