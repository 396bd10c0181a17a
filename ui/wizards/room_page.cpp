// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/room_page.h"

#include <QFileInfo>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/models/file_choice.h"
#include "ui/style/keys.h"
#include "ui/style/words.h"
#include "ui/views/job_progress.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/label.h"
#include "ui/widgets/scroll_area.h"
#include "ui/wizards/hold_ring.h"
#include "ui/wizards/measure_meter.h"
#include "ui/wizards/room_drawing.h"

namespace noctule::ui {
namespace {

using room_survey::SurveyedAnchor;

constexpr double kHeardWell = 0.5;  ///< share of an anchor's pulses that anybody heard

QString headlineOf(Grade grade) {
    switch (grade) {
        case Grade::kGood:
            return RoomPage::tr("The room is surveyed");
        case Grade::kUsable:
            return RoomPage::tr("The room can be used");
        default:
            return RoomPage::tr("The room cannot be used yet");
    }
}

}  // namespace

WizardWords roomWords() {
    return {RoomPage::tr("Room"),
            "grid",
            RoomPage::tr("Where the anchors hang, so that place and heading of everybody hold."),
            RoomPage::tr("Somebody in a suit walks past all anchors, one minute; after an anchor was moved"),
            {},
            {},
            {},
            {}};
}

RoomPage::RoomPage(Studio& studio, QWidget* parent)
    : QWidget(parent),
      studio_(studio),
      run_(new RoomRun(studio, this)),
      walk_(new RoomWalk(studio, this)),
      lead_(new Label({}, TextRole::kBody, Ink::kLabel)),
      headline_(new Label({}, TextRole::kVerdict, Ink::kValue, true)),
      note_(new Label({}, TextRole::kSecondary, Ink::kHint)),
      empty_(new EmptyState({}, tr("Go to Connect"), "link")),
      found_(new QWidget),
      ring_(new HoldRing),
      walk_words_(new Label({}, TextRole::kBody, Ink::kLabel)),
      plan_(new RoomDrawing(RoomDrawing::From::kAbove)),
      front_(new RoomDrawing(RoomDrawing::From::kFront)),
      progress_(new JobProgress),
      heard_(new MeasureMeter(MeasureMeter::Form::kBelow)),
      error_(new MeasureMeter(MeasureMeter::Form::kBelow)),
      agreement_(new MeasureMeter(MeasureMeter::Form::kBelow)),
      words_(new Label({}, TextRole::kSecondary, Ink::kLabel)),
      why_no_walk_(new Label({}, TextRole::kSecondary, Ink::kHint)),
      walk_button_(makeButton(ButtonKind::kOutlined, tr("Walk and survey"), "record")),
      survey_(makeButton(ButtonKind::kOutlined, tr("Survey again"), "redo")),
      use_(makeButton(ButtonKind::kPrimary, tr("Use these places"))),
      process_(makeButton(ButtonKind::kOutlined, tr("Process the take again"), "redo")),
      save_(makeButton(ButtonKind::kOutlined, tr("Save as file"), "export")),
      leave_(makeButton(ButtonKind::kText, tr("Back to Calibrate"))) {
    makeColumn(this)->addWidget(new ScrollArea(makeCentre()));
    side_ = makeSide();
    connectParts();
    refresh();
}

void RoomPage::connectParts() {
    connect(run_, &RoomRun::changed, this, &RoomPage::followRun);
    connect(walk_, &RoomWalk::changed, this, &RoomPage::refresh);
    connect(walk_, &RoomWalk::ticked, this, &RoomPage::showTime);
    connect(walk_, &RoomWalk::ended, this, &RoomPage::openWalked);
    connect(&studio_.suits(), &LiveSuits::changed, this, [this] {
        const std::tuple now(walk_->phase(), walk_->whyNotBegin(), walk_->caution());
        if (std::exchange(readiness_, now) != now)
            refreshReadiness();
    });
    const auto giveUp = [this] {
        opens_walked_ = false;
        refresh();
    };
    connect(&studio_.take(), &TakeDocument::failed, this, giveUp);
    connect(&studio_.take(), &TakeDocument::torn, this, giveUp);
    connect(walk_button_, &QPushButton::clicked, this, &RoomPage::pressWalk);
    connect(survey_, &QPushButton::clicked, run_, &RoomRun::survey);
    connect(use_, &QPushButton::clicked, run_, &RoomRun::use);
    connect(process_, &QPushButton::clicked, this, &RoomPage::process);
    connect(save_, &QPushButton::clicked, this, &RoomPage::chooseFile);
    connect(leave_, &QPushButton::clicked, this, &RoomPage::leaveRequested);
    connect(empty_, &EmptyState::activated, this, [this] {
        if (walk_->isPossible())
            pressWalk();
        else
            studio_.goTo(Step::kConnect);
    });
}

QWidget* RoomPage::makeCentre() {
    auto* centre = new QWidget;
    auto* column = makeColumn(centre, {24, 16, 24, 16}, 12);
    column->addWidget(lead_->wrapped());
    column->addWidget(headline_->wrapped());
    auto* trouble = new QWidget;
    walk_trouble_ = makeColumn(trouble);
    column->addWidget(trouble);
    column->addWidget(progress_);
    column->addWidget(empty_, 1);
    column->addWidget(makeWalk());
    auto* found = makeColumn(found_, {}, 16);
    auto* pictures = addRow(found, 16);
    pictures_ = pictures->parentWidget();
    found->setStretchFactor(pictures_, 1);
    pictures->addWidget(plan_, 3);
    pictures->addWidget(front_, 2);
    auto* findings = new QWidget;
    findings_ = makeColumn(findings, {}, 8);
    found->addWidget(findings);
    auto* measures = addRow(found, 24);
    for (MeasureMeter* measure : {heard_, error_, agreement_})
        measures->addWidget(measure, 1);
    found->addWidget(note_->wrapped());
    found->addStretch();
    column->addWidget(found_, 1);
    column->addStretch();  // where nothing is drawn, all stands at the top
    return centre;
}

QWidget* RoomPage::makeWalk() {
    walk_row_ = new QWidget;
    auto* row = makeRow(walk_row_, {}, 16);
    row->addWidget(ring_);
    row->addWidget(walk_words_->wrapped(), 1);
    return walk_row_;
}

QWidget* RoomPage::makeSide() {
    auto* side = new QWidget(this);
    side->hide();
    auto* column = makeColumn(side);
    auto* list = new QWidget;
    anchors_ = makeColumn(list, {12, 16, 12, 12}, 8);
    column->addWidget(new ScrollArea(list), 1);
    auto* foot = new QWidget;
    auto* foot_column = makeColumn(foot, {12, 8, 12, 12}, 8);
    foot_column->addWidget(words_->wrapped());
    for (Button* button : {use_, process_, save_})
        foot_column->addWidget(button);
    foot_column->addWidget(why_no_walk_->wrapped());
    foot_column->addWidget(walk_button_);
    auto* row = addRow(foot_column, 8);
    row->addWidget(survey_);
    row->addStretch();
    row->addWidget(leave_);
    column->addWidget(foot);
    return side;
}

void RoomPage::enter() {
    if (!walk_->isRunning() && run_->phase() == RoomRun::Phase::kReady)
        run_->survey();
    refresh();
}

void RoomPage::leave() {
    follows_walk_ = opens_walked_ = false;
    walk_->end();
}

void RoomPage::followRun() {
    // Whatever take was opened, the walk's is no longer waited for.
    const bool opened_walked = studio_.take().isOpen() && std::exchange(opens_walked_, false);
    if (opened_walked && studio_.take().path() == walked_ && run_->phase() == RoomRun::Phase::kReady)
        return run_->survey();
    refresh();
}

void RoomPage::refresh() {
    words_->clear();
    clearWidgets(*walk_trouble_);
    clearWidgets(*findings_);
    clearWidgets(*anchors_);
    refreshButtons();
    refreshPictures();
    if (walk_->isRunning())
        showWalk();
    else
        showRun();
    walk_trouble_->parentWidget()->setVisible(walk_trouble_->count() > 0);
    refreshReadiness();
}

void RoomPage::refreshButtons() {
    using enum RoomRun::Phase;
    const RoomRun::Phase phase = run_->phase();
    const bool walks = walk_->isRunning();
    survey_->setVisible(!walks && phase != kNoTake);
    survey_->setDisabledBecause(phase == kSurveying ? tr("It is being surveyed.") : QString());
    survey_->setText(phase == kReady ? tr("Survey") : tr("Survey again"));
    const bool is_placed =
        !walks && phase == kResult &&
        run_->result().result.room->boards.size() + run_->result().result.room->sources.size() > 0;
    use_->setVisible(is_placed && !run_->isInUse());
    process_->setVisible(!walks && phase == kResult && run_->isInUse());
    save_->setVisible(is_placed);
    const bool is_without =
        phase == kResult && std::ranges::any_of(run_->result().survey.anchors, &SurveyedAnchor::left_out);
    walk_button_->setText(walks ? tr("End the walk") : is_without ? tr("Walk again") : tr("Walk and survey"));
    walk_button_->setIconName(walks ? "stop" : "record");
}

/// Whether a walk can begin, and why not.
void RoomPage::refreshReadiness() {
    const bool walks = walk_->isRunning();
    const QString why_not = walks ? QString() : walk_->whyNotBegin();
    why_no_walk_->setText(opens_walked_ ? QString() : why_not);
    why_no_walk_->setVisible(!why_no_walk_->text().isEmpty());
    if (walks)
        return walk_button_->setDisabledBecause(
            walk_->phase() == RoomWalk::Phase::kSaving ? tr("The take is being saved.") : QString());
    walk_button_->setDisabledBecause(why_not);
    if (run_->phase() == RoomRun::Phase::kNoTake)
        words_->setText(opens_walked_ || !why_not.isEmpty() ? QString() : walk_->caution());
    const bool is_possible = walk_->isPossible();
    const QString sentence =
        is_possible
            ? tr("Stand still in the rest pose in the middle, in sight of all anchors, then walk "
                 "slowly past all of them and turn, for a minute. The places are shown meanwhile; "
                 "the survey ends by itself when every anchor is good.")
            : tr("Connect a suit and a box of anchors, then walk slowly past all anchors: the room is "
                 "surveyed meanwhile. Or open a take with anchors in Review.");
    empty_->setSentence(sentence);
    empty_->button()->setText(is_possible ? tr("Walk and survey") : tr("Go to Connect"));
    empty_->button()->setIconName(is_possible ? "record" : "link");
    empty_->button()->setDisabledBecause(is_possible ? why_not : QString());
}

void RoomPage::refreshPictures() {
    const RoomRun::Phase phase = run_->phase();
    const bool walks = walk_->isRunning();
    const bool is_drawn = walks ? walk_->found() != nullptr : phase == RoomRun::Phase::kResult;
    walk_row_->setVisible(walks);
    progress_->follow(!walks && phase == RoomRun::Phase::kSurveying ? run_->job() : nullptr);
    empty_->setVisible(!walks && !opens_walked_ && phase == RoomRun::Phase::kNoTake);
    found_->setVisible(is_drawn || (!walks && phase == RoomRun::Phase::kFailed));
    for (QWidget* part :
         {static_cast<QWidget*>(plan_), static_cast<QWidget*>(front_), static_cast<QWidget*>(heard_),
          static_cast<QWidget*>(error_), static_cast<QWidget*>(agreement_), static_cast<QWidget*>(note_)})
        part->setVisible(is_drawn);
    pictures_->setVisible(is_drawn);
}

void RoomPage::showRun() {
    using enum RoomRun::Phase;
    const RoomRun::Phase phase = run_->phase();
    lead_->setText(phase == kNoTake ? tr("Room") : tr("Room of %1").arg(run_->takeName()));
    switch (phase) {
        case kNoTake:
            headline_->setText(opens_walked_ ? tr("The room is being surveyed")
                                             : tr("Walk slowly past all anchors"));
            break;
        case kReady:
            headline_->setText(tr("Where do the anchors hang?"));
            break;
        case kSurveying:
            headline_->setText(tr("The room is being surveyed"));
            break;
        case kFailed:
            headline_->setText(tr("The room was not surveyed"));
            showErrorCard(*findings_, run_->error());
            break;
        case kResult:
            showResult();
            break;
    }
    showWalkTrouble();
}

int RoomPage::letterOf(const std::string& performer) const {
    if (walk_->isRunning()) {
        for (const SuitInUse* worn : studio_.suits().connected())
            if (studio_.suits().nameOf(*worn).toStdString() == performer)
                return studio_.suits().letterOf(*worn);
        return 0;
    }
    const auto& people = studio_.take().subjects();
    const auto walked = std::ranges::find(people, performer, &TakeSubject::name);
    return walked != people.end() ? static_cast<int>(walked - people.begin()) : 0;
}

/// Drawings, meters and cards of what was found.
void RoomPage::showSurvey(const SurveyedTake& found, SurveyStage stage) {
    const int performer = letterOf(found.survey.performer);
    plan_->show(&found.survey, performer);
    front_->show(&found.survey, performer);
    showFindingCards(*findings_, found, stage);
    const AnchorChoice choice{
        [this](size_t anchor) { return run_->whyNotWithout(anchor); },
        [this](size_t anchor, bool is_without) { run_->setWithout(anchor, is_without); }};
    showAnchorCards(*anchors_, found, stage, stage == SurveyStage::kDone ? &choice : nullptr);
    const auto weakest = std::ranges::min_element(found.survey.anchors, {}, [](const SurveyedAnchor& anchor) {
        return std::pair(anchor.left_out, anchor.heardShare());
    });
    if (weakest != found.survey.anchors.end())
        heard_->setMeasure({tr("Anchors heard"),
                            tr("the weakest: %1 of %2").arg(weakest->heard).arg(weakest->sent),
                            weakest->heardShare(), weakest->heardShare() >= kHeardWell});
    const auto measure = [](MeasureMeter& meter, const QString& name, double value_m, double good_m) {
        meter.setMeasure(
            {name,
             RoomPage::tr("%1, good: up to %2").arg(millimetresText(value_m), millimetresText(good_m, 0)),
             std::min(1.0, value_m / (2 * good_m)), value_m <= good_m});
    };
    measure(*error_, tr("Largest error"), found.survey.worstSigma_m(), room_survey::kGoodAnchor_m);
    measure(*agreement_, tr("Agreement"), found.survey.median_m, room_survey::kGoodAgreement_m);
}

void RoomPage::showResult() {
    const SurveyedTake& found = run_->result();
    const Grade grade = found.result.grade();
    headline_->setText(headlineOf(grade));
    showSurvey(found, SurveyStage::kDone);
    note_->setText(
        found.survey.frame.of_performer
            ? tr("Nobody has to measure: places come from what the anchors and the suit hear. The origin is "
                 "where %1 stood in the rest pose; the arrow is where %1 faced.")
                  .arg(QString::fromStdString(found.survey.performer))
            : tr("Nobody walked past the anchors: place and heading are those of the room's file."));
    use_->setText(grade == Grade::kNotUsable ? tr("Use these places anyway") : tr("Use these places"));
    if (run_->isInUse())
        words_->setText(
            tr("In use in %1; undo with %2. Results that it has were made with the earlier "
               "places.")
                .arg(run_->takeName(), keysText(Keys::keyOf("window/undo", QKeySequence("Ctrl+Z")))));
    else if (grade == Grade::kNotUsable)
        words_->setText(tr("Poses would be wrong where the cards say so. Mend what is named first."));
    else
        words_->setText(
            tr("The places come into force in %1. Other takes and the box itself get them from the "
               "file.")
                .arg(run_->takeName()));
    QStringList left_out;
    for (size_t i = 0; i < found.survey.anchors.size(); ++i)
        if (found.survey.anchors[i].left_out)
            left_out << QString::number(i + 1);
    if (!left_out.isEmpty())
        words_->setText(
            words_->text() + ' ' +
            tr("Without anchor %1: the file lacks it, and in this take its place stays as it was. The other "
               "places stay as they were found with it; to find them without it, take it away and walk "
               "again.",
               nullptr, int(left_out.size()))
                .arg(left_out.join(", ")));
}

void RoomPage::chooseFile() {
    const QString path =
        FileChoice{"rooms", tr("Save the room"), tr("Rooms (*.json)"), "room.json"}.toSave(this);
    if (path.isEmpty())
        return;
    if (const QString why = run_->save(path); !why.isEmpty())
        emit studio_.failed(tr("The room was not saved"), why, About::kFile);
    else
        studio_.sayOfFile(tr("%1 is written.").arg(QFileInfo(path).fileName()));
}

void RoomPage::process() {
    studio_.processAccurately(studio_.take().path().toStdString());
    studio_.goTo(Step::kReview);
}

}  // namespace noctule::ui
