// SPDX-License-Identifier: Apache-2.0
// Any figure made ready to wear our motion: what screens, exports and pictures do with a mesh that somebody
// opens.
//
//   auto body = readWearable(path);                         // read apart; bones found, or made
//   auto moving = MovingBody::of(*body, actor.skeleton);    // moving_body.h
//   auto matrices = moving->skinMatrices(pose);
#pragma once

#include <memory>
#include <optional>

#include "core/mesh/rig/auto_rig.h"
#include "core/mesh/rig/bone_map.h"

namespace noctule {

struct WearableBody {
    std::string name;  ///< of its file, as errors call it
    RiggedMesh mesh;
    BoneMap bones;
    std::optional<Landmarks> landmarks{};  ///< when the rig was made here
};

/// What somebody set by hand; what is absent is found.
struct WearingChoices {
    std::optional<BoneMap> bones;        ///< of a rigged mesh
    std::optional<Landmarks> landmarks;  ///< of an unrigged one, in the mesh as placedForRigging() gives it

    bool operator==(const WearingChoices&) const = default;
};

/// kUnusable: no human skeleton is found (the message says which joints have no bone), and as checkBoneMap(),
/// findLandmarks() and heatWeights(); `where` names the file.
Result<WearableBody> wearable(RiggedMesh mesh, const std::string& where, const WearingChoices& choices = {},
                              const JobContext& job = {});

/// From a file (importMeshApart(), whose errors are passed on) to a body that can be worn.
Result<std::shared_ptr<const WearableBody>> readWearable(const std::string& path,
                                                         const WearingChoices& choices = {},
                                                         const JobContext& job = {});

/// An unrigged figure with its soles on y = 0 above the origin, without the aids that MakeHuman's base mesh
/// carries (groups called "helper-..." and "joint-...").
RiggedMesh placedForRigging(const RiggedMesh& mesh);

}  // namespace noctule
