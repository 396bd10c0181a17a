// SPDX-License-Identifier: Apache-2.0
// How lively each joint moves. A filter that grants every joint the accelerations of a kicking leg believes
// its accelerometers little and smooths nothing in a trunk; one that grants them less loses the leg. So each
// link's process noise follows what the readings teach: the filter's own corrections of an acceleration have,
// where the noise is right, the variance by which observing shrinks the acceleration's own (covariance
// matching: Myers and Tapley 1976, "Adaptive sequential estimation with unknown noise statistics", with a
// forgetting memory and for logarithms).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/body/kinematics.h"

namespace noctule {

struct MotionNoiseParameters {
    double least_rad_per_s2 = 1, most_rad_per_s2 = 300;  ///< of a joint's acceleration; root: of its turn
    /// Boards on flesh make accelerations that no joint has, and are as quiet between them.
    double flesh_rad_per_s2 = 200;
    double memory_s = 0.3;
    double largest_surprise = 30;  ///< a motion begins within a few frames, an outlier teaches no more
};

class MotionNoise {
public:
    MotionNoise() = default;
    /// `variance`: of the accelerations, per velocity index, to begin with; `adapts`: per link;
    /// `root_is_seen`: by another system, so that it is never calm.
    MotionNoise(const KinematicTree& tree, Eigen::VectorXd variance, const std::vector<bool>& adapts,
                const MotionNoiseParameters& parameters, bool root_is_seen = false);

    /// Stationary variance of the accelerations, per velocity index.
    const Eigen::VectorXd& variance() const { return calm_ ? calm_variance_ : variance_; }

    /// After all observations of one instant: the accelerations' corrections, and by how much their variances
    /// shrank. `interval_s` since the last; `flesh_share` 0 to 1.
    void learn(const Eigen::VectorXd& correction, const Eigen::VectorXd& shrinkage, double interval_s,
               double flesh_share);
    /// What a gyroscope at the end of its range did not see may have been anything.
    void allowMost(const Link& link);
    /// Joints are believed to move as little as they may. What was learnt is kept for afterwards.
    void setCalm(bool calm) { calm_ = calm; }
    /// As it was to begin with, where nothing is learnt.
    void restart() { variance_ = first_variance_; }

private:
    struct Turning {
        int first = 0, count = 0;  ///< velocity indices that rotate
    };
    MotionNoiseParameters parameters_;
    std::vector<Turning> turning_;
    Eigen::VectorXd first_variance_, variance_, calm_variance_;
    bool calm_ = false;
};

}  // namespace noctule
