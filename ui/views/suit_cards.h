// SPDX-License-Identifier: Apache-2.0
// How the suits fare that are connected beside each other: a card per performer with letter, name and
// verdict, the box, and the worst that is wrong. Shows who is looked at; a button shows another one. Hidden
// for one.
#pragma once

#include <QWidget>
#include <vector>

#include "ui/models/capture_context.h"
#include "ui/style/ink.h"

class QVBoxLayout;

namespace noctule::ui {

class ProblemCard;
class SuitStateCard;

/// How one of several suits fares, in a few words each.
struct SuitStateWords {
    int letter = 0;
    QString name, box;
    Tone tone = Tone::kNeutral;
    QString verdict;
    QString problem;  ///< empty: none
    bool is_shown = false;
    bool operator==(const SuitStateWords&) const = default;
};
SuitStateWords suitStateWords(LiveSuits& suits, const SuitInUse& worn);

class SuitCards : public QWidget {
    Q_OBJECT
public:
    explicit SuitCards(CaptureContext& capture, QWidget* parent = nullptr);

    const std::vector<SuitStateWords>& words() const { return words_; }
    const std::vector<SuitStateCard*>& cards() const { return cards_; }
    /// Why they cannot be recorded together; null: they can.
    ProblemCard* apart() const { return apart_; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    void refresh();
    void showApart();

    CaptureContext& capture_;
    QVBoxLayout* column_;
    std::vector<SuitStateCard*> cards_;
    std::vector<SuitStateWords> words_;
    ProblemCard* apart_ = nullptr;
};

}  // namespace noctule::ui
