// SPDX-License-Identifier: Apache-2.0
#include "tests/ui/support/phase_table.h"
#include "ui/wizards/wizard_run.h"

namespace noctule::ui {
namespace {

TEST(PhasesOfACalibration, AreReachedAndLeadBack) {
    using enum WizardRun::Phase;
    const auto table = WizardRun::transitions();
    test::expectWhole(table, kIntro, 5);
    EXPECT_EQ(test::before(table, kResult), std::set{kSolving}) << "of a suit that was left nothing is shown";
    EXPECT_EQ(test::before(table, kTaking), std::set{kGuiding});
}

}  // namespace
}  // namespace noctule::ui
