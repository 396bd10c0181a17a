// SPDX-License-Identifier: Apache-2.0
// Right dock of Record: whether it records well, what to look at, and the numbers behind it.
#pragma once

#include <QTimer>
#include <QWidget>

#include "ui/models/studio.h"
#include "ui/style/ink.h"

namespace noctule::ui {

class Button;
class Label;
class NumberRows;
class RecordProblems;
class SuitCards;
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
    SuitCards& suits() { return *suits_; }
    RecordProblems& problems() { return *problems_; }

protected:
    void showEvent(QShowEvent* event) override;

private:
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
    QString checkedWords() const;
    void showVerdict();
    void showRow();

    Studio& studio_;
    SuitCards* suits_;         ///< of several
    Label* in_row_ = nullptr;  ///< the same
    VerdictHeader* verdict_;
    QString verdict_text_;
    RecordProblems* problems_;
    QWidget* of_suit_;
    NumberRows* numbers_;  ///< a row per Fact
    Label *made_, *offsets_, *boards_, *checked_;
    Button* check_;
    double screen_delay_s_ = 0;
};

}  // namespace noctule::ui
