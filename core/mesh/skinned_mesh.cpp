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

}  // namespace

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
