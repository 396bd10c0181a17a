// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/excess_noise.h"

#include <algorithm>

namespace noctule {

void ExcessNoise::learn(const Eigen::VectorXd& innovations, const Eigen::VectorXd& expected_variances,
                        Eigen::VectorXd& before) {
    const double excess = variance(), limit = parameters_.huber_sigma;
    const Eigen::ArrayXd bounds = limit * (expected_variances.array() + excess).sqrt();
    const Eigen::ArrayXd clipped = innovations.array().max(-bounds).min(bounds);
    const double learning = 1 / parameters_.memory;
    seen_ += learning * (clipped.square().mean() - seen_);
    expected_ += learning * (expected_variances.mean() - expected_);
    if (before.size() == innovations.size())
        product_ += learning * ((clipped * before.array().max(-bounds).min(bounds)).mean() - product_);
    before = innovations;
}

double ExcessNoise::variance() const {
    return std::max(0.0, seen_ - expected_);
}

double ExcessNoise::whitenedVariance() const {
    const double correlation =
        seen_ > 0 ? std::clamp(product_ / seen_, 0.0, parameters_.longest_correlation) : 0;
    return variance() * (1 + correlation) / (1 - correlation);
}

}  // namespace noctule
