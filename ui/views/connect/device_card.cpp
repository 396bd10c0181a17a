// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/device_card.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QVBoxLayout>

#include "ui/models/suit_finder.h"
#include "ui/style/theme.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/icon_label.h"
#include "ui/widgets/label.h"
#include "ui/widgets/name_field.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

/// Of several suits, told apart by name as well; none of them is a colour of states.
QColor suitColour(int index) {
    const Tokens& tokens = Theme::get().tokens();
    const std::array colours{tokens.acc,           tokens.x,  tokens.y, tokens.confidence[2],
                             tokens.confidence[4], tokens.ref};
    static_assert(std::tuple_size_v<decltype(colours)> == SuitFinder::kSuitColours);
    return index < 0 ? tokens.t2 : colours[static_cast<size_t>(index) % colours.size()];
}

}  // namespace

DeviceCard::DeviceCard(QWidget* parent)
    : Card(parent),
      icon_(new IconLabel("usb", [this] { return suitColour(words_.colour); })),
      state_icon_(new IconLabel(
          "check", [this] { return colorOf(words_.tone); }, 14)),
      name_(new ElidedLabel({}, TextRole::kBody, Ink::kValue, true)),
      state_(new Label({}, TextRole::kSecondary, Ink::kHint)),
      detail_((new Label({}, TextRole::kSecondary, Ink::kLabel))->wrapped()),
      button_(makeButton(ButtonKind::kText, {})),
      rename_(new ToolButton("edit", tr("Rename"))),
      more_(new ToolButton("more", tr("More"))) {
    auto* column = makeColumn(this, {12, 8, 12, 10}, 2);
    head_ = addRow(column, 6);
    head_->addWidget(icon_);
    head_->addWidget(name_, 1);
    head_->addWidget(rename_);
    head_->addWidget(more_);
    auto* menu = new QMenu(more_);
    menu->addAction(tr("Forget"), this, [this] { emit forgotten(words_.serial); });
    more_->setMenu(menu);
    more_->setPopupMode(QToolButton::InstantPopup);
    more_->hide();
    setFocusProxy(rename_);  // where a name that was typed leaves the focus
    column->addWidget(detail_);
    foot_ = addRow(column, 6);
    foot_->addWidget(state_icon_);
    foot_->addWidget(state_, 1);
    foot_->addStretch();
    connect(button_, &QPushButton::clicked, this, &DeviceCard::activated);
    connect(rename_, &QToolButton::clicked, this, &DeviceCard::askForName);
}

void DeviceCard::askForName() {
    auto* field = new NameField(tr("Name of the suit"), words_.name, this);
    QRect place = name_->geometry().translated(name_->parentWidget()->mapTo(this, QPoint()));
    place.setRight(rename_->mapTo(this, rename_->rect().bottomRight()).x());
    const int height = field->sizeHint().height();
    field->setGeometry(place.x(), place.center().y() - height / 2, place.width(), height);
    // While a name is typed the list may change, and the card show another device.
    connect(field, &NameField::named, this,
            [this, serial = words_.serial](const QString& name) { emit named(serial, name); });
    field->show();
    field->setFocus(Qt::OtherFocusReason);
}

void DeviceCard::setWords(const DeviceWords& words) {
    if (words == words_)
        return;
    words_ = words;
    icon_->setIcon(words.icon, [this] { return suitColour(words_.colour); });
    name_->setText(words.name);
    state_->setText(words.state);
    state_->setInk(inkOf(words.tone));
    const bool has_icon = !words.state.isEmpty() && words.tone != Tone::kNeutral;
    state_icon_->setIcon(iconOf(words.tone), [this] { return colorOf(words_.tone); });
    state_icon_->setVisible(has_icon);
    state_->setVisible(!words.state.isEmpty());
    detail_->setText(words.detail);
    detail_->setVisible(!words.detail.isEmpty());
    button_->setText(words.action);
    // Beside the name where that has room, and no state has to be read first.
    const bool below = !words.state.isEmpty() || !words.serial.isEmpty();
    (below ? foot_ : head_)->addWidget(button_);
    foot_->parentWidget()->setVisible(below);
    button_->setVisible(!words.action.isEmpty());
    rename_->setVisible(!words.serial.isEmpty());
    more_->setVisible(words.can_be_forgotten);
    more_->setAccessibleName(tr("More about %1").arg(words.name));
    rename_->setAccessibleName(tr("Rename %1").arg(words.name));
    button_->setAccessibleName(words.action + ' ' + words.name);
    setSelected(words.chosen);
    setAccessibleName(words.name);
    setAccessibleDescription(words.state + (words.state.isEmpty() ? "" : ". ") + words.detail);
}

}  // namespace noctule::ui
