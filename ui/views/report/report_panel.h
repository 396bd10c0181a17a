// SPDX-License-Identifier: Apache-2.0
// Right dock of Review: is the take good? Verdict, problems, four numbers, joints, and at the bottom the way
// on: Export.
#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "ui/models/review_context.h"
#include "ui/views/review_words.h"

class QBoxLayout;

namespace noctule::ui {

class Button;
class BetweenPanel;
class EmptyState;
class JointTable;
class Label;
class ProblemCard;
class ValueCard;
class VerdictHeader;

class ReportPanel : public QWidget {
    Q_OBJECT
public:
    explicit ReportPanel(ReviewContext& review, QWidget* parent = nullptr);

    JointTable& joints() { return *joints_; }
    /// The first few as cards; how many more the full report has.
    void showProblems(const std::vector<ProblemWords>& problems);

signals:
    void fullReportWanted();
    void exportWanted();
    void processingWanted();
    void gyroscopesWanted();  ///< processing with them

private:
    QWidget* makeNumbers();
    void refresh();
    void showVerdict(const TakeVerdict& verdict);
    void showFeet();
    void goTo(const ProblemWords& problem);

    ReviewContext& review_;
    VerdictHeader* verdict_;
    EmptyState* empty_;
    QWidget *judged_, *problems_;
    QBoxLayout* problems_column_;
    Label* more_problems_;
    std::array<ValueCard*, 4> cards_;
    BetweenPanel* between_;
    JointTable* joints_;
    Label *slide_, *drift_, *contacts_;
    Button *full_report_, *export_;
};

}  // namespace noctule::ui
