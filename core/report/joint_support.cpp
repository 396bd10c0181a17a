// SPDX-License-Identifier: Apache-2.0
#include "core/report/joint_support.h"

#include <algorithm>
#include <set>

namespace noctule {
namespace {

constexpr double kStep_s = 0.032;

/// Joint and all its ancestors; empty for -1.
std::set<int> chainOf(const Skeleton& skeleton, int joint) {
    std::set<int> chain;
    for (int j = joint; j >= 0; j = skeleton.joint(j).parent)
        chain.insert(j);
    return chain;
}

/// Joints that turn the line between two segments; a part fixed in the room (segment -1) sees the whole
/// chain.
std::vector<int> jointsBetween(const Skeleton& skeleton, int a, int b) {
    const std::set<int> one = chainOf(skeleton, a), other = chainOf(skeleton, b);
    std::vector<int> between;
    std::set_symmetric_difference(one.begin(), one.end(), other.begin(), other.end(),
                                  std::back_inserter(between));
    return between;
}

using Covered = std::vector<bool>;  // per step of time

void cover(Covered& covered, const ReportPair& pair, double begin_s, double hold_s) {
    for (const PulseAtBoard& pulse : pair.pulses) {
        const double after_s = pulse.time_s - begin_s;
        if (pulse.fate != PulseFate::kUsed || !(after_s >= 0))
            continue;
        const auto first = static_cast<size_t>(after_s / kStep_s);
        const auto last = std::min(covered.size(), static_cast<size_t>((after_s + hold_s) / kStep_s) + 1);
        for (size_t i = first; i < last; ++i)
            covered[i] = true;
    }
}

/// Finds the time that parts the take into a backed and an unbacked half most clearly.
void findLoss(const Covered& covered, double begin_s, JointSupport& support) {
    const auto least = static_cast<size_t>(kLeastHalf_s / kStep_s);
    const auto total = std::count(covered.begin(), covered.end(), true);
    int64_t before = 0;
    for (size_t i = 0; i + least <= covered.size(); before += covered[i++]) {
        if (i < least)
            continue;
        const double share = static_cast<double>(before) / static_cast<double>(i);
        const double rest = static_cast<double>(total - before) / static_cast<double>(covered.size() - i);
        if (share < kBackedBefore || rest > kBackedAfter || share - rest <= support.lost_share)
            continue;
        support.lost_share = share - rest;
        support.lost_from_s = begin_s + static_cast<double>(i) * kStep_s;
    }
}

double shareOf(const Covered& covered) {
    const auto count = std::count(covered.begin(), covered.end(), true);
    return covered.empty() ? 0 : static_cast<double>(count) / static_cast<double>(covered.size());
}

}  // namespace

std::vector<JointSupport> jointSupport(const Skeleton& skeleton, const Suit& suit,
                                       const std::vector<ReportPair>& pairs,
                                       const std::vector<double>& board_share, const ReportTake& take,
                                       double hold_s) {
    require(board_share.size() == suit.boards.size(), "every board has a share");
    const double begin_s = std::max(take.begin_s, take.rest_s);
    const auto steps = static_cast<size_t>(std::max(0.0, take.afterRest_s()) / kStep_s);
    std::vector<Covered> covered(skeleton.joints().size(), Covered(steps));
    for (const ReportPair& pair : pairs) {
        const Board& board = suit.boards.at(static_cast<size_t>(pair.board));
        const Source& source = suit.sources.at(static_cast<size_t>(pair.source));
        for (const int j :
             jointsBetween(skeleton, skeleton.find(board.segment), skeleton.find(source.segment)))
            cover(covered[static_cast<size_t>(j)], pair, begin_s, hold_s);
    }
    std::vector<JointSupport> support;
    for (int j = 1; j < skeleton.size(); ++j) {
        if (skeleton.joint(j).type == JointType::kFixed)
            continue;
        double readings = 0;
        for (size_t b = 0; b < suit.boards.size(); ++b)
            if (chainOf(skeleton, skeleton.find(suit.boards[b].segment)).contains(j))
                readings = std::max(readings, board_share[b]);
        const double ranges = shareOf(covered[static_cast<size_t>(j)]);
        support.push_back({skeleton.joint(j).name, ranges, readings * (1 - ranges), {}, 0});
        findLoss(covered[static_cast<size_t>(j)], begin_s, support.back());
    }
    return support;
}

}  // namespace noctule
