// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/source_offsets/jig_groups.h"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

namespace noctule {
namespace {

constexpr double kGroupShare = 0.6;
constexpr size_t kLeastOfGroup = 3;
constexpr size_t kMostPairsNamed = 3;

/// -1 and "": any.
using GroupKey = std::tuple<int, int, std::string>;  // source, board, placement

bool belongsTo(const GroupKey& key, const JigMeasurement& m) {
    const auto& [source, board, placement] = key;
    return (source < 0 || source == m.source) && (board < 0 || board == m.board) &&
           (placement.empty() || placement == m.placement);
}

JigGroup groupOf(const JigData& jig, const GroupKey& key, const std::vector<bool>& flagged) {
    const auto& [source, board, placement] = key;
    JigGroup group;
    if (source >= 0)
        group.part = jig.suit.sources[static_cast<size_t>(source)].id;
    else if (board >= 0)
        group.part = jig.suit.boards[static_cast<size_t>(board)].id;
    const std::string part = source >= 0  ? jigSource(jig.suit, source)
                             : board >= 0 ? jigBoard(jig.suit, board)
                                          : "";
    group.words = part.empty() ? "placement " + placement
                               : part + (placement.empty() ? "" : ", in placement " + placement);
    for (size_t i = 0; i < jig.measurements.size(); ++i)
        if (belongsTo(key, jig.measurements[i])) {
            ++group.total;
            if (flagged[i])
                group.flagged.push_back(i);
        }
    return group;
}

/// The largest that is flagged for the most part.
std::optional<JigGroup> largestGroup(const JigData& jig, const std::vector<bool>& flagged) {
    std::map<GroupKey, std::pair<size_t, size_t>> counts;  // flagged, total
    for (size_t i = 0; i < jig.measurements.size(); ++i) {
        const JigMeasurement& m = jig.measurements[i];
        for (const GroupKey& key :
             {GroupKey{m.source, -1, ""}, GroupKey{-1, m.board, ""}, GroupKey{-1, -1, m.placement},
              GroupKey{m.source, -1, m.placement}, GroupKey{-1, m.board, m.placement}}) {
            auto& [flags, total] = counts[key];
            flags += flagged[i] ? 1 : 0;
            ++total;
        }
    }
    const GroupKey* best = nullptr;
    std::pair<size_t, size_t> best_count{kLeastOfGroup - 1, 0};
    for (const auto& [key, count] : counts) {
        const auto& [flags, total] = count;
        const bool mostly = static_cast<double>(flags) >= kGroupShare * static_cast<double>(total);
        const bool larger =
            flags > best_count.first || (best && flags == best_count.first && total < best_count.second);
        if (mostly && larger) {
            best = &key;
            best_count = count;
        }
    }
    return best ? std::optional(groupOf(jig, *best, flagged)) : std::nullopt;
}

JigGroup singlePairs(const JigData& jig, const std::vector<bool>& flagged) {
    JigGroup group;
    group.total = jig.measurements.size();
    for (size_t i = 0; i < flagged.size(); ++i)
        if (flagged[i]) {
            const JigMeasurement& m = jig.measurements[i];
            if (group.flagged.size() < kMostPairsNamed)
                group.words += (group.flagged.empty() ? "" : "; ") + jigSource(jig.suit, m.source) + " to " +
                               jigBoard(jig.suit, m.board) + ", in placement " + m.placement;
            group.flagged.push_back(i);
        }
    if (group.flagged.size() > kMostPairsNamed)
        group.words += " and " + std::to_string(group.flagged.size() - kMostPairsNamed) + " more";
    return group;
}

}  // namespace

std::vector<JigGroup> groupFlagged(const JigData& jig, std::vector<bool> flagged) {
    std::vector<JigGroup> groups;
    while (const auto group = largestGroup(jig, flagged)) {
        for (const size_t i : group->flagged)
            flagged[i] = false;
        groups.push_back(*group);
    }
    if (JigGroup pairs = singlePairs(jig, flagged); !pairs.flagged.empty())
        groups.push_back(std::move(pairs));
    return groups;
}

}  // namespace noctule
