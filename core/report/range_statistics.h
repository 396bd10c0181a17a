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

/// Of the sizes of the residuals of used ranges: what is usual, whatever a few echoes do to the mean.
std::optional<double> residualMedian_m(const std::vector<ReportPair>& pairs);

RangeStatistics rangeStatistics(const ReportPair& pair);
RangeStatistics rangeStatistics(const std::vector<ReportPair>& pairs);

}  // namespace noctule
