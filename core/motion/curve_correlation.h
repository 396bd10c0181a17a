// SPDX-License-Identifier: Apache-2.0
// How well the curves of two motions agree when one is shifted against the other: the mean over the curves of
// Pearson's correlation, so that scales and constant differences between two bodies have no effect.
#pragma once

#include "core/motion/motion_curves.h"

namespace noctule {

class CurveCorrelation {
public:
    /// Curves on which either motion hardly moves are left out.
    CurveCorrelation(std::vector<AlignmentCurve> first, std::vector<AlignmentCurve> second, int64_t step_ns,
                     double least_overlap_s);
    /// With means over `factor` steps instead.
    CurveCorrelation coarser(int factor) const;

    bool moves() const { return !pairs_.empty(); }
    int firstLag() const;
    int lastLag() const;
    /// Steps in which both are there: first's step i meets second's step i - lag.
    int overlap(int lag) const;
    /// -1 when the overlap is too short.
    double at(int lag) const;
    /// By how many standard errors the residuals at `worse` exceed those at `better`, over their common time,
    /// in blocks of a quarter of a second.
    double excessOf(int worse, int better) const;
    /// Standard deviation of the shift, from the curvature of the correlation and from how its slope
    /// scatters: over time in blocks whose neighbours depend on each other, with all curves of a body
    /// together, and from curve to curve, since an estimate lags more in one joint than in another.
    int64_t sigma_ns(int lag) const;

private:
    struct ShiftTerms;
    struct Pair {
        AlignmentCurve first, second;
        std::vector<double> first_sum, first_squares, second_sum, second_squares;  ///< of all before
    };
    /// y = gain * x, both standardised over the overlap at a lag.
    struct Fit {
        double mean_x = 0, mean_y = 0, scale_x = 0, scale_y = 0, correlation = 0;
    };
    Fit fitOf(const Pair& pair, int lag) const;
    void addPair(AlignmentCurve first, AlignmentCurve second);
    std::pair<int, int> range(int lag) const;

    std::vector<Pair> pairs_;
    int64_t step_ns_;
    double least_overlap_s_;
    int first_size_ = 0, second_size_ = 0;
};

}  // namespace noctule
