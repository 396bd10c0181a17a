// SPDX-License-Identifier: Apache-2.0
// What each joint's angle rested on. A range between a source and a microphone depends on the joints on the
// way from the one to the other and on no others (common ancestors cancel); an inertial reading on the joints
// between its board and the root, of which its own segment's joint is told most directly.
#pragma once

#include "core/body/skeleton.h"
#include "core/report/report_data.h"
#include "core/suit/suit.h"

namespace noctule {

/// Of every joint with freedom, the root left out. `pairs` index the suit's sources and boards, as do
/// `board_share` (share of frames with a reading, 0..1). Nothing before the end of the take's rest counts: no
/// range is used until then. A range counts for `hold_s` after its pulse.
std::vector<JointSupport> jointSupport(const Skeleton& skeleton, const Suit& suit,
                                       const std::vector<ReportPair>& pairs,
                                       const std::vector<double>& board_share, const ReportTake& take,
                                       double hold_s = kPairHold_s);

/// A joint lost its ranges (a strap moved, a source fell off) when their share was at least the one before
/// and at most the other after, each over at least kLeastHalf_s.
inline constexpr double kBackedBefore = 0.7, kBackedAfter = 0.25, kLeastHalf_s = 3;

}  // namespace noctule
