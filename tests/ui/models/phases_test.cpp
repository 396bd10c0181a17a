// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest-spi.h>

#include "tests/ui/support/phase_table.h"
#include "ui/models/live_suit.h"

namespace noctule::ui {
namespace {

using test::before;

TEST(PhasesOfASuit, AreReachedAndLeadBack) {
    using enum LiveSuit::Phase;
    const auto table = LiveSuit::transitions();
    test::expectWhole(table, kNone, 8);
    EXPECT_EQ(before(table, kRecording), std::set{kStarting}) << "a take is begun before it runs";
    EXPECT_FALSE(before(table, kNone).contains(kRecording)) << "a take is saved before the suit is left";
    EXPECT_EQ(before(table, kConnecting), std::set{kNone});
}

TEST(PhasesOfASuit, AStepThatNobodyPlannedFailsATest) {
    expectTransition(LiveSuit::transitions(), LiveSuit::Phase::kStarting, LiveSuit::Phase::kRecording,
                     "suit");
    EXPECT_NONFATAL_FAILURE(expectTransition(LiveSuit::transitions(), LiveSuit::Phase::kNone,
                                             LiveSuit::Phase::kRecording, "suit"),
                            "suit: phase 0 does not lead to phase 5");
}

}  // namespace
}  // namespace noctule::ui
