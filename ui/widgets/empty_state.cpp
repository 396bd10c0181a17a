// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/empty_state.h"

#include <QBoxLayout>

#include "ui/style/theme.h"
#include "ui/widgets/button.h"
#include "ui/widgets/label.h"

namespace noctule::ui {

EmptyState::EmptyState(const QString& sentence, const QString& action, const QString& icon_name,
                       QWidget* parent)
    : QWidget(parent) {
    sentence_ = (new Label(sentence, TextRole::kBody, Ink::kLabel))->wrapped();
    sentence_->setAlignment(Qt::AlignCenter);
    auto* column = new QVBoxLayout(this);
    column->addStretch(1);
    auto* middle = new QHBoxLayout;  // on a wide page too
    middle->addStretch();
    middle->addWidget(sentence_, 1000);
    middle->addStretch();
    column->addLayout(middle);
    if (!action.isEmpty()) {
        button_ = makeButton(ButtonKind::kOutlined, action, icon_name);
        connect(button_, &Button::clicked, this, &EmptyState::activated);
        column->addWidget(button_, 0, Qt::AlignHCenter);
    }
    column->addStretch(1);
    const auto restyle = [this, column] {
        const Theme& theme = Theme::get();
        column->setContentsMargins(theme.px(16), theme.px(16), theme.px(16), theme.px(16));
        column->setSpacing(theme.px(12));
        sentence_->setMaximumWidth(theme.px(640));
    };
    connect(&Theme::get(), &Theme::changed, this, restyle);
    restyle();
}

void EmptyState::setSentence(const QString& sentence) {
    sentence_->setText(sentence);
}

}  // namespace noctule::ui
