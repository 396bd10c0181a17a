// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/step_bar.h"

#include <QAbstractButton>
#include <QBoxLayout>
#include <QKeyEvent>
#include <QPainter>

#include "ui/style/paint.h"
#include "ui/style/theme.h"

namespace noctule::ui {

class StepBar::StepButton : public QAbstractButton {
public:
    StepButton(const QString& name, int number, QWidget* parent) : QAbstractButton(parent), number_(number) {
        setText(name);
        setCheckable(true);
        setFocusPolicy(Qt::TabFocus);
        setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
        setState(State::kOpen);
    }

    void setState(State state) {
        state_ = state;
        setAccessibleDescription(state == State::kDone        ? StepBar::tr("Done")
                                 : state == State::kAttention ? StepBar::tr("Needs attention")
                                                              : StepBar::tr("Step %1").arg(number_));
        update();
    }
    State state() const { return state_; }
    void setNumber(int number) {
        number_ = number;
        setState(state_);
    }

    QSize sizeHint() const override {
        const Theme& theme = Theme::get();
        const QFontMetrics metrics(theme.font(TextRole::kBody, true));
        return {metrics.horizontalAdvance(text()) + theme.px(4 + 18 + 8 + 4), theme.px(52)};
    }
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent*) override {
        const Theme& theme = Theme::get();
        const Tokens& tokens = theme.tokens();
        QPainter painter(this);
        const bool lit = isChecked() || underMouse();
        const QColor ring = state_ == State::kDone        ? tokens.ok
                            : state_ == State::kAttention ? tokens.warn
                            : isChecked()                 ? tokens.acc
                                                          : tokens.edge;
        paintBadge(painter, ring, state_ == State::kOpen && !isChecked() ? tokens.t2 : ring);
        painter.setFont(theme.font(TextRole::kBody, true));
        painter.setPen(lit ? tokens.t1 : tokens.t2);
        painter.drawText(rect().adjusted(theme.px(30), 0, 0, 0), Qt::AlignVCenter, text());
        if (isChecked())
            paintBox(painter, QRect(0, height() - theme.px(2), width(), theme.px(2)), 1, tokens.acc);
    }
    void enterEvent(QEvent*) override { update(); }
    void leaveEvent(QEvent*) override { update(); }

private:
    void paintBadge(QPainter& painter, const QColor& ring, const QColor& mark) const {
        const Theme& theme = Theme::get();
        const QRect circle(theme.px(4), (height() - theme.px(18)) / 2, theme.px(18), theme.px(18));
        paintBox(painter, circle, theme.px(9), {}, ring);
        if (state_ == State::kDone)
            return paintIcon(painter, circle, "check", theme.px(12), mark);
        painter.setFont(theme.font(TextRole::kCaption, true));
        painter.setPen(mark);
        painter.drawText(circle, Qt::AlignCenter,
                         state_ == State::kAttention ? "!" : QString::number(number_));
    }

    int number_;
    State state_ = State::kOpen;
};

StepBar::StepBar(const QStringList& names, QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
    for (const QString& name : names) {
        const int index = count();
        auto* step = new StepButton(name, index + 1, this);
        step->installEventFilter(this);
        row->addWidget(step);
        steps_.push_back(step);
        connect(step, &QAbstractButton::clicked, this, [this, index] {
            setCurrent(current_);  // shown as present only once it is
            emit stepClicked(index);
        });
    }
    const auto restyle = [row] { row->setSpacing(Theme::get().px(24)); };
    connect(&Theme::get(), &Theme::changed, this, [this, restyle] {
        restyle();
        for (StepButton* step : steps_)
            step->updateGeometry();
    });
    restyle();
    setAccessibleName(tr("Steps"));
}

void StepBar::setState(int index, State state) {
    steps_.at(index)->setState(state);
}

StepBar::State StepBar::state(int index) const {
    return steps_.at(index)->state();
}

QString StepBar::name(int index) const {
    return steps_.at(index)->text();
}

void StepBar::setShown(int index, bool shown) {
    steps_.at(index)->setVisible(shown);
    int number = 0;
    for (StepButton* step : steps_)
        if (!step->isHidden())
            step->setNumber(++number);
    updateGeometry();
}

bool StepBar::isShown(int index) const {
    return !steps_.at(index)->isHidden();
}

void StepBar::setCurrent(int index) {
    current_ = index;
    for (int i = 0; i < count(); ++i)
        steps_[i]->setChecked(i == index);
}

QRect StepBar::stepRect(int index) const {
    return steps_.at(index)->geometry();
}

bool StepBar::eventFilter(QObject* object, QEvent* event) {
    if (event->type() != QEvent::KeyPress)
        return false;
    const auto here = std::find(steps_.begin(), steps_.end(), object);
    if (here == steps_.end())
        return false;
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        (*here)->click();
        return true;
    }
    const int index = static_cast<int>(here - steps_.begin());
    const int next = key == Qt::Key_Right  ? index + 1
                     : key == Qt::Key_Left ? index - 1
                     : key == Qt::Key_Home ? 0
                     : key == Qt::Key_End  ? count() - 1
                                           : -1;
    if (next < 0 || next >= count())
        return key == Qt::Key_Right || key == Qt::Key_Left;
    const int onward = key == Qt::Key_Left ? -1 : 1;
    const int reached = steps_[next]->isHidden() ? next + onward : next;
    steps_[reached]->setFocus(Qt::TabFocusReason);
    return true;
}

}  // namespace noctule::ui
