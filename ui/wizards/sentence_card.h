// SPDX-License-Identifier: Apache-2.0
// The live sentence of a wizard with its reason, beside the ring that fills; the edge has the colour of the
// tone. What changes ten times a second must not move the drawing above it: the card grows, and keeps its
// height.
#pragma once

#include "ui/style/ink.h"
#include "ui/widgets/card.h"

namespace noctule::ui {

class HoldRing;
class Label;
struct LiveSentence;

class SentenceCard : public Card {
    Q_OBJECT
public:
    explicit SentenceCard(QWidget* parent = nullptr);

    void setSentence(const LiveSentence& now);
    QString sentence() const;
    HoldRing& ring() { return *ring_; }
    /// May be lower again: another step has begun.
    void forgetHeight();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void keepHeight();

    Tone tone_ = Tone::kNeutral;
    HoldRing* ring_;
    Label *sentence_, *detail_;
};

}  // namespace noctule::ui
