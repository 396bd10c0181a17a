// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/tool_button.h"

#include <QPainter>
#include <QStyleOption>

#include "ui/style/paint.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"

namespace noctule::ui {

ToolButton::ToolButton(const QString& icon_name, const QString& name, const QKeySequence& shortcut,
                       QWidget* parent)
    : QToolButton(parent) {
    setAutoRaise(true);
    setFocusPolicy(Qt::TabFocus);
    connect(&Theme::get(), &Theme::changed, this, &ToolButton::restyle);
    setMeaning(icon_name, name, shortcut);
}

void ToolButton::setMeaning(const QString& icon_name, const QString& name, const QKeySequence& shortcut) {
    icon_name_ = icon_name;
    setAccessibleName(name);
    setAccessibleDescription(keysText(shortcut));
    tooltip_ = shortcut.isEmpty()
                   ? name
                   : tr("%1 (%2)", "name of a button (its shortcut)").arg(name, keysText(shortcut));
    if (isEnabled())
        setToolTip(tooltip_);
    restyle();
}

void ToolButton::setPrimary(bool primary) {
    primary_ = primary;
    restyle();
}

void ToolButton::setTargetSize(int width, int height) {
    target_ = {width, height};
    restyle();
}

void ToolButton::setDisabledBecause(const QString& reason) {
    setEnabled(reason.isEmpty());
    setToolTip(reason.isEmpty() ? tooltip_ : reason);
}

QSize ToolButton::sizeHint() const {
    const Theme& theme = Theme::get();
    return {theme.px(target_.width()), theme.px(target_.height())};
}

void ToolButton::restyle() {
    updateGeometry();
    update();
}

void ToolButton::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    QPainter painter(this);
    QStyleOptionToolButton option;
    initStyleOption(&option);
    QColor color = isChecked() ? tokens.acc : underMouse() ? tokens.t1 : tokens.t2;
    if (primary_ && isEnabled()) {
        const bool lit = underMouse() || isDown();
        paintBox(painter, rect(), theme.px(4), lit ? mixed(tokens.acc, tokens.t1, 0.15) : tokens.acc);
        color = tokens.onacc;
    } else {
        style()->drawPrimitive(QStyle::PE_PanelButtonTool, &option, &painter, this);
    }
    const int room = std::min(target_.width(), target_.height()) - 12;
    const int size = room >= 32 ? 24 : room >= 24 ? 20 : 16;
    if (!isEnabled())
        painter.setOpacity(0.5);
    paintIcon(painter, rect(), icon_name_, theme.px(size), isEnabled() ? color : tokens.t3);
}

}  // namespace noctule::ui
