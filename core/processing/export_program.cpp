// SPDX-License-Identifier: Apache-2.0
#include "core/processing/export_program.h"

#include <algorithm>

namespace noctule {

/// - Blender works in metres: a file in metres arrives with scale 1 on its armature, named after the top
/// node.
/// - MotionBuilder and Maya recognise HumanIK's names under a node called Reference, in centimetres.
/// - Unity turns centimetres into metres by the file's scale and finds a humanoid by our own names.
/// - Unreal makes the node above the hips its topmost bone and wants that to be called root; its retargeter
///   knows HumanIK's names.
const std::vector<ExportProgram>& exportPrograms() {
    static const std::vector<ExportProgram> programs{
        {"blender", 1, 60, JointNames::kOwn, "Armature"},
        {"motionbuilder", 0.01, 120, JointNames::kHumanIk, "Reference"},
        {"unity", 0.01, 60, JointNames::kOwn, "Root"},
        {"unreal", 0.01, 60, JointNames::kHumanIk, "root"}};
    return programs;
}

ExportProgram exportProgram(const std::string& key) {
    const auto& programs = exportPrograms();
    const auto found = std::find_if(programs.begin(), programs.end(),
                                    [&](const ExportProgram& program) { return program.key == key; });
    return found == programs.end() ? ExportProgram{} : *found;
}

}  // namespace noctule
