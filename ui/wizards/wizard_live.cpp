// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/wizard_live.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "ui/models/capture_context.h"
#include "ui/models/part_names.h"
#include "ui/style/words.h"
#include "ui/views/body_figure.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/label.h"
#include "ui/wizards/hold_ring.h"
#include "ui/wizards/measure_meter.h"
#include "ui/wizards/rig_drawing.h"
#include "ui/wizards/tone_card.h"
#include "ui/wizards/wizard_words.h"

namespace noctule::ui {
namespace {

BoardMark markOf(const WizardRun& run, int board) {
    const Guide& guide = *run.guide();
    const Guidance& now = guide.guidance();
    if (guide.isSkipped(board))
        return BoardMark::kSkipped;
    if (now.boards.empty())
        return BoardMark::kWaiting;
    switch (now.boards[static_cast<size_t>(board)]) {
        case GuidedBoard::kAbsent:
            return BoardMark::kAbsent;
        case GuidedBoard::kMoves:
            return BoardMark::kWaiting;
        case GuidedBoard::kElsewhere:
        case GuidedBoard::kAskew:
        case GuidedBoard::kIdle:
            return BoardMark::kWrong;
        case GuidedBoard::kRight:
            break;
    }
    return guide.isDone(run.step(), board) ? BoardMark::kDone : BoardMark::kRight;
}

}  // namespace

WizardLive::WizardLive(CaptureContext& capture, QWidget* parent)
    : QWidget(parent),
      capture_(capture),
      step_(new Label({}, TextRole::kSection, Ink::kLabel)),
      so_far_(new Label({}, TextRole::kSecondary, Ink::kLabel)),
      instruction_(new Label({}, TextRole::kInstruction, Ink::kValue, true)),
      drawing_(new RigDrawing),
      ring_(new HoldRing),
      sentence_(new Label({}, TextRole::kVerdict, Ink::kValue, true)),
      detail_(new Label({}, TextRole::kSection, Ink::kLabel)) {
    auto* column = makeColumn(this, {32, 20, 32, 20}, 12);
    auto* head = addRow(column);
    head->addWidget(step_);
    head->addStretch();
    head->addWidget(so_far_);
    column->addWidget(instruction_->wrapped());
    column->addWidget(drawing_, 1);
    column->addWidget(makeCard());
    column->addWidget(makeMeasures());
}

QWidget* WizardLive::makeCard() {
    card_ = new ToneCard;
    auto* row = makeRow(card_, {20, 16, 20, 16}, 20);
    row->addWidget(ring_);
    auto* words = new QWidget;
    auto* column = makeColumn(words, {}, 4);
    column->addStretch();
    column->addWidget(sentence_->wrapped());
    column->addWidget(detail_->wrapped());
    column->addStretch();
    row->addWidget(words, 1);
    // What changes ten times a second must not move the drawing above it.
    keepSize(*card_, 0, 116);
    return card_;
}

QWidget* WizardLive::makeMeasures() {
    auto* all = new QWidget;
    auto* row = makeRow(all, {}, 24);
    for (MeasureMeter*& measure : measures_) {
        measure = new MeasureMeter(MeasureMeter::Value::kBeside);
        row->addWidget(measure, 1);
    }
    return all;
}

void WizardLive::setRun(WizardRun* run) {
    run_ = run;
    if (!run)
        return;
    connect(run, &WizardRun::changed, this, &WizardLive::refresh);
    connect(run, &WizardRun::guided, this, &WizardLive::refresh);
    dressed_for_.reset();
    refresh();
}

/// While the performer is to move, or moves: of the exercise's animation.
std::optional<int> WizardLive::exerciseFrame() const {
    if (run_->task() != WizardTask::kMovement || run_->isWaitingForSuit())
        return std::nullopt;
    const Guidance& now = run_->guide()->guidance();
    if (!now.isRight() && now.hindrance != Hindrance::kMove)
        return std::nullopt;
    return ExerciseFigures::frameAt(static_cast<Exercise>(run_->step()), run_->secondsSoFar());
}

/// As soon as a suit says who wears it.
void WizardLive::dress() {
    const LiveSuit& suit = capture_.suit();
    if (suit.phase() == LiveSuit::Phase::kNone || suit.suit().boards.empty())
        return;
    const std::optional<int> frame = exerciseFrame();
    if (dressed_for_ == frame.value_or(-1))
        return;
    drawing_->setBody(frame
                          ? exercises_.figure(*frame, suit.actor(), capture_.shared().body())
                          : BodyFigure::of(suit.actor(), capture_.shared().body(), BodyFigure::Stance::kRest),
                      suit.suit());
    dressed_for_ = frame.value_or(-1);
}

QString WizardLive::instruction() const {
    return instruction_->text();
}

QString WizardLive::sentence() const {
    return sentence_->text();
}

void WizardLive::refresh() {
    if (!run_ || !run_->guide())
        return;
    const int step = run_->step(), steps = run_->stepCount();
    step_->setText(steps > 1 ? tr("Step %1 of %2").arg(step + 1).arg(steps) : wordsOf(run_->task()).title);
    so_far_->setText(tr("%1 so far").arg(timeText(run_->secondsSoFar(), 0)));
    const bool stands_first = run_->task() == WizardTask::kMovement && !exerciseFrame();
    const QString instruction = run_->stepWords(step).instruction;
    instruction_->setText(stands_first ? tr("Stand still. Then: %1").arg(instruction) : instruction);
    const LiveSentence now = sentenceOf(*run_);
    card_->setTone(now.tone);
    sentence_->setText(now.sentence);
    detail_->setText(now.detail);
    ring_->show(run_->heldShare(), holdOf(run_->task()), now.tone == Tone::kOk ? Tone::kOk : Tone::kNeutral);
    dress();
    showPicture();
    showMeasures();
}

void WizardLive::showPicture() {
    const Guidance& now = run_->guide()->guidance();
    RigPicture picture;
    picture.kind = pictureOf(run_->task());
    const bool has_sides =
        picture.kind == RigPicture::Kind::kPlate || picture.kind == RigPicture::Kind::kTurntable;
    picture.side = has_sides ? run_->sideOf(run_->step()) : -1;
    picture.turns = std::abs(now.rpm.value_or(0)) > 0;
    for (int board = 0; board < static_cast<int>(run_->suit().boards.size()); ++board)
        picture.boards.push_back(markOf(*run_, board));
    const bool names_board = now.hindering > 0 && now.board >= 0 && now.hindrance != Hindrance::kMoves;
    if (names_board && !run_->isWaitingForSuit()) {
        picture.wrong_board = now.board;
        picture.call_out_title = tr("Board %1").arg(now.board + 1);
        const QString place =
            boardName(run_->suit().boards[static_cast<size_t>(now.board)], NameCase::kInside);
        picture.call_out_text = now.hindrance == Hindrance::kAskew
                                    ? tr("%1, %2 askew").arg(place, degreesText(now.value, 1))
                                : now.hindrance == Hindrance::kAbsent ? tr("%1, silent").arg(place)
                                : now.hindrance == Hindrance::kIdle   ? tr("%1, hardly moved").arg(place)
                                                                      : place;
    }
    drawing_->setDescription(instruction_->text());
    drawing_->setPicture(picture);
}

void WizardLive::showMeasures() {
    const std::vector<LiveMeasure> now = measuresOf(*run_);
    for (size_t i = 0; i < measures_.size(); ++i) {
        measures_[i]->setVisible(i < now.size());
        if (i < now.size())
            measures_[i]->setMeasure(now[i]);
    }
}

}  // namespace noctule::ui
