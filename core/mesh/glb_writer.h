// SPDX-License-Identifier: Apache-2.0
// A skinned mesh as binary glTF 2.0: one mesh with its skin, joints as nodes under it, in the bind pose.
#pragma once

#include <string>

#include "core/job/result.h"
#include "core/mesh/skinned_mesh.h"

namespace noctule {

/// kUsage when the file exists and may not be replaced, kDisk when it cannot be written. `skeleton` gives the
/// joints' tree; its zero pose is the mesh's bind pose.
Status writeSkinnedMesh(const std::string& path, const SkinnedMesh& mesh, const Skeleton& skeleton,
                        bool overwrite);

}  // namespace noctule
