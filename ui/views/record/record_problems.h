// SPDX-License-Identifier: Apache-2.0
// "To look at" on Record: what hinders the suit and what befalls the take that runs, the worst three as
// cards. A card leaves by itself when its cause is gone.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "ui/models/studio.h"
#include "ui/style/ink.h"
#include "ui/views/readiness_words.h"

class QVBoxLayout;

namespace noctule::ui {

class Label;
class ProblemCard;

class RecordProblems : public QWidget {
    Q_OBJECT
public:
    explicit RecordProblems(Studio& studio, QWidget* parent = nullptr);

    void refresh();
    int count() const { return count_; }
    /// Without what is said of the calibration and its check.
    int countBesideFit() const { return beside_fit_; }
    /// Of what there is.
    Tone worst() const { return worst_; }
    const std::vector<ProblemCard*>& cards() const { return cards_; }

private:
    /// As a card shows it.
    struct Problem {
        Tone tone = Tone::kWarn;
        QString title, text;
        int board = -1;                          ///< that "Show on body" chooses
        std::optional<ReadinessProblem> judged;  ///< that can be accepted
        HindranceWords words;
    };
    std::vector<Problem> ofTake() const;
    std::vector<Problem> ofSuit() const;
    void showCards(const std::vector<Problem>& problems);
    ProblemCard* makeCard(const Problem& problem);

    Studio& studio_;
    QVBoxLayout* column_;
    Label* more_;
    std::vector<ProblemCard*> cards_;
    int count_ = 0, beside_fit_ = 0;
    bool made_while_recording_ = false;  ///< the cards
    Tone worst_ = Tone::kNeutral;
};

}  // namespace noctule::ui
