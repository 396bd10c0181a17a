// SPDX-License-Identifier: Apache-2.0
// Right dock of Record: whether it records well, what to look at, and the numbers behind it.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <optional>
#include <vector>

#include "ui/models/studio.h"
#include "ui/style/ink.h"

class QVBoxLayout;

namespace noctule::ui {

class Label;
class NumberRows;
class ProblemCard;
class VerdictHeader;

class RecordReadiness : public QWidget {
    Q_OBJECT
public:
    explicit RecordReadiness(Studio& studio, QWidget* parent = nullptr);

    enum class Fact { kBoards, kSources, kPairs, kLink, kBattery, kStorage, kAir, kView };
    /// As shown; empty: not known.
    QString value(Fact fact) const;
    /// From a live frame to the screen, in the median.
    void setScreenDelay(double seconds);
    QString verdict() const { return verdict_text_; }
    /// Titles of the cards under "To look at".
    QStringList problems() const;

protected:
    void showEvent(QShowEvent* event) override;

private:
    /// As a card shows it.
    struct Problem {
        Tone tone = Tone::kWarn;
        QString title, text;
        int board = -1;                          ///< that "Show on body" chooses
        std::optional<ReadinessProblem> judged;  ///< that can be accepted
        QString accept;
    };
    void addFacts();
    void setFact(Fact fact, const QString& value, const QString& hint = {}, Tone tone = Tone::kNeutral,
                 double share = -1);
    QWidget* makeCalibration();
    void refresh();
    void showHealth();
    void showLink();
    void showSupplies();
    void showAir();
    void showCalibration();
    std::vector<Problem> problemsNow() const;
    std::vector<Problem> problemsOfTake() const;
    void showVerdict(const std::vector<Problem>& problems);
    void showCards(const std::vector<Problem>& problems);
    ProblemCard* makeCard(const Problem& problem);

    Studio& studio_;
    VerdictHeader* verdict_;
    QString verdict_text_;
    QWidget* to_look_at_;
    QVBoxLayout* cards_;
    Label* more_;
    NumberRows* numbers_;  ///< a row per Fact
    Label *made_, *offsets_, *boards_;
    std::vector<ProblemCard*> shown_;
    QElapsedTimer since_rate_;
    int64_t rate_from_sample_ = 0;
    double megabytes_per_s_ = 0, screen_delay_s_ = 0;
};

}  // namespace noctule::ui
