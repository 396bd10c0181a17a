// SPDX-License-Identifier: Apache-2.0
// The curves of ranges and readings, taken out of their tables one at a time, and what the pulses of a pair
// came to between two times. Curves of motions are in joint_curves.h.
#pragma once

#include "core/report/report_data.h"
#include "core/review/series.h"
#include "core/review/take_review.h"

namespace noctule {

enum class RangeQuantity {
    kConfidence,  ///< 0..1 at every pulse of the source; 0 where it was not heard
    kDistance_m,  ///< the curve breaks at pulses that were not heard
    kResidual_m,  ///< measured minus expected; it breaks where no estimator tried the range
};
Series rangeSeries(const RangeTable& table, int source, int board, RangeQuantity quantity);

/// What became of a source's last pulse at or before t_s at one board: what the curve of the confidence holds
/// at that time.
struct PairNow {
    bool has_pulse = false;           ///< there is one, not older than kPairHold_s
    std::optional<float> confidence;  ///< of what was heard of it
};
PairNow pairAt(const RangeTable& table, int source, int board, double t_s);

/// `axis`: 0..2 gyroscope in rad/s, 3..5 accelerometer in m/s^2. Lost and clipped readings break the curve.
Series readingSeries(const ReadingTable& table, int board, int axis);

/// What became of a source's pulses at one board.
struct PairWindow {
    int64_t pulses = 0, heard = 0;
    int64_t used = 0;                      ///< by the estimator, with full or less weight
    int64_t gated = 0;                     ///< heard, but too far from what the pose allows
    double mean_confidence = 0;            ///< over all pulses; what was not heard counts as 0
    std::optional<double> residual_rms_m;  ///< of the used ones
};

/// Answers for all pairs at once and any time, fast enough for every mouse move (two binary searches).
class PairSummaries {
public:
    PairSummaries() = default;
    explicit PairSummaries(const RangeTable& table);

    int sourceCount() const { return source_count_; }
    int boardCount() const { return board_count_; }
    /// Pulses sent within [from_s, to_s).
    PairWindow window(int source, int board, double from_s, double to_s) const;

private:
    /// Sums over the ranges before each; one entry more than ranges.
    struct Sums {
        double confidence = 0, residual_squares_m2 = 0;
        int32_t used = 0, gated = 0, residuals = 0;
    };
    struct Pair {
        std::vector<double> t_s;
        std::vector<Sums> before;
    };
    int source_count_ = 0, board_count_ = 0;
    std::vector<std::vector<double>> pulse_t_s_;  ///< per source
    std::vector<Pair> pairs_;
};

}  // namespace noctule
