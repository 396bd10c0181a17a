// SPDX-License-Identifier: Apache-2.0
// What a filter did, step by step and linearised as it was, for a smoother that goes back over it. Going back
// needs to know how errors are carried and what was observed, not how they grow.
#pragma once

#include <cstdint>
#include <deque>
#include <variant>
#include <vector>

#include "core/estimation/covariance.h"
#include "core/estimation/heading_shift.h"
#include "core/math/transition_kernels.h"

namespace noctule {

/// The estimate at an instant at which a pose is wanted. Its covariance is that of the errors before the
/// step's last corrections, the same to first order: the next step carries it over.
struct TapedFrame {
    std::vector<int64_t> times_ns;  ///< several while the body is still
    MotionState motion;
    Eigen::VectorXd apart;   ///< added to `motion` gives the estimate; empty: it is that
    Eigen::MatrixXd P_pose;  ///< covariance of the coordinates with all states: freedoms x n
    double flesh_rad2 = 0;   ///< as in jointSigmas()
};

/// Variances that were added to the covariance, per state, because the estimate was lost. A limb's and those
/// of what it carries go together (LimbTurns::errorOf), which is not kept here.
struct Widening {
    Eigen::VectorXd variance;
};

/// LinkTransitions: of a step, or of corrections within one.
using FilterTape =
    std::deque<std::variant<LinkTransitions, HeadingShift, ObservedUpdate, TapedFrame, Widening>>;

}  // namespace noctule
