// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/progress_line.h"

#include <QGridLayout>
#include <QProgressBar>

#include "ui/style/theme.h"
#include "ui/widgets/button.h"
#include "ui/widgets/elided_label.h"

namespace noctule::ui {

namespace {

constexpr int kSteps = 1000;

}  // namespace

ProgressLine::ProgressLine(QWidget* parent) : QWidget(parent) {
    text_ = new ElidedLabel({}, TextRole::kSecondary, Ink::kLabel);
    bar_ = new QProgressBar;
    bar_->setRange(0, kSteps);
    bar_->setTextVisible(false);
    bar_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    cancel_ = makeButton(ButtonKind::kText, tr("Cancel"));
    connect(cancel_, &Button::clicked, this, &ProgressLine::cancelled);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(text_, 0, 0);
    grid->addWidget(bar_, 1, 0);
    grid->addWidget(cancel_, 0, 1, 2, 1);
    grid->setColumnStretch(0, 1);
    const auto restyle = [grid] {
        grid->setHorizontalSpacing(Theme::get().px(8));
        grid->setVerticalSpacing(Theme::get().px(2));
    };
    connect(&Theme::get(), &Theme::changed, this, restyle);
    restyle();
}

void ProgressLine::setText(const QString& text) {
    text_->setText(text);
    bar_->setAccessibleName(text);
}

void ProgressLine::setFraction(double fraction) {
    const bool known = fraction >= 0;
    bar_->setRange(0, known ? kSteps : 0);
    if (known)
        bar_->setValue(qRound(std::min(fraction, 1.0) * kSteps));
}

void ProgressLine::setCancellable(bool cancellable) {
    cancel_->setVisible(cancellable);
}

}  // namespace noctule::ui
