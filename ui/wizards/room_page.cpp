// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/room_page.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/language/core_words.h"
#include "ui/style/words.h"
#include "ui/views/job_progress.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/bar_meter.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/icon_label.h"
#include "ui/widgets/label.h"
#include "ui/widgets/problem_card.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/section_header.h"
#include "ui/wizards/calibration_table_card.h"
#include "ui/wizards/measure_meter.h"
#include "ui/wizards/room_drawing.h"

namespace noctule::ui {
namespace {

using room_survey::RoomSurvey;
using room_survey::SurveyedAnchor;

constexpr double kHeardWell = 0.5;  ///< share of an anchor's pulses that anybody heard

void clear(QBoxLayout& layout) {
    while (QLayoutItem* item = layout.takeAt(0)) {
        delete item->widget();
        delete item;
    }
}

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

/// "2 good, 1 weak"
QString countOf(const RoomSurvey& survey) {
    std::vector<std::pair<QString, int>> counts;
    for (const SurveyedAnchor& anchor : survey.anchors) {
        const QString words = stateOf(anchor).words;
        const auto same = std::ranges::find(counts, words, &std::pair<QString, int>::first);
        if (same == counts.end())
            counts.emplace_back(words, 1);
        else
            ++same->second;
    }
    QStringList list;
    for (const auto& [words, count] : counts)
        list << QStringLiteral("%1 %2").arg(count).arg(words);
    return list.join(", ");
}

QWidget* anchorCard(const RoomSurvey& survey, size_t index) {
    const SurveyedAnchor& anchor = survey.anchors[index];
    const AnchorState state = stateOf(anchor);
    auto* card = new Card;
    auto* column = makeColumn(card, {12, 8, 12, 10}, 6);
    auto* head = addRow(column, 8);
    head->addWidget(new Label(RoomPage::tr("Anchor %1").arg(QString::number(index + 1)), TextRole::kBody,
                              Ink::kValue, true));
    head->addWidget(new Label(QString::fromStdString(anchor.id), TextRole::kSecondary, Ink::kHint));
    head->addStretch();
    const Ink ink = state.tone == Tone::kOk ? Ink::kOk : state.tone == Tone::kWarn ? Ink::kWarn : Ink::kError;
    head->addWidget(new IconLabel(iconOf(state.tone), [ink] { return colorOf(ink); }));
    head->addWidget(new Label(state.words, TextRole::kSecondary, ink, true));
    auto* numbers = addRow(column, 8);
    if (anchor.placed) {
        numbers->addWidget(new Label(RoomPage::tr("height %1").arg(metresText(anchor.place_m.y())),
                                     TextRole::kSecondary, Ink::kLabel));
        numbers->addWidget(new Label(QStringLiteral("±%1").arg(millimetresText(anchor.sigma_m)),
                                     TextRole::kSecondary, state.tone == Tone::kOk ? Ink::kLabel : ink));
    }
    numbers->addStretch();
    const QString heard = RoomPage::tr("heard %1 of %2").arg(anchor.heard).arg(anchor.sent);
    numbers->addWidget(new Label(heard, TextRole::kSecondary, Ink::kLabel));
    auto* bar = new BarMeter;
    bar->setValue(anchor.heardShare(), state.tone, heard);
    column->addWidget(bar);
    QStringList hears;
    for (const int other : anchor.hears)
        hears << QString::number(other + 1);
    if (!hears.isEmpty())
        column->addWidget(
            new Label(RoomPage::tr("hears anchor %1", nullptr, int(hears.size())).arg(hears.join(", ")),
                      TextRole::kSecondary, Ink::kHint));
    return card;
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
      lead_(new Label({}, TextRole::kBody, Ink::kLabel)),
      headline_(new Label({}, TextRole::kVerdict, Ink::kValue, true)),
      note_(new Label({}, TextRole::kSecondary, Ink::kHint)),
      empty_(new EmptyState(
          tr("Record a take for the room: stand still in the rest pose in the middle, then walk slowly past "
             "all anchors and turn, for a minute. Or open such a take in Review."),
          tr("Go to Record"), "record")),
      found_(new QWidget),
      plan_(new RoomDrawing(RoomDrawing::From::kAbove)),
      front_(new RoomDrawing(RoomDrawing::From::kFront)),
      progress_(new JobProgress),
      heard_(new MeasureMeter(MeasureMeter::Value::kBelow)),
      error_(new MeasureMeter(MeasureMeter::Value::kBelow)),
      agreement_(new MeasureMeter(MeasureMeter::Value::kBelow)),
      words_(new Label({}, TextRole::kSecondary, Ink::kLabel)),
      survey_(makeButton(ButtonKind::kOutlined, tr("Survey again"), "redo")),
      use_(makeButton(ButtonKind::kPrimary, tr("Use these places"))),
      process_(makeButton(ButtonKind::kOutlined, tr("Process the take again"), "redo")),
      save_(makeButton(ButtonKind::kOutlined, tr("Save as file"), "export")),
      leave_(makeButton(ButtonKind::kText, tr("Back to Calibrate"))) {
    makeColumn(this)->addWidget(new ScrollArea(makeCentre()));
    side_ = makeSide();
    connect(run_, &RoomRun::changed, this, &RoomPage::refresh);
    connect(survey_, &QPushButton::clicked, run_, &RoomRun::survey);
    connect(use_, &QPushButton::clicked, run_, &RoomRun::use);
    connect(process_, &QPushButton::clicked, this, &RoomPage::process);
    connect(save_, &QPushButton::clicked, this, &RoomPage::chooseFile);
    connect(leave_, &QPushButton::clicked, this, &RoomPage::leaveRequested);
    connect(empty_, &EmptyState::activated, this, [this] { studio_.goTo(Step::kRecord); });
    refresh();
}

QWidget* RoomPage::makeCentre() {
    auto* centre = new QWidget;
    auto* column = makeColumn(centre, {24, 16, 24, 16}, 12);
    column->addWidget(lead_->wrapped());
    column->addWidget(headline_->wrapped());
    column->addWidget(progress_);
    column->addWidget(empty_, 1);
    auto* found = makeColumn(found_, {}, 16);
    auto* pictures = addRow(found, 16);
    found->setStretchFactor(pictures->parentWidget(), 1);
    pictures->addWidget(plan_, 3);
    pictures->addWidget(front_, 2);
    auto* findings = new QWidget;
    findings_ = makeColumn(findings, {}, 8);
    found->addWidget(findings);
    auto* measures = addRow(found, 24);
    for (MeasureMeter* measure : {heard_, error_, agreement_})
        measures->addWidget(measure, 1);
    found->addWidget(note_->wrapped());
    column->addWidget(found_, 1);
    return centre;
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
    auto* row = addRow(foot_column, 8);
    row->addWidget(survey_);
    row->addStretch();
    row->addWidget(leave_);
    column->addWidget(foot);
    return side;
}

void RoomPage::enter() {
    if (run_->phase() == RoomRun::Phase::kReady)
        run_->survey();
    refresh();
}

void RoomPage::refresh() {
    using enum RoomRun::Phase;
    const RoomRun::Phase phase = run_->phase();
    progress_->follow(phase == kSurveying ? run_->job() : nullptr);
    empty_->setVisible(phase == kNoTake);
    found_->setVisible(phase == kResult || phase == kFailed);
    survey_->setVisible(phase != kNoTake);
    survey_->setDisabledBecause(phase == kSurveying ? tr("It is being surveyed.") : QString());
    survey_->setText(phase == kReady ? tr("Survey") : tr("Survey again"));
    for (QWidget* part :
         {static_cast<QWidget*>(plan_), static_cast<QWidget*>(front_), static_cast<QWidget*>(heard_),
          static_cast<QWidget*>(error_), static_cast<QWidget*>(agreement_), static_cast<QWidget*>(note_)})
        part->setVisible(phase == kResult);
    const bool is_placed =
        phase == kResult &&
        run_->result().result.room->boards.size() + run_->result().result.room->sources.size() > 0;
    use_->setVisible(is_placed && !run_->isInUse());
    process_->setVisible(phase == kResult && run_->isInUse());
    save_->setVisible(is_placed);
    lead_->setText(phase == kNoTake ? tr("Room") : tr("Room of %1").arg(run_->takeName()));
    words_->clear();
    clear(*findings_);
    clear(*anchors_);
    switch (phase) {
        case kNoTake:
            headline_->setText(tr("Walk slowly past all anchors"));
            break;
        case kReady:
            headline_->setText(tr("Where do the anchors hang?"));
            break;
        case kSurveying:
            headline_->setText(tr("The room is being surveyed"));
            break;
        case kFailed:
            headline_->setText(tr("The room was not surveyed"));
            findings_->addWidget(new ProblemCard(Tone::kError, coreWords(run_->error().message),
                                                 coreWords(run_->error().remedy + ".")));
            break;
        case kResult:
            showResult();
            break;
    }
}

void RoomPage::showResult() {
    const SurveyedTake& found = run_->result();
    const Grade grade = found.result.grade();
    headline_->setText(headlineOf(grade));
    const auto& people = studio_.take().subjects();
    const auto walked = std::ranges::find(people, found.survey.performer, &TakeSubject::name);
    const int performer = walked != people.end() ? static_cast<int>(walked - people.begin()) : 0;
    plan_->show(&found.survey, performer);
    front_->show(&found.survey, performer);
    showFindings();
    showAnchors();
    const auto weakest = std::ranges::min_element(found.survey.anchors, {}, &SurveyedAnchor::heardShare);
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
    note_->setText(
        found.survey.frame.of_performer
            ? tr("Nobody has to measure: places come from what the anchors and the suit hear. The origin is "
                 "where %1 stood in the rest pose; the arrow is where %1 faced.")
                  .arg(QString::fromStdString(found.survey.performer))
            : tr("Nobody walked past the anchors: place and heading are those of the room's file."));
    use_->setText(grade == Grade::kNotUsable ? tr("Use these places anyway") : tr("Use these places"));
    if (run_->isInUse())
        words_->setText(tr("In use in %1; undo with %2. Results that it has were made with the earlier "
                           "places.")
                            .arg(run_->takeName(), keysText(QKeySequence("Ctrl+Z"))));
    else if (grade == Grade::kNotUsable)
        words_->setText(tr("Poses would be wrong where the cards say so. Mend what is named first."));
    else
        words_->setText(
            tr("The places come into force in %1. Other takes and the box itself get them from the "
               "file.")
                .arg(run_->takeName()));
}

void RoomPage::showFindings() {
    for (const std::string& warning : run_->result().result.warnings)
        findings_->addWidget(new ProblemCard(Tone::kWarn, coreWords(warning), {}));
    for (const Finding& finding : run_->result().result.document.findings)
        findings_->addWidget(new ProblemCard(
            finding.grade == Grade::kNotUsable ? Tone::kError : Tone::kWarn, coreWords(finding.what),
            coreWords(finding.remedy.empty() ? std::string() : finding.remedy + ".")));
}

void RoomPage::showAnchors() {
    const RoomSurvey& survey = run_->result().survey;
    anchors_->addWidget(new SectionHeader(tr("Anchors"), countOf(survey)));
    for (size_t i = 0; i < survey.anchors.size(); ++i)
        anchors_->addWidget(anchorCard(survey, i));
    const auto& tables = run_->result().result.document.tables;
    if (!survey.distances.empty() && !tables.empty())
        anchors_->addWidget(new CalibrationTableCard(tables.back()));
    anchors_->addStretch();
}

void RoomPage::chooseFile() {
    const QString path = QFileDialog::getSaveFileName(this, tr("Save the room"), QStringLiteral("room.json"),
                                                      tr("Rooms (*.json)"));
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
