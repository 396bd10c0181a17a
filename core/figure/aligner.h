// SPDX-License-Identifier: Apache-2.0
// The work behind alignFigure(): trunk first, then limbs outwards.
#pragma once

#include <optional>

#include "core/figure/alignment.h"

namespace noctule::figure {

class Aligner {
public:
    Aligner(const MotionClip& clip, const SeenMotion& seen, const JointMapping& mapping,
            const Skeleton& target);
    Alignment align();

private:
    // trunk_alignment.cpp
    bool trunkStands() const;
    bool zeroIsSymmetric() const;
    double zeroBend() const;
    void alignStandingTrunk();
    void alignTrunkByBones();
    void alignHead();
    void alignShoulder(const std::string& side);
    void setAxes(const std::string& joint, const Vector3d& left, const Vector3d& up);
    std::pair<int, int> trunkBone(bool upper) const;

    // limb_alignment.cpp
    void alignLimb(const std::string& side, const std::string& upper, const std::string& lower,
                   const std::string& end, const std::string& parent);
    Quaterniond untwisted(const std::string& upper, const Vector3d& bone, const Vector3d& wanted,
                          const std::string& parent) const;
    double bendTwist(const std::string& upper, const std::string& lower, const std::string& end) const;
    double hingeTwist(const std::string& upper, const std::string& lower, const std::string& end) const;
    void alignHand(const std::string& side);

    // foot_alignment.cpp
    void alignFoot(const std::string& side);
    bool zeroFootStands(const std::string& side, double stance_rad, double spread_rad) const;
    std::optional<std::pair<double, double>> stanceSlope(int foot, int toe) const;
    double slopeBelowAnkle(const std::string& side, const Vector3d& left, const Vector3d& ahead,
                           const std::optional<std::pair<double, double>>& stance) const;

    bool has(const std::string& joint) const { return mapping_.contains(joint); }
    int at(const std::string& joint) const { return mapping_.at(joint); }
    Vector3d zero(const std::string& joint) const { return zero_[static_cast<size_t>(at(joint))]; }
    Vector3d place(const GlobalPose& pose, const std::string& joint) const {
        return pose.p_world_joint[static_cast<size_t>(at(joint))];
    }
    Quaterniond canonical(const GlobalPose& pose, const std::string& joint) const {
        return pose.q_world_joint[static_cast<size_t>(at(joint))] * q_.at(joint);
    }
    /// In the frame of joint `from`.
    Vector3d bone(const std::string& from, const std::string& to) const {
        return seen_.between(at(from), at(from), at(to));
    }
    /// Mean of a world direction, in the frame of a joint.
    Vector3d meanIn(const std::string& joint,
                    const std::function<Vector3d(const GlobalPose&)>& direction) const;
    /// Chest, or the hips where there is no chest.
    std::string chest() const { return has("Chest") ? "Chest" : "Hips"; }

    const MotionClip& clip_;
    const SeenMotion& seen_;
    const JointMapping& mapping_;
    const Skeleton& target_;
    std::vector<Vector3d> zero_;  ///< positions in the zero pose
    Quaterniond q_zero_body_;     ///< axes of the zero pose's trunk
    bool trunk_stands_ = false;
    std::map<std::string, Quaterniond> q_;
};

/// Programs lay their frames along bones or along the world: a direction near an axis of its frame is meant
/// to be that axis.
Vector3d snapped(const Vector3d& direction, double within_rad);
double angleOf(const Vector3d& a, const Vector3d& b);

}  // namespace noctule::figure
