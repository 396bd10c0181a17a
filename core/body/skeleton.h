// SPDX-License-Identifier: Apache-2.0
// A tree of joints. Every joint carries the segment of the same name; its frame sits in the joint, and with
// all local rotations at identity all frames are parallel to the world (about a T pose). Lengths in metres,
// angles in radians. Parents come before children; joint 0 is the root.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/job/result.h"
#include "core/math/conventions.h"

namespace noctule {

enum class JointType {
    kFree,       ///< root only: any position and rotation
    kBall,       ///< any rotation
    kUniversal,  ///< exp(axis0 a0) * exp(axis1 a1)
    kHinge,      ///< exp(axis0 a0)
    kFixed,      ///< rigid with its parent
};

struct DegreeOfFreedom {
    std::string name;  ///< "flexion"
    Vector3d axis = Vector3d::UnitX();
    double min_rad = -3.1415926535897931;  ///< of a ball joint: of that component of the rotation vector
    double max_rad = 3.1415926535897931;
};

struct Joint {
    std::string name;  ///< canonical names: see canonicalJointNames()
    int parent = -1;
    Vector3d offset_m = Vector3d::Zero();  ///< in the parent's frame
    JointType type = JointType::kFixed;
    std::vector<DegreeOfFreedom> dof;            ///< ball 3, universal 2, hinge 1, free and fixed 0
    std::optional<Vector3d> end_m;               ///< tip of the segment, in the joint's frame
    std::map<std::string, std::string> aliases;  ///< "humanik", "mixamo" -> name there
};

/// A position of all joints: root in the world, everything else relative to its parent.
struct Pose {
    Vector3d p_world_root = Vector3d::Zero();
    std::vector<Quaterniond> q_parent_joint;  ///< per joint; of the root q_world_root
};

/// A checked tree of joints; immutable once made.
class Skeleton {
public:
    Skeleton() = default;

    /// Fails (kUnusable) when parents do not come first, names repeat, or freedoms do not fit the type.
    static Result<Skeleton> make(std::vector<Joint> joints);

    const std::vector<Joint>& joints() const { return joints_; }
    const Joint& joint(int index) const { return joints_[static_cast<size_t>(index)]; }
    int size() const { return static_cast<int>(joints_.size()); }
    /// Index of a joint by name, or -1.
    int find(const std::string& name) const;
    /// All local rotations identity, root at the origin.
    Pose zeroPose() const;

private:
    std::vector<Joint> joints_;
};

/// Position and orientation of every joint frame in the world.
struct GlobalPose {
    std::vector<Vector3d> p_world_joint;
    std::vector<Quaterniond> q_world_joint;
};
GlobalPose globalPose(const Skeleton& skeleton, const Pose& pose);

/// Nearest rotation that the joint can make, limits applied, and its angles (ball: rotation vector).
/// A free joint returns q itself; a fixed one identity.
struct JointAngles {
    Quaterniond q_parent_joint;
    Eigen::VectorXd angles_rad;
};
JointAngles projectOntoJoint(const Joint& joint, const Quaterniond& q_parent_joint, bool apply_limits);

/// Rotation of a joint from its angles (inverse of projectOntoJoint; free and fixed: identity).
Quaterniond rotationFromAngles(const Joint& joint, const Eigen::VectorXd& angles_rad);

}  // namespace noctule
