// SPDX-License-Identifier: Apache-2.0
// How far an estimated motion is from a reference (Vlasic 2007, table 1 and figures 6 and 7).
//
// Joints   the geodesic angle between the two local rotations of every joint that moves in both skeletons,
// the
//          root left out; common_joints.h says what is compared when the skeletons differ.
// Frames   two skeletons' axes and rest poses may differ: segment_match.h says what is taken off.
// Instants those of the estimate; the reference is interpolated to them and never across a longer hole.
// Root     the unknown start of yaw and position is taken off at the first compared frame; what remains is
//          drift. Yaw is about the vertical, tilt the angle between the two verticals.
// Courses  of all frames that were compared, on the estimate's clock.
// NEES     normalised estimation error squared per freedom: the mean over joints, components and time of
//          (component of the error's rotation vector / its sigma)^2, right perturbation, variances only. 1
//          when the sigmas are honest, more when the filter is too sure. Components without a sigma (an axis
//          the joint does not have) and composed joints are left out; all three components count for balls.
#pragma once

#include <array>
#include <limits>

#include "core/motion/course.h"
#include "core/motion/segment_match.h"
#include "core/motion/time_offset.h"

namespace noctule {

struct ComparisonOptions {
    int64_t from_ns = std::numeric_limits<int64_t>::min();  ///< on the estimate's clock; after the rest
    int64_t to_ns = std::numeric_limits<int64_t>::max();
    bool align_time = false;                     ///< find the clocks' shift, applied when it is trusted
    std::optional<int64_t> reference_offset_ns;  ///< a known shift instead
    /// Frames of the reference's segments are found (segment_match.h). Off: axes and zero pose as ours.
    bool match_segments = true;
    bool curves = true;  ///< of every compared joint, as in figure 6; 17 MB at most
};

/// Of an angle over time, in degrees.
struct AngleStatistics {
    double mean_deg = 0, std_deg = 0, rms_deg = 0, max_deg = 0;
    double drift_deg_per_min = 0;        ///< slope of the line through it
    double median_deg = 0, p95_deg = 0;  ///< half and 95 percent of the time it is below; to 0.01 degrees
};

struct JointComparison {
    std::string name;
    std::string relative_to;  ///< the joint whose frame the rotation is taken in
    bool composed = false;    ///< rotations of joints that only one skeleton moves are included
    AngleStatistics angle;
    double position_mm = 0;      ///< mean distance of the joint's two positions, in the root's frame
    std::optional<double> nees;  ///< of this joint
};

/// Figure 6 for one joint. Angles z, x, y of joint_angles.h, without jumps: they may leave +-180 degrees.
struct JointCurve {
    std::string name;
    std::array<Course, 3> estimate_deg, reference_deg;
    std::array<Course, 3> sigma_deg;  ///< empty when the estimate carries no sigma
    Course difference_deg;            ///< geodesic
};

/// Root mean squares of the drift, and its course.
struct RootComparison {
    double yaw_deg = 0, tilt_deg = 0, position_m = 0;
    double yaw_drift_deg_per_min = 0;                        ///< slope of the line through the yaw
    Course yaw_curve_deg, tilt_curve_deg, position_curve_m;  ///< yaw signed
};

/// Which joint of the reference was compared with which of ours.
struct MatchedJoint {
    std::string name, reference_name;
    bool moves = false;  ///< in both
    SegmentMatch segment;
};

struct Comparison {
    std::vector<MatchedJoint> matched;  ///< the root first, in the estimate's order
    std::vector<JointComparison> joints;
    double mean_deg = 0;  ///< mean of the joints' means
    std::optional<double>
        end_effector_mm;  ///< mean position error of those of hands, feet and head in common
    RootComparison root;
    std::optional<double> nees;  ///< absent without sigmas
    double duration_s = 0;       ///< from the first to the last compared frame
    int64_t frames = 0;          ///< compared
    int64_t estimate_missing = 0,
            reference_missing = 0;  ///< frames of each, in the window, that hold no pose
    int64_t unmatched = 0;          ///< frames of the estimate where the reference has none near enough
    TimeOffset offset;              ///< as applied; correlation 0 when none was looked for
    std::optional<TimeOffset> refused_offset;  ///< looked for, found and not trusted
    Course mean_curve_deg;                     ///< mean over joints of the angle
    std::vector<JointCurve> curves;            ///< in the order of `joints`

    const JointComparison* find(const std::string& name) const;
};

/// Fails (kUnusable) when the motions share no moving joint or no time, or do not fit their skeletons. Goes
/// through the estimate once; with `align_time` it is first read as a whole.
Result<Comparison> compareMotions(const PoseSource& estimate, const TimedMotion& reference,
                                  const ComparisonOptions& options = {});
Result<Comparison> compareMotions(const TimedMotion& estimate, const TimedMotion& reference,
                                  const ComparisonOptions& options = {});

}  // namespace noctule
