// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/wizard_rail.h"

#include <QCheckBox>
#include <QPainter>
#include <QVBoxLayout>

#include "ui/style/paint.h"
#include "ui/style/theme.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"

namespace noctule::ui {

RailStep::RailStep(QWidget* parent) : QAbstractButton(parent) {
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    connect(&Theme::get(), &Theme::changed, this, [this] {
        updateGeometry();
        update();
    });
}

void RailStep::setStep(State state, const QString& name, const QString& hint, bool chosen) {
    state_ = state;
    name_ = name;
    hint_ = hint;
    chosen_ = chosen;
    const QString words = state == State::kDone      ? tr("%1, %2, done")
                          : state == State::kCurrent ? tr("%1, %2, now")
                                                     : tr("%1, %2, to come");
    setAccessibleName(words.arg(name, hint));
    updateGeometry();
    update();
}

QSize RailStep::sizeHint() const {
    return QSize(Theme::get().px(200), Theme::get().px(hint_.isEmpty() ? 40 : 52));
}

void RailStep::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (state_ == State::kCurrent || chosen_)
        painter.fillRect(rect(), tokens.sel);
    const QRectF circle(theme.px(15), (height() - theme.px(20)) / 2.0, theme.px(20), theme.px(20));
    if (state_ == State::kDone) {
        painter.setPen(QPen(tokens.ok, theme.px(1.5)));
        painter.drawEllipse(circle);
        paintIcon(painter, circle, "check", theme.px(14), tokens.ok);
    } else if (state_ == State::kCurrent) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(tokens.acc);
        painter.drawEllipse(circle);
        painter.setBrush(tokens.onacc);
        painter.drawEllipse(circle.center(), theme.px(4), theme.px(4));
    } else {
        painter.setPen(QPen(tokens.edge, theme.px(1.5)));
        painter.drawEllipse(circle);
    }
    const int left = theme.px(45);
    const QRect words = rect().adjusted(left, 0, -theme.px(8), 0);
    painter.setPen(state_ == State::kWaiting ? tokens.t2 : tokens.t1);
    painter.setFont(theme.font(TextRole::kBody, state_ == State::kCurrent));
    const int middle = height() / 2;
    const QRect upper =
        hint_.isEmpty() ? words : QRect(words.left(), middle - theme.px(18), words.width(), theme.px(18));
    painter.drawText(upper, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(name_, Qt::ElideRight, words.width()));
    if (!hint_.isEmpty()) {
        painter.setPen(tokens.t3);
        painter.setFont(theme.font(TextRole::kCaption));
        painter.drawText(QRect(words.left(), middle + theme.px(1), words.width(), theme.px(16)),
                         Qt::AlignLeft | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(hint_, Qt::ElideRight, words.width()));
    }
}

WizardRail::WizardRail(QWidget* parent)
    : QWidget(parent),
      title_(new Label({}, TextRole::kPage, Ink::kValue, true)),
      hint_(new Label({}, TextRole::kSecondary, Ink::kLabel)),
      tones_(new QCheckBox(tr("Tones"))),
      leave_(makeButton(ButtonKind::kOutlined, tr("Leave and resume later"))) {
    auto* column = makeColumn(this, {0, 12, 0, 12});
    auto* head = new QWidget;
    auto* head_column = makeColumn(head, {15, 0, 15, 10}, 4);
    head_column->addWidget(new Label(tr("Calibrate"), TextRole::kCaption, Ink::kHint));
    head_column->addWidget(title_);
    column->addWidget(head);
    auto* rows = new QWidget;
    rows_column_ = makeColumn(rows);
    column->addWidget(rows);
    column->addStretch();
    auto* foot = new QWidget;
    auto* foot_column = makeColumn(foot, {15, 12, 15, 0}, 12);
    foot_column->addWidget(hint_->wrapped());
    tones_->setToolTip(tr("A tone when a step is right, another when it has been taken"));
    foot_column->addWidget(tones_);
    foot_column->addWidget(leave_);
    column->addWidget(foot);
    connect(leave_, &QPushButton::clicked, this, &WizardRail::leaveRequested);
    connect(tones_, &QCheckBox::toggled, this, [this](bool on) {
        if (run_)
            run_->setTones(on);
    });
}

void WizardRail::setRun(WizardRun* run) {
    run_ = run;
    chosen_ = -1;
    if (!run)
        return;
    const WizardWords words = wordsOf(run->task());
    title_->setText(words.title);
    hint_->setText(words.in_any_order);
    tones_->setChecked(run->tones());
    connect(run, &WizardRun::changed, this, &WizardRail::refresh);
    connect(run, &WizardRun::guided, this, &WizardRail::refresh);
    refresh();
}

RailStep* WizardRail::row(size_t index) {
    while (rows_.size() <= index) {
        auto* step = new RailStep;
        const int at = static_cast<int>(rows_.size()) - 1;  // behind "What you need"
        connect(step, &QAbstractButton::clicked, this, [this, at] {
            if (!run_ || !run_->guide() || at < 0 || at >= run_->stepCount() || !run_->guide()->isDone(at))
                return;
            chosen_ = chosen_ == at ? -1 : at;
            refresh();
            emit stepChosen(chosen_);
        });
        rows_column_->addWidget(step);
        rows_.push_back(step);
    }
    return rows_[index];
}

void WizardRail::refresh() {
    if (!run_)
        return;
    using Phase = WizardRun::Phase;
    using State = RailStep::State;
    const Phase phase = run_->phase();
    size_t at = 0;
    row(at++)->setStep(phase == Phase::kIntro ? State::kCurrent : State::kDone, tr("What you need"),
                       wordsOf(run_->task()).takes.section(';', 0, 0).section(',', -1).trimmed(), false);
    const bool guides = phase == Phase::kGuiding || phase == Phase::kTaking;
    if (chosen_ >= run_->stepCount() || (chosen_ >= 0 && !run_->guide()->isDone(chosen_)))
        chosen_ = -1;
    for (int step = 0; step < run_->stepCount(); ++step) {
        const StepWords words = run_->stepWords(step);
        const bool done = run_->guide()->isDone(step);
        row(at++)->setStep(done                             ? State::kDone
                           : guides && step == run_->step() ? State::kCurrent
                                                            : State::kWaiting,
                           words.name, words.hint, step == chosen_);
    }
    const bool over = phase == Phase::kResult || phase == Phase::kSolving;
    row(at++)->setStep(over ? State::kCurrent : State::kWaiting, tr("Result"), {}, false);
    for (size_t i = 0; i < rows_.size(); ++i)
        rows_[i]->setVisible(i < at);
    tones_->setChecked(run_->tones());
    leave_->setText(!run_->isUnfinished() || run_->task() == WizardTask::kCheck || phase == Phase::kIntro
                        ? way_back_
                        : tr("Leave and resume later"));
}

}  // namespace noctule::ui
