// SPDX-License-Identifier: Apache-2.0
// Drives one chain (an arm, a trunk) live: clutch and reindexing (Miller 2004, section 6), synchronisation
// that is accepted and blended in, dead man's key, watchdog, workspace box, speed scale, stop. Called once
// per command, at equal steps; every command is the last one plus at most speed * dt, whatever comes in.
#pragma once

#include <optional>

#include "core/robot/profile.h"
#include "core/robot/step_limiter.h"
#include "core/robot/teleoperation_states.h"

namespace noctule::robot {

struct TeleopSettings {
    double dt_s = 1.0 / 140;                       ///< between commands
    double scale = 1;                              ///< of the hand's way; larger: the robot moves farther
    double speed_scale = 1;                        ///< 0..1, of all joints' speed limits
    Matrix3d R_base_world = Matrix3d::Identity();  ///< from the performer's world to the robot's base
    Vector3d box_min_m = Vector3d::Constant(-10), box_max_m = Vector3d::Constant(10);  ///< of the tip
    double stale_s = 0.1;           ///< without a fresh pose for so long the arm brakes
    double least_confidence = 0.5;  ///< below, the arm moves at a quarter of its speed
    double farthest_rad = 0.35;     ///< a joint farther off than this is not accepted
    double blend_s = 1;
};

/// A pose of the performer's hand, and the joint values that it asks for where posture is followed.
struct TeleopPose {
    int64_t time_ns = 0;  ///< on the clock of step()
    Vector3d p_world_hand = Vector3d::Zero();
    Quaterniond q_world_hand = Quaterniond::Identity();
    double confidence = 1;               ///< 0..1
    std::optional<JointVector> posture;  ///< absent: the hand is followed relative to where it engaged
};

struct TeleopKeys {
    bool dead_man = false, clutch = false;             ///< held
    bool accept = false, stop = false, reset = false;  ///< pressed since the last step
    double speed_scale = 1;                            ///< 0..1, times that of the settings
};

struct TeleopCommand {
    JointVector q;
    TeleopState state = TeleopState::kIdle;
    JointVector ghost;            ///< what the performer asks for; the command where that is not known
    double farthest_rad = 0;      ///< of ghost and command
    int farthest_joint = 0;       ///< of the chain
    bool is_slowed = false;       ///< the pose is uncertain
    bool is_outside_box = false;  ///< the ghost's tip was moved to the border of the box
};

class Teleoperator {
public:
    /// `max_speed` per joint, rad/s; `q`: where the robot stands. Other limits are the profile's.
    Teleoperator(const Chain& chain, const std::vector<double>& max_speed, const RobotProfile& profile,
                 const TeleopSettings& settings, const JointVector& q);

    /// `pose`: the newest one, also when it is the same as before.
    TeleopCommand step(int64_t now_ns, const std::optional<TeleopPose>& pose, const TeleopKeys& keys);
    TeleopState state() const { return state_; }

    /// Where the joints go, within their limits, while nobody drives; none: they stay.
    void setRetreat(const std::optional<JointVector>& q) { retreat_ = q; }
    const std::vector<JointMotion>& motion() const { return motion_; }
    /// Takes the last step back and brakes instead.
    void brakeFrom(const std::vector<JointMotion>& before);

private:
    struct Index {
        Vector3d p_world_hand, p_base_tip;
        Matrix3d R_world_hand, R_base_tip;
    };
    void take(TeleopEvent event);
    void handleKeys(const TeleopKeys& keys);
    void watch(int64_t now_ns, const std::optional<TeleopPose>& pose);
    void index(const TeleopPose& pose);
    JointVector askedFor(const TeleopPose& pose, bool& is_outside_box) const;
    JointVector tipAt(const Matrix3d& R_base_tip, const Vector3d& p_base_tip, const JointVector& from) const;
    JointVector places() const;
    void move(const JointVector* wish, double speed_scale, const JointVector* last_wish = nullptr);
    void follow(const JointVector& ghost, double speed_scale);

    Chain chain_;
    std::vector<double> speeds_;
    double acceleration_, jerk_;
    TeleopSettings settings_;
    TeleopState state_ = TeleopState::kIdle;
    std::vector<JointMotion> motion_;
    std::optional<Index> index_;
    std::optional<JointVector> retreat_, last_ghost_;
    JointVector blend_from_;
    double blended_s_ = 0;
    bool has_pose_ = false;
};

}  // namespace noctule::robot
