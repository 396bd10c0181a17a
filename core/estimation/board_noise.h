// SPDX-License-Identifier: Apache-2.0
// How far one board's readings are believed beyond its data sheet: what its innovations teach, and what
// flesh adds to an accelerometer.
#pragma once

#include <cmath>

#include "core/estimation/excess_noise.h"
#include "core/estimation/measurement.h"

namespace noctule {

struct BoardNoiseParameters {
    /// Accelerometers' biases are constant, distances' errors come from echoes and from where boards sit.
    ExcessNoiseParameters accel{280}, distance{20}, gyro{280};
    double huber_sigma = 2.5;  ///< beyond it an innovation pulls no further

    /// On flesh an accelerometer reads its own wobble as well, more than the motion that drives it (a damped
    /// oscillator of some 12 Hz, and what it makes gyroscopes say of the limb), and sits a few degrees off.
    double flesh_per_motion = 3, flesh_accel_m_per_s2 = 3, wobble_time_s = 0.3;

    /// Microphones shift with the pose and stay so for a while: what a filter follows is no innovation, so it
    /// is not learnt. Per distance, as white noise with the same effect (some millimetres for half a second).
    double flesh_distance_m = 0.007;
};

class BoardNoise {
public:
    BoardNoise(const BoardNoiseParameters& parameters, size_t sources);

    /// Adds to the variances. `motion_m_per_s2`: the reading without gravity; `flesh_share` 0 to 1.
    void adaptAccel(ObservationBlock& block, const TriadReading& reading, double motion_m_per_s2,
                    double flesh_share, const Covariance& P);
    void adaptGyro(ObservationBlock& block, const TriadReading& reading, const Covariance& P);
    /// Learns from a distance; returns the variance of its innovation, with what was learnt before, for the
    /// gate.
    double learnDistance(const ObservationBlock& block, int source, const Covariance& P);
    double distanceVariance(int source, double flesh_share) const {
        return distance_[static_cast<size_t>(source)].whitenedVariance() +
               std::pow(flesh_share * parameters_.flesh_distance_m, 2);
    }

private:
    void adapt(ObservationBlock& block, const TriadReading& reading, ExcessNoise& noise,
               Eigen::VectorXd& before, const Covariance& P) const;

    BoardNoiseParameters parameters_;
    ExcessNoise accel_, gyro_;
    std::vector<ExcessNoise> distance_;  ///< per source: an echo or an obstacle concerns one pair
    Eigen::VectorXd accel_before_, gyro_before_;
    std::vector<Eigen::VectorXd> distance_before_;  ///< per source
    double shaken_m_per_s2_ = 0;
};

}  // namespace noctule
