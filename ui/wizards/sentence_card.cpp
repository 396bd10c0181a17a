// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/sentence_card.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QResizeEvent>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/style/theme.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/label.h"
#include "ui/wizards/hold_ring.h"
#include "ui/wizards/wizard_words.h"

namespace noctule::ui {
namespace {

constexpr int kLeastCard = 116;

}  // namespace

SentenceCard::SentenceCard(QWidget* parent)
    : Card(parent),
      ring_(new HoldRing),
      sentence_(new Label({}, TextRole::kVerdict, Ink::kValue, true)),
      detail_(new Label({}, TextRole::kSection, Ink::kLabel)) {
    auto* row = makeRow(this, {20, 16, 20, 16}, 20);
    row->addWidget(ring_);
    auto* words = new QWidget;
    auto* column = makeColumn(words, {}, 4);
    column->addStretch();
    column->addWidget(sentence_->wrapped());
    column->addWidget(detail_->wrapped());
    column->addStretch();
    row->addWidget(words, 1);
    connect(&Theme::get(), &Theme::changed, this, &SentenceCard::forgetHeight);
    forgetHeight();
}

void SentenceCard::setSentence(const LiveSentence& now) {
    sentence_->setText(now.sentence);
    detail_->setText(now.detail);
    keepHeight();
    if (now.tone == tone_)
        return;
    tone_ = now.tone;
    update();
}

QString SentenceCard::sentence() const {
    return sentence_->text();
}

void SentenceCard::forgetHeight() {
    setFixedHeight(Theme::get().px(kLeastCard));
    keepHeight();
}

void SentenceCard::keepHeight() {
    sentence_->parentWidget()->updateGeometry();  // else the words' height is that of the sentence before
    setFixedHeight(std::max(height(), layout()->heightForWidth(width())));
}

void SentenceCard::resizeEvent(QResizeEvent* event) {
    Card::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
        forgetHeight();
}

void SentenceCard::paintEvent(QPaintEvent* event) {
    Card::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double width = Theme::get().px(2), inset = width / 2, radius = Theme::get().px(8);
    painter.setPen(QPen(tone_ == Tone::kNeutral ? Theme::get().tokens().edge : colorOf(tone_), width));
    painter.drawRoundedRect(QRectF(rect()).adjusted(inset, inset, -inset, -inset), radius, radius);
}

}  // namespace noctule::ui
