// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/field_live.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <utility>

#include "ui/models/voice.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"
#include "ui/wizards/field_drawing.h"
#include "ui/wizards/field_heights.h"
#include "ui/wizards/field_words.h"
#include "ui/wizards/headline.h"
#include "ui/wizards/hold_ring.h"
#include "ui/wizards/measure_meter.h"
#include "ui/wizards/sentence_card.h"

namespace noctule::ui {

FieldLive::FieldLive(QWidget* parent)
    : QWidget(parent),
      head_(new Label({}, TextRole::kSection, Ink::kLabel)),
      so_far_(new Label({}, TextRole::kSecondary, Ink::kLabel)),
      instruction_(new Headline),
      drawing_(new FieldDrawing),
      heights_(new FieldHeights),
      card_(new SentenceCard),
      foot_(new Label(tr("The page goes on by itself when every sensor has 90 % of all directions. A sensor "
                         "that stays behind can be done alone afterwards."),
                      TextRole::kSecondary, Ink::kLabel)) {
    // With large text it is higher than a small window and scrolls.
    auto* content = new QWidget;
    makeColumn(this)->addWidget(new ScrollArea(content));
    auto* column = makeColumn(content, {32, 16, 32, 16}, 12);
    auto* head = addRow(column);
    so_far_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    head->addWidget(head_->wrapped(), 1);
    head->addWidget(so_far_);
    column->addWidget(instruction_);
    column->addWidget(drawing_, 1);
    column->addWidget(heights_, 1);
    column->addWidget(card_);
    column->addWidget(makeChecks());
    column->addWidget(foot_->wrapped());
}

QWidget* FieldLive::makeChecks() {
    auto* all = new QWidget;
    auto* row = makeRow(all, {}, 12);
    for (MeasureMeter*& check : checks_) {
        check = new MeasureMeter(MeasureMeter::Form::kBelow);
        row->addWidget(check, 1);
    }
    return all;
}

void FieldLive::setRun(WizardRun* run) {
    run_ = run;
    said_.clear();
    shown_step_ = -1;
    if (!run)
        return;
    connect(run, &WizardRun::changed, this, &FieldLive::refresh);
    connect(run, &WizardRun::guided, this, &FieldLive::refresh);
    refresh();
}

QString FieldLive::instruction() const {
    return instruction_->text();
}

QString FieldLive::sentence() const {
    return card_->sentence();
}

void FieldLive::refresh() {
    const FieldGuide* guide = run_ ? run_->fieldGuide() : nullptr;
    if (!guide)
        return;
    const int step = run_->step();
    const bool turns = step == FieldGuide::kTurn;
    const double share = guide->leastShare();
    head_->setText(turns ? tr("%1 of 100 directions, all sensors").arg(guide->sphere().seen())
                         : run_->stepWords(step).name);
    so_far_->setText(tr("%1 so far").arg(timeText(run_->secondsSoFar(), 0)));
    instruction_->setText(fieldInstruction(*run_));
    drawing_->setVisible(turns);
    heights_->setVisible(!turns);
    foot_->setVisible(turns);
    if (turns)
        drawing_->show(guide->sphere(), guide->sphere().emptySide());
    else
        heights_->show(guide->spot(), step == FieldGuide::kFloor, guide->strongerNow_percent());
    const LiveSentence now = fieldSentence(*run_);
    card_->setSentence(now);
    if (std::exchange(shown_step_, step) != step)
        card_->forgetHeight();
    if (turns)
        card_->ring().showShare(share, now.tone == Tone::kOk ? Tone::kOk : Tone::kAccent);
    else
        card_->ring().show(run_->heldShare(), holdOf(run_->task()), Tone::kOk);
    showChecks();
    // Heard with the bag in both hands and one's back to the screen.
    const bool guides = run_->phase() == WizardRun::Phase::kGuiding;
    if (turns && guides && std::exchange(said_, instruction_->text()) != instruction_->text())
        Voice::get().say(said_);
}

void FieldLive::showChecks() {
    const std::vector<LiveMeasure> now = fieldMeasures(*run_->fieldGuide());
    for (size_t i = 0; i < checks_.size(); ++i)
        checks_[i]->setMeasure(now[i]);
}

}  // namespace noctule::ui
