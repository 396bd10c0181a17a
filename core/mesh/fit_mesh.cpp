// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/fit_mesh.h"

#include <algorithm>
#include <cmath>

namespace noctule {
namespace {

/// Below this extent along an axis a segment says nothing about its length there.
constexpr double kLeastExtent_m = 0.03;

/// Height of the zero pose, from the lowest joint or tip to the highest.
double height_m(const Skeleton& skeleton) {
    const GlobalPose global = globalPose(skeleton, skeleton.zeroPose());
    double low = 0, high = 0;
    for (size_t j = 0; j < global.p_world_joint.size(); ++j) {
        const Joint& joint = skeleton.joint(static_cast<int>(j));
        for (const Vector3d& p :
             {global.p_world_joint[j],
              Vector3d(global.p_world_joint[j] + joint.end_m.value_or(Vector3d::Zero()))}) {
            low = std::min(low, p.y());
            high = std::max(high, p.y());
        }
    }
    return high - low;
}

/// Sum of the absolute offsets, axis by axis, from a joint to its children and its tip.
Vector3d extentOf(const Skeleton& skeleton, int joint) {
    Vector3d sum = skeleton.joint(joint).end_m.value_or(Vector3d::Zero()).cwiseAbs();
    for (const Joint& child : skeleton.joints())
        if (child.parent == joint)
            sum += child.offset_m.cwiseAbs();
    return sum;
}

Vector3d stretchOf(const Skeleton& from, int joint_from, const Skeleton& to, int joint_to, double overall) {
    const Vector3d before = extentOf(from, joint_from), after = extentOf(to, joint_to);
    Vector3d stretch = Vector3d::Constant(overall);
    for (int axis = 0; axis < 3; ++axis)
        if (before[axis] > kLeastExtent_m && after[axis] > kLeastExtent_m)
            stretch[axis] = after[axis] / before[axis];
    return stretch;
}

/// p -> target + stretch * (p - origin)
struct SegmentMap {
    Vector3d origin_m, target_m, stretch;
};

std::vector<SegmentMap> segmentMaps(const SkinnedMesh& mesh, const Skeleton& from, const Skeleton& to) {
    const double overall = height_m(to) / height_m(from);
    const GlobalPose before = globalPose(from, bindPose(from)), after = globalPose(to, bindPose(to));
    std::vector<SegmentMap> maps;
    for (const SkinBone& bone : mesh.bones) {
        const int b = nearestJoint(to, from.joint(nearestJoint(from, bone.joint)).name);
        const int a = nearestJoint(from, to.joint(b).name);
        maps.push_back({before.p_world_joint[static_cast<size_t>(a)],
                        after.p_world_joint[static_cast<size_t>(b)], stretchOf(from, a, to, b, overall)});
    }
    return maps;
}

void fit(SkinnedVertex& vertex, const std::vector<SegmentMap>& maps) {
    Vector3d place = Vector3d::Zero(), inverse_stretch = Vector3d::Zero();
    const Vector3d p_m = vertex.p_m.cast<double>();
    for (size_t i = 0; i < 4; ++i) {
        const SegmentMap& map = maps[vertex.bones[i]];
        place += vertex.weights[i] * (map.target_m + map.stretch.cwiseProduct(p_m - map.origin_m));
        inverse_stretch += vertex.weights[i] * map.stretch.cwiseInverse();
    }
    vertex.p_m = place.cast<float>();
    vertex.normal = vertex.normal.cast<double>().cwiseProduct(inverse_stretch).normalized().cast<float>();
}

}  // namespace

SkinnedMesh fitted(const SkinnedMesh& mesh, const Skeleton& from, const Skeleton& to) {
    const std::vector<SegmentMap> maps = segmentMaps(mesh, from, to);
    SkinnedMesh result = mesh;
    for (SkinnedVertex& vertex : result.vertices)
        fit(vertex, maps);
    for (size_t b = 0; b < result.bones.size(); ++b) {
        const SegmentMap& map = maps[b];
        const Vector3d joint_m =
            -(result.bones[b].bind_inverse.block<3, 1>(0, 3).cast<double>());  // frames are parallel
        const Vector3d moved_m = map.target_m + map.stretch.cwiseProduct(joint_m - map.origin_m);
        result.bones[b].bind_inverse.block<3, 1>(0, 3) = -moved_m.cast<float>();
    }
    return result;
}

}  // namespace noctule
