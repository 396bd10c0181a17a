// SPDX-License-Identifier: Apache-2.0
#include "core/guide/placement_guide.h"

#include <algorithm>
#include <map>

#include "core/calibration/source_offsets/jig_labels.h"
#include "core/math/order_statistics.h"

namespace noctule {
namespace {

constexpr double kHeardWithin_s = 0.5, kHeardWell = 0.3;
bool isHeardWell(const PairHealth& pair) {
    return pair.age_s && *pair.age_s < kHeardWithin_s && pair.confidence >= kHeardWell;
}

}  // namespace

std::vector<std::string> placementsOf(const KnownDistances& known) {
    std::vector<std::string> placements;
    for (const KnownDistance& distance : known.distances)
        if (std::ranges::find(placements, distance.placement) == placements.end())
            placements.push_back(distance.placement);
    return placements;
}

PlacementGuide::PlacementGuide(const Suit& suit, const Calibration& calibration, int sample_rate_hz,
                               const KnownDistances& known)
    : Guide(suit, calibration, sample_rate_hz, static_cast<int>(placementsOf(known).size())),
      placements_(placementsOf(known)),
      pairs_(placements_.size()) {
    for (const KnownDistance& distance : known.distances) {
        const int source = suit.findSource(distance.source), board = suit.findBoard(distance.board);
        const auto placement = std::ranges::find(placements_, distance.placement) - placements_.begin();
        if (source >= 0 && board >= 0)
            pairs_[static_cast<size_t>(placement)].push_back({source, board, distance.distance_m});
    }
}

std::optional<double> PlacementGuide::misfit_m(const HealthReport& health, size_t placement,
                                               double factor) const {
    std::map<int, std::vector<double>> by_source;
    for (const Pair& pair : pairs_[placement])
        if (const PairHealth& heard = health.pair(pair.source, pair.board);
            !isSkipped(pair.board) && isHeardWell(heard))
            by_source[pair.source].push_back(heard.distance_m - pair.distance_m / factor);
    std::vector<double> misfits;
    for (const auto& [source, differences] : by_source) {
        if (differences.size() < 3)
            continue;
        const double offset_m = medianOf(differences);
        for (const double difference : differences)
            misfits.push_back(std::abs(difference - offset_m));
    }
    return misfits.empty() ? std::nullopt : std::optional(medianOf(misfits));
}

std::optional<double> PlacementGuide::unitFactor(const HealthReport& health) const {
    for (const UnitMistake& mistake : unitMistakes())
        for (size_t placement = 0; placement < pairs_.size(); ++placement)
            if (misfit_m(health, placement, mistake.factor).value_or(kFits_m) < kFits_m)
                return mistake.factor;
    return std::nullopt;
}

double PlacementGuide::heardShare(const HealthReport& health, size_t placement) const {
    int asked = 0, heard = 0;
    for (const Pair& pair : pairs_[placement])
        if (!isSkipped(pair.board)) {
            ++asked;
            heard += isHeardWell(health.pair(pair.source, pair.board));
        }
    return asked > 0 ? static_cast<double>(heard) / asked : 0;
}

Hindrance PlacementGuide::see(const HealthReport& health, Guidance& guidance) {
    if (heardBoards(health, guidance).empty())
        return Hindrance::kNoReadings;
    double best_m = kFits_m, share = 0;
    for (size_t placement = 0; placement < pairs_.size(); ++placement) {
        share = std::max(share, heardShare(health, placement));
        const auto misfit = misfit_m(health, placement);
        if (misfit && *misfit < best_m) {
            best_m = *misfit;
            guidance.step = static_cast<int>(placement);
        }
    }
    guidance.heard_share = guidance.step ? heardShare(health, index(*guidance.step)) : share;
    guidance.value = *guidance.heard_share;
    if (*guidance.heard_share < kEnoughShare)
        return Hindrance::kUnheard;
    const auto factor = guidance.step ? std::nullopt : unitFactor(health);
    if (!factor)
        return Hindrance::kNone;
    guidance.value = *factor;
    return Hindrance::kUnit;
}

}  // namespace noctule
