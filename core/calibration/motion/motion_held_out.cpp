// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/motion/motion_held_out.h"

#include <algorithm>
#include <cmath>

#include "core/job/staged_progress.h"

namespace noctule {
namespace {

constexpr double kTaughtShare = 0.65;  // of the movement of each take
constexpr int kTeachingIterations = 8, kTryingIterations = 3;

struct Slices {
    std::vector<MotionEvidence> takes{};
    std::vector<MotionNode> nodes{};
};

/// Of every take the part of its movement between two shares.
Slices sliced(const HeldOutProblem& problem, double from_share, double to_share) {
    Slices slices;
    auto first = problem.found.nodes.begin();
    for (const MotionEvidence& take : problem.takes) {
        const int rest = take.rests.front().count, moved = take.nodes - rest;
        const auto at = [&](double share) { return rest + static_cast<int>(std::lround(share * moved)); };
        std::vector<MotionNode> nodes(first, first + take.nodes);
        first += take.nodes;
        slices.takes.push_back(slicedEvidence(take, at(from_share), at(to_share), nodes));
        slices.nodes.insert(slices.nodes.end(), nodes.begin(), nodes.end());
    }
    return slices;
}

}  // namespace

MotionEvidence slicedEvidence(const MotionEvidence& evidence, int from, int to,
                              std::vector<MotionNode>& nodes) {
    const int rest = evidence.rests.front().count, shift = from - rest;
    const auto contains = [&](int node) { return (node >= 0 && node < rest) || (node >= from && node < to); };
    const auto moved = [&](int node) { return node < rest ? node : node - shift; };
    const bool seam = shift > 0;
    MotionEvidence slice;
    slice.begin_s = evidence.begin_s;
    slice.step_s = evidence.step_s;
    slice.nodes = rest + to - from;
    slice.heard_share = evidence.heard_share;
    for (const NodeSpan& span : evidence.rests)
        if (contains(span.first) && contains(span.first + span.count - 1))
            slice.rests.push_back({moved(span.first), span.count});
    for (size_t b = 0; b < evidence.turns.size(); ++b) {
        slice.turns.emplace_back();
        slice.forces.emplace_back();
        for (int k = 0; k < evidence.nodes; ++k) {
            if (!contains(k))
                continue;
            slice.forces.back().push_back(evidence.forces[b][static_cast<size_t>(k)]);
            const bool is_end = moved(k) == 0 || moved(k) + 1 == slice.nodes;
            if (is_end || (seam && (moved(k) == rest - 1 || moved(k) == rest)))
                slice.forces.back().back().heard = false;
            if (moved(k) + 1 == slice.nodes)
                continue;
            slice.turns.back().push_back(evidence.turns[b][static_cast<size_t>(k)]);
            if (seam && moved(k) == rest - 1)
                slice.turns.back().back().heard = false;
        }
    }
    for (const HeardDistance& heard : evidence.distances)
        if (contains(heard.node - 1) && contains(heard.node) && contains(heard.node + 1) &&
            moved(heard.node + 1) - moved(heard.node - 1) == 2 &&
            !(seam && std::abs(moved(heard.node) - rest) <= 1)) {
            slice.distances.push_back(heard);
            slice.distances.back().node = moved(heard.node);
        }
    std::vector<MotionNode> kept;
    for (int k = 0; k < evidence.nodes; ++k)
        if (contains(k))
            kept.push_back(nodes[static_cast<size_t>(k)]);
    nodes = std::move(kept);
    return slice;
}

Result<HeldOutCheck> checkOnHeldOut(const HeldOutProblem& problem, const JobContext& job) {
    HeldOutCheck check;
    const Slices taught = sliced(problem, 0, kTaughtShare), held = sliced(problem, kTaughtShare, 1);
    MotionSettings teaching = problem.settings;
    teaching.most_iterations = kTeachingIterations;
    MotionUnknowns start = problem.found;
    start.nodes = taught.nodes;
    MotionFit fit(problem.body, problem.model, problem.layout, teaching, taught.takes, problem.expected);
    auto learnt = fit.run(std::move(start), StagedProgress(job, 0, 0.6).job());
    if (!learnt)
        return learnt.error();

    MotionSettings trying = problem.settings;
    trying.most_iterations = kTryingIterations;
    std::vector<double> costs[2];
    for (const bool is_learnt : {true, false}) {
        MotionUnknowns tried = is_learnt ? learnt->unknowns : problem.rest_pose;
        tried.nodes = held.nodes;
        const ExpectedConstants expected{tried.boards, problem.expected.sources,
                                         std::vector<bool>(tried.boards.size(), true)};
        MotionFit trial(problem.body, problem.model, problem.layout, trying, held.takes, expected);
        trial.keepNoise(fit.noise());
        auto result = trial.run(std::move(tried),
                                StagedProgress(job, is_learnt ? 0.6 : 0.8, is_learnt ? 0.8 : 1).job());
        if (!result)
            return result.error();
        costs[is_learnt ? 1 : 0] = std::move(result->board_cost);
    }
    for (size_t b = 0; b < costs[0].size(); ++b)
        check.cost_ratio.push_back(costs[0][b] > 0 && std::isfinite(costs[1][b]) ? costs[1][b] / costs[0][b]
                                                                                 : 1);
    return check;
}

}  // namespace noctule
