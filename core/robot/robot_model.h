// SPDX-License-Identifier: Apache-2.0
// A robot as its URDF file describes it: a tree of links joined by joints. Metres, radians; frames are those
// of the file (REP 103: x forward, y left, z up in the root link).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/math/conventions.h"

namespace noctule::robot {

enum class JointKind { kFixed, kRevolute, kContinuous, kPrismatic };

/// Assumed where a file states no usable limit; the reader says so for each joint.
inline constexpr double kAssumedRange_rad = 3.1415926535897931;  ///< to both sides of 0
inline constexpr double kAssumedRange_m = 0.1;
inline constexpr double kAssumedSpeed_rad_per_s = 1.0;  ///< prismatic: m/s
/// A stated speed beyond this is no limit (Robonaut 2 states 1000).
inline constexpr double kHighestSpeed_rad_per_s = 100;

/// The joint follows another one: q = factor * q_other + offset.
struct Mimic {
    int joint = -1;
    double factor = 1, offset = 0;
};

struct RobotJoint {
    std::string name;
    JointKind kind = JointKind::kFixed;
    int parent_link = -1, child_link = -1;
    Eigen::Isometry3d T_parent_joint = Eigen::Isometry3d::Identity();
    Vector3d axis = Vector3d::UnitZ();           ///< unit, in the joint's frame
    double lower = 0, upper = 0;                 ///< rad or m; of a continuous joint -inf and inf
    double max_speed = kAssumedSpeed_rad_per_s;  ///< rad/s or m/s
    std::optional<Mimic> mimic;

    bool moves() const { return kind != JointKind::kFixed; }
};

/// A primitive of the collision shape as a capsule; a sphere has both ends in one place.
struct LinkShape {
    Vector3d a_m = Vector3d::Zero(), b_m = Vector3d::Zero();  ///< in the link's frame
    double radius_m = 0;
};

/// A mesh that shows the link.
struct LinkMesh {
    std::string file;  ///< as the URDF names it: package://, file:// or a path
    Eigen::Isometry3d T_link_mesh = Eigen::Isometry3d::Identity();
    Vector3d scale = Vector3d::Ones();
};

struct RobotLink {
    std::string name;
    int parent_joint = -1;             ///< -1: the root
    std::vector<int> child_joints;     ///< in the order of names
    std::vector<LinkShape> shapes;     ///< of spheres, cylinders and boxes
    std::vector<LinkMesh> meshes;      ///< not read: see robot_film/robot_mesh.h
    std::optional<Vector3d> centre_m;  ///< of mass
};

struct RobotModel {
    std::string name;
    std::vector<RobotLink> links;      ///< parents first; link 0 is the root
    std::vector<RobotJoint> joints;    ///< parents first
    std::vector<std::string> notices;  ///< what was assumed, one sentence each

    int findLink(const std::string& link) const;    ///< -1: none
    int findJoint(const std::string& joint) const;  ///< -1: none
    /// Joints from the root down to the link.
    std::vector<int> jointsAbove(int link) const;
};

/// Place of a link in another one with all joints at 0 (mimic joints at their offset).
Eigen::Isometry3d placeAtZero(const RobotModel& model, int from_link, int to_link);

}  // namespace noctule::robot
