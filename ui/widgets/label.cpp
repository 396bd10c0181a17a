// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/label.h"

namespace noctule::ui {

Label::Label(const QString& text, TextRole role, Ink ink, bool medium, QWidget* parent)
    : QLabel(text, parent), role_(role), ink_(ink), medium_(medium) {
    setTextFormat(Qt::PlainText);
    connect(&Theme::get(), &Theme::changed, this, &Label::restyle);
    restyle();
}

void Label::setInk(Ink ink) {
    ink_ = ink;
    restyle();
}

void Label::setRole(TextRole role, bool medium) {
    role_ = role;
    medium_ = medium;
    restyle();
}

Label* Label::wrapped() {
    setWordWrap(true);
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    return this;
}

Label* Label::selectable() {
    setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return this;
}

void Label::restyle() {
    setFont(Theme::get().font(role_, medium_));
    QPalette colors;
    for (const auto group : {QPalette::Active, QPalette::Inactive})
        colors.setColor(group, QPalette::WindowText, colorOf(ink_));
    colors.setColor(QPalette::Disabled, QPalette::WindowText, colorOf(Ink::kHint));
    setPalette(colors);
}

}  // namespace noctule::ui
