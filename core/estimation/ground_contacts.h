// SPDX-License-Identifier: Apache-2.0
// The feet on the ground, as a filter knows them: when each stands (StanceDetector, or as an operator has set
// it), and what that says of the body: the point of contact has no velocity (zero-velocity update, ZUPT;
// Foxlin, "Pedestrian tracking with shoe-mounted inertial sensors", IEEE Computer Graphics and Applications
// 25, 2005) and on level ground the height it had in the rest pose. Nothing else on the suit tells where a
// free root goes. Feet roll and slip by some centimetres a second all the same: only the root's translation
// is observed, with what is not known of the body as noise, for in joints a tenth of a degree counts.
//
// Feet are the segments LeftFoot and RightFoot as far as they carry boards; on a suit without boards there,
// the segments with boards that reach lowest in the rest pose, as far as they are legs: well below the root.
// The point of contact is the ball of the foot: where the first joint below stands (the toes), else the
// segment's end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/estimation/covariance.h"
#include "core/estimation/stance_detector.h"
#include "core/motion/foot_contacts.h"

namespace noctule {

/// What feet stand on. kLevel: one floor, as high as in the rest pose. kUneven: steps, slopes, boxes.
/// kTreadmill: it moves; contacts are found and hold nothing. kNone: no contacts at all.
enum class Ground { kLevel, kUneven, kTreadmill, kNone };

/// "level", "uneven", "treadmill", "none": as on the command line and in takes.
const char* groundName(Ground ground);
std::optional<Ground> groundFromName(const std::string& name);

struct GroundParameters {
    Ground ground = Ground::kLevel;
    bool holds_feet = true;  ///< false: contacts are only noted, as when another system knows the root
    StanceParameters stance;
    std::optional<std::vector<FootContacts>> given;  ///< instead of those found

    double interval_s = 1.0 / 35;  ///< of updates
    double velocity_m_per_s = 0.07,
           pivot_m = 0.05;  ///< feet roll and shoes give; pivot: times the foot's rate
    double height_m = 0.05;
    /// A slip stays for a while, and so do the errors of the leg above: updates so close to each other share
    /// them, and each counts as one of white noise with the same effect on their mean. Larger: the root is
    /// less sure of its place along the floor.
    double slip_lasts_s = 0.1;
    /// By how much the place of the sole under the root changes from one update to the next: how high a root
    /// stands is never known better than that adds up to.
    double sole_m = 0.014;
    /// How level floors and soles are, of people and in recordings. A root whose height is known better
    /// (anchors of a room) is not held by the floor.
    double level_m = 0.01;
    double huber_sigma = 2.5;
    /// Farther from the floor, beyond height_gate_sigma of where the body may be, it stands on something
    /// else: a stair is 0.17 m.
    double height_gate_m = 0.08, height_gate_sigma = 3;
    /// A foot that the filter sees move faster, by swing_sigma of what it knows, is swung evenly.
    double fastest_m_per_s = 0.7, swing_sigma = 5;
};

/// Contacts as they are noted; a flight that is too short joins two.
class ContactLog {
public:
    void note(const std::string& foot, double from_s, double to_s);
    const std::vector<FootContacts>& feet() const { return feet_; }

private:
    std::vector<FootContacts> feet_;
};

class GroundContacts {
public:
    GroundContacts() = default;
    /// Links of `suit` are those of `tree`, whose joints are the actor's. `rest`: the body as it stands on
    /// the floor.
    GroundContacts(const Skeleton& actor, const KinematicTree& tree, const SuitModel& suit,
                   const MotionState& rest, const GroundParameters& parameters);

    /// The feet have stood during the rest pose, which ends now.
    void rest(double begin_s, double end_s, ContactLog& log);
    /// Readings of all boards, in order of time for each.
    void listen(const std::vector<InertialMeasurement>& measurements, const BodyState& state);
    /// What the feet that stand now tell; notes them in `log`. Widens the height of the root in `P`.
    std::vector<ObservationBlock> observe(const KinematicTree& tree, const StateLayout& layout,
                                          const BodyState& state, Covariance& P, double now_s,
                                          ContactLog& log);

private:
    struct Foot {
        std::string name;
        std::vector<FootContact> given;
        int board = 0, link = 0;
        Vector3d p_link_contact_m;
        StanceDetector detector;
        double floor_m = 0;        ///< height of the point in the rest pose
        double observed_s = -1e9;  ///< last update
        bool swings = false;       ///< evenly, as the filter saw it then
        double swung_s = -1e9;     ///< when that was last
    };
    std::optional<double> standsSince_s(const Foot& foot, double now_s) const;
    std::optional<ObservationBlock> onFloor(const Foot& foot, double height_m, double body_variance_m2,
                                            int column, Covariance& P) const;

    GroundParameters parameters_;
    std::vector<Foot> feet_;
};

}  // namespace noctule
