// SPDX-License-Identifier: Apache-2.0
// Counts over the pulses of source-board pairs.
#pragma once

#include <array>

#include "core/report/report_data.h"

namespace noctule {

struct RangeStatistics {
    std::array<int64_t, kPulseFates> count{};  ///< by PulseFate
    double confidence_sum = 0;
    double residual_squares_m2 = 0;  ///< of used ranges with a known residual
    int64_t residuals = 0;
    double longest_gap_s = 0;  ///< between two used ranges or an end of the take

    int64_t of(PulseFate fate) const { return count[static_cast<size_t>(fate)]; }
    int64_t pulses() const;
    int64_t heard() const;
    double usedShare() const;       ///< of all pulses, 0..1
    double meanConfidence() const;  ///< over all pulses; what was not heard counts as 0
    std::optional<double> residualRms_m() const;
    /// Adds the counts of another pair; the longest gap is the longer one.
    void merge(const RangeStatistics& other);
};

/// Sizes of the residuals of used ranges.
std::vector<float> residualSizes_m(const ReportPair& pair);
std::vector<float> residualSizes_m(const std::vector<ReportPair>& pairs);
/// What the given share (0..1) of the sizes stays within, whatever echoes do to the mean; none without sizes.
std::optional<double> quantileOf(std::vector<float> sizes, double share);

RangeStatistics rangeStatistics(const ReportPair& pair);
RangeStatistics rangeStatistics(const std::vector<ReportPair>& pairs);

}  // namespace noctule
