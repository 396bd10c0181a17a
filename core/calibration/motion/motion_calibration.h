// SPDX-License-Identifier: Apache-2.0
// Calibration from 15 to 60 s of movement that begins in the rest pose; beyond Vlasic 2007, whose rest pose
// (section 5.4) and body measures are its priors. Batch least squares over the trajectory of the whole body
// and, at the same time, each board's mounting, place and zeros, how it moves with the pose on its flesh, the
// sources' places and offsets, the bones' lengths and the speed of sound.
//
// Observable: how boards sit across a bone that swings, and the axes of hinges. Not observable in any
// movement, so left to the rest pose and reported with its sigma: turns that a joint's zero takes up (a
// forearm or a shin about its own bone, hands, feet and the head, which no further bone hangs on). Errors:
// kCancelled alone; a take that cannot be used is a report with reasons.
#pragma once

#include <string>
#include <vector>

#include "core/calibration/findings.h"
#include "core/calibration/motion/motion_settings.h"
#include "core/calibration/observations.h"
#include "core/job/job.h"

namespace noctule {

/// Root mean squares of what is left over of a board's readings.
struct LeftOver {
    double turn_rad = 0;        ///< of the gyroscope's turn in a step
    double force_m_per_s2 = 0;  ///< of the accelerometer
    double distance_m = 0;      ///< of distances to it
};

struct BoardInMotion {
    std::string id;
    bool measured = false;  ///< else none of the following holds, and applied() leaves the board as it was
    Quaterniond q_segment_board = Quaterniond::Identity();  ///< in the rest pose
    Vector3d sigma_turn_rad = Vector3d::Zero();             ///< of it, about the board's axes
    bool observed[3] = {};  ///< per axis: the movement showed it, not the rest pose and the suit alone
    double turned_rad = 0;  ///< from the calibration before
    Vector3d p_segment_board_m = Vector3d::Zero(), sigma_place_m = Vector3d::Zero();
    Vector3d gyro_zero_rad_per_s = Vector3d::Zero();    ///< beyond gyro_zero_counts
    Vector3d accel_zero_m_per_s2 = Vector3d::Zero();    ///< beyond the base's
    Vector3d gyro_zero_counts = Vector3d::Zero();       ///< of the rest pose
    std::optional<BoardFlesh> flesh{};                  ///< empty: not solved for
    double tissue_mean_rad = 0, tissue_spread_rad = 0;  ///< its tilt over the movement
    LeftOver before{}, after{};
};

struct SourceInMotion {
    std::string id;
    Vector3d p_segment_source_m = Vector3d::Zero(), sigma_place_m = Vector3d::Zero();
    double offset_m = 0, sigma_offset_m = 0;  ///< of every distance, beyond the base's
};

struct BoneInMotion {
    std::string joint;            ///< at the bone's lower end
    double scale = 1, sigma = 0;  ///< of the actor's offset
};

struct MotionReport {
    std::vector<Finding> findings;
    std::string detector;
    std::vector<BoardInMotion> boards;              ///< per board of the suit
    std::vector<SourceInMotion> sources;            ///< per source of the suit; empty without distances
    std::vector<BoneInMotion> bones;                ///< per joint but the root
    double sound_scale = 1, sigma_sound_scale = 0;  ///< factor on the speed of sound in force
    double c_m_per_s = 340;                         ///< that speed
    double moved_s = 0;                             ///< of all takes, without the rest
    int rests = 0;                                  ///< how often the rest pose was held
    int distances = 0, iterations = 0;
    bool converged = false;

    Grade grade() const { return gradeOf(findings); }
    bool fitted() const { return iterations > 0; }
    /// `base` with what was found; boards that were not measured stay as they are.
    Calibration applied(const Calibration& base, const Suit& suit) const;
    /// `actor` with the bones found.
    Actor applied(const Actor& actor) const;
};

/// Takes of one suit and one performer, none empty.
Result<MotionReport> calibrateMotion(const std::vector<Observations>& takes, const MotionSettings& settings,
                                     const JobContext& job);

}  // namespace noctule
