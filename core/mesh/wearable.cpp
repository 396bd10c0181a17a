// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/wearable.h"

#include <algorithm>

#include "core/mesh/surface_graph.h"

namespace noctule {
namespace {

Result<WearableBody> withBones(RiggedMesh mesh, const std::string& where,
                               const std::optional<BoneMap>& chosen) {
    WearableBody body{std::move(mesh), {}, {}};
    body.bones = chosen ? *chosen : findBoneMap(body.mesh);
    if (const Status checked = checkBoneMap(body.bones, body.mesh, where); !checked)
        return checked.error();
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

}  // namespace noctule
