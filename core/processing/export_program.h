// SPDX-License-Identifier: Apache-2.0
// What the programs that motions travel to expect of a file: unit, frame rate, names, and what stands above
// the hips. Y is up and the body faces +Z everywhere; every one of them turns FBX and glTF by itself.
#pragma once

#include <string>
#include <vector>

#include "core/formats/figure.h"

namespace noctule {

struct ExportProgram {
    std::string key;                 ///< "motionbuilder"; empty: made for nobody in particular
    double metres_per_unit = 0.01;   ///< of BVH and FBX
    double frames_per_second = 120;  ///< unless asked for another
    JointNames names = JointNames::kOwn;
    std::string root_name = "Reference";  ///< FBX: the node above the hips
};

/// blender, motionbuilder (Maya too), unity, unreal.
const std::vector<ExportProgram>& exportPrograms();
/// The one of that key; what nobody is named for gets when there is none.
ExportProgram exportProgram(const std::string& key);

}  // namespace noctule
