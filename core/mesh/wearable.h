// SPDX-License-Identifier: Apache-2.0
// Any figure made ready to wear our motion: what screens, exports and pictures do with a mesh that somebody
// opens.
//
//   auto mesh = importMeshApart(path);                          // mesh_reader.h
//   auto body = wearable(std::move(*mesh), path);               // bones found, or made
//   auto retargeter = Retargeter::make(body->mesh, body->bones, actor.skeleton, path);
//   auto matrices = skinMatrices(body->mesh, retargeter->pose(pose));
#pragma once

#include <optional>

#include "core/mesh/auto_rig.h"
#include "core/mesh/bone_map.h"

namespace noctule {

struct WearableBody {
    RiggedMesh mesh;
    BoneMap bones;
    std::optional<Landmarks> landmarks;  ///< when the rig was made here
};

/// What somebody set by hand; what is absent is found.
struct WearingChoices {
    std::optional<BoneMap> bones;        ///< of a rigged mesh
    std::optional<Landmarks> landmarks;  ///< of an unrigged one, in the mesh as placedForRigging() gives it
};

/// kUnusable as checkBoneMap(), findLandmarks() and heatWeights(); `where` names the file.
Result<WearableBody> wearable(RiggedMesh mesh, const std::string& where, const WearingChoices& choices = {},
                              const JobContext& job = {});

/// An unrigged figure with its soles on y = 0 above the origin, without the aids that MakeHuman's base mesh
/// carries (groups called "helper-..." and "joint-...").
RiggedMesh placedForRigging(const RiggedMesh& mesh);

}  // namespace noctule
