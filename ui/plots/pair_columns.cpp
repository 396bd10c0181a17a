// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/pair_columns.h"

#include "ui/models/part_names.h"

namespace noctule::ui {

std::vector<PairColumnGroup> columnGroups(const Suit& suit) {
    std::vector<PairColumnGroup> groups;
    for (int b = 0; b < static_cast<int>(suit.boards.size()); ++b) {
        const QString name = groupName(groupOfSegment(suit.boards[static_cast<size_t>(b)].segment));
        if (groups.empty() || groups.back().name != name)
            groups.push_back({name, b, b});
        groups.back().last = b;
    }
    return groups;
}

}  // namespace noctule::ui
