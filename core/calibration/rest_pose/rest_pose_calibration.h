// SPDX-License-Identifier: Apache-2.0
// Calibration from a performer who stands still in the rest pose (Vlasic 2007, section 5.4: gravity aligns
// the pose and the boards, readings integrate to zero; with distances, which expose what is in the wrong
// place). Gives per board its orientation on its segment, the gyroscope's zeros and the accelerometer's error
// along the vertical. Not observable, so left as the suit file says and reported with the sigma of the prior:
// a board's turn about the vertical, the accelerometer's error across the vertical (it shows as a tilt, which
// is then wrong by that angle) and how a tilt divides between joint and strap beyond what the priors tell.
// Errors: kCancelled alone; a take that cannot be used is a report with reasons.
#pragma once

#include <string>
#include <vector>

#include "core/calibration/findings.h"
#include "core/calibration/observations.h"
#include "core/job/job.h"

namespace noctule {

/// Sigmas are priors per axis; larger ones let the data move things farther.
struct RestPoseSettings {
    double sigma_pose_rad = radians(5);         ///< each freedom of each joint
    double sigma_board_turn_rad = radians(10);  ///< straps
    double sigma_board_shift_m = 0.01, sigma_source_shift_m = 0.005;
    double sigma_distance_m = 0.005;                   ///< echoes, bones, the air; of a pulse heard well
    double askew_rad = radians(20), shifted_m = 0.04;  ///< boards beyond are named
    double unknown_rad = radians(20);  ///< a mounting with a larger sigma is as good as unknown
};

struct BoardAtRest {
    std::string id;
    bool measured = false;  ///< else none of the following holds, and applied() leaves the board as it was
    Quaterniond q_segment_board = Quaterniond::Identity();
    double tilt_from_suit_rad = 0;       ///< by which it leans otherwise than the suit file says
    double sigma_tilt_rad = 0;           ///< of up in the world, as the chain of pose and board gives it
    double sigma_mounting_tilt_rad = 0;  ///< of q_segment_board, with the pose's uncertainty
    double sigma_turn_rad = 0;           ///< about the vertical: that of the prior
    Vector3d gyro_zero_counts = Vector3d::Zero(), sigma_gyro_zero_counts = Vector3d::Zero();
    double accel_above_g_m_per_s2 = 0;              ///< |mean a| - g: its error along the vertical
    Vector3d accel_zero_counts = Vector3d::Zero();  ///< with which |mean a| = g; else unchanged
    Vector3d shift_m = Vector3d::Zero();  ///< in the segment's frame, as distances suggest; not applied
};

struct JointAtRest {
    std::string joint;
    Vector3d deviation_rad = Vector3d::Zero();  ///< rotation vector from the rest pose asked for
    double sigma_rad = 0;                       ///< largest of its freedoms
};

/// Two boards worn, or plugged in, the one as the other. Indices of the suit.
struct SwappedBoards {
    int first = 0, second = 0;
    bool plugs = false;          ///< readings came with the other's calibration: exchanged at the box
    double likelihood_gain = 0;  ///< of -2 log likelihood against the suit's description
};

struct RestPoseReport {
    std::vector<Finding> findings;
    Stretch stretch;           ///< that was used
    bool rest_marked = false;  ///< the take says where the rest pose is; else the longest stillness was taken
    std::vector<BoardAtRest> boards;  ///< per board of the suit
    std::vector<JointAtRest> joints;  ///< per joint that can turn
    Pose pose;
    std::vector<SwappedBoards> swapped;  ///< surest first
    std::vector<SwappedBoards> untold;   ///< pairs that are as likely exchanged as not: nothing shows it
    std::vector<SwappedBoards> rivals;   ///< other exchanges that would explain the first of `swapped`
    int sources = 0;                     ///< of the suit
    int distances = 0;                   ///< pairs that took part
    double distance_rms_m = 0;           ///< of what the fit leaves over, weighted, without echoes
    int iterations = 0;
    bool converged = false;
    double cost = 0;

    Grade grade() const { return gradeOf(findings); }
    /// `base` with the orientations and zeros found; boards that were not measured stay as they are.
    Calibration applied(const Calibration& base, const Suit& suit) const;
};

Result<RestPoseReport> calibrateRestPose(const Observations& take, const RestPoseSettings& settings,
                                         const JobContext& job);

}  // namespace noctule
