// SPDX-License-Identifier: Apache-2.0
// How the mannequin's skin hangs on its joints: at every joint a soft boundary (one or two planes) parts what
// moves with the joint from what stays with its parent.
#pragma once

#include <array>

#include "core/body/skeleton.h"
#include "core/mesh/skinned_mesh.h"

namespace noctule {

struct BoneWeights {
    std::array<uint16_t, 4> bones{};  ///< joints of the skeleton, heaviest first
    std::array<float, 4> weights{};   ///< sum 1
};

/// For a place on the skin of the default actor in its zero pose; `global` is that pose.
BoneWeights mannequinWeights(const Skeleton& skeleton, const GlobalPose& global, const Vector3d& p_m);

}  // namespace noctule
