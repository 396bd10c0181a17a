// SPDX-License-Identifier: Apache-2.0
#include "ui/views/performer_buttons.h"

#include <QToolButton>

#include "ui/style/performer_disc.h"
#include "ui/style/theme.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/label.h"

namespace noctule::ui {

namespace {
constexpr int kSwitchDisc = 18, kSwitchPadding = 24, kSwitchHeight = 28;  // pixels at 100 percent
}

PerformerButtons::PerformerButtons(const QString& title, QWidget* parent)
    : QWidget(parent), row_(makeRow(this, {12, 4, 12, 4}, 4)) {
    row_->addWidget(new Label(title, TextRole::kSecondary, Ink::kHint));
    row_->addStretch();
    connect(&Theme::get(), &Theme::changed, this, &PerformerButtons::decorate);
    hide();
}

void PerformerButtons::setPerformers(const QStringList& names, int chosen) {
    chosen_ = chosen;
    const size_t count = names.size() > 1 ? static_cast<size_t>(names.size()) : 0;
    while (buttons_.size() > count) {
        // One may be on its way out of its own click.
        buttons_.back()->hide();
        buttons_.back()->deleteLater();
        buttons_.pop_back();
    }
    while (buttons_.size() < count) {
        const int index = static_cast<int>(buttons_.size());
        auto* button = new QToolButton;
        button->setCheckable(true);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        connect(button, &QToolButton::clicked, this, [this, button, index] {
            button->setChecked(index == chosen_);  // a click on the shown one does not switch it off
            emit this->chosen(index);
        });
        row_->insertWidget(row_->count() - 1, button);
        buttons_.push_back(button);
    }
    for (size_t i = 0; i < count; ++i) {
        const QString& name = names[static_cast<int>(i)];
        buttons_[i]->setText(name);
        buttons_[i]->setAccessibleName(tr("Show %1", "a performer").arg(name));
        buttons_[i]->setChecked(static_cast<int>(i) == chosen);
    }
    decorate();
    setVisible(count > 0);
}

void PerformerButtons::decorate() {
    const Theme& theme = Theme::get();
    const int size_px = theme.px(kSwitchDisc);
    for (size_t i = 0; i < buttons_.size(); ++i) {
        QToolButton& button = *buttons_[i];
        button.setFont(theme.font(TextRole::kBody, button.isChecked()));
        button.setIconSize({size_px, size_px});
        button.setIcon(performerPixmap(static_cast<int>(i), size_px, devicePixelRatioF()));
        const QFontMetrics metrics(theme.font(TextRole::kBody, true));
        button.setFixedSize(metrics.horizontalAdvance(button.text()) + size_px + theme.px(kSwitchPadding),
                            std::max(theme.px(kSwitchHeight), metrics.height()));
    }
}

}  // namespace noctule::ui
