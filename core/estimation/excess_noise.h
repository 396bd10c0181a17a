// SPDX-License-Identifier: Apache-2.0
// Noise that a sensor has beyond its data sheet, learnt from its own innovations: flesh wobbles, straps slip,
// a bias or a mounting is not quite what the calibration says. Such errors are coloured: readings that follow
// each other share them, so that n of them tell less than n independent ones would. An error with lag-one
// correlation r counts as white noise of (1 + r) / (1 - r) times its variance, which has the same effect on
// means over many readings (first-order autoregression).
#pragma once

#include "core/estimation/covariance.h"

namespace noctule {

struct ExcessNoiseParameters {
    double memory = 280;  ///< readings over which it is learnt
    double longest_correlation = 0.98;
    double huber_sigma = 2.5;  ///< beyond which an innovation teaches no more: outliers are no noise
};

class ExcessNoise {
public:
    explicit ExcessNoise(const ExcessNoiseParameters& parameters) : parameters_(parameters) {}

    /// Innovations of one reading and their expected variances, without excess; `before`: innovations of the
    /// reading before, for the correlation (empty: none), which become these.
    void learn(const Eigen::VectorXd& innovations, const Eigen::VectorXd& expected_variances,
               Eigen::VectorXd& before);

    /// Beyond what is expected.
    double variance() const;
    /// The same as white noise with the same effect.
    double whitenedVariance() const;

private:
    ExcessNoiseParameters parameters_;
    double seen_ = 0, expected_ = 0, product_ = 0;  ///< running means
};

}  // namespace noctule
