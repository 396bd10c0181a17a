// SPDX-License-Identifier: Apache-2.0
// Where one point is, from a window of ranges to known places and from what its wearer's bones allow. Sources
// on a chest lie nearly in a plane, so that ranges to them fit a mirror image as well; sound that goes round
// a body comes late. A filter that linearises about one place meets neither.
#pragma once

#include <deque>
#include <vector>

#include "core/cooperative/free_points.h"

namespace noctule::cooperative {

struct LostPointSettings {
    double lost_m = 0.12;        ///< standard deviation along the worst axis from which a point is lost
    double found_m = 0.08;       ///< and up to which a fit counts as certain
    double well_known_m = 0.04;  ///< up to which a place is remembered
    double gated_share = 0.6;    ///< of about 20 ranges in a row; more: the place is wrong
    double memory_s = 0.25;      ///< of ranges
    double interval_s = 0.05;    ///< between looks
    double speed_m_per_s = 1;    ///< of a point against its wearer
    double least_reach_m = 0.1;  ///< how far a point gets from where it was known, at least
    /// Sound that goes round a body is late for as long as the body is in its way: one error of all ranges
    /// from one place.
    double detour_m = 0.03;
    double explained = 4;          ///< largest mean squared normalised residual of a fit
    double out_of_reach_m = 0.08;  ///< beyond what bones allow: one of both points is at a wrong place
    double reach_m = 0.03;         ///< by which soft tissue and mounting add to what bones allow
};

/// How far two points can be from each other.
struct Reach {
    double least_m = 0, most_m = 1e6;
};

/// A range of a lost point to a known place.
struct LostRange {
    double time_s = 0, distance_m = 0, variance_m2 = 0;
    Vector3d known_m = Vector3d::Zero();
    int known = 0;  ///< which: a point, or an anchor as in PointRange
};

/// A known point of the same body.
struct PointOfBody {
    Vector3d p_m = Vector3d::Zero();
    Reach reach;
};

/// Where a point can be at all.
struct PointBounds {
    std::vector<PointOfBody> body{};
    double lowest_m = -1e6;  ///< the floor, less what mounting may be off
};

/// Normal distribution of a point's place and velocity.
struct PointBelief {
    Vector3d p_m = Vector3d::Zero(), v_m_per_s = Vector3d::Zero();
    Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Identity();
};

struct PointFit {
    PointBelief belief;  ///< of all places that explain the ranges, at `time_s`
    bool is_certain = false;
};

/// Least squares with Cauchy weights from many starting points; several places that explain the ranges widen
/// the covariance.
PointFit fitPoint(const std::deque<LostRange>& ranges, double time_s, const PointBelief& prior,
                  const PointBounds& bounds, const LostPointSettings& settings);

/// The state of `point` becomes that of `from`, `offset_m` away, with independent errors added.
void hangPoint(FreePoints& points, int point, int from, const Vector3d& offset_m, double sigma_m,
               double sigma_m_per_s);
/// The state of `point` becomes that belief, independent of the other points.
void putPoint(FreePoints& points, int point, const PointBelief& belief);

}  // namespace noctule::cooperative
