// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/wizard_intro.h"

#include <QFileInfo>
#include <QVBoxLayout>

#include "core/suit/calibration_lack.h"
#include "ui/models/capture_context.h"
#include "ui/models/file_choice.h"
#include "ui/style/words.h"
#include "ui/views/body_figure.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/problem_card.h"
#include "ui/widgets/section_header.h"
#include "ui/wizards/field_drawing.h"
#include "ui/wizards/rig_drawing.h"
#include "ui/wizards/wizard_run.h"

namespace noctule::ui {

WizardIntro::WizardIntro(CaptureContext& capture, QWidget* parent)
    : QWidget(parent),
      capture_(capture),
      what_(new Label({}, TextRole::kInstruction, Ink::kValue, true)),
      needs_(new Label({}, TextRole::kBody, Ink::kLabel)),
      set_up_(new Label({}, TextRole::kBody, Ink::kLabel)),
      distances_words_(new Label({}, TextRole::kBody, Ink::kHint)),
      kept_words_(new Label({}, TextRole::kBody, Ink::kHint)),
      words_(new QWidget),
      drawing_(new RigDrawing),
      sphere_(new FieldDrawing),
      problem_(new ProblemCard(Tone::kError, {}, {})),
      prerequisite_(new ProblemCard(
          Tone::kNeutral, tr("Better after the gyroscopes"),
          tr("The gyroscopes of this suit are not calibrated yet. How the boards sit is found all the same; "
             "after them, exchanged plugs are noticed more surely, and the zeros found stay in use."))),
      begin_(makeButton(ButtonKind::kPrimary, tr("Begin"))),
      anew_(makeButton(ButtonKind::kText, tr("Begin anew"))),
      distances_(makeButton(ButtonKind::kOutlined, tr("Choose the distances"), "ruler")),
      takes_(makeButton(ButtonKind::kText, tr("Use recorded takes"))) {
    auto* column = makeColumn(this, {32, 20, 32, 20}, 12);
    column->addWidget(what_->wrapped());
    column->addWidget(drawing_, 1);
    column->addWidget(sphere_, 1);
    makeWords();
    for (ProblemCard* card : {problem_, prerequisite_}) {
        column->addWidget(card);
        card->hide();
    }
    auto* buttons = addRow(column, 12);
    distances_->setTall(true);
    buttons->addWidget(distances_);
    buttons->addWidget(begin_);
    buttons->addWidget(anew_);
    buttons->addStretch();
    auto* instead = addRow(column, 12);
    instead->addWidget(takes_);
    instead->addWidget(kept_words_->wrapped(), 1);
    takes_->setToolTip(tr("Nothing is measured now: takes of another day or another box are used instead"));
    connect(begin_, &QPushButton::clicked, this, [this] {
        no_distances_.clear();
        run_->begin();
    });
    connect(anew_, &QPushButton::clicked, this, [this] { run_->beginAnew(); });
    connect(distances_, &QPushButton::clicked, this, &WizardIntro::chooseDistances);
    connect(takes_, &QPushButton::clicked, this, &WizardIntro::chooseTakes);
}

void WizardIntro::makeWords() {
    auto* words = makeColumn(words_, {12, 16, 12, 12}, 24);
    const auto add = [words](const QString& title, std::initializer_list<Label*> texts) {
        auto* part = new QWidget;
        auto* column = makeColumn(part, {}, 6);
        column->addWidget(new SectionHeader(title));
        for (Label* text : texts)
            column->addWidget(text->wrapped());
        words->addWidget(part);
    };
    add(tr("What you need"), {needs_, distances_words_});
    add(tr("Set-up"), {set_up_});
    words->addStretch();
}

void WizardIntro::setRun(WizardRun* run) {
    run_ = run;
    no_distances_.clear();
    problem_->hide();
    if (!run)
        return;
    const WizardWords words = wordsOf(run->task());
    what_->setText(words.headline);
    needs_->setText(words.needs.join("\n\n"));
    set_up_->setText(words.set_up);
    RigPicture picture;
    picture.kind = pictureOf(run->task());
    const Suit& suit = capture_.suit().suit();
    const size_t boards = suit.boards.empty() ? 18 : suit.boards.size();
    picture.boards.assign(boards, BoardMark::kWaiting);
    if (!suit.boards.empty())
        drawing_->setBody(
            BodyFigure::of(capture_.suit().actor(), capture_.shared().body(), BodyFigure::Stance::kRest),
            suit);
    drawing_->setPicture(picture);
    drawing_->setDescription(words.set_up);
    const bool turns = run->task() == WizardTask::kMagnetometers;
    drawing_->setVisible(!turns);
    sphere_->setVisible(turns);
    distances_->setVisible(run->task() == WizardTask::kSources);
    connect(run, &WizardRun::changed, this, &WizardIntro::refresh);
    refresh();
}

void WizardIntro::refresh() {
    if (!run_ || run_->phase() != WizardRun::Phase::kIntro)
        return;
    const bool unfinished = run_->isUnfinished();
    begin_->setText(unfinished ? tr("Go on") : tr("Begin"));
    begin_->setDisabledBecause(run_->whyNotBegin());
    anew_->setVisible(unfinished);
    anew_->setDisabledBecause(run_->whyNotBegin());
    const bool lacks_distances = run_->task() == WizardTask::kSources && run_->distanceCount() == 0;
    takes_->setDisabledBecause(lacks_distances ? run_->whyNotBegin() : QString());
    kept_words_->setText(unfinished ? keptWords(run_->unfinished()) : run_->whyNotBegin());
    distances_words_->setVisible(run_->task() == WizardTask::kSources);
    distances_words_->setText(run_->distanceCount() > 0
                                  ? tr("%1: %n distance(s)", nullptr, run_->distanceCount())
                                        .arg(QFileInfo(run_->distancesPath()).fileName())
                                  : tr("CSV with placement, kind, id, x_m, y_m, z_m, or with placement, "
                                       "source, board, distance_m"));
    const Suit& suit = capture_.suit().suit();
    const Calibration known = capture_.calibrations().inForce().value_or(Calibration{});
    prerequisite_->setVisible(run_->task() == WizardTask::kRestPose &&
                              lackOf(suit, known).ofMostGyroscopes());
    showProblem();
}

void WizardIntro::showProblem() {
    const QString why = no_distances_.isEmpty() ? run_->trouble() : no_distances_;
    problem_->setTexts(
        no_distances_.isEmpty() ? tr("The takes could not be used") : tr("The distances could not be read"),
        why);
    problem_->setVisible(!why.isEmpty());
}

QString WizardIntro::keptWords(const UnfinishedCalibration& unfinished) {
    const QString since = dateText(QDateTime::fromString(unfinished.started_utc, Qt::ISODate).toLocalTime());
    const int steps = unfinished.stepsDone();
    const QString of_steps =
        steps > 0 ? tr("%n step(s) were taken on %1 and are kept.", nullptr, steps).arg(since) : QString();
    if (unfinished.share <= 0)
        return of_steps;
    const QString share = percentText(unfinished.share);
    return steps > 0 ? of_steps + ' ' + tr("%1 of the directions are kept, too.").arg(share)
                     : tr("%1 of the directions were seen on %2 and are kept.").arg(share, since);
}

void WizardIntro::useDistances(const QString& path) {
    no_distances_ = run_->setDistances(path);
    showProblem();
}

QString WizardIntro::problem() const {
    return problem_->isVisible() ? problem_->title() : QString();
}

QString WizardIntro::prerequisite() const {
    return prerequisite_->isVisible() ? prerequisite_->title() : QString();
}

void WizardIntro::chooseDistances() {
    const QString path = FileChoice{"distances", tr("Choose the distances of the jig"),
                                    tr("Tables (*.csv *.txt);;All files (*)")}
                             .toOpen(this);
    if (run_ && !path.isEmpty())
        useDistances(path);
}

void WizardIntro::chooseTakes() {
    const QStringList paths = FileChoice{.kind = "calibration_takes",
                                         .title = tr("Choose the takes"),
                                         .filter = tr("Takes (*.noctule)"),
                                         .usual = capture_.shared().takesFolder()}
                                  .severalToOpen(this);
    if (!run_ || paths.isEmpty())
        return;
    no_distances_.clear();
    run_->solveTakes(paths);
}

}  // namespace noctule::ui
