// SPDX-License-Identifier: Apache-2.0
// Readings at the end of a sensor's range: all they say is that the truth lies there or beyond.
#pragma once

#include <limits>

#include "core/estimation/observation.h"

namespace noctule {

/// Nothing is known of how far beyond.
inline constexpr double kAnyExcess = std::numeric_limits<double>::infinity();

/// Makes of each such axis the plain reading with the same effect: the expected reading is a Gaussian, cut
/// off at the end of the range, and an update with the new residual and variance gives its mean and variance
/// (the moments of the Tobit Kalman filter: Allik et al. 2016, "The Tobit Kalman filter: an estimator for
/// censored measurements"). Taken as it stands the end of the range would be believed to the last digit, and
/// a limb that turns at twice that rate would be lost without the filter knowing. `reading` made `block`;
/// `innovation_variance` by row, before. Into the block's origin, as `target`, goes what was added to
/// residuals. The part beyond the end counts as exponentially distributed, too, with mean `mean_excess`: it
/// shifts the Gaussian towards the end by S / mean_excess. A rate that nobody sees is otherwise pushed
/// farther away by every reading.
void censor(ObservationBlock& block, const TriadReading& reading, const Eigen::VectorXd& innovation_variance,
            double mean_excess);

/// For who asks only once what readings tell: axes that are expected beyond the end as well tell nothing.
void leaveOutBeyond(ObservationBlock& block, const TriadReading& reading);

}  // namespace noctule
