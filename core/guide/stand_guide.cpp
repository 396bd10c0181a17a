// SPDX-License-Identifier: Apache-2.0
#include "core/guide/stand_guide.h"

namespace noctule {
Hindrance StandGuide::see(const HealthReport& health, Guidance& guidance) {
    const std::vector<int> heard = heardBoards(health, guidance);
    for (const int board : heard) {
        const bool calm = isCalm(*health.boards[index(board)].means);
        guidance.boards[index(board)] = calm ? GuidedBoard::kRight : GuidedBoard::kMoves;
    }
    if (heard.empty())
        return Hindrance::kNoReadings;
    guidance.step = 0;
    return Hindrance::kNone;
}

}  // namespace noctule
