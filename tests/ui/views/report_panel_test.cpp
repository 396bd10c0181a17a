// SPDX-License-Identifier: Apache-2.0
#include "ui/views/report/report_panel.h"

#include <QLabel>

#include "tests/ui/views/reviewed_session.h"
#include "ui/style/theme.h"
#include "ui/widgets/button.h"
#include "ui/widgets/problem_card.h"

namespace noctule::ui {
namespace {

using ReportPanelTest = test::ReviewedSession;

TEST_F(ReportPanelTest, OfFiveProblemsThreeAreCardsAndTheFullReportHasTheRest) {
    openTake("swing_001");
    ReportPanel panel(*studio_);
    std::vector<ProblemWords> problems(5);
    QStringList all;
    for (ProblemWords& problem : problems) {
        problem.title = QString("Problem %1").arg(all.size() + 1);
        all += problem.title;
    }
    const auto says = [&](const QString& words) {
        const auto labels = panel.findChildren<QLabel*>();
        return std::ranges::any_of(
            labels, [&](const QLabel* label) { return !label->isHidden() && label->text().contains(words); });
    };
    const auto titles = [&] {
        QStringList shown;
        for (const ProblemCard* card : panel.findChildren<ProblemCard*>())
            shown += card->title();
        return shown;
    };
    panel.showProblems(problems);
    EXPECT_EQ(titles(), all.mid(0, 3));
    EXPECT_TRUE(says("2 more in the full report"));
    bool wanted = false;
    QObject::connect(&panel, &ReportPanel::fullReportWanted, &panel, [&] { wanted = true; });
    for (Button* button : panel.findChildren<Button*>())
        if (button->text() == "Open full report" && !button->isHidden())
            button->click();
    EXPECT_TRUE(wanted);
    problems.resize(3);
    panel.showProblems(problems);
    EXPECT_EQ(titles(), all.mid(0, 3));
    EXPECT_FALSE(says("in the full report"));
}

}  // namespace
}  // namespace noctule::ui
