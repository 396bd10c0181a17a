// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/verdict_header.h"

#include <QBoxLayout>
#include <algorithm>

#include "ui/widgets/accessible.h"
#include "ui/widgets/icon_label.h"
#include "ui/widgets/label.h"

namespace noctule::ui {

VerdictHeader::VerdictHeader(QWidget* parent) : QWidget(parent) {
    describe(*this, {QAccessible::Heading});
    icon_ = new IconLabel(
        "info", [] { return colorOf(Tone::kNeutral); }, 20);
    verdict_ = (new Label({}, TextRole::kPage, Ink::kValue, true))->wrapped();
    text_ = (new Label({}, TextRole::kBody, Ink::kLabel))->wrapped();
    text_->setVisible(false);
    head_ = new QHBoxLayout;
    head_->addWidget(icon_, 0, Qt::AlignTop);
    head_->addWidget(verdict_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(head_);
    column->addWidget(text_);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    connect(&Theme::get(), &Theme::changed, this, &VerdictHeader::restyle);
    restyle();
}

void VerdictHeader::setVerdict(Tone tone, const QString& verdict, const QString& text) {
    tone_ = tone;
    icon_->setIcon(iconOf(tone), [tone] { return colorOf(tone); });
    verdict_->setText(verdict);
    text_->setText(text);
    text_->setVisible(!text.isEmpty());
    setAccessibleName(verdict);
    setAccessibleDescription(text);
}

void VerdictHeader::setRole(TextRole role) {
    role_ = role;
    restyle();
}

void VerdictHeader::restyle() {
    const Theme& theme = Theme::get();
    verdict_->setRole(role_, true);
    icon_->setIconSize(role_ == TextRole::kSection ? 16 : 24);
    // The icon stands in the middle of the first line.
    const int line = QFontMetrics(theme.font(role_, true)).height();
    icon_->setMinimumHeight(std::max(line, icon_->sizeHint().height()));
    head_->setSpacing(theme.px(8));
    layout()->setSpacing(theme.px(4));
}

}  // namespace noctule::ui
