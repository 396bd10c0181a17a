// SPDX-License-Identifier: Apache-2.0
#include "core/guide/stand_guide.h"

namespace noctule {
namespace {

/// Breathing and sway; a step or a raised arm is ten times that.
constexpr double kSway_rad_per_s = 0.1, kSway_m_per_s2 = 0.5;

}  // namespace

Hindrance StandGuide::see(const HealthReport& health, Guidance& guidance) {
    bool any = false;
    for (int board = 0; board < boardCount(); ++board) {
        if (!isHeard(health, board))
            continue;
        any = true;
        const BoardHealth::Means& means = *health.boards[index(board)].means;
        guidance.boards[index(board)] = means.gyro_deviation_rad_per_s < kSway_rad_per_s &&
                                                means.accel_deviation_m_per_s2 < kSway_m_per_s2
                                            ? GuidedBoard::kRight
                                            : GuidedBoard::kMoves;
    }
    if (!any)
        return Hindrance::kNoReadings;
    guidance.step = 0;
    return Hindrance::kNone;
}

}  // namespace noctule
