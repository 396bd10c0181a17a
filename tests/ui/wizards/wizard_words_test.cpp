// SPDX-License-Identifier: Apache-2.0
// The first page of a wizard, before Begin: its headline, and what the rail shows.
#include <QLabel>
#include <set>

#include "tests/ui/wizards/wizard_flow.h"

namespace noctule::ui {
namespace {

using WizardWordsTest = test::WizardFlow;

TEST_F(WizardWordsTest, TheHeadlineSaysWhatToDo) {
    const std::set<QString> verbs{"Put", "Press", "Stand"};
    for (const WizardTask task : kWizardTasks) {
        page_->open(task);
        const QString headline = wordsOf(task).headline;
        EXPECT_TRUE(verbs.contains(headline.section(' ', 0, 0))) << headline.toStdString();
        EXPECT_FALSE(headline.endsWith('.')) << headline.toStdString();
        const auto labels = page_->wizard().intro().findChildren<QLabel*>();
        EXPECT_TRUE(std::ranges::any_of(labels, [&](const QLabel* label) {
            return label->text() == headline;
        })) << headline.toStdString();
        page_->closeWizard();
    }
}

TEST_F(WizardWordsTest, ALevelTableIsFoundWithASpiritLevel) {
    EXPECT_TRUE(
        wordsOf(WizardTask::kAccelerometers)
            .needs.contains("A level table (use a spirit level), and a square block to lean the plate on"));
}

TEST_F(WizardWordsTest, WhatCountsByItselfSaysThatItDoesAfterBegin) {
    for (const WizardTask task : {WizardTask::kRestPose, WizardTask::kCheck})
        EXPECT_TRUE(wordsOf(task).in_any_order.startsWith("After Begin it counts by itself"))
            << wordsOf(task).in_any_order.toStdString();
}

TEST_F(WizardWordsTest, TheRailSaysBeforeBeginWhatIsNeededAndWhatComes) {
    connectRig({"--rig", "level"});
    page_->open(WizardTask::kAccelerometers);
    ASSERT_EQ(run().phase(), test::Phase::kIntro);
    QStringList shown;
    for (const RailStep* step : page_->wizard().rail()->findChildren<RailStep*>())
        if (!step->isHidden())
            shown << step->accessibleName();
    ASSERT_EQ(shown.size(), 2) << shown.join("; ").toStdString();
    EXPECT_TRUE(shown[0].startsWith("What you need, about 4 minutes")) << shown[0].toStdString();
    EXPECT_TRUE(shown[1].startsWith("Result")) << shown[1].toStdString();
}

}  // namespace
}  // namespace noctule::ui
