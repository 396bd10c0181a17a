// SPDX-License-Identifier: Apache-2.0
// How people hold their joints when nothing more is known: what an estimator without readings of a joint
// falls back to. A Gaussian per joint, learnt from motions.
#pragma once

#include <optional>
#include <string>

#include "core/math/conventions.h"

namespace noctule {

struct UsualTurn {
    Quaterniond q_parent_joint;  ///< the mean
    Vector3d sigma_rad;          ///< of a right perturbation of it, about each axis
};

/// Of a joint of the default actor; none of others.
std::optional<UsualTurn> usualTurn(const std::string& joint);

}  // namespace noctule
