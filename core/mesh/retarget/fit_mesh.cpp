// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/retarget/fit_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/rotation.h"

namespace noctule {
namespace {

/// Below this extent along an axis a segment says nothing about its length there.
constexpr double kLeastExtent_m = 0.03;
/// A tip that is this many times nearer or farther than the body's size lets expect is none of the body's:
/// many skeletons end their hands at the knuckles.
constexpr double kMostTip = 1.6;

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

/// Sum of the absolute offsets, axis by axis of a frame in which the joint's own stands turned by `R`, from a
/// joint to its children and its tip.
Vector3d extentOf(const Skeleton& skeleton, int joint, const Matrix3d& R) {
    Vector3d sum = (R.transpose() * skeleton.joint(joint).end_m.value_or(Vector3d::Zero())).cwiseAbs();
    for (const Joint& child : skeleton.joints())
        if (child.parent == joint)
            sum += (R.transpose() * child.offset_m).cwiseAbs();
    return sum;
}

/// Which segments turn so that they point as the performer's do in the zero pose: to their one child.
constexpr std::array kPointing{"Arm", "ForeArm", "UpLeg", "Leg"};

Vector3d towardsChild(const Skeleton& skeleton, int joint) {
    for (const Joint& child : skeleton.joints())
        if (child.parent == joint)
            return child.offset_m;
    return Vector3d::Zero();
}

/// How segments of the body turn on their way to the performer's zero pose.
class SegmentTurns {
public:
    SegmentTurns(const Skeleton& from, const Skeleton& to, const FeetAtRest& feet)
        : from_(from), to_(to), feet_(feet) {}

    Matrix3d of(int joint_from, int joint_to) const {
        const std::string& name = from_.joint(joint_from).name;
        for (const std::string side : {"Left", "Right"}) {
            if (name == side + "Foot" || name == side + "ToeBase")
                return smallestRotation(Vector3d::UnitY(), feet_.up[side == "Left" ? 0 : 1])
                    .toRotationMatrix();
            for (const char* segment : kPointing)
                if (name == side + segment)
                    return pointing(towardsChild(from_, joint_from), towardsChild(to_, joint_to));
        }
        return Matrix3d::Identity();
    }

private:
    static Matrix3d pointing(const Vector3d& from, const Vector3d& to) {
        const bool are_known = from.norm() > kLeastExtent_m && to.norm() > kLeastExtent_m;
        return are_known ? smallestRotation(from, to).toRotationMatrix() : Matrix3d(Matrix3d::Identity());
    }

    const Skeleton& from_;
    const Skeleton& to_;
    const FeetAtRest& feet_;
};

/// p -> target + R stretch (p - origin)
struct SegmentMap {
    Vector3d origin_m, target_m, stretch;
    Matrix3d R;
};

Vector3d stretchOf(const Skeleton& from, int joint_from, const Skeleton& to, int joint_to, const Matrix3d& R,
                   double overall) {
    const Vector3d before = extentOf(from, joint_from, Matrix3d::Identity());
    const Vector3d after = extentOf(to, joint_to, R);
    const bool ends_in_tip = towardsChild(to, joint_to).isZero();
    Vector3d stretch = Vector3d::Constant(overall);
    for (int axis = 0; axis < 3; ++axis) {
        if (before[axis] <= kLeastExtent_m || after[axis] <= kLeastExtent_m)
            continue;
        const double ratio = after[axis] / before[axis];
        if (!ends_in_tip || std::abs(std::log(ratio / overall)) < std::log(kMostTip))
            stretch[axis] = ratio;
    }
    return stretch;
}

std::vector<SegmentMap> segmentMaps(const SkinnedMesh& mesh, const Skeleton& from, const Skeleton& to,
                                    const FeetAtRest& feet) {
    const double overall = height_m(to) / height_m(from);
    const GlobalPose before = globalPose(from, bindPose(from)), after = globalPose(to, bindPose(to));
    const SegmentTurns turns(from, to, feet);
    std::vector<SegmentMap> maps;
    for (const SkinBone& bone : mesh.bones) {
        const int b = nearestJoint(to, from.joint(nearestJoint(from, bone.joint)).name);
        const int a = nearestJoint(from, to.joint(b).name);
        const Matrix3d R = turns.of(a, b);
        maps.push_back({before.p_world_joint[static_cast<size_t>(a)],
                        after.p_world_joint[static_cast<size_t>(b)], stretchOf(from, a, to, b, R, overall),
                        R});
    }
    return maps;
}

void fit(SkinnedVertex& vertex, const std::vector<SegmentMap>& maps) {
    Vector3d place = Vector3d::Zero(), normal = Vector3d::Zero();
    const Vector3d p_m = vertex.p_m.cast<double>(), normal_before = vertex.normal.cast<double>();
    for (size_t i = 0; i < 4; ++i) {
        const SegmentMap& map = maps[vertex.bones[i]];
        place += vertex.weights[i] * (map.target_m + map.R * map.stretch.cwiseProduct(p_m - map.origin_m));
        normal += vertex.weights[i] * (map.R * normal_before.cwiseQuotient(map.stretch));
    }
    vertex.p_m = place.cast<float>();
    vertex.normal = normal.normalized().cast<float>();
}

}  // namespace

SkinnedMesh fitted(const SkinnedMesh& mesh, const Skeleton& from, const Skeleton& to,
                   const FeetAtRest& feet) {
    const std::vector<SegmentMap> maps = segmentMaps(mesh, from, to, feet);
    SkinnedMesh result = mesh;
    for (SkinnedVertex& vertex : result.vertices)
        fit(vertex, maps);
    for (size_t b = 0; b < result.bones.size(); ++b) {
        const SegmentMap& map = maps[b];
        const Vector3d joint_m =
            -(result.bones[b].bind_inverse.block<3, 1>(0, 3).cast<double>());  // frames are parallel
        const Vector3d moved_m = map.target_m + map.R * map.stretch.cwiseProduct(joint_m - map.origin_m);
        result.bones[b].bind_inverse.block<3, 1>(0, 3) = -moved_m.cast<float>();
    }
    return result;
}

}  // namespace noctule
