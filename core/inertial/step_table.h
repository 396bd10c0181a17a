// SPDX-License-Identifier: Apache-2.0
// The companded steps of the delta code: small steps exactly, large ones to about 10 %. Counts of a 12-bit
// reading. core/inertial/README.md section 3.
#pragma once

#include <array>

namespace noctule {

/// Step of each 6-bit code.
inline constexpr std::array<int, 64> kSteps = {
    0,     1,     2,     3,     4,    5,    6,    8,    10,   12,   15,   19,   24,   30,   37,   46,
    58,    73,    91,    114,   142,  178,  222,  278,  347,  434,  543,  679,  849,  1061, 1326, 1658,
    -2048, -1658, -1326, -1061, -849, -679, -543, -434, -347, -278, -222, -178, -142, -114, -91,  -73,
    -58,   -46,   -37,   -30,   -24,  -19,  -15,  -12,  -10,  -8,   -6,   -5,   -4,   -3,   -2,   -1};

/// The reconstruction after a step: x + kSteps[code], saturating at 0 and 4095.
int stepped(int reconstruction, int code);

/// The code that brings the reconstruction nearest to the target (any value); of equals the smallest step.
int nearestCode(int reconstruction, int target);

/// Standard deviation, counts, of what one frame's code rounds away of a finite step of about that size:
/// uniform between the midpoints to the neighbouring table entries, so 0.29 (the reading's own rounding) for
/// small steps. The next frame pays it back: the noise of successive readings is differenced, not white.
double codecRoundingSigmaCounts(double step_counts);

}  // namespace noctule
