// SPDX-License-Identifier: Apache-2.0
#include "ui/views/suit_state_card.h"

#include <QPainter>
#include <QVBoxLayout>

#include "ui/style/performer_disc.h"
#include "ui/style/theme.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/elided_label.h"

namespace noctule::ui {
namespace {

constexpr int kStateDisc = 18, kStateStripe = 3;

}  // namespace

SuitStateCard::SuitStateCard(QWidget* parent)
    : Card(parent),
      disc_(new QLabel),
      name_(new ElidedLabel({}, TextRole::kBody, Ink::kValue, true)),
      box_(new ElidedLabel({}, TextRole::kSecondary, Ink::kHint)),
      verdict_(new Chip(Tone::kNeutral, {})),
      problem_((new Label({}, TextRole::kSecondary, Ink::kLabel))->wrapped()),
      show_(makeButton(ButtonKind::kText, tr("Show"))) {
    auto* column = makeColumn(this, {12, 8, 12, 8}, 4);
    auto* head = addRow(column, 8);
    head->addWidget(disc_);
    head->addWidget(name_, 1);
    head->addWidget(show_);
    verdict_->setInteractive(false);
    addRow(column, 0)->addWidget(verdict_, 0, Qt::AlignLeft);
    column->addWidget(problem_);
    column->addWidget(box_);
    connect(show_, &QPushButton::clicked, this, &SuitStateCard::showWanted);
    connect(&Theme::get(), &Theme::changed, this, &SuitStateCard::decorate);
}

void SuitStateCard::setWords(const SuitStateWords& words) {
    if (words == words_)
        return;
    words_ = words;
    name_->setText(words.name);
    box_->setText(words.box);
    box_->setVisible(!words.box.isEmpty());
    verdict_->setState(words.tone, words.verdict);
    problem_->setText(words.problem);
    problem_->setVisible(!words.problem.isEmpty());
    show_->setVisible(!words.is_shown);
    show_->setAccessibleName(tr("Show %1", "a performer").arg(words.name));
    setSelected(words.is_shown);
    setAccessibleName(words.name);
    setAccessibleDescription(words.problem.isEmpty() ? words.verdict : words.verdict + ". " + words.problem);
    decorate();
}

void SuitStateCard::decorate() {
    disc_->setPixmap(performerPixmap(words_.letter, Theme::get().px(kStateDisc), devicePixelRatioF()));
    update();
}

void SuitStateCard::paintEvent(QPaintEvent* event) {
    Card::paintEvent(event);
    QPainter painter(this);
    painter.fillRect(QRect(0, 0, Theme::get().px(kStateStripe), height()), performerColor(words_.letter));
}

}  // namespace noctule::ui
