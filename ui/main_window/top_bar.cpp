// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/top_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPainter>
#include <algorithm>
#include <array>

#include "ui/style/keys.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/step_bar.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

constexpr int kTopBarHeight = 52, kFoldBelow = 1180, kMark = 60, kGaps = 40;
constexpr std::array kSteps{Step::kConnect, Step::kCalibrate, Step::kRecord,
                            Step::kRobot,   Step::kReview,    Step::kExport};

}  // namespace

int TopBar::indexOf(Step step) {
    const auto found = std::find(kSteps.begin(), kSteps.end(), step);
    return found == kSteps.end() ? -1 : static_cast<int>(found - kSteps.begin());
}

Step TopBar::stepAt(int index) {
    return kSteps.at(static_cast<size_t>(index));
}

TopBar::TopBar(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    steps_ =
        new StepBar({tr("Connect"), tr("Calibrate"), tr("Record"), tr("Robot"), tr("Review"), tr("Export")});
    steps_->setShown(indexOf(Step::kRobot), false);
    left_ = makeLeft();
    right_ = makeRight();
    auto* row = makeRow(this, {12, 0, 12, 0}, 8);
    row->addWidget(left_, 1);
    row->addWidget(steps_);
    row->addWidget(right_, 1);
    followKey(*this, "window/record", QKeySequence("Ctrl+R"), [this](const QKeySequence& key) {
        record_key_ = key;
        showRecordKey();
    });
    connect(steps_, &StepBar::stepClicked, this, [this](int index) { emit stepRequested(stepAt(index)); });
    connect(&Theme::get(), &Theme::changed, this, [this] {
        updateGeometry();
        foldWhereNarrow();
    });
}

QWidget* TopBar::makeLeft() {
    auto* left = new QWidget;
    auto* row = makeRow(left, {}, 8);
    auto* mark = new QLabel;
    const auto draw = [mark] {
        mark->setPixmap(Theme::get().pixmap("bat", Theme::get().px(24), Theme::get().tokens().acc));
    };
    draw();
    connect(&Theme::get(), &Theme::changed, mark, draw);
    menus_ = new QMenuBar;
    menus_->setNativeMenuBar(false);
    menus_->setAccessibleName(tr("Menus"));
    menus_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    folded_ = new ToolButton("menu", tr("Menu"));
    folded_->setPopupMode(QToolButton::InstantPopup);
    folded_->hide();
    row->addWidget(mark);
    row->addWidget(menus_, 1);
    row->addWidget(folded_);
    row->addStretch();
    return left;
}

QWidget* TopBar::makeRight() {
    auto* right = new QWidget;
    auto* row = makeRow(right, {}, 8);
    suit_ = new Chip(Tone::kNeutral, tr("No suit"), "board");
    suit_->setToolTip(tr("No suit is connected. Opens Connect."));
    box_ = new Chip(Tone::kNeutral, {}, "link");
    box_->setToolTip(tr("The connected suit. Opens Connect."));
    box_->hide();
    record_ = makeButton(ButtonKind::kRecord, tr("Record"), "record");
    preferences_ = new ToolButton("gear", tr("Preferences"));
    followKey(*preferences_, "window/preferences", QKeySequence("Ctrl+,"),
              [this](const QKeySequence& key) { preferences_->setMeaning("gear", tr("Preferences"), key); });
    row->addStretch();
    row->addWidget(suit_);
    row->addWidget(box_);
    row->addWidget(record_);
    row->addWidget(preferences_);
    for (Chip* chip : {suit_, box_})
        connect(chip, &QAbstractButton::clicked, this, [this] { emit stepRequested(Step::kConnect); });
    connect(record_, &QPushButton::clicked, this, &TopBar::recordRequested);
    connect(preferences_, &QToolButton::clicked, this, &TopBar::preferencesRequested);
    return right;
}

void TopBar::fold(const QList<QMenu*>& menus) {
    auto* all = new QMenu(folded_);
    for (QMenu* menu : menus)
        all->addMenu(menu);
    folded_->setMenu(all);
    foldWhereNarrow();
}

bool TopBar::isFolded() const {
    return menus_->isHidden();
}

void TopBar::showStep(Step step) {
    const bool start = step == Step::kStart;
    step_ = step;
    steps_->setCurrent(indexOf(step));
    steps_->setVisible(!start);
    preferences_->setVisible(start);
    showRecordButton();
    foldWhereNarrow();
}

void TopBar::showRobot(bool shown) {
    steps_->setShown(indexOf(Step::kRobot), shown);
    foldWhereNarrow();
}

void TopBar::showRecording(std::optional<double> seconds) {
    const bool changes = records_ != seconds.has_value();
    records_ = seconds.has_value();
    record_->setText(seconds ? timeText(*seconds, 0) : tr("Record"));
    record_->setAccessibleName(seconds ? tr("Recording, %1").arg(timeText(*seconds, 0)) : tr("Record"));
    if (!changes)
        return;
    showRecordKey();
    showRecordButton();
}

void TopBar::showRecordKey() {
    record_->setToolTip((records_ ? tr("A take is being recorded. Opens Record; %1 stops it.", "a key")
                                  : tr("Opens Record (%1)", "a key"))
                            .arg(keysText(record_key_)));
    foldWhereNarrow();
}

void TopBar::showRecordButton() {
    record_->setVisible(step_ != Step::kRecord && (records_ || step_ != Step::kStart));
}

void TopBar::showSuit(Tone tone, const QString& state, const QString& name, bool needs_attention) {
    const bool connected = !name.isEmpty();
    const QString words = connected ? state : tr("No suit");
    const StepBar::State step = !connected                              ? StepBar::State::kOpen
                                : tone == Tone::kOk && !needs_attention ? StepBar::State::kDone
                                                                        : StepBar::State::kAttention;
    const int connect_step = indexOf(Step::kConnect);
    if (suit_->text() == words && suit_->tone() == tone && box_->text() == name &&
        steps_->state(connect_step) == step)
        return;
    steps_->setState(connect_step, step);
    suit_->setState(tone, words, tone == Tone::kNeutral ? "board" : QString());
    suit_->setToolTip(connected ? state + QLatin1Char('\n') + tr("Boards that are there. Opens Connect.")
                                : tr("No suit is connected. Opens Connect."));
    box_->setState(Tone::kNeutral, name, "link");
    foldWhereNarrow();
}

void TopBar::foldWhereNarrow() {
    // The steps stand in the centre; in some languages the menus need more than what is left beside them.
    const int beside = (width() - steps_->sizeHint().width()) / 2 - Theme::get().px(kMark);
    const bool narrow = width() < Theme::get().px(kFoldBelow) || menus_->sizeHint().width() > beside;
    const bool fold = narrow && !steps_->isHidden();
    menus_->setVisible(!fold);
    folded_->setVisible(fold);
    const bool has_steps = !steps_->isHidden();
    record_->setShortcutHint(records_ ? QKeySequence() : record_key_);
    suit_->setBrief(false);
    const int sides = 2 * (record_->sizeHint().width() + suit_->sizeHint().width() + Theme::get().px(36));
    const bool room = has_steps && width() > steps_->sizeHint().width() + sides;
    suit_->setVisible(has_steps);
    suit_->setBrief(!room);
    // A suit's trouble must be seen: the keys of Record give way to it.
    const int all = folded_->sizeHint().width() + steps_->sizeHint().width() + record_->sizeHint().width() +
                    suit_->sizeHint().width() + Theme::get().px(kMark + kGaps);
    if (has_steps && all > width())
        record_->setShortcutHint({});
    const int box = 2 * (box_->sizeHint().width() + Theme::get().px(8));
    box_->setVisible(room && !box_->text().isEmpty() && width() > steps_->sizeHint().width() + sides + box);
}

QSize TopBar::sizeHint() const {
    return {Theme::get().px(kFoldBelow), Theme::get().px(kTopBarHeight)};
}

QSize TopBar::minimumSizeHint() const {
    const int left = folded_->sizeHint().width() + Theme::get().px(kMark + kGaps),
              right = right_->minimumSizeHint().width();
    return {steps_->isHidden() ? 2 * std::max(left, right) : left + steps_->minimumSizeHint().width() + right,
            Theme::get().px(kTopBarHeight)};
}

void TopBar::paintEvent(QPaintEvent*) {
    const Tokens& tokens = Theme::get().tokens();
    QPainter painter(this);
    painter.fillRect(rect(), tokens.panel);
    painter.fillRect(QRect(0, height() - 1, width(), 1), tokens.line);
}

void TopBar::resizeEvent(QResizeEvent*) {
    foldWhereNarrow();
}

}  // namespace noctule::ui
