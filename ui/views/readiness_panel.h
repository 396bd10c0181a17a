// SPDX-License-Identifier: Apache-2.0
// "Am I ready?": the verdict in words, what hinders it by name with what to do, the numbers, and the way on.
#pragma once

#include <QWidget>

#include "ui/models/studio.h"

class QVBoxLayout;

namespace noctule::ui {

class Button;
class NumberRows;
class ProblemCard;
class VerdictHeader;

class ReadinessPanel : public QWidget {
    Q_OBJECT
public:
    explicit ReadinessPanel(Studio& studio, QWidget* parent = nullptr);

    const std::vector<ProblemCard*>& cards() const { return cards_; }
    Button* wayOn() { return way_on_; }
    NumberRows& numbers() { return *numbers_; }
    QString verdict() const { return verdict_text_; }
    /// Stands below the problems where the page has no room for it; null: none.
    void setGuest(QWidget* guest);

signals:
    void boardChosen(int board);
    void putSuitOnRequested();

private:
    void show();
    void showProblems();
    void addCard(const ReadinessProblem& problem);
    void showNumbers();
    void showWayOn();
    QWidget* makeWaysWithoutSuit();

    Studio& studio_;
    VerdictHeader* verdict_;
    QString verdict_text_;
    QWidget* problems_;
    QVBoxLayout *problem_column_, *guest_column_;
    std::vector<ReadinessProblem> shown_;
    std::vector<ProblemCard*> cards_;
    QWidget* ways_;
    Button* more_;
    bool shows_all_ = false;
    NumberRows* numbers_;
    int boards_, sources_, pairs_, battery_, storage_;
    Button* way_on_;
};

}  // namespace noctule::ui
