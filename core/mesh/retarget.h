// SPDX-License-Identifier: Apache-2.0
// Our pose on any rig. Every mapped bone turns as our joint does, measured from a common pose: limbs point
// the same way in the world whatever the rest poses (T, A, elbows bent), trunk, head and feet turn from where
// they rest upright. Steps and heights are scaled by the length of the legs, and the lowest sole is as high
// above the ground as ours, so that feet neither sink nor float. Bones between mapped ones (twist, more
// vertebrae) keep their place relative to their parent.
#pragma once

#include <array>

#include "core/body/skeleton.h"
#include "core/mesh/bone_map.h"

namespace noctule {

class Retargeter {
public:
    /// `source` has canonical joint names (or aliases). kUnusable as checkBoneMap(), or when a main joint is
    /// missing in the source or legs have no length; `where` names the mesh.
    static Result<Retargeter> make(const RiggedMesh& target, const BoneMap& map, const Skeleton& source,
                                   const std::string& where);

    /// World transforms of the target's nodes; its soles' ground is y = 0.
    RigPose pose(const Pose& source) const;
    /// The same as what moves every node there from its rest pose: pose = motion * rest. Rigid, whatever the
    /// nodes' own transforms hold. What does not hang on the hips goes along with them.
    std::vector<Eigen::Isometry3d> motions(const Pose& source) const;

    /// Length of the target's legs over that of ours.
    double scale() const { return scale_; }
    /// From the target's world at rest to ours: upright and facing +Z. Identity where it stands so already.
    const Matrix3d& upright() const { return upright_; }

private:
    /// A node that one of our joints turns.
    struct Turned {
        int joint = -1;
        Matrix3d align = Matrix3d::Identity();  ///< from its rest to where it is in our zero pose; world
    };
    /// Two points of a sole, below the ankle and at the toes: in the target's rest pose, and in the frame of
    /// our foot.
    struct Sole {
        int node = 0, joint = 0;
        std::array<Vector3d, 2> p_rest, p_joint_m;
    };
    Retargeter() = default;
    std::vector<Eigen::Isometry3d> turned(const GlobalPose& source, const Vector3d& p_hips) const;

    Skeleton source_;
    std::vector<int> parents_;
    RigPose rest_;
    std::vector<Turned> turned_;  ///< per node; joint -1: keeps its place under its parent
    std::array<Sole, 2> soles_;
    int hips_ = 0;
    double scale_ = 1;
    Matrix3d upright_ = Matrix3d::Identity();
};

}  // namespace noctule
