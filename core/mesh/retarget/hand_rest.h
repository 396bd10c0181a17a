// SPDX-License-Identifier: Apache-2.0
// How a rig's hand rests, seen from where its fingers end. World of the mesh.
#pragma once

#include "core/mesh/rigged_mesh.h"

namespace noctule {

struct HandRest {
    Vector3d along =
        Vector3d::Zero();  ///< from the wrist to the fingers; zero when there are fewer than three
    Vector3d thumb =
        Vector3d::Zero();  ///< from the wrist to the end of the thumb; zero when none stands apart
};

/// `forearm` points from elbow to wrist: what leaves it most is the thumb.
HandRest handAtRest(const RiggedMesh& mesh, int hand, const Vector3d& forearm);

}  // namespace noctule
