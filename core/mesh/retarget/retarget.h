// SPDX-License-Identifier: Apache-2.0
// Our pose on any rig. Every mapped bone turns as our joint does, measured from a common pose: limbs point
// the same way in the world whatever the rest poses (T, A, elbows bent), trunk, head and feet turn from where
// they rest upright. Steps and heights are scaled by the length of the legs, and the lowest sole is as high
// above the ground as ours, so that feet neither sink nor float. Soles are flat when ours are
// (feet_at_rest.h), and where a longer foot would go through the floor, toes and foot give way. Bones between
// mapped ones (twist, more vertebrae) keep their place relative to their parent.
#pragma once

#include <array>
#include <cstdint>

#include "core/body/skeleton.h"
#include "core/mesh/retarget/feet_at_rest.h"
#include "core/mesh/rig/bone_map.h"

namespace noctule {

/// One leg of the target in a pose, and where our own sole is; the target's world and metres, ours in ours.
struct LegPlaces {
    Vector3d hip, knee, ankle;
    Vector3d knee_axis;                       ///< of our knee; the shin bends about it
    std::array<Vector3d, 2> sole, sole_ours;  ///< below the ankle and at the toes

    /// By how much the knee has to turn so that the leg reaches from its hip to the ankle moved by `shift`;
    /// as near as a stretched leg comes.
    double kneeTurn(const Vector3d& shift) const;
};

/// What a leg does on top of a pose, so that its foot gets elsewhere; see foot_lock.h.
struct FootCorrection {
    Vector3d p_root = Vector3d::Zero();  ///< way of the ankle in the frame of our root, the target's metres
    double knee_rad = 0;                 ///< turn of the shin about our knee's axis
};
using FootCorrections = std::array<FootCorrection, 2>;  ///< left, right

class Retargeter {
public:
    /// `source` has canonical joint names (or aliases). kUnusable as checkBoneMap(), or when a main joint is
    /// missing in the source or legs have no length; `where` names the mesh.
    static Result<Retargeter> make(const RiggedMesh& target, const BoneMap& map, const Skeleton& source,
                                   const FeetAtRest& feet, const std::string& where);

    /// World transforms of the target's nodes; its soles' ground is y = 0.
    RigPose pose(const Pose& source, const FootCorrections& feet = {}) const;
    /// The same as what moves every node there from its rest pose: pose = motion * rest. Rigid, whatever the
    /// nodes' own transforms hold. What does not hang on the hips goes along with them; another body in the
    /// file (nodesOfOtherBodies()) stands.
    std::vector<Eigen::Isometry3d> motions(const Pose& source, const FootCorrections& feet = {}) const;
    /// Left and right; feet as in motions().
    std::array<LegPlaces, 2> legs(const Pose& source, const FootCorrections& feet = {}) const;

    /// Length of the target's legs over that of ours.
    double scale() const { return scale_; }
    /// From the target's world at rest to ours: upright and facing +Z. Identity where it stands so already.
    const Matrix3d& upright() const { return upright_; }
    /// Whether a node of the target belongs to another body.
    bool stands(int node) const { return stands_[static_cast<size_t>(node)]; }

private:
    /// A node that one of our joints turns.
    struct Turned {
        int joint = -1;
        Matrix3d align = Matrix3d::Identity();  ///< from its rest to where it is in our zero pose; world
    };
    /// Nodes of the target and joints of ours; two points of the sole, below the ankle and at the toes: in
    /// the target's rest pose, and in the frame of our foot.
    struct Leg {
        int thigh = 0, shin = 0, foot = 0, toes = -1, shin_joint = 0, foot_joint = 0;
        std::array<Vector3d, 2> p_rest, p_joint_m;
        std::vector<Vector3d> foot_skin, toes_skin;  ///< in the target's rest pose; lowestSkin()
    };
    /// What of a leg moves a node.
    enum class LegPart : uint8_t { kNone, kThigh, kShin, kFoot, kToes };
    Retargeter() = default;
    std::vector<Eigen::Isometry3d> turned(const GlobalPose& source, const Vector3d& p_hips) const;
    std::vector<Eigen::Isometry3d> onGround(const GlobalPose& source) const;
    LegPlaces placesOf(const Leg& leg, const GlobalPose& source,
                       const std::vector<Eigen::Isometry3d>& motions) const;
    void bend(size_t side, const LegPlaces& places, const Vector3d& shift, double knee_rad,
              std::vector<Eigen::Isometry3d>& motions) const;
    std::vector<LegPart> partsOf(const Leg& leg) const;
    void putOnFloor(size_t side, double flat, double floor, std::vector<Eigen::Isometry3d>& motions) const;

    Skeleton source_;
    std::vector<int> parents_;
    RigPose rest_;
    std::vector<Turned> turned_;  ///< per node; joint -1: keeps its place under its parent
    std::array<Leg, 2> legs_;
    std::array<std::vector<LegPart>, 2> leg_parts_;  ///< per leg and node
    std::vector<bool> stands_;                       ///< per node
    double ground_ = 0;                              ///< height of what the target stands on, upright
    int hips_ = 0;
    double scale_ = 1;
    Matrix3d upright_ = Matrix3d::Identity();
};

}  // namespace noctule
