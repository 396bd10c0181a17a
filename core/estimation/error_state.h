// SPDX-License-Identifier: Apache-2.0
// Errors of a filter's state in the order of its StateLayout: rotations by right perturbations, all else by
// differences.
#pragma once

#include "core/estimation/observation.h"

namespace noctule {

/// The coordinates' part: what retracts `from` to `to`.
Eigen::VectorXd coordinateError(const KinematicTree& tree, const MotionState& from, const MotionState& to);

void addError(const KinematicTree& tree, const StateLayout& layout, const Eigen::VectorXd& error,
              BodyState& state);

/// What added to `from` gives `to`.
Eigen::VectorXd errorBetween(const KinematicTree& tree, const StateLayout& layout, const BodyState& from,
                             const BodyState& to);

}  // namespace noctule
