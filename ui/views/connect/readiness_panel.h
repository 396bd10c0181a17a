// SPDX-License-Identifier: Apache-2.0
// "Am I ready?": the verdict in words, what hinders it by name with what to do, the numbers, and the way on.
#pragma once

#include <QWidget>

#include "ui/models/capture_context.h"
#include "ui/views/readiness_words.h"

class QVBoxLayout;

namespace noctule::ui {

class Button;
class NewerValues;
class NumberRows;
class ProblemCard;
class SuitCards;
class VerdictHeader;

class ReadinessPanel : public QWidget {
    Q_OBJECT
public:
    explicit ReadinessPanel(CaptureContext& capture, QWidget* parent = nullptr);

    const std::vector<ProblemCard*>& cards() const { return cards_; }
    Button* wayOn() { return way_on_; }
    NewerValues& newer() { return *newer_; }
    /// Connects the box that was found; hidden when there is none.
    Button* connectButton() { return connect_; }
    QString verdictText() const { return verdict_sentences_; }
    NumberRows& numbers() { return *numbers_; }
    QString verdict() const { return verdict_text_; }
    /// Stands below the problems where the page has no room for it; null: none.
    void setGuest(QWidget* guest);

signals:
    void boardChosen(int board);
    void putSuitOnRequested();

private:
    void show();
    void showVerdict();
    void showProblems();
    void addCard(const ReadinessProblem& problem);
    void repair(Repair repair, const ReadinessProblem& problem);
    void showBlinking();
    void showCalibration();
    void showWaysWithoutSuit();
    void showNumbers();
    void showWayOn();
    QWidget* makeWaysWithoutSuit();

    CaptureContext& capture_;
    SuitCards* suits_;  ///< of several
    VerdictHeader* verdict_;
    QString verdict_text_, verdict_sentences_;
    QWidget* problems_;
    QVBoxLayout *problem_column_, *guest_column_;
    NewerValues* newer_;
    std::vector<ReadinessProblem> shown_;
    std::vector<ProblemCard*> cards_;
    std::vector<std::pair<Button*, ReadinessProblem>> blink_buttons_;
    Button *connect_ = nullptr, *start_virtual_ = nullptr, *start_virtual_beside_ = nullptr;
    QString found_address_;
    QWidget* ways_;
    Button* more_;
    bool shows_all_ = false;
    NumberRows* numbers_;
    int boards_, sources_, pairs_, battery_, storage_, calibration_;
    Button* way_on_;
    Step way_on_to_ = Step::kRecord;
};

}  // namespace noctule::ui
