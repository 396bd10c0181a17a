// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/problem_card.h"

#include <QBoxLayout>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "ui/style/theme.h"
#include "ui/widgets/accessible.h"
#include "ui/widgets/button.h"
#include "ui/widgets/icon_label.h"
#include "ui/widgets/label.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {

ProblemCard::ProblemCard(Tone tone, const QString& title, const QString& text, QWidget* parent)
    : QWidget(parent), tone_(tone) {
    describe(*this, {QAccessible::AlertMessage});
    icon_ = new IconLabel(iconOf(tone), [tone] { return colorOf(tone); });
    title_ = (new Label({}, TextRole::kBody, Ink::kValue, true))->wrapped();
    text_ = (new Label({}, TextRole::kSecondary, Ink::kLabel))->wrapped();
    close_ = new ToolButton("close", tr("Close"), {}, this);
    close_->setVisible(false);
    connect(close_, &ToolButton::clicked, this, &ProblemCard::closed);

    auto* head = new QHBoxLayout;
    head->setContentsMargins(0, 0, 0, 0);
    head->addWidget(icon_, 0, Qt::AlignTop);
    head->addWidget(title_, 1);
    content_ = new QVBoxLayout(this);
    content_->addLayout(head);
    content_->addWidget(text_);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    connect(&Theme::get(), &Theme::changed, this, &ProblemCard::restyle);
    restyle();
    setTexts(title, text);
}

void ProblemCard::setTexts(const QString& title, const QString& text) {
    title_->setText(title);
    text_->setText(text);
    text_->setVisible(!text.isEmpty());
    setAccessibleName(title);
    setAccessibleDescription(text);
}

Button* ProblemCard::addAction(const QString& text, const QString& icon_name) {
    if (!actions_) {
        actions_ = new QHBoxLayout;
        actions_->addStretch(1);
        content_->addLayout(actions_);
        restyle();
    }
    const bool first = actions_->count() == 1;
    Button* button = makeButton(first ? ButtonKind::kOutlined : ButtonKind::kText, text, icon_name);
    actions_->insertWidget(actions_->count() - 1, button, 0, Qt::AlignLeft);
    arrangeActions();
    return button;
}

std::vector<int> ProblemCard::actionWidths() const {
    std::vector<int> widths;
    for (int i = 0; actions_ && i < actions_->count(); ++i)
        if (const QWidget* button = actions_->itemAt(i)->widget(); button && !button->isHidden())
            widths.push_back(button->sizeHint().width());
    return widths;
}

/// Beside one another where they find room, else below.
void ProblemCard::arrangeActions() {
    if (!actions_)
        return;
    int needed = -actions_->spacing();
    for (const int width : actionWidths())
        needed += width + actions_->spacing();
    actions_->setDirection(needed > contentsRoom() ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

int ProblemCard::contentsRoom() const {
    const QMargins around = content_->contentsMargins();
    return width() - around.left() - around.right();
}

QSize ProblemCard::minimumSizeHint() const {
    QSize least = QWidget::minimumSizeHint();
    if (!actions_)
        return least;
    int widest = std::max(content_->itemAt(0)->minimumSize().width(), text_->minimumSizeHint().width());
    for (const int width : actionWidths())
        widest = std::max(widest, width);
    least.setWidth(widest + width() - contentsRoom());
    return least;
}

void ProblemCard::setClosable(bool closable) {
    closable_ = closable;
    close_->setVisible(closable);
    restyle();
}

QString ProblemCard::title() const {
    return title_->text();
}

void ProblemCard::restyle() {
    const Theme& theme = Theme::get();
    content_->setContentsMargins(theme.px(12), theme.px(12), theme.px(12), theme.px(12));
    content_->setSpacing(theme.px(6));
    content_->itemAt(0)->layout()->setSpacing(theme.px(8));
    content_->itemAt(0)->layout()->setContentsMargins(0, 0, closable_ ? theme.px(24) : 0, 0);
    placeClose();
    if (actions_) {
        actions_->setContentsMargins(0, theme.px(4), 0, 0);
        actions_->setSpacing(theme.px(8));
    }
    arrangeActions();
    update();
}

void ProblemCard::placeClose() {
    const int gap = Theme::get().px(6);
    close_->resize(close_->sizeHint());
    close_->move(width() - close_->width() - gap, gap);
}

void ProblemCard::resizeEvent(QResizeEvent*) {
    arrangeActions();
    placeClose();
}

void ProblemCard::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath card;
    card.addRoundedRect(rect(), theme.px(4), theme.px(4));
    painter.fillPath(card, theme.tokens().raised);
    painter.setClipPath(card);
    painter.fillRect(QRect(0, 0, theme.px(3), height()), colorOf(tone_));
}

void ProblemCard::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (!announced_)
        announce(*this);
    announced_ = true;
}

}  // namespace noctule::ui
