// SPDX-License-Identifier: Apache-2.0
#include "core/guide/stand_guide.h"

namespace noctule {
Hindrance StandGuide::see(const HealthReport& health, Guidance& guidance) {
    const std::vector<int> heard = heardBoards(health, guidance);
    for (const int board : heard) {
        const BoardHealth::Means& means = *health.boards[index(board)].means;
        const bool calm = means.gyro_deviation_rad_per_s < kSway_rad_per_s &&
                          means.accel_deviation_m_per_s2 < kSway_m_per_s2;
        guidance.boards[index(board)] = calm ? GuidedBoard::kRight : GuidedBoard::kMoves;
    }
    if (heard.empty())
        return Hindrance::kNoReadings;
    guidance.step = 0;
    return Hindrance::kNone;
}

}  // namespace noctule
