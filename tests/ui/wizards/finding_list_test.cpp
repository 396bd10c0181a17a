// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/finding_list.h"

#include <gtest/gtest.h>

#include <QApplication>

#include "tests/ui/support/wait.h"
#include "ui/style/theme.h"
#include "ui/widgets/button.h"
#include "ui/widgets/problem_card.h"

namespace noctule::ui {
namespace {

QStringList titlesSeen(const FindingList& list) {
    QStringList titles;
    for (const ProblemCard* card : list.findChildren<ProblemCard*>())
        if (card->isVisibleTo(&list))
            titles += card->title();
    return titles;
}

QString clickOn(const FindingList& list) {
    auto* more = list.findChild<Button*>();
    const QString text = more ? more->text() : QString();
    if (more)
        more->click();
    return text;
}

TEST(FindingList, OfFiveFindingsTheFirstThreeAreShownUntilAllAreAskedFor) {
    Theme::install(*qApp);
    std::vector<Finding> findings;
    QStringList all;
    for (int i = 1; i <= 5; ++i) {
        findings.push_back({Grade::kUsable, "", "Board " + std::to_string(i) + " stands out", "Repeat it"});
        all += QString("Board %1 stands out").arg(i);
    }
    FindingList list;
    list.setFindings(findings);
    EXPECT_EQ(titlesSeen(list), all.mid(0, 3));
    EXPECT_EQ(clickOn(list), "2 more");
    EXPECT_TRUE(waitFor([&] { return titlesSeen(list) == all; }));
    list.setFindings(findings);
    EXPECT_EQ(titlesSeen(list), all) << "the choice stays";
    EXPECT_EQ(clickOn(list), "Show the worst only");
    EXPECT_TRUE(waitFor([&] { return titlesSeen(list) == all.mid(0, 3); }));
    findings.resize(3);
    list.setFindings(findings);
    EXPECT_EQ(titlesSeen(list), all.mid(0, 3));
    EXPECT_EQ(list.findChild<Button*>(), nullptr) << "nothing more to show";
}

}  // namespace
}  // namespace noctule::ui
