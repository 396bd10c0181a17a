// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/field_sensors.h"

#include <QVBoxLayout>

#include "ui/models/part_names.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/problem_card.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/section_header.h"
#include "ui/wizards/field_table.h"
#include "ui/wizards/field_words.h"

namespace noctule::ui {

FieldSensors::FieldSensors(QWidget* parent)
    : QWidget(parent),
      count_(new Label({}, TextRole::kSecondary, Ink::kLabel)),
      table_(new FieldTable),
      card_(new ProblemCard(Tone::kWarn, {}, {})),
      sensor_anew_(card_->addAction(tr("Start it anew"))),
      skip_(card_->addAction(tr("Skip it"))),
      strength_(new Label({}, TextRole::kSecondary)),
      dip_(new Label({}, TextRole::kSecondary)),
      floor_(new Label({}, TextRole::kSecondary)),
      words_(new Label({}, TextRole::kSecondary, Ink::kLabel)),
      anew_(makeButton(ButtonKind::kOutlined, tr("Begin anew"), "loop")),
      enough_(makeButton(ButtonKind::kOutlined, {})),
      back_(makeButton(ButtonKind::kText, tr("Back"))),
      without_floor_(makeButton(ButtonKind::kOutlined, tr("Leave out the floor"))),
      unskip_(makeButton(ButtonKind::kText, tr("Ask for the skipped ones again"))) {
    auto* column = makeColumn(this);
    auto* scrolled = new QWidget;
    auto* scrolled_column = makeColumn(scrolled, {0, 8, 0, 8}, 8);
    auto* head = new QWidget;
    auto* head_row = makeRow(head, {12, 0, 12, 0});
    head_row->addWidget(new Label(tr("Sensors"), TextRole::kBody, Ink::kValue, true));
    head_row->addStretch();
    head_row->addWidget(count_);
    scrolled_column->addWidget(head);
    scrolled_column->addWidget(table_);
    scrolled_column->addStretch();
    column->addWidget(new ScrollArea(scrolled), 1);
    auto* card = new QWidget;
    makeColumn(card, {12, 8, 12, 4})->addWidget(card_);
    column->addWidget(card);
    card_->hide();
    column->addWidget(makeSpot());
    column->addWidget(makeFoot());
    connect(sensor_anew_, &QPushButton::clicked, this, [this] {
        if (const int board = troubledBoard(); board >= 0)
            run_->startAnew(board);
    });
    connect(skip_, &QPushButton::clicked, this, &FieldSensors::skipSensor);
    connect(anew_, &QPushButton::clicked, this, [this] { run_->repeat(FieldGuide::kTurn); });
    connect(enough_, &QPushButton::clicked, this, [this] { run_->useThoseDone(); });
    connect(back_, &QPushButton::clicked, this, [this] { run_->lookAtSpotAgain(); });
    connect(without_floor_, &QPushButton::clicked, this, [this] { run_->leaveOutFloor(); });
    connect(unskip_, &QPushButton::clicked, this, &FieldSensors::unskipAll);
}

QWidget* FieldSensors::makeSpot() {
    auto* spot = new QWidget;
    auto* column = makeColumn(spot, {12, 8, 12, 4}, 6);
    column->addWidget(new SectionHeader(tr("Field of this spot")));
    const auto add = [column](const QString& name, Label* value) {
        auto* row = addRow(column);
        row->addWidget(new Label(name, TextRole::kSecondary, Ink::kLabel));
        row->addStretch();
        row->addWidget(value);
    };
    add(tr("Strength"), strength_);
    add(tr("Dip"), dip_);
    add(tr("Near the floor"), floor_);
    return spot;
}

QWidget* FieldSensors::makeFoot() {
    auto* foot = new QWidget;
    auto* column = makeColumn(foot, {12, 4, 12, 12}, 8);
    column->addWidget(words_->wrapped());
    column->addWidget(unskip_, 0, Qt::AlignLeft);
    column->addWidget(without_floor_);
    column->addWidget(enough_);
    auto* row = addRow(column, 8);
    row->addWidget(anew_);
    row->addStretch();
    row->addWidget(back_);
    back_->setToolTip(tr("To the field of this spot once more; what was turned stays"));
    without_floor_->setToolTip(
        tr("Nothing is known of the floor then; turn the suit at the height of your chest"));
    return foot;
}

void FieldSensors::setRun(WizardRun* run) {
    run_ = run;
    table_->setRun(run);
    if (!run)
        return;
    connect(run, &WizardRun::changed, this, &FieldSensors::refresh);
    connect(run, &WizardRun::guided, this, &FieldSensors::refresh);
    refresh();
}

/// The first that cannot be used as it is.
int FieldSensors::troubledBoard() const {
    const FieldGuide* guide = run_ ? run_->fieldGuide() : nullptr;
    if (guide && guide->guidance().hindrance == Hindrance::kAbsent)
        return guide->guidance().board;
    for (int board = 0; guide && board < static_cast<int>(run_->suit().boards.size()); ++board) {
        const FieldTurnState state = guide->turnOf(board).state();
        const bool is_well = state == FieldTurnState::kGoing || state == FieldTurnState::kDone;
        if (!guide->isSkipped(board) && (guide->carriesIronNow(board) || !is_well))
            return board;
    }
    return -1;
}

void FieldSensors::skipSensor() {
    if (const int board = troubledBoard(); board >= 0)
        run_->skip(board, true);
}

void FieldSensors::showTrouble(int board) {
    card_->setVisible(board >= 0);
    if (board < 0)
        return;
    const FieldTurn& turn = run_->fieldGuide()->turnOf(board);
    const QString name = sensorName(*run_, board);
    const bool absent = run_->fieldGuide()->guidance().hindrance == Hindrance::kAbsent;
    sensor_anew_->setVisible(!absent);
    sensor_anew_->setText(tr("Start sensor %1 anew").arg(board + 1));
    skip_->setText(tr("Skip sensor %1").arg(board + 1));
    if (absent)
        return card_->setTexts(tr("%1 is not heard").arg(name),
                               tr("Push its plug in until it clicks; if its light stays dark, change the "
                                  "cable."));
    switch (turn.state()) {
        case FieldTurnState::kClipped:
            return card_->setTexts(tr("%1 is beyond its range").arg(name),
                                   tr("A magnet lies beside it. Take it away; readings begin anew."));
        case FieldTurnState::kNoField:
            return card_->setTexts(tr("%1 reads no field").arg(name),
                                   tr("Its magnetometer seems to be broken or shielded. Skip it."));
        default:
            break;
    }
    const QString uneven = percentText(turn.uneven_percent().value_or(0) / 100, 1);
    if (run_->fieldGuide()->carriesIronNow(board))
        return card_->setTexts(tr("%1 carries iron").arg(name),
                               tr("Its field changes by %1 as it turns, more than that of the others. A "
                                  "ring, a watch or a buckle "
                                  "lies beside it. Take it out; readings begin anew.")
                                   .arg(uneven));
    card_->setTexts(
        tr("The field of %1 changes by %2").arg(name, uneven),
        tr("The spot is bent, or iron lies beside it. Go 1 m away from steel; readings begin anew."));
}

void FieldSensors::refresh() {
    const FieldGuide* guide = run_ ? run_->fieldGuide() : nullptr;
    if (!guide)
        return;
    table_->refresh();
    int asked = 0;
    for (int board = 0; board < static_cast<int>(run_->suit().boards.size()); ++board)
        asked += !guide->isSkipped(board);
    const int done = guide->enoughBoards();
    count_->setText(tr("%1 of %2 have enough").arg(done).arg(asked));
    showTrouble(troubledBoard());
    showSpot(guide->spot());
    showWaysOn(*guide, done);
    words_->setVisible(!run_->trouble().isEmpty());
    words_->setText(run_->trouble());
}

void FieldSensors::showSpot(const SpotField& spot) {
    strength_->setText(spot.moments > 0 ? microteslaText(spot.strength_ut, spot.strength_sigma_ut)
                                        : kNoValue);
    dip_->setText(spot.dip_deg ? tr("%1 down").arg(degreesText(radians(*spot.dip_deg), 0)) : kNoValue);
    floor_->setText(spot.floor_percent ? strongerText(*spot.floor_percent) : kNoValue);
    floor_->setInk(spot.isBentAtFloor() ? Ink::kWarn : Ink::kValue);
}

void FieldSensors::showWaysOn(const FieldGuide& guide, int done) {
    enough_->setText(tr("Use the %n that are done", nullptr, done));
    enough_->setDisabledBecause(done > 0 ? QString() : tr("No sensor has 90 % of the directions yet."));
    const bool turns = run_->step() == FieldGuide::kTurn;
    anew_->setDisabledBecause(turns ? QString() : tr("Nothing has been turned yet."));
    back_->setDisabledBecause(guide.isDone(FieldGuide::kSpot) ? QString() : tr("This is the first step."));
    without_floor_->setVisible(run_->step() == FieldGuide::kFloor);
    enough_->setVisible(turns);
    bool any_skipped = false;
    for (int board = 0; board < static_cast<int>(run_->suit().boards.size()); ++board)
        any_skipped |= guide.hasField(board) && guide.isSkipped(board);
    unskip_->setVisible(any_skipped);
}

void FieldSensors::unskipAll() {
    const FieldGuide* guide = run_->fieldGuide();
    for (int board = 0; guide && board < static_cast<int>(run_->suit().boards.size()); ++board)
        if (guide->hasField(board))
            run_->skip(board, false);
}

}  // namespace noctule::ui
