// SPDX-License-Identifier: Apache-2.0
// From averages of a still stretch to what a fit of the rest pose reads: directions of up and distances, for
// boards that may be arranged otherwise than the suit's description says. How sure an accelerometer is comes
// from how far the boards' readings are from g: that shows the error along the vertical, and the error across
// it, which is a tilt and shows in nothing, is taken to be as large.
#pragma once

#include <optional>
#include <vector>

#include "core/calibration/rest_pose/rest_pose_fit.h"
#include "core/calibration/still_stretch.h"

namespace noctule {

/// What stands behind a place of the suit: whose readings and sound, and whose calibration belongs to them.
struct StreamPlace {
    int stream = 0, calibration = 0;

    bool operator==(const StreamPlace&) const = default;
};
using Arrangement = std::vector<StreamPlace>;  ///< per board of the suit

class RestEvidenceMaker {
public:
    /// Keeps references to both.
    RestEvidenceMaker(const Observations& take, const StillStretch& still, double sigma_distance_m);

    /// Every board where the suit says.
    Arrangement asDescribed() const;
    RestEvidence make(const Arrangement& arrangement) const;
    /// -2 log likelihood of readings at rest: |a| = g and no rotation.
    double sensorCost(const StreamPlace& board) const;

    const BoardCalibration& calibration(int board) const { return calibrations_[static_cast<size_t>(board)]; }
    /// Mean specific force, m/s^2.
    Vector3d accel(const StreamPlace& board) const;
    Vector3d gyro_rad_per_s(const StreamPlace& board) const;
    bool accelIsCalibrated(int board) const;
    /// Of the direction of up; of a single board from its group (calibrated or not).
    double sigmaUp_rad(int board) const;
    /// None when the source has no offset for the detector in use.
    std::optional<double> distance_m(const StillFlight& flight, int calibrated_as) const;
    /// Both boards could be exchanged at their plugs without anybody seeing it in the readings.
    bool sameCalibration(int a, int b) const;

private:
    double spread_m_per_s2(bool calibrated) const;
    void addUp(int place, const StreamPlace& placed, RestEvidence& into) const;
    void addDistance(int place, const StreamPlace& placed, const StillFlight& flight,
                     RestEvidence& into) const;

    const Observations& take_;
    const StillStretch& still_;
    double sigma_distance_m_;
    std::vector<BoardCalibration> calibrations_;  ///< per board; nominal where there is none
    double spread_calibrated_m_per_s2_ = 0, spread_nominal_m_per_s2_ = 0;
};

/// Places and orientations that the suit's description, or else the calibration in force, gives.
RestPriors priorsOf(const Observations& take, bool oriented_as_calibrated);

}  // namespace noctule
