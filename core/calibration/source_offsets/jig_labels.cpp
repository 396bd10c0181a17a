// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/source_offsets/jig_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/math/order_statistics.h"

namespace noctule {
namespace {

using SwapKind = SwappedLabels::Kind;

constexpr UnitMistake kUnitMistakes[] = {
    {1000, "as if millimetres stood under a heading in metres"},
    {100, "as if centimetres stood under a heading in metres"},
    {10, "as if they were in another unit than the heading says"},
    {1 / 0.0254, "as if inches stood under a heading in metres"},
    {25.4, "as if inches had been turned into millimetres twice"},
    {1 / 0.3048, "as if feet stood under a heading in metres"},
    {1e-3, "as if metres stood under a heading in millimetres"},
    {1e-2, "as if they were in another unit than the heading says"},
    {0.1, "as if centimetres stood under a heading in millimetres"},
    {1 / 25.4, "as if inches stood under a heading in millimetres"},
    {1 / 304.8, "as if feet stood under a heading in millimetres"},
};
constexpr double kUnitTolerance = 0.1;

constexpr double kCauchyScale_s = 1e-5;  // 3.4 mm: above the thermometer's error, below any mistake
constexpr double kSuspicious_s = 5e-6;   // median over a label's measurements
constexpr double kExplained_s = 2e-5;    // 7 mm
constexpr double kExplainedShare = 0.75;
constexpr double kLeastGain = 8;
constexpr int kMostSwaps = 6;

/// Measurements in the form that a change of labels needs: which distance belongs to which.
class LabelTrial {
public:
    explicit LabelTrial(const JigData& jig)
        : sources_(jig.suit.sources.size()), boards_(jig.suit.boards.size()) {
        std::map<std::string, int> placements;
        for (const JigMeasurement& m : jig.measurements) {
            const auto [label, is_new] = placements.emplace(m.placement, std::ssize(labels_));
            if (is_new)
                labels_.push_back(m.placement);
            keys_.push_back({label->second, m.source, m.board});
            delays_s_.push_back(m.flight_s - jig.mic_delay_s[static_cast<size_t>(m.board)]);
            c_m_per_s_.push_back(m.c_m_per_s);
        }
        free_.assign(keys_.size(), true);
        distances_m_.assign(labels_.size() * jig.suit.sources.size() * jig.suit.boards.size(), std::nan(""));
        for (size_t i = 0; i < keys_.size(); ++i)
            distances_m_[indexOf(keys_[i])] = jig.measurements[i].distance_m;
    }

    struct Swap {
        SwapKind kind;
        int first, second;
        int placement;  ///< -1: all
    };

    const std::vector<std::string>& labels() const { return labels_; }

    /// The best of all exchanges that explain what they concern.
    std::optional<Swap> best() const {
        const std::vector<double> residuals = residualsOf(nullptr);
        std::optional<Swap> best;
        double best_gain = kLeastGain;
        for (const Swap& swap : candidates(residuals))
            if (const double gain = gainOf(swap, residuals); gain > best_gain) {
                best_gain = gain;
                best = swap;
            }
        return best;
    }

    /// What it concerns takes part in no further search.
    std::vector<size_t> settle(const Swap& swap) {
        std::vector<size_t> concerned;
        for (size_t i = 0; i < keys_.size(); ++i)
            if (free_[i] && concerns(swap, keys_[i])) {
                free_[i] = false;
                concerned.push_back(i);
            }
        return concerned;
    }

private:
    using Key = std::array<int, 3>;  // placement, source, board

    static size_t placeOf(SwapKind kind) {
        return kind == SwapKind::kPlacements ? 0 : kind == SwapKind::kSources ? 1 : 2;
    }

    size_t indexOf(const Key& key) const {
        return (static_cast<size_t>(key[0]) * sources_ + static_cast<size_t>(key[1])) * boards_ +
               static_cast<size_t>(key[2]);
    }

    static bool concerns(const Swap& swap, const Key& key) {
        const int label = key[placeOf(swap.kind)];
        return (label == swap.first || label == swap.second) &&
               (swap.placement < 0 || key[0] == swap.placement);
    }

    /// Against each source's median; NaN where nothing is known or the search is over.
    std::vector<double> residualsOf(const Swap* swap) const {
        std::vector<double> residuals(keys_.size(), std::nan(""));
        std::vector<std::vector<double>> by_source(sources_);
        for (size_t i = 0; i < keys_.size(); ++i) {
            Key key = keys_[i];
            if (!free_[i])
                continue;
            if (swap && concerns(*swap, key)) {
                int& label = key[placeOf(swap->kind)];
                label = label == swap->first ? swap->second : swap->first;
            }
            residuals[i] = delays_s_[i] - distances_m_[indexOf(key)] / c_m_per_s_[i];
            if (!std::isnan(residuals[i]))
                by_source[static_cast<size_t>(keys_[i][1])].push_back(residuals[i]);
        }
        std::vector<double> offsets_s;
        for (std::vector<double>& residuals_s : by_source)
            offsets_s.push_back(medianOf(std::move(residuals_s)));
        for (size_t i = 0; i < keys_.size(); ++i)
            residuals[i] -= offsets_s[static_cast<size_t>(keys_[i][1])];
        return residuals;
    }

    /// Pairs of labels that both look suspicious.
    std::vector<Swap> candidates(const std::vector<double>& residuals) const {
        std::vector<Swap> swaps;
        for (const SwapKind kind : {SwapKind::kBoards, SwapKind::kSources, SwapKind::kPlacements})
            for (int placement = -1; placement < std::ssize(labels_); ++placement) {
                if (kind == SwapKind::kPlacements && placement >= 0)
                    break;
                const std::vector<int> suspects = suspiciousLabels(kind, placement, residuals);
                for (size_t i = 0; i < suspects.size(); ++i)
                    for (size_t j = i + 1; j < suspects.size(); ++j)
                        swaps.push_back({kind, suspects[i], suspects[j], placement});
            }
        return swaps;
    }

    std::vector<int> suspiciousLabels(SwapKind kind, int placement,
                                      const std::vector<double>& residuals) const {
        std::map<int, std::vector<double>> by_label;
        for (size_t i = 0; i < keys_.size(); ++i)
            if (!std::isnan(residuals[i]) && (placement < 0 || keys_[i][0] == placement))
                by_label[keys_[i][placeOf(kind)]].push_back(std::abs(residuals[i]));
        std::vector<int> labels;
        for (const auto& [label, values] : by_label)
            if (medianOf(values) > kSuspicious_s)
                labels.push_back(label);
        return labels;
    }

    static double cauchy(double residual_s) {
        return std::log1p(residual_s * residual_s / (kCauchyScale_s * kCauchyScale_s));
    }

    /// How much better everything fits; 0 when what is concerned stays unexplained.
    double gainOf(const Swap& swap, const std::vector<double>& before) const {
        const std::vector<double> after = residualsOf(&swap);
        double gain = 0;
        int concerned = 0, explained = 0;
        for (size_t i = 0; i < keys_.size(); ++i) {
            if (std::isnan(before[i]) || std::isnan(after[i]))
                continue;
            gain += cauchy(before[i]) - cauchy(after[i]);
            if (concerns(swap, keys_[i])) {
                ++concerned;
                explained += std::abs(after[i]) < kExplained_s ? 1 : 0;
            }
        }
        return explained >= kExplainedShare * concerned ? gain : 0;
    }

    std::vector<std::string> labels_;
    std::vector<Key> keys_;
    std::vector<double> delays_s_, c_m_per_s_;
    std::vector<bool> free_;
    size_t sources_, boards_;
    std::vector<double> distances_m_;  ///< by indexOf; NaN: unknown
};

}  // namespace

std::span<const UnitMistake> unitMistakes() {
    return kUnitMistakes;
}

std::optional<UnitMistake> findUnitMistake(const JigData& jig) {
    std::map<int, std::vector<const JigMeasurement*>> by_source;
    for (const JigMeasurement& m : jig.measurements)
        by_source[m.source].push_back(&m);
    // Differences leave no offset; half the list apart they are as long as they can be for all.
    std::vector<double> factors;
    for (auto& [source, measurements] : by_source) {
        std::ranges::sort(measurements, {}, [](const JigMeasurement* m) { return m->distance_m; });
        const size_t half = measurements.size() / 2;
        for (size_t i = 0; half > 0 && i + half < measurements.size(); ++i) {
            const JigMeasurement &near = *measurements[i], &far = *measurements[i + half];
            const double by_sound_m = (far.flight_s - near.flight_s) * far.c_m_per_s;
            if (by_sound_m != 0)
                factors.push_back((far.distance_m - near.distance_m) / by_sound_m);
        }
    }
    const double factor = medianOf(factors);
    for (const UnitMistake& mistake : kUnitMistakes)
        if (std::abs(factor / mistake.factor - 1) < kUnitTolerance)
            return mistake;
    return std::nullopt;
}

std::vector<SwappedLabels> markSwappedLabels(JigData& jig) {
    LabelTrial trial(jig);
    std::vector<SwappedLabels> swaps;
    while (swaps.size() < kMostSwaps) {
        const auto swap = trial.best();
        if (!swap)
            break;
        for (const size_t i : trial.settle(*swap))
            jig.measurements[i].mislabelled = true;
        const auto idOf = [&](int label) {
            const auto at = static_cast<size_t>(label);
            return swap->kind == SwapKind::kBoards    ? jig.suit.boards[at].id
                   : swap->kind == SwapKind::kSources ? jig.suit.sources[at].id
                                                      : trial.labels()[at];
        };
        swaps.push_back({swap->kind, idOf(swap->first), idOf(swap->second),
                         swap->placement < 0 ? "" : trial.labels()[static_cast<size_t>(swap->placement)]});
    }
    return swaps;
}

}  // namespace noctule
