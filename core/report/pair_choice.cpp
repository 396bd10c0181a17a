// SPDX-License-Identifier: Apache-2.0
#include "core/report/pair_choice.h"

#include <algorithm>

namespace noctule {
namespace {

const ReportPair* findPair(const ReportData& data, int source, int board) {
    const auto found = std::find_if(data.pairs.begin(), data.pairs.end(), [&](const ReportPair& p) {
        return p.source == source && p.board == board && !p.pulses.empty();
    });
    return found == data.pairs.end() ? nullptr : &*found;
}

std::vector<int> boardsOfFigure5(const std::vector<ReportBoard>& boards) {
    std::vector<int> chosen;
    for (const char* segment : {"Chest", "LeftUpLeg", "LeftFoot"})
        for (size_t b = 0; b < boards.size(); ++b)
            if (boards[b].segment == segment) {
                chosen.push_back(static_cast<int>(b));
                break;
            }
    for (int b = 0; chosen.size() < 3 && b < static_cast<int>(boards.size()); ++b)
        if (std::find(chosen.begin(), chosen.end(), b) == chosen.end())
            chosen.push_back(b);
    return chosen;
}

std::string groupOf(const std::string& segment) {
    if (segment.empty())
        return "Room";
    const bool left = segment.starts_with("Left"), right = segment.starts_with("Right");
    if (!left && !right)
        return "Trunk";
    const bool leg = segment.ends_with("Leg") || segment.ends_with("Foot") || segment.ends_with("ToeBase");
    return std::string(left ? "Left " : "Right ") + (leg ? "leg" : "arm");
}

}  // namespace

std::vector<const ReportPair*> chosenPairs(const ReportData& data) {
    std::vector<std::pair<int, int>> wanted = data.chosen_pairs;
    if (wanted.empty() && !data.sources.empty())
        for (const int board : boardsOfFigure5(data.boards)) {
            wanted.emplace_back(0, board);
            if (data.sources.size() > 1)
                wanted.emplace_back(static_cast<int>(data.sources.size()) - 1, board);
        }
    std::vector<const ReportPair*> pairs;
    for (const auto& [source, board] : wanted)
        if (const ReportPair* pair = findPair(data, source, board))
            pairs.push_back(pair);
    return pairs;
}

std::vector<BoardGroup> boardGroups(const ReportData& data) {
    std::vector<BoardGroup> groups;
    for (int b = 0; b < static_cast<int>(data.boards.size()); ++b) {
        const std::string name = groupOf(data.boards[static_cast<size_t>(b)].segment);
        if (groups.empty() || groups.back().name != name)
            groups.push_back({name, b, b});
        groups.back().last = b;
    }
    return groups;
}

}  // namespace noctule
