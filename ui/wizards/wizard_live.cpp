// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/wizard_live.h"

#include <QHBoxLayout>
#include <QResizeEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/models/capture_context.h"
#include "ui/models/part_names.h"
#include "ui/style/words.h"
#include "ui/views/body_figure.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"
#include "ui/wizards/hold_ring.h"
#include "ui/wizards/measure_meter.h"
#include "ui/wizards/rig_drawing.h"
#include "ui/wizards/sentence_card.h"
#include "ui/wizards/wizard_words.h"

namespace noctule::ui {
namespace {

constexpr int kNarrowPage = 600, kBetweenMeasures = 24, kBetweenLines = 6;

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
      card_(new SentenceCard) {
    auto* column = makeColumn(this, {32, 20, 32, 20}, 12);
    // With large text in a small window the drawing scrolls; the sentence below it always stands in view.
    auto* task = new QWidget;
    column->addWidget(new ScrollArea(task), 1);
    auto* task_column = makeColumn(task, {}, 12);
    auto* head = addRow(task_column);
    head->addWidget(step_);
    head->addStretch();
    head->addWidget(so_far_);
    task_column->addWidget(instruction_->wrapped());
    task_column->addWidget(drawing_, 1);
    column->addWidget(card_);
    column->addWidget(makeMeasures());
    connect(&Theme::get(), &Theme::changed, this, [this] { fit(true); });
}

QWidget* WizardLive::makeMeasures() {
    auto* all = new QWidget;
    measures_row_ = makeRow(all, {}, kBetweenMeasures);
    for (MeasureMeter*& measure : measures_) {
        measure = new MeasureMeter(MeasureMeter::Form::kBeside);
        measures_row_->addWidget(measure, 1);
    }
    return all;
}

/// In a narrow page the instruction is smaller and each measure has a line of its own. Back to wide only
/// `anew`: numbers that change must not change the page.
void WizardLive::fit(bool anew) {
    const Theme& theme = Theme::get();
    if (anew)
        instruction_->setRole(width() < theme.px(kNarrowPage) ? TextRole::kVerdict : TextRole::kInstruction);
    const QMargins edges = layout()->contentsMargins();
    const int shown = static_cast<int>(
        std::ranges::count_if(measures_, [](const MeasureMeter* measure) { return !measure->isHidden(); }));
    const int room = (width() - edges.left() - edges.right() - (shown - 1) * theme.px(kBetweenMeasures)) /
                     std::max(1, shown);
    const bool is_narrow = std::ranges::any_of(measures_, [room](const MeasureMeter* measure) {
        return !measure->isHidden() && measure->widthBeside() > room;
    });
    if (!anew && (!is_narrow || measures_row_->direction() == QBoxLayout::TopToBottom))
        return;
    measures_row_->setDirection(is_narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    measures_row_->setSpacing(theme.px(is_narrow ? kBetweenLines : kBetweenMeasures));
    for (MeasureMeter* measure : measures_)
        measure->setForm(is_narrow ? MeasureMeter::Form::kLine : MeasureMeter::Form::kBeside);
}

void WizardLive::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
        fit(true);
}

void WizardLive::setRun(WizardRun* run) {
    run_ = run;
    if (!run)
        return;
    connect(run, &WizardRun::changed, this, &WizardLive::refresh);
    connect(run, &WizardRun::guided, this, &WizardLive::refresh);
    dressed_for_.reset();
    shown_step_ = -1;
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
    return card_->sentence();
}

void WizardLive::refresh() {
    if (!run_ || !run_->guide())
        return;
    const int step = run_->step(), steps = run_->stepCount();
    const bool another = std::exchange(shown_step_, step) != step;
    step_->setText(steps > 1 ? tr("Step %1 of %2").arg(step + 1).arg(steps) : wordsOf(run_->task()).title);
    so_far_->setText(tr("%1 so far").arg(timeText(run_->secondsSoFar(), 0)));
    const bool stands_first = run_->task() == WizardTask::kMovement && !exerciseFrame();
    const QString instruction = run_->stepWords(step).instruction;
    instruction_->setText(stands_first ? tr("Stand still. Then: %1").arg(instruction) : instruction);
    const LiveSentence now = sentenceOf(*run_);
    card_->setSentence(now);
    if (another)
        card_->forgetHeight();
    card_->ring().show(run_->heldShare(), holdOf(run_->task()),
                       now.tone == Tone::kOk ? Tone::kOk : Tone::kNeutral);
    dress();
    showPicture();
    showMeasures();
    fit(another);
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
