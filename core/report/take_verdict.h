// SPDX-License-Identifier: Apache-2.0
// Whether a processed take can be used, and why not, as data that the report (verdict.h) and the screens
// word. With a reference the error decides, without one what the angles rested on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/job/grade.h"
#include "core/report/report_data.h"

namespace noctule {

/// The limits of the grades, with their reasons. With a reference the error is known and decides; what the
/// angles rested on then only explains. Lost frames and holes count either way. Simulated takes of the
/// nominal scenario have errors of 0.1 to 0.5 degrees, 72 to 82 % backed, residuals of 4 to 15 mm.
struct VerdictLimits {
    /// Mean joint error against a reference: an animator sees more than about 3 degrees; the paper's complete
    /// system had 5.7 to 8.0 and was a success.
    double good_mean_deg = 3, usable_mean_deg = 8;
    /// A single joint beyond this is seen at once.
    double good_joint_deg = 8;
    /// Share of joints and time constrained by a range not longer than three rounds ago; the rest drifts with
    /// its gyroscopes, 1 to 3 degrees a minute. Shins and feet are always low: few microphones hear them.
    double good_backed = 0.5, usable_backed = 0.2;
    /// Share of a joint's time in which neither ranges nor inertia told anything.
    double good_alone = 0.02, usable_alone = 0.2;
    /// Range residuals: 3 mm is the detector's noise, 15 mm what sound around the body and parts a little out
    /// of place add; more is a source gone astray or a lost pose.
    double good_residual_m = 0.02, usable_residual_m = 0.05;
    /// Frames that a board lost: gyroscopes bridge single frames, not the loss of every fifth.
    double good_lost = 0.02, usable_lost = 0.2;
    /// Share of the distances that cannot be (below 0, beyond earshot) or that the filter threw out. Beyond a
    /// half the poses rest on what is left by chance.
    double good_refused = 0.5;
    /// One hole without any signal: a second of prediction is off by tens of degrees.
    double good_hole_s = 0.25, usable_hole_s = 1;
};

enum class VerdictReason {
    kNone,
    kMeanError,      ///< against the reference
    kJointError,     ///< of the worst joint
    kSupport,        ///< too little of the worst joint's time was backed by ranges
    kResidual,       ///< ranges do not fit the poses
    kDistances,      ///< most distances cannot be, or were thrown out
    kBoardLost,      ///< a board lost frames
    kHole,           ///< a hole without signal
    kNoPoses,        ///< the run shows nothing
    kEndsInRest,     ///< the recording ended before the rest pose did; stands for all that follows from it
    kPeopleApart,    ///< nothing measured where several performers stand to each other
    kNotCalibrated,  ///< what the run was made with lacks values; stands for all that follows from it
    kNoGyroscopes,   ///< the run used none: its angles are guesses; stands for all that follows from it
};

/// Of a joint that moves, in the order of the skeleton.
struct VerdictJoint {
    std::string joint;
    std::optional<double> mean_deg, worst_deg;  ///< against the reference
    double backed_by_ranges = 0;                ///< share of time, 0..1
    double backed_by_inertia = 0;               ///< of the rest
    Grade grade = Grade::kGood;                 ///< a low one need not lower that of the take
};

struct VerdictBoard {
    int board = 0;  ///< index into the suit
    double lost_share = 0;
    std::optional<double> joined_s{}, left_s{};  ///< take's clock, where that is most of the loss
};

/// A source or a board whose ranges miss the pose, though those of the others do not.
struct VerdictPart {
    bool is_source = false;
    int index = 0;        ///< into the suit
    double median_m = 0;  ///< of the sizes of its residuals
};

struct TakeVerdict {
    Grade grade = Grade::kGood;
    /// What lowered the grade, worst first; empty when nothing did. The screens word the first one or two.
    std::vector<VerdictReason> reasons;

    /// By error with a reference, else the one that ranges stopped backing; empty: none stands out.
    std::string worst_joint;
    /// The joint that no sensor told for most of the time, where that lowered the grade; empty: none.
    std::string alone_joint;
    double alone_share = 0;                  ///< of the time
    bool alone_by_design = false;            ///< it has no sensor and keeps its usual pose
    std::optional<double> worst_from_s;      ///< from when on it was less certain, where that can be told
    std::vector<VerdictBoard> lossy_boards;  ///< that lost more than is good, worst first
    bool lost_together = false;              ///< all boards and about as much: the link to their box did
    CalibrationLack lack;                    ///< of what the run was made with
    std::string sensors;                     ///< that the run used: A, G, D

    std::optional<double> mean_error_deg;     ///< over joints, against the reference
    double compared_share = 1;                ///< of the take after its rest: covered by the reference, 0..1
    double backed_share = 0;                  ///< of joints and time: backed by ranges
    std::optional<double> residual_rms_m;     ///< of used ranges; a few echoes make it large
    std::optional<double> residual_median_m;  ///< of their sizes
    /// Two of three stay within it: the standard deviation of normal errors, and echoes do not move it. The
    /// filter trusts pairs that are always late little, so that they say nothing of the pose.
    std::optional<double> residual_spread_m;
    std::optional<VerdictPart> astray;            ///< with kResidual: where one part's ranges alone miss
    double refused_share = 0;                     ///< of the distances: they cannot be
    double hole_s = 0, longest_hole_s = 0;        ///< without signal, of all boards
    std::optional<double> yaw_drift_deg_per_min;  ///< against the reference
    std::vector<VerdictJoint> joints;
};

TakeVerdict judgeTake(const ReportData& report, const VerdictLimits& limits = {});

}  // namespace noctule
