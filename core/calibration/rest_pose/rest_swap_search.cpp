// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/rest_pose/rest_swap_search.h"

#include <algorithm>
#include <cmath>

namespace noctule {
namespace {

constexpr int kMostSwapIterations = 40, kQuickIterations = 1;
constexpr size_t kFinalists = 20;
constexpr double kHopeless = 20;
constexpr size_t kMostExplanations = 6;
// -2 log of the odds: one swap in a thousand takes, and 153 pairs to choose from.
constexpr double kSwapMustGain = 12;
// The same and the freedom to fit anything: three coordinates, each twenty times wider.
constexpr double kShiftMustGain = 25;
constexpr double kRivalWithin = 8, kUntoldWithin = 8;
constexpr double kAnyShift_m = 0.2;
constexpr size_t kDistancesForShift = 3;

struct RestHypothesis {
    enum class Kind { kSwap, kBoardShifted, kSourceShifted } kind = Kind::kSwap;
    SwappedBoards swap;
    int part = 0;  ///< board or source that is elsewhere
    Arrangement arrangement;
    RestPriors priors;
    RestEvidence evidence;
    RestFit fit;
    double cost = 0;

    double mustGain() const { return kind == Kind::kSwap ? kSwapMustGain : kShiftMustGain; }
};

class RestSearch {
public:
    RestSearch(const RestPoseFit& fitter, const RestEvidenceMaker& maker, const RestSight& sight,
               const RestPriors& priors)
        : fitter_(fitter), maker_(maker), sight_(sight) {
        best_.arrangement = maker.asDescribed();
        best_.priors = priors;
        best_.evidence = maker.make(best_.arrangement);
        best_.fit = fitter.fit(priors, best_.evidence, kMostSwapIterations);
        best_.cost = best_.fit.cost + arrangementCost(best_.arrangement);
    }

    Result<RestExplanation> run(const JobContext& job) {
        for (size_t round = 0; round < kMostExplanations; ++round) {
            job.progress(static_cast<double>(round) / kMostExplanations, "Rest pose: comparing boards");
            std::vector<RestHypothesis> hypotheses = listHypotheses();
            for (RestHypothesis& hypothesis : hypotheses) {
                if (job.cancelled())
                    return JobContext::cancelledError();
                tryOut(hypothesis, kQuickIterations);
            }
            std::ranges::sort(hypotheses, {}, rank);
            hypotheses.resize(std::min(hypotheses.size(), kFinalists));
            for (RestHypothesis& hypothesis : hypotheses)
                tryOut(hypothesis, kMostSwapIterations);
            std::ranges::sort(hypotheses, {}, rank);
            if (!acceptBest(hypotheses))
                break;
        }
        return best_;
    }

private:
    double arrangementCost(const Arrangement& arrangement) const {
        double cost = sight_.cost(arrangement);
        for (const StreamPlace& board : arrangement)
            cost += maker_.sensorCost(board);
        return cost;
    }

    static double rank(const RestHypothesis& h) { return h.cost + h.mustGain(); }

    /// Goes on from an earlier try.
    void tryOut(RestHypothesis& h, int iterations) const {
        const bool begun = h.fit.iterations > 0;
        h.fit = fitter_.fit(h.priors, h.evidence, iterations, begun ? &h.fit : nullptr);
        h.cost = h.fit.cost + arrangementCost(h.arrangement);
    }

    bool isSwapped(int board) const { return best_.arrangement[static_cast<size_t>(board)].stream != board; }

    bool hasEvidence(int board) const {
        const auto tells = [board](const auto& evidence) { return evidence.board == board; };
        return std::ranges::any_of(best_.evidence.ups, tells) ||
               std::ranges::any_of(best_.evidence.distances, tells);
    }

    void addSwaps(std::vector<RestHypothesis>& into) const {
        const int boards = static_cast<int>(best_.arrangement.size());
        for (int a = 0; a < boards; ++a)
            for (int b = a + 1; b < boards; ++b)
                if (!isSwapped(a) && !isSwapped(b) && hasEvidence(a) && hasEvidence(b)) {
                    into.push_back(swapOf(a, b, false));
                    if (!maker_.sameCalibration(a, b) &&
                        maker_.sensorCost({b, a}) + maker_.sensorCost({a, b}) <
                            maker_.sensorCost({a, a}) + maker_.sensorCost({b, b}) + kHopeless)
                        into.push_back(swapOf(a, b, true));
                }
    }

    RestHypothesis swapOf(int a, int b, bool plugs) const {
        RestHypothesis h;
        h.swap = {a, b, plugs, 0};
        h.arrangement = best_.arrangement;
        h.arrangement[static_cast<size_t>(a)] = {b, plugs ? a : b};
        h.arrangement[static_cast<size_t>(b)] = {a, plugs ? b : a};
        h.priors = best_.priors;
        h.evidence = maker_.make(h.arrangement);
        return h;
    }

    std::vector<RestHypothesis> listHypotheses() const {
        std::vector<RestHypothesis> hypotheses;
        addSwaps(hypotheses);
        const auto heard = [&](auto part, int index) {
            return std::ranges::count(best_.evidence.distances, index, part) >=
                   static_cast<std::ptrdiff_t>(kDistancesForShift);
        };
        const auto elsewhere = [&](RestHypothesis::Kind kind, int part) {
            RestHypothesis h{kind, {}, part, best_.arrangement, best_.priors, best_.evidence, {}, 0};
            hypotheses.push_back(std::move(h));
            return &hypotheses.back().priors;
        };
        for (int b = 0; b < static_cast<int>(best_.priors.boards.size()); ++b)
            if (heard(&DistanceEvidence::board, b) && !std::ranges::count(best_.shifted_boards, b))
                elsewhere(RestHypothesis::Kind::kBoardShifted, b)
                    ->boards[static_cast<size_t>(b)]
                    .sigma_shift_m = kAnyShift_m;
        for (int s = 0; s < static_cast<int>(best_.priors.sources.size()); ++s)
            if (heard(&DistanceEvidence::source, s) && !std::ranges::count(best_.shifted_sources, s))
                elsewhere(RestHypothesis::Kind::kSourceShifted, s)
                    ->sources[static_cast<size_t>(s)]
                    .sigma_shift_m = kAnyShift_m;
        return hypotheses;
    }

    void noteUntold(const std::vector<RestHypothesis>& hypotheses) {
        best_.untold.clear();
        for (const RestHypothesis& h : hypotheses)
            if (h.kind == RestHypothesis::Kind::kSwap && !h.swap.plugs && h.cost < best_.cost + kUntoldWithin)
                best_.untold.push_back({h.swap.first, h.swap.second, false, best_.cost - h.cost});
    }

    /// False when nothing explains more than what is known.
    bool acceptBest(std::vector<RestHypothesis>& finalists) {
        noteUntold(finalists);
        if (finalists.empty() || best_.cost - finalists.front().cost < finalists.front().mustGain())
            return false;
        accept(finalists.front(), finalists);
        return true;
    }

    void accept(RestHypothesis& chosen, const std::vector<RestHypothesis>& finalists) {
        if (chosen.kind == RestHypothesis::Kind::kSwap) {
            chosen.swap.likelihood_gain = best_.cost - chosen.cost;
            for (const RestHypothesis& h : finalists)
                if (h.kind == chosen.kind && h.cost - chosen.cost < kRivalWithin &&
                    !samePair(h.swap, chosen.swap))
                    best_.rivals.push_back({h.swap.first, h.swap.second, h.swap.plugs, best_.cost - h.cost});
            best_.swapped.push_back(chosen.swap);
        } else {
            (chosen.kind == RestHypothesis::Kind::kBoardShifted ? best_.shifted_boards
                                                                : best_.shifted_sources)
                .push_back(chosen.part);
        }
        best_.arrangement = std::move(chosen.arrangement);
        best_.priors = std::move(chosen.priors);
        best_.evidence = std::move(chosen.evidence);
        best_.fit = std::move(chosen.fit);
        best_.cost = chosen.cost;
    }

    static bool samePair(const SwappedBoards& a, const SwappedBoards& b) {
        return a.first == b.first && a.second == b.second;
    }

    const RestPoseFit& fitter_;
    const RestEvidenceMaker& maker_;
    const RestSight& sight_;
    RestExplanation best_;
};

}  // namespace

Result<RestExplanation> explainRest(const RestPoseFit& fitter, const RestEvidenceMaker& maker,
                                    const RestSight& sight, const RestPriors& priors, const JobContext& job) {
    return RestSearch(fitter, maker, sight, priors).run(job);
}

}  // namespace noctule
