// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/rig/wearable.h"

#include <algorithm>

#include "core/mesh/import/mesh_reader.h"
#include "core/mesh/rig/other_skeletons.h"
#include "core/mesh/rig/rig_tree.h"
#include "core/mesh/surface_graph.h"

namespace noctule {
namespace {

Error noSkeleton(const std::string& where, const std::vector<std::string>& missing) {
    std::string names;
    for (const std::string& joint : missing)
        names += (names.empty() ? "" : ", ") + joint;
    const bool all = missing.size() == mainJoints().size();
    return {
        ErrorKind::kUnusable,
        where + (all ? ": no human skeleton is found in it" : ": no bones are found for " + names),
        "Name its bones as HumanIK, Mixamo, VRM or Rigify do, or say which bone is which in a map of bones"};
}

/// A body on whose limbs no skin hangs would be carried about like a statue: control bones were taken for
/// those that move the skin, or weights are missing.
Status checkLimbsMoveSkin(const WearableBody& body, const std::string& where) {
    const std::vector<bool> moves = movesSkin(body.mesh);
    for (const std::string side : {"Left", "Right"})
        for (const char* limb : {"UpLeg", "Leg", "Arm", "ForeArm"}) {
            const std::string& node = body.bones.node_of_joint.at(side + limb);
            if (!moves[static_cast<size_t>(body.mesh.find(node))])
                return Error{ErrorKind::kUnusable,
                             where + ": no part of its surface hangs on the bone " + node + " (" + side +
                                 limb + ") or below it",
                             "Give the skin weights, or say in a map of bones which bones move it"};
        }
    return Done{};
}

Result<WearableBody> withBones(RiggedMesh mesh, const std::string& where,
                               const std::optional<BoneMap>& chosen) {
    WearableBody body{where, std::move(mesh), {}};
    body.bones = chosen ? *chosen : findBoneMap(body.mesh);
    if (const auto missing = missingMainJoints(body.bones); !missing.empty())
        return noSkeleton(where, missing);
    if (const Status checked = checkBoneMap(body.bones, body.mesh, where); !checked)
        return checked.error();
    body.mesh = dressed(std::move(body.mesh), body.bones);
    if (const Status moving = checkLimbsMoveSkin(body, where); !moving)
        return moving.error();
    return body;
}

}  // namespace

RiggedMesh placedForRigging(const RiggedMesh& mesh) {
    std::vector<bool> keep;
    for (const MeshPart& part : mesh.parts)
        keep.push_back(!part.name.starts_with("helper-") && !part.name.starts_with("joint-"));
    if (std::find(keep.begin(), keep.end(), true) == keep.end())
        keep.assign(keep.size(), true);
    RiggedMesh placed = withParts(mesh, keep);
    Eigen::AlignedBox3f box;
    for (const SkinnedVertex& vertex : placed.skin.vertices)
        box.extend(vertex.p_m);
    if (box.isEmpty())
        return placed;
    const Eigen::Vector3f below(box.center().x(), box.min().y(), box.center().z());
    for (SkinnedVertex& vertex : placed.skin.vertices)
        vertex.p_m -= below;
    return placed;
}

Result<WearableBody> wearable(RiggedMesh mesh, const std::string& where, const WearingChoices& choices,
                              const JobContext& job) {
    if (mesh.isRigged())
        return withBones(std::move(mesh), where, choices.bones);
    const RiggedMesh placed = placedForRigging(mesh);
    const auto landmarks = choices.landmarks ? Result<Landmarks>(*choices.landmarks)
                                             : findLandmarks(welded(placed.skin).mesh, where);
    if (!landmarks)
        return landmarks.error();
    auto rigged = autoRigged(placed, *landmarks, where, {}, job);
    if (!rigged)
        return rigged.error();
    auto body = withBones(std::move(*rigged), where, std::nullopt);
    if (body)
        body->landmarks = *landmarks;
    return body;
}

Result<std::shared_ptr<const WearableBody>> readWearable(const std::string& path,
                                                         const WearingChoices& choices,
                                                         const JobContext& job) {
    job.progress(0, "Reading " + path);
    auto mesh = importMeshApart(path, {}, job);
    if (!mesh)
        return mesh.error();
    job.progress(0.5, mesh->isRigged() ? "Finding bones" : "Fitting a skeleton");
    auto body = wearable(std::move(*mesh), path, choices, {nullptr, job.cancel});
    if (!body)
        return body.error();
    return std::make_shared<const WearableBody>(std::move(*body));
}

}  // namespace noctule
