// SPDX-License-Identifier: Apache-2.0
// What the filter believes of a body without readings.
#include <cmath>

#include "core/estimation/manifold_filter.h"
#include "core/math/rotation.h"

namespace noctule {

void ManifoldFilter::updatePriors() {
    for (const int link : now_.give.lostLinks(now_.state.motion))
        beginAnew(tree_.link(link));
    std::vector<ObservationBlock> blocks =
        now_.give.observe(now_.state.motion, now_.P, parameters_.prior_interval_s);
    const auto pull = [&](int index, double residual, double sigma) {
        blocks.push_back({{index},
                          Eigen::MatrixXd::Ones(1, 1),
                          Eigen::VectorXd::Constant(1, residual),
                          Eigen::VectorXd::Constant(1, sigma * sigma)});
    };
    if (isFree()) {
        const Vector3d still = -now_.state.motion.rate.head<3>();
        const double sigma = parameters_.root_velocity_prior_m_per_s;
        blocks.push_back(
            velocityOfRoot(layout_, now_.state.motion, still, Vector3d::Constant(sigma * sigma)));
    }
    for (size_t i = 0; i < tree_.links().size(); ++i) {
        const Link& link = tree_.links()[i];
        if (!isBlind(link) || (i == 0 && parameters_.root_given))
            continue;
        const int rotation = link.type == LinkType::kFree ? 3 : 0;
        const Vector3d away =
            logQuaternion(rest_.q_parent_link[i].conjugate() * now_.state.motion.q_parent_link[i]);
        for (int k = rotation; k < link.count; ++k) {
            const int index = link.first + k;
            const double angle = link.type == LinkType::kHinge
                                     ? now_.state.motion.angle_rad[i] - rest_.angle_rad[i]
                                     : away[k - rotation];
            if (i > 0)
                pull(layout_.theta(index), -angle, parameters_.blind.pose_prior_rad);
            pull(layout_.rate(index), -now_.state.motion.rate[index], parameters_.blind.rate_prior_rad_per_s);
        }
    }
    observe(std::move(blocks));
}

}  // namespace noctule
