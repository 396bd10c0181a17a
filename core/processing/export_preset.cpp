// SPDX-License-Identifier: Apache-2.0
#include "core/processing/export_preset.h"

#include <algorithm>

namespace noctule {

/// - Blender works in metres: a file in metres arrives with scale 1 on its armature, named after the top
/// node.
/// - MotionBuilder and Maya recognise HumanIK's names under a node called Reference, in centimetres.
/// - Unity turns centimetres into metres by the file's scale and finds a humanoid by our own names.
/// - Unreal takes root motion from the topmost bone, which it wants to be called root; its retargeter knows
///   HumanIK's names.
const std::vector<ExportPreset>& exportPresets() {
    static const std::vector<ExportPreset> presets{
        {"blender", 1, 60, JointNames::kOwn, "Armature", false},
        {"motionbuilder", 0.01, 120, JointNames::kHumanIk, "Reference", false},
        {"unity", 0.01, 60, JointNames::kOwn, "Root", false},
        {"unreal", 0.01, 60, JointNames::kHumanIk, "root", true}};
    return presets;
}

ExportPreset exportPreset(const std::string& key) {
    const auto& presets = exportPresets();
    const auto found = std::find_if(presets.begin(), presets.end(),
                                    [&](const ExportPreset& preset) { return preset.key == key; });
    return found == presets.end() ? ExportPreset{} : *found;
}

}  // namespace noctule
