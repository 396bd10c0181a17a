// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/board_noise.h"

#include <algorithm>
#include <cmath>

#include "core/inertial/reading.h"

namespace noctule {

BoardNoise::BoardNoise(const BoardNoiseParameters& parameters, size_t sources)
    : parameters_(parameters),
      accel_(parameters.accel),
      gyro_(parameters.gyro),
      distance_(sources, ExcessNoise(parameters.distance)),
      distance_before_(sources) {}

void BoardNoise::adaptAccel(ObservationBlock& block, const TriadReading& reading, double motion_m_per_s2,
                            double flesh_share, const Covariance& P) {
    constexpr double kFrame_s = 1.0 / kInertialFramesPerSecond;
    shaken_m_per_s2_ =
        std::max(motion_m_per_s2, shaken_m_per_s2_ * std::exp(-kFrame_s / parameters_.wobble_time_s));
    block.variance.array() += std::pow(flesh_share * parameters_.flesh_per_motion * shaken_m_per_s2_, 2) +
                              std::pow(flesh_share * parameters_.flesh_accel_m_per_s2, 2);
    adapt(block, reading, accel_, accel_before_, P);
}

void BoardNoise::adaptGyro(ObservationBlock& block, const TriadReading& reading, const Covariance& P) {
    adapt(block, reading, gyro_, gyro_before_, P);
}

void BoardNoise::adapt(ObservationBlock& block, const TriadReading& reading, ExcessNoise& noise,
                       Eigen::VectorXd& before, const Covariance& P) const {
    if (reading.isClipped()) {  // its innovation is not of this noise
        block.variance.array() += noise.whitenedVariance();
        return;
    }
    const Eigen::VectorXd expected = P.innovationVariance(block);
    noise.learn(block.residual, expected, before);
    limitPull(block, expected.array() + noise.variance(), parameters_.huber_sigma);
    block.variance.array() += noise.whitenedVariance();
}

double BoardNoise::learnDistance(const ObservationBlock& block, int source, const Covariance& P) {
    const Eigen::VectorXd expected = P.innovationVariance(block);
    ExcessNoise& noise = distance_[static_cast<size_t>(source)];
    const double variance = expected[0] + noise.variance();
    noise.learn(block.residual, expected, distance_before_[static_cast<size_t>(source)]);
    return variance;
}

}  // namespace noctule
