// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/support/phase_table.h"
#include "ui/views/record/record_run.h"

namespace noctule::ui {
namespace {

TEST(PhasesOfARecording, AreReachedAndLeadBack) {
    using enum RecordRun::State;
    const auto table = RecordRun::transitions();
    test::expectWhole(table, kNoSuit, 6);
    EXPECT_EQ(test::before(table, kCountdown), (std::set{kReady, kRefused}));
    EXPECT_EQ(test::before(table, kRecording), (std::set{kReady, kRefused, kCountdown}))
        << "the take before is saved first";
}

}  // namespace
}  // namespace noctule::ui
