// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/censoring.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace noctule {
namespace {

constexpr double kNothingLearnt = 1e8;  // a variance

/// Mean of a standard normal variable known to be `a` or more (inverse Mills ratio), less a.
double meanBeyond(double a) {
    if (a > 20)
        return a / (a * a + 2);  // to 1 / a^4 of itself, where erfc would soon be nothing
    const double density = std::exp(-0.5 * a * a) / std::sqrt(2 * std::numbers::pi);
    return density / (0.5 * std::erfc(a / std::numbers::sqrt2)) - a;
}

}  // namespace

void censor(ObservationBlock& block, const TriadReading& reading, const Eigen::VectorXd& innovation_variance,
            double mean_excess) {
    if (!reading.isClipped())
        return;
    block.origin.target = -block.residual;
    for (Eigen::Index i = 0; i < block.rows(); ++i) {
        const int beyond = reading.axes[static_cast<size_t>(i)].beyond;
        if (beyond == 0)
            continue;
        const double S = innovation_variance[i], sigma = std::sqrt(S);
        const double shift = S / mean_excess;
        const double a = (beyond * block.residual[i] + shift) / sigma;
        const double past = meanBeyond(a), mean = past + a;
        const double learnt = std::max(mean * past, S / kNothingLearnt);
        block.residual[i] = beyond * (sigma * mean - shift) / learnt;
        block.variance[i] = std::min(block.variance[i] + S / learnt - S, kNothingLearnt);
    }
    block.origin.target += block.residual;
}

void leaveOutBeyond(ObservationBlock& block, const TriadReading& reading) {
    for (Eigen::Index i = 0; i < block.rows(); ++i)
        if (reading.axes[static_cast<size_t>(i)].beyond * block.residual[i] < 0) {
            block.residual[i] = 0;
            block.variance[i] = kNothingLearnt;
        }
}

}  // namespace noctule
