// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/calibrate_page.h"

#include <QKeyEvent>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/style/words.h"
#include "ui/views/connect/suit_switch.h"
#include "ui/views/fit_words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/section_header.h"
#include "ui/widgets/verdict_header.h"
#include "ui/wizards/calibration_state.h"
#include "ui/wizards/room_page.h"
#include "ui/wizards/task_card.h"
#include "ui/wizards/unfinished_calibration.h"
#include "ui/wizards/wizard_intro.h"
#include "ui/wizards/wizard_page.h"

namespace noctule::ui {

CalibratePage::CalibratePage(Studio& studio, QWidget* parent)
    : Page(parent),
      studio_(studio),
      suits_(new SuitSwitch(studio)),
      of_suit_(makeSuits()),
      centre_(new QStackedWidget),
      left_(new QStackedWidget(this)),
      right_(new QStackedWidget(this)),
      wizard_(new WizardPage(studio)),
      room_(new RoomPage(studio)),
      overview_(nullptr) {
    auto* column = makeColumn(this);
    column->addWidget(of_suit_);
    column->addWidget(centre_, 1);
    overview_ = makeOverview();
    centre_->addWidget(overview_);
    centre_->addWidget(wizard_);
    centre_->addWidget(room_);
    right_->addWidget(makeOverviewSide());
    right_->addWidget(wizard_->side());
    right_->addWidget(room_->side());
    left_->addWidget(makeHistory());
    left_->addWidget(wizard_->rail());
    for (QWidget* dock : {left_, right_}) {
        dock->hide();
        dock->installEventFilter(this);
        for (QScrollArea* area : dock->findChildren<QScrollArea*>())
            area->installEventFilter(this);
    }
    setFocusPolicy(Qt::ClickFocus);
    setDockTitles(tr("Calibrations"), tr("Calibration"));
    connect(wizard_, &WizardPage::leaveRequested, this, &CalibratePage::closeWizard);
    connect(room_, &RoomPage::leaveRequested, this, &CalibratePage::showOverview);
    connect(&studio.take(), &TakeDocument::opened, this, &CalibratePage::refresh);
    studio.suits().follow(&CalibrationShelf::changed, this, &CalibratePage::refresh);
    studio.suits().follow(&LiveSuit::wearingChanged, this, &CalibratePage::refresh);
    studio.suits().follow(&LiveSuit::phaseChanged, this, &CalibratePage::refresh);
    connect(&studio.session(), &SessionModel::opened, this, &CalibratePage::followSession);
    refresh();
}

CalibratePage::~CalibratePage() = default;

QWidget* CalibratePage::leftDock() {
    return left_;
}

QWidget* CalibratePage::rightDock() {
    return right_;
}

void CalibratePage::enter() {
    if (wizard_->run())
        wizard_->run()->setPaused(false);
    setFocus();
}

void CalibratePage::leave() {
    if (wizard_->run())
        wizard_->run()->setPaused(true);
    room_->leave();
}

bool CalibratePage::showsWizard() const {
    return centre_->currentWidget() == wizard_;
}

Button* CalibratePage::startButton(WizardTask task) {
    return cards_.at(task)->button();
}

QWidget* CalibratePage::makeSuits() {
    auto* of_suit = new QWidget;
    makeColumn(of_suit)->addWidget(suits_);
    studio_.suits().setChoiceGuard(this, [this] { return whyNotOtherSuit(); });
    return of_suit;
}

bool CalibratePage::isUnderWay() const {
    if (!showsWizard() || wizard_->run()->phase() == WizardRun::Phase::kIntro)
        return false;
    const WizardRun& run = *wizard_->run();
    return run.phase() != WizardRun::Phase::kResult || (!run.isSaved() && run.task() != WizardTask::kCheck);
}

/// What was taken of one suit would be lost.
QString CalibratePage::whyNotOtherSuit() {
    return isUnderWay() ? tr("Finish or leave this calibration, then choose another suit.") : QString();
}

QWidget* CalibratePage::makeOverview() {
    auto* tasks = new QWidget;
    auto* column = makeColumn(tasks, {}, 8);  // all of them are seen on the smallest screen
    for (const WizardTask task : kWizardTasks) {
        auto* card = new TaskCard(wordsOf(task));
        connect(card->button(), &QPushButton::clicked, this, [this, task] { open(task); });
        cards_[task] = card;
        column->addWidget(card);
    }
    room_card_ = new TaskCard(roomWords());
    connect(room_card_->button(), &QPushButton::clicked, this, &CalibratePage::openRoom);
    column->addWidget(room_card_);
    column->addStretch();
    keepMaximumWidth(*tasks, 720);
    auto* middle = new QWidget;
    auto* row = makeRow(middle, {16, 16, 16, 16});
    row->addStretch();
    row->addWidget(tasks, 1000);
    row->addStretch();
    return new ScrollArea(middle);
}

QWidget* CalibratePage::makeOverviewSide() {
    auto* content = new QWidget;
    auto* column = makeColumn(content, {12, 16, 12, 12}, 12);
    verdict_ = new VerdictHeader;
    column->addWidget(verdict_);
    column->addStretch();
    way_on_ = makeButton(ButtonKind::kPrimary, {}, "next");
    connect(way_on_, &QPushButton::clicked, this, &CalibratePage::goOn);
    column->addWidget(way_on_);
    return new ScrollArea(content);
}

void CalibratePage::goOn() {
    if (next_)
        open(*next_);
    else
        studio_.goTo(Step::kRecord);
}

QString CalibratePage::sessionNow() const {
    return studio_.session().isOpen() ? QString::fromStdString(studio_.session().session().folder.string())
                                      : QString();
}

/// What was taken belongs to the session in which it was; a wizard that begins may make the first one.
void CalibratePage::followSession() {
    if (showsWizard() && !session_.isEmpty() && session_ != sessionNow())
        closeWizard();
    session_ = sessionNow();
    refresh();
}

void CalibratePage::checkBeforeTake() {
    if (showsWizard() && wizard_->run() && wizard_->run()->task() != WizardTask::kCheck)
        return studio_.say(tr("Finish or leave this calibration, then check the suit."));
    open(WizardTask::kCheck);
    back_to_record_ = true;
    wizard_->setWayBack(tr("Back to Record"));
    if (wizard_->run()->whyNotBegin().isEmpty())
        wizard_->run()->begin();
}

void CalibratePage::open(WizardTask task) {
    room_->leave();
    of_suit_->show();
    session_ = sessionNow();
    back_to_record_ = false;
    wizard_->setWayBack(tr("Back to Calibrate"));
    wizard_->open(task);
    centre_->setCurrentWidget(wizard_);
    right_->setCurrentWidget(wizard_->side());
    left_->setCurrentWidget(wizard_->rail());
    setDockTitles(tr("Steps"), tr("Boards"));
    setFocus();
}

void CalibratePage::openRoom() {
    of_suit_->hide();  // the room is of a take
    centre_->setCurrentWidget(room_);
    right_->setCurrentWidget(room_->side());
    left_->setCurrentIndex(0);
    setDockTitles(tr("Calibrations"), tr("Anchors"));
    room_->enter();
    setFocus();
}

void CalibratePage::showOverview() {
    room_->leave();
    of_suit_->show();
    centre_->setCurrentWidget(overview_);
    right_->setCurrentIndex(0);
    left_->setCurrentIndex(0);
    setDockTitles(tr("Calibrations"), tr("Calibration"));
    refresh();
}

void CalibratePage::closeWizard() {
    wizard_->close();
    showOverview();
    if (std::exchange(back_to_record_, false))
        studio_.goTo(Step::kRecord);
}

/// Of steps that an earlier visit took, in this session and of this suit; empty: none.
QString CalibratePage::keptWords(WizardTask task) const {
    if (!studio_.session().isOpen())
        return {};
    const Session& session = studio_.session().session();
    const QString path = unfinishedPath(QString::fromStdString(session.calibrationFolder().string()),
                                        keyOf(task), studio_.suit().serial());
    return WizardIntro::keptWords(
        readUnfinished(path, QString::fromStdString(session.evidenceFolder().string())));
}

void CalibratePage::refresh() {
    const std::optional<Calibration> in_force = studio_.calibrations().inForce();
    const Suit& suit = studio_.suit().suit();
    const QDateTime now = QDateTime::currentDateTime();
    const bool is_exact = studio_.suit().isKnownExactly();
    const QString other = in_force ? studio_.calibrations().otherSuitOf(*in_force) : QString();
    next_ = is_exact ? std::nullopt : nextTask(other.isEmpty() ? in_force : std::nullopt, suit, now);
    const bool has_field = std::ranges::any_of(suit.boards, &Board::has_magnetometer);
    // Of anchors the places and the sources count; nobody wears them.
    for (const auto& [task, card] : cards_)
        card->setVisible(task == WizardTask::kMagnetometers
                             ? has_field && !suit.isFixed()
                             : task == WizardTask::kSources || !suit.isFixed());
    room_card_->setVisible(RoomRun::hasRoom(studio_));
    room_card_->setState(Tone::kNeutral,
                         room_->run().phase() != RoomRun::Phase::kNoTake
                             ? tr("From the take that is open, %1").arg(room_->run().takeName())
                         : room_->walk().isPossible()
                             ? tr("Somebody can walk past the anchors now")
                             : tr("Needs a take in which somebody walks past the anchors"));
    room_card_->setButton(tr("Survey"), false);
    bool is_stated = true;
    for (const auto& [task, card] : cards_) {
        if (task == WizardTask::kCheck) {
            card->setState(Tone::kNeutral, in_force ? tr("Against the calibration in force")
                                                    : tr("There is nothing to check yet"));
            const QString cannot = whyNotCheck(lackOf(suit, in_force.value_or(Calibration{})));
            if (in_force && !cannot.isEmpty())
                card->setState(Tone::kWarn, cannot);
            card->button()->setDisabledBecause(in_force ? cannot : tr("There is no calibration to check."));
        } else {
            const TaskState state = stateOf(task, in_force, suit, now);
            is_stated = is_stated && state.unstated == 0;
            if (is_exact)
                card->setState(Tone::kOk, tr("Known exactly"));
            else
                card->setState(state.tone(), state.words());
            if (const QString kept = keptWords(task); !kept.isEmpty())
                card->setState(Tone::kWarn, card->state() + ". " + kept);
        }
        card->setButton(task == WizardTask::kCheck ? tr("Check") : tr("Prepare"), next_ == task);
    }
    if (!in_force && suit.isFixed())
        verdict_->setVerdict(
            Tone::kWarn, tr("Not calibrated"),
            tr("Until the anchors' sources are calibrated, their places are found to decimetres only. Begin "
               "with the source offsets, or import the calibration of this box."));
    else if (!in_force)
        verdict_->setVerdict(
            Tone::kWarn, tr("Not calibrated"),
            tr("Nothing moves live and nothing can be processed before the suit is calibrated. "
               "Begin with the source offsets, or import its calibration."));
    else if (is_exact)
        verdict_->setVerdict(
            Tone::kOk, tr("Known exactly"),
            tr("The virtual suit says by itself how it measures and how it sits on the body. "
               "Calibrating it is for practice only."));
    else if (!other.isEmpty())
        verdict_->setVerdict(Tone::kWarn, tr("Calibrated for another suit"),
                             tr("The calibration in use was made for %1: with it the poses of %2 are wrong. "
                                "Calibrate %2, or import its calibration.",
                                "two serial numbers")
                                 .arg(other, studio_.suit().serial()));
    else if (next_)
        verdict_->setVerdict(Tone::kWarn, tr("Next: %1").arg(wordsOf(*next_).title),
                             tr("The other values stay in use; their cards say how good they are."));
    else
        verdict_->setVerdict(
            Tone::kOk, tr("Calibrated"),
            is_stated ? tr("All parts of the suit have values that are recent enough. Check them with three "
                           "seconds of standing still.")
                      : tr("All parts of the suit have values, but where they come from is not stated. Check "
                           "them with three seconds of standing still."));
    way_on_->setText(next_ ? tr("Prepare: %1").arg(wordsOf(*next_).title) : tr("Continue to Record"));
    export_->setDisabledBecause(in_force ? QString() : tr("There is no calibration to export."));
    showHistory();
}

void CalibratePage::keyPressEvent(QKeyEvent* event) {
    if (!showsWizard() || !wizard_->handleKey(event->key()))
        Page::keyPressEvent(event);
}

/// Keys that nothing in a dock wanted come to its scroll areas and to itself last.
bool CalibratePage::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::KeyPress && showsWizard() &&
        wizard_->handleKey(static_cast<QKeyEvent*>(event)->key()))
        return true;
    return Page::eventFilter(object, event);
}

}  // namespace noctule::ui
