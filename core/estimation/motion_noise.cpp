// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/motion_noise.h"

#include <algorithm>
#include <cmath>

namespace noctule {

MotionNoise::MotionNoise(const KinematicTree& tree, Eigen::VectorXd variance, const std::vector<bool>& adapts,
                         const MotionNoiseParameters& parameters, bool root_is_seen)
    : parameters_(parameters),
      first_variance_(std::move(variance)),
      variance_(first_variance_),
      calm_variance_(first_variance_) {
    for (size_t i = 0; i < tree.links().size(); ++i) {
        const Link& link = tree.links()[i];
        const int turning = link.type == LinkType::kFree ? 3 : link.count;
        if (adapts[i] && link.count > 0)
            turning_.push_back({link.first + link.count - turning, turning});
        if (i > 0 || !root_is_seen)
            calm_variance_.segment(link.first + link.count - turning, turning)
                .setConstant(std::pow(parameters_.least_rad_per_s2, 2));
    }
}

void MotionNoise::learn(const Eigen::VectorXd& correction, const Eigen::VectorXd& shrinkage,
                        double interval_s, double flesh_share) {
    const double least =
        std::pow(std::max(parameters_.least_rad_per_s2, flesh_share * parameters_.flesh_rad_per_s2), 2);
    const double most = std::pow(parameters_.most_rad_per_s2, 2);
    for (const Turning& turning : turning_) {
        const double expected = shrinkage.segment(turning.first, turning.count).sum();
        if (expected <= 0)
            continue;
        const double ratio = correction.segment(turning.first, turning.count).squaredNorm() / expected;
        const double growth = std::min(ratio, parameters_.largest_surprise) - 1;
        auto variance = variance_.segment(turning.first, turning.count);
        variance.setConstant(
            std::clamp(variance[0] * std::exp(growth * interval_s / parameters_.memory_s), least, most));
    }
}

void MotionNoise::allowMost(const Link& link) {
    for (const Turning& turning : turning_)
        if (turning.first >= link.first && turning.first < link.first + link.count)
            variance_.segment(turning.first, turning.count)
                .setConstant(std::pow(parameters_.most_rad_per_s2, 2));
}

}  // namespace noctule
