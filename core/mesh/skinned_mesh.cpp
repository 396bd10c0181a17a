// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/skinned_mesh.h"

#include <algorithm>

#include "core/body/actor.h"

namespace noctule {
namespace {

double lowestPoint_m(const Skeleton& skeleton) {
    const GlobalPose global = globalPose(skeleton, skeleton.zeroPose());
    double lowest_m = 0;
    for (int j = 0; j < skeleton.size(); ++j) {
        const double y_m = global.p_world_joint[static_cast<size_t>(j)].y();
        const double tip_m = skeleton.joint(j).end_m ? skeleton.joint(j).end_m->y() : 0;
        lowest_m = std::min({lowest_m, y_m, y_m + tip_m});
    }
    return lowest_m;
}

/// The parent by canonical name; empty for the root and for names that are not canonical.
std::string canonicalParent(const std::string& joint) {
    static const Skeleton canonical = defaultActor().skeleton;
    const int index = canonical.find(joint);
    return index > 0 ? canonical.joint(canonical.joint(index).parent).name : std::string();
}

Eigen::Matrix4f matrixOf(const Vector3d& p_m, const Quaterniond& q) {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.topLeftCorner<3, 3>() = q.toRotationMatrix();
    matrix.topRightCorner<3, 1>() = p_m;
    return matrix.cast<float>();
}

Eigen::Matrix4f translation(const Vector3d& p_m) {
    return matrixOf(p_m, Quaterniond::Identity());
}

/// As many triangles of each part as are kept; parts that keep none go.
std::vector<SurfacePart> onlySurface(const std::vector<SurfacePart>& surface, const std::vector<bool>& keep) {
    std::vector<SurfacePart> kept;
    uint32_t first = 0;
    for (const SurfacePart& part : surface) {
        const auto begin = keep.begin() + part.first_triangle;
        const auto count = static_cast<uint32_t>(std::count(begin, begin + part.triangles, true));
        if (count > 0)
            kept.push_back({first, count, part.look});
        first += count;
    }
    return kept;
}

}  // namespace

std::vector<SurfacePart> surfaceParts(const SkinnedMesh& mesh) {
    if (mesh.surface.empty())
        return {{0, static_cast<uint32_t>(mesh.triangles.size())}};
    return mesh.surface;
}

std::vector<std::shared_ptr<const SurfaceTexture>> texturesOf(const std::vector<SurfacePart>& surface) {
    std::vector<std::shared_ptr<const SurfaceTexture>> textures;
    for (const SurfacePart& part : surface)
        if (part.look && part.look->texture && !textureIndex(part, textures))
            textures.push_back(part.look->texture);
    return textures;
}

std::optional<size_t> textureIndex(const SurfacePart& part,
                                   const std::vector<std::shared_ptr<const SurfaceTexture>>& textures) {
    if (!part.look || !part.look->texture)
        return std::nullopt;
    const auto found = std::find(textures.begin(), textures.end(), part.look->texture);
    return found == textures.end() ? std::nullopt
                                   : std::optional(static_cast<size_t>(found - textures.begin()));
}

SkinnedMesh onlyTriangles(const SkinnedMesh& mesh, const std::vector<bool>& keep) {
    require(keep.size() == mesh.triangles.size(), "onlyTriangles() needs a word for each triangle");
    SkinnedMesh kept{{}, {}, mesh.bones, onlySurface(mesh.surface, keep)};
    constexpr uint32_t kGone = UINT32_MAX;
    std::vector<uint32_t> moved(mesh.vertices.size(), kGone);
    for (size_t t = 0; t < keep.size(); ++t) {
        if (!keep[t])
            continue;
        std::array<uint32_t, 3> corners = mesh.triangles[t];
        for (uint32_t& corner : corners) {
            if (moved[corner] == kGone) {
                moved[corner] = static_cast<uint32_t>(kept.vertices.size());
                kept.vertices.push_back(mesh.vertices[corner]);
            }
            corner = moved[corner];
        }
        kept.triangles.push_back(corners);
    }
    return kept;
}

Pose bindPose(const Skeleton& skeleton) {
    Pose pose = skeleton.zeroPose();
    pose.p_world_root.y() = -lowestPoint_m(skeleton);
    return pose;
}

std::vector<SkinBone> bonesOf(const Skeleton& skeleton) {
    const GlobalPose bind = globalPose(skeleton, bindPose(skeleton));
    std::vector<SkinBone> bones;
    for (int j = 0; j < skeleton.size(); ++j)
        bones.push_back({skeleton.joint(j).name, translation(-bind.p_world_joint[static_cast<size_t>(j)])});
    return bones;
}

int nearestJoint(const Skeleton& skeleton, const std::string& joint) {
    for (std::string name = joint; !name.empty(); name = canonicalParent(name))
        if (const int index = skeleton.find(name); index >= 0)
            return index;
    return 0;
}

std::vector<Eigen::Matrix4f> skinMatrices(const SkinnedMesh& mesh, const Skeleton& skeleton,
                                          const GlobalPose& pose) {
    std::vector<Eigen::Matrix4f> matrices;
    for (const SkinBone& bone : mesh.bones) {
        const int joint = nearestJoint(skeleton, bone.joint);
        const std::string& name = skeleton.joint(joint).name;
        const auto bound = std::find_if(mesh.bones.begin(), mesh.bones.end(),
                                        [&](const SkinBone& b) { return b.joint == name; });
        const size_t j = static_cast<size_t>(joint);
        matrices.push_back(matrixOf(pose.p_world_joint[j], pose.q_world_joint[j]) *
                           (bound != mesh.bones.end() ? bound->bind_inverse : bone.bind_inverse));
    }
    return matrices;
}

}  // namespace noctule
