// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/tour.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "ui/main_window/main_window.h"
#include "ui/main_window/top_bar.h"
#include "ui/style/theme.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/step_bar.h"

namespace noctule::ui {
namespace {

/// The step Robot is there only with a robot.
constexpr std::array kToured{Step::kConnect, Step::kCalibrate, Step::kRecord, Step::kReview, Step::kExport};
constexpr int kCards = kToured.size(), kTourWidth = 340, kPointer = 8;
constexpr const char* kSeen = "tour/offered";

struct CardWords {
    QString title, text;
};

CardWords wordsOf(int card) {
    switch (card) {
        case 0:
            return {
                Tour::tr("Connect"),
                Tour::tr("The suit on the body: what every board hears and feels, and what to do when one is "
                         "silent. Any step can be opened at any time.")};
        case 1:
            return {Tour::tr("Calibrate"),
                    Tour::tr("Wizards find out how the suit measures and how it sits on the body. They "
                             "go on by themselves and say when something is not good enough.")};
        case 2:
            return {Tour::tr("Record"),
                    Tour::tr("One large button. A take is on disk while it runs; whatever happens, "
                             "it is safe up to the last second.")};
        case 3:
            return {Tour::tr("Review"),
                    Tour::tr("The body moves, and every plot follows the same time. Process again "
                             "with other sensors, compare with a reference, read the report.")};
        default:
            return {Tour::tr("Export"),
                    Tour::tr("Choose what the animation is for. Every file is read back and "
                             "compared with its take before it counts as written.")};
    }
}

}  // namespace

bool Tour::isDue(QSettings& settings) {
    return !settings.value(kSeen, false).toBool();
}

void Tour::noteAnswer(QSettings& settings) {
    settings.setValue(kSeen, true);
}

Tour::Tour(MainWindow& window, TopBar& bar) : QFrame(&window), window_(window), bar_(bar) {
    auto* column = makeColumn(this, {20, 16 + kPointer, 20, 16}, 8);
    count_ = new Label({}, TextRole::kSecondary, Ink::kHint);
    title_ = new Label({}, TextRole::kPage, Ink::kValue, true);
    text_ = new Label({}, TextRole::kBody, Ink::kLabel);
    text_->wrapped();
    column->addWidget(count_);
    column->addWidget(title_);
    column->addWidget(text_);
    auto* row = addRow(column);
    skip_ = makeButton(ButtonKind::kText, tr("Leave the tour"));
    back_ = makeButton(ButtonKind::kOutlined, tr("Back"));
    next_ = makeButton(ButtonKind::kPrimary, tr("Next"));
    next_->setTall(false);
    row->addWidget(skip_);
    row->addStretch();
    row->addWidget(back_);
    row->addWidget(next_);
    keepSize(*this, kTourWidth, 0);
    connect(skip_, &QPushButton::clicked, this, &Tour::end);
    connect(back_, &QPushButton::clicked, this, [this] { show(card_ - 1); });
    connect(next_, &QPushButton::clicked, this, [this] { card_ + 1 < kCards ? show(card_ + 1) : end(); });
    window_.installEventFilter(this);
}

void Tour::start() {
    left_from_ = window_.step();
    QFrame::show();
    show(0);
}

void Tour::show(int card) {
    card_ = card;
    const CardWords words = wordsOf(card);
    window_.goTo(kToured.at(static_cast<size_t>(card)));
    count_->setText(tr("%1 of %2", "number of a card, how many there are").arg(card + 1).arg(kCards));
    title_->setText(words.title);
    text_->setText(words.text);
    setAccessibleName(words.title);
    setAccessibleDescription(words.text);
    back_->setVisible(card > 0);
    next_->setText(card + 1 < kCards ? tr("Next") : tr("Done"));
    place();
    next_->setFocus(Qt::TabFocusReason);  // the page that came has taken it
}

void Tour::place() {
    const StepBar& steps = bar_.steps();
    const QRect in_bar = steps.stepRect(TopBar::indexOf(kToured.at(static_cast<size_t>(card_))));
    const QRect step(steps.mapTo(&window_, in_bar.topLeft()), in_bar.size());
    const QSize size(Theme::get().px(kTourWidth),
                     std::max(heightForWidth(Theme::get().px(kTourWidth)), sizeHint().height()));
    const int left =
        std::clamp(step.center().x() - size.width() / 2, 8, std::max(8, window_.width() - size.width() - 8));
    pointer_x_ = step.center().x() - left;
    setGeometry(QRect(QPoint(left, bar_.geometry().bottom() + 2), size));
    raise();
    update();
}

void Tour::end() {
    window_.goTo(left_from_);
    deleteLater();
    hide();
}

void Tour::keyPressEvent(QKeyEvent* event) {
    const bool is_return = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    auto* button = qobject_cast<QPushButton*>(focusWidget());
    if (event->key() == Qt::Key_Escape)
        end();
    else if (is_return && button)
        button->click();
    else
        QFrame::keyPressEvent(event);
}

bool Tour::focusNextPrevChild(bool next) {
    std::vector<QWidget*> buttons;
    for (Button* button : {skip_, back_, next_})
        if (button->isVisible())
            buttons.push_back(button);
    if (buttons.empty())  // it ends
        return QFrame::focusNextPrevChild(next);
    const auto at = std::ranges::find(buttons, focusWidget());
    const auto count = std::ssize(buttons), index = at - buttons.begin();
    buttons[static_cast<size_t>((index + (next ? 1 : count - 1)) % count)]->setFocus(Qt::TabFocusReason);
    return true;
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && isVisible())
        place();
    return QFrame::eventFilter(watched, event);
}

void Tour::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const double tip = theme.px(kPointer), radius = theme.px(8);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath card, pointer;
    card.addRoundedRect(QRectF(rect()).adjusted(0.5, tip + 0.5, -0.5, -0.5), radius, radius);
    pointer.addPolygon(
        QVector<QPointF>{{pointer_x_ - tip, tip + 1}, {1.0 * pointer_x_, 1}, {pointer_x_ + tip, tip + 1}});
    painter.setPen(tokens.acc);
    painter.setBrush(tokens.raised);
    painter.drawPath(card.united(pointer));
}

}  // namespace noctule::ui
