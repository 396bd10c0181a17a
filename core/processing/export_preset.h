// SPDX-License-Identifier: Apache-2.0
// What the programs that motions travel to expect of a file: unit, frame rate, names, and what stands above
// the hips. Y is up and the body faces +Z everywhere; every one of them turns FBX and glTF by itself.
#pragma once

#include <string>
#include <vector>

#include "core/formats/figure.h"

namespace noctule {

struct ExportPreset {
    std::string key;                 ///< "motionbuilder"; empty: made for nobody in particular
    double metres_per_unit = 0.01;   ///< of BVH and FBX
    double frames_per_second = 120;  ///< unless asked for another
    JointNames names = JointNames::kOwn;
    std::string root_name = "Reference";  ///< FBX: what stands above the hips
    bool root_is_bone = false;            ///< FBX: a bone, for programs that move a character by it
};

/// blender, motionbuilder (Maya too), unity, unreal.
const std::vector<ExportPreset>& exportPresets();
/// The one of that key; what nobody is named for gets when there is none.
ExportPreset exportPreset(const std::string& key);

}  // namespace noctule
