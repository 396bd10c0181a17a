// SPDX-License-Identifier: Apache-2.0
// What a robot needs of a performer in one frame: where both arms point and where the wrists are, in the
// axes of the chest (x to the left, y up, z forward), since arms that follow the head or the hips move when
// the legs do; and the same of both legs, in the axes of the hips. Works for any skeleton whose arms have
// names that are known (body/bone_names.h).
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include "core/motion/clip.h"

namespace noctule::robot {

enum class Side { kLeft = 0, kRight = 1 };

struct ArmPose {
    Vector3d upper = Vector3d::UnitX();    ///< unit, shoulder to elbow
    Vector3d forearm = Vector3d::UnitX();  ///< unit, elbow to wrist
    Vector3d wrist_m = Vector3d::Zero();   ///< from the shoulder
    /// Turn of each segment from the T pose (arms to the sides, palms down).
    Matrix3d R_upper = Matrix3d::Identity(), R_forearm = Matrix3d::Identity(), R_hand = Matrix3d::Identity();
};

/// Of the hips, with the legs below them.
struct LegsPose {
    /// As of an arm, but `wrist_m`, the ankle, from between the hips, and `R_hand`, the foot's turn.
    std::array<ArmPose, 2> in_hips;                ///< by Side
    Matrix3d R_world_hips = Matrix3d::Identity();  ///< columns: the hips' left, up and forward
    Vector3d p_world_hips_m = Vector3d::Zero();    ///< between both hips
};

struct PerformerFrame {
    std::array<ArmPose, 2> in_chest;  ///< by Side, in the axes of the chest
    std::array<ArmPose, 2> in_world;  ///< the same in the axes that the chest has in the T pose
    double heading_rad = 0;           ///< of the chest about the vertical, from where the T pose faces
    Matrix3d R_hips_chest = Matrix3d::Identity();  ///< turn of the chest from upright, in the hips' axes
    std::optional<LegsPose> legs{};                ///< absent: the skeleton has no two whole legs
};

class PerformerArms {
public:
    /// kUnusable names the bones that are missing or have no length.
    static Result<PerformerArms> make(const Skeleton& skeleton, const std::string& where);

    PerformerFrame at(const GlobalPose& pose) const;
    double armLength_m(Side side) const { return arm_length_m_[static_cast<size_t>(side)]; }
    /// Hip to knee to ankle, the mean of both; 0 without legs.
    double legLength_m() const { return leg_length_m_; }

    /// The largest standard deviation of a joint of either arm. `sigma_rad`: 3 per joint of the skeleton;
    /// empty or of another size: 0.
    double worstSigma_rad(const std::vector<double>& sigma_rad) const;
    /// The same of the joints between hips and chest.
    double trunkSigma_rad(const std::vector<double>& sigma_rad) const;

    /// Turn from the T pose to the reference posture: upper arm down, elbow at a right angle, forearm and
    /// palm's edge ahead.
    static Matrix3d referenceUpper(Side side);
    static Matrix3d referenceForearm(Side side);

private:
    struct ArmBones {
        int upper = -1, forearm = -1, hand = -1;
        /// From the T pose's axes to each segment's own frame.
        Matrix3d R_upper_t, R_forearm_t, R_hand_t;
    };
    void findLegs(const Skeleton& skeleton, const std::map<std::string, int>& bones);
    ArmPose armAt(const GlobalPose& pose, const ArmBones& bones, const Matrix3d& R_world_body) const;

    std::array<ArmBones, 2> arms_;
    std::optional<std::array<ArmBones, 2>> legs_;
    std::array<double, 2> arm_length_m_{};
    double leg_length_m_ = 0;
    int chest_ = -1, hips_ = -1;
    std::vector<int> spine_;                        ///< from the chest down, without the hips
    Matrix3d R_world_body_ = Matrix3d::Identity();  ///< of chest and hips in the zero pose
};

}  // namespace noctule::robot
