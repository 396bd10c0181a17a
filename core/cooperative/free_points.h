// SPDX-License-Identifier: Apache-2.0
// The state of Welch 2018: transceivers as free points, each with place and velocity in the world (m, m/s).
// A range is the distance between two points, or between a point and an anchor, which stands still and is
// known. Places and velocities are kept apart, since only places are measured: see correct().
#pragma once

#include <vector>

#include "core/math/conventions.h"

namespace noctule::cooperative {

/// Equations 1 to 3: 6 states per point. The order is that of the points, three components each.
struct FreePoints {
    Eigen::VectorXd p_m, v_m_per_s;
    Eigen::MatrixXd cov_pp, cov_pv, cov_vv;  ///< blocks of the aggregate covariance

    int count() const { return static_cast<int>(p_m.size() / 3); }
    Vector3d place(int point) const { return p_m.segment<3>(3 * point); }
    /// The whole covariance, places first.
    Eigen::MatrixXd covariance() const;
};

/// Points at rest with independent errors.
FreePoints startPoints(const std::vector<Vector3d>& places_m, double sigma_m, double sigma_m_per_s);

/// Equations 4 to 9. `q` in m^2/s^3: white noise of the acceleration; 0.03 a calm handshake, 0.3 a dance.
void predict(FreePoints& points, double dt_s, double q_m2_per_s3);

/// One element of equation 10.
struct PointRange {
    int point = 0;
    int other = 0;  ///< a point; -1 - k: anchor k
    double distance_m = 0;
    double variance_m2 = 0;
};
inline constexpr int anchorPoint(int anchor) {
    return -1 - anchor;
}

/// One row of the Jacobian (equations 14 and 15): +direction at `point`, -direction at `other`.
struct RangeRow {
    int point = 0, other = 0;
    Vector3d direction = Vector3d::UnitX();
    double innovation_m = 0;  ///< equation 16
    double variance_m2 = 0;
};

/// Equations 12 to 16. A range between two points at one place has no direction and is left out.
std::vector<RangeRow> linearise(const FreePoints& points, const std::vector<Vector3d>& anchors_m,
                                const std::vector<PointRange>& ranges);

/// The update of the extended Kalman filter with all rows at once, in its information form over the places:
/// with L = sum of h h^T / r and M = (I + L Ppp)^-1, Ppp <- Ppp M, Ppv <- M^T Ppv, Pvv <- Pvv - Ppv^T M L
/// Ppv. It is the textbook's update, at a cost that hardly grows with the number of ranges.
void correct(FreePoints& points, const std::vector<RangeRow>& rows);

/// The same by the gain of the textbook (Welch and Bishop 1995, equations 1.11 to 1.13).
void correctByGain(FreePoints& points, const std::vector<RangeRow>& rows);

/// Variance of the vector from one point to another, m^2: tr(Pa + Pb - 2 Pab).
double relativeVariance(const FreePoints& points, int a, int b);

}  // namespace noctule::cooperative
