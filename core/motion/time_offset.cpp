// SPDX-License-Identifier: Apache-2.0
#include "core/motion/time_offset.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/motion/curve_correlation.h"

namespace noctule {
namespace {

constexpr int64_t kStep_ns = 10'000'000;
constexpr int kCoarse = 5;  ///< steps of the search
constexpr double kLeastOverlap_s = 2;
constexpr double kApart_s = 0.15;      ///< nearer shifts are the same peak
constexpr double kClearlyWorse = 0.1;  ///< correlation by which a rival loses without further proof
constexpr double kLeastGap = 0.003;    ///< correlation by which it must lose in any case
constexpr double kProof = 4;           ///< standard errors by which its residuals must be larger
constexpr size_t kJudgedPeaks = 40, kNamedRivals = 5;
constexpr double kLeastShare = 0.3;  ///< of the best shift's overlap, that a rival must have

struct Peak {
    int lag = 0;
    double fine = 0;  ///< with the parabola's part
    double correlation = -1;
    double evidence = 0;  ///< Fisher's z times the root of the overlap's length
};

double parabolaPeak(double left, double middle, double right) {
    const double curvature = left - 2 * middle + right;
    return curvature < 0 ? std::clamp(0.5 * (left - right) / curvature, -0.5, 0.5) : 0;
}

double evidenceOf(double correlation, double overlap_steps) {
    return std::atanh(std::clamp(correlation, -0.999, 0.999)) * std::sqrt(overlap_steps);
}

/// Local maxima of the coarse search, the most evident first.
std::vector<Peak> coarsePeaks(const CurveCorrelation& coarse, int first, int last) {
    std::vector<double> all;
    for (int lag = first; lag <= last; ++lag)
        all.push_back(coarse.at(lag));
    std::vector<Peak> peaks;
    for (size_t i = 0; i < all.size(); ++i) {
        const double left = i > 0 ? all[i - 1] : -1, right = i + 1 < all.size() ? all[i + 1] : -1;
        const int lag = first + static_cast<int>(i);
        if (all[i] > -1 && all[i] >= left && all[i] >= right)
            peaks.push_back({lag * kCoarse, 0, all[i], evidenceOf(all[i], coarse.overlap(lag))});
    }
    std::ranges::sort(peaks, std::ranges::greater{}, &Peak::evidence);
    if (peaks.size() > kJudgedPeaks)
        peaks.resize(kJudgedPeaks);
    return peaks;
}

Peak refined(const CurveCorrelation& fine, const Peak& coarse) {
    Peak best = coarse;
    best.correlation = -1;
    for (int lag = coarse.lag - 2 * kCoarse; lag <= coarse.lag + 2 * kCoarse; ++lag)
        if (const double c = fine.at(lag); c > best.correlation)
            best.lag = lag, best.correlation = c;
    best.fine = best.lag + parabolaPeak(fine.at(best.lag - 1), best.correlation, fine.at(best.lag + 1));
    best.evidence = evidenceOf(best.correlation, fine.overlap(best.lag));
    return best;
}

/// Shifts that the motions do not refute, the best five by time.
std::vector<Peak> findRivals(const CurveCorrelation& fine, std::vector<Peak> peaks, const Peak& best) {
    std::erase_if(peaks, [&](const Peak& peak) {
        const double gap = best.correlation - peak.correlation;
        const bool same = std::abs(peak.lag - best.lag) * static_cast<double>(kStep_ns) < kApart_s * 1e9;
        return same || gap > kClearlyWorse || fine.overlap(peak.lag) < kLeastShare * fine.overlap(best.lag) ||
               (gap > kLeastGap && fine.excessOf(peak.lag, best.lag) > kProof);
    });
    std::ranges::sort(peaks, std::ranges::greater{}, &Peak::correlation);
    if (peaks.size() > kNamedRivals)
        peaks.resize(kNamedRivals);
    std::ranges::sort(peaks, {}, &Peak::lag);
    return peaks;
}

std::string inMs(int64_t time_ns) {
    return std::to_string(std::llround(static_cast<double>(time_ns) * 1e-6)) + " ms";
}

}  // namespace

std::optional<TimeOffset> findTimeOffset(const TimedMotion& estimate, const TimedMotion& reference,
                                         double max_shift_s) {
    if (estimate.frames.empty() || reference.frames.empty())
        return std::nullopt;
    const std::vector<CommonJoint> common = commonJoints(estimate.skeleton, reference.skeleton);
    const CurveCorrelation fine(motionCurves(estimate, common, false, kStep_ns),
                                motionCurves(reference, common, true, kStep_ns), kStep_ns, kLeastOverlap_s);
    if (!fine.moves())
        return std::nullopt;
    const CurveCorrelation coarse = fine.coarser(kCoarse);
    const int64_t start_difference_ns = estimate.frames.front().time_ns - reference.frames.front().time_ns;
    const double zero_lag = -static_cast<double>(start_difference_ns) / (kCoarse * kStep_ns);
    const double reach = max_shift_s * 1e9 / (kCoarse * kStep_ns);
    std::vector<Peak> peaks =
        coarsePeaks(coarse, std::max(static_cast<int>(zero_lag - reach), coarse.firstLag()),
                    std::min(static_cast<int>(zero_lag + reach), coarse.lastLag()));
    for (Peak& peak : peaks)
        peak = refined(fine, peak);
    if (peaks.empty())
        return std::nullopt;
    const Peak best = *std::ranges::max_element(peaks, {}, &Peak::evidence);
    const auto offsetOf = [&](const Peak& peak) {
        return start_difference_ns + std::llround(peak.fine * kStep_ns);
    };
    TimeOffset offset{offsetOf(best), best.correlation, fine.sigma_ns(best.lag), {}};
    for (const Peak& rival : findRivals(fine, peaks, best))
        offset.rivals.push_back({offsetOf(rival), rival.correlation});
    return offset;
}

std::string distrust(const TimeOffset& offset) {
    char correlation[32];
    std::snprintf(correlation, sizeof correlation, "%.2f", offset.correlation);
    if (offset.correlation < TimeOffset::kLeastCorrelation)
        return std::string("does not match at any shift (best correlation ") + correlation + ")";
    if (!offset.rivals.empty()) {
        std::string rivals;
        for (const TimeOffset::Rival& rival : offset.rivals)
            rivals += (rivals.empty() ? "" : ", ") + inMs(rival.add_to_reference_ns);
        const std::string best = inMs(offset.add_to_reference_ns);
        return offset.rivals.size() > 1 ? "repeats itself: " + rivals + " fit about as well as " + best
                                        : "repeats itself: " + rivals + " fits about as well as " + best;
    }
    return "moves too little to tell the shift better than within " + inMs(2 * offset.sigma_ns);
}

}  // namespace noctule
