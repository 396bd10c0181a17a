// SPDX-License-Identifier: Apache-2.0
#include "core/report/range_statistics.h"

#include <algorithm>
#include <numeric>

namespace noctule {
namespace {

double shareOf(double part, int64_t whole) {
    return whole > 0 ? part / static_cast<double>(whole) : 0;
}

}  // namespace

int64_t RangeStatistics::pulses() const {
    return std::accumulate(count.begin(), count.end(), int64_t{0});
}

int64_t RangeStatistics::heard() const {
    return of(PulseFate::kUsed) + of(PulseFate::kRejected) + of(PulseFate::kUnused);
}

double RangeStatistics::usedShare() const {
    return shareOf(static_cast<double>(of(PulseFate::kUsed)), pulses());
}

double RangeStatistics::meanConfidence() const {
    return shareOf(confidence_sum, pulses());
}

std::optional<double> RangeStatistics::residualRms_m() const {
    if (residuals == 0)
        return std::nullopt;
    return std::sqrt(residual_squares_m2 / static_cast<double>(residuals));
}

void RangeStatistics::merge(const RangeStatistics& other) {
    for (size_t i = 0; i < count.size(); ++i)
        count[i] += other.count[i];
    confidence_sum += other.confidence_sum;
    residual_squares_m2 += other.residual_squares_m2;
    residuals += other.residuals;
    longest_gap_s = std::max(longest_gap_s, other.longest_gap_s);
}

RangeStatistics rangeStatistics(const ReportPair& pair) {
    RangeStatistics statistics;
    if (pair.pulses.empty())
        return statistics;
    double last_used_s = pair.pulses.front().time_s;
    const auto closeGap = [&](double time_s) {
        statistics.longest_gap_s = std::max(statistics.longest_gap_s, time_s - last_used_s);
        last_used_s = time_s;
    };
    for (const PulseAtBoard& pulse : pair.pulses) {
        ++statistics.count[static_cast<size_t>(pulse.fate)];
        if (std::isfinite(pulse.confidence))
            statistics.confidence_sum += pulse.confidence;
        if (pulse.fate != PulseFate::kUsed)
            continue;
        closeGap(pulse.time_s);
        if (std::isfinite(pulse.residual_m)) {
            statistics.residual_squares_m2 += double{pulse.residual_m} * pulse.residual_m;
            ++statistics.residuals;
        }
    }
    closeGap(pair.pulses.back().time_s);
    return statistics;
}

RangeStatistics rangeStatistics(const std::vector<ReportPair>& pairs) {
    RangeStatistics all;
    for (const ReportPair& pair : pairs)
        all.merge(rangeStatistics(pair));
    return all;
}

std::vector<float> residualSizes_m(const ReportPair& pair) {
    std::vector<float> sizes;
    for (const PulseAtBoard& pulse : pair.pulses)
        if (pulse.fate == PulseFate::kUsed && std::isfinite(pulse.residual_m))
            sizes.push_back(std::abs(pulse.residual_m));
    return sizes;
}

std::vector<float> residualSizes_m(const std::vector<ReportPair>& pairs) {
    std::vector<float> all;
    for (const ReportPair& pair : pairs)
        std::ranges::copy(residualSizes_m(pair), std::back_inserter(all));
    return all;
}

std::optional<double> quantileOf(std::vector<float> sizes, double share) {
    if (sizes.empty())
        return std::nullopt;
    const auto at =
        sizes.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sizes.size() - 1));
    std::ranges::nth_element(sizes, at);
    return *at;
}

}  // namespace noctule
