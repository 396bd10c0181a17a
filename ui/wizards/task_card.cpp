// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/task_card.h"

#include <QHBoxLayout>

#include "ui/style/theme.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/icon_label.h"
#include "ui/widgets/label.h"

namespace noctule::ui {

TaskCard::TaskCard(const WizardWords& words, QWidget* parent)
    : Card(parent),
      state_(new Label({}, TextRole::kSecondary, Ink::kLabel)),
      state_icon_(new IconLabel("info", [] { return colorOf(Ink::kHint); })),
      button_(makeButton(ButtonKind::kOutlined, tr("Prepare"))) {
    auto* row = makeRow(this, {20, 12, 20, 12}, 20);
    row->addWidget(new IconLabel(
                       words.icon, [] { return Theme::get().tokens().t2; }, 40),
                   0, Qt::AlignTop);
    auto* texts = new QWidget;
    auto* column = makeColumn(texts, {}, 4);
    column->addWidget(new Label(words.title, TextRole::kSection, Ink::kValue, true));
    column->addWidget((new Label(words.what, TextRole::kBody, Ink::kLabel))->wrapped());
    column->addWidget((new Label(words.takes, TextRole::kSecondary, Ink::kHint))->wrapped());
    auto* state = addRow(column, 6, {0, 4, 0, 0});
    state->addWidget(state_icon_);
    state->addWidget(state_->wrapped(), 1);
    row->addWidget(texts, 1);
    button_->setAccessibleName(tr("Prepare: %1").arg(words.title));
    row->addWidget(button_, 0, Qt::AlignVCenter);
}

void TaskCard::setState(Tone tone, const QString& state) {
    state_->setText(state);
    state_->setInk(inkOf(tone));
    state_icon_->setIcon(tone == Tone::kNeutral ? QStringLiteral("info") : iconOf(tone),
                         [tone] { return tone == Tone::kNeutral ? colorOf(Ink::kHint) : colorOf(tone); });
}

QString TaskCard::state() const {
    return state_->text();
}

void TaskCard::setButton(const QString& text, bool is_next) {
    button_->setText(text);
    setSelected(is_next);
}

}  // namespace noctule::ui
