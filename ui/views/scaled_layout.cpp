// SPDX-License-Identifier: Apache-2.0
#include "ui/views/scaled_layout.h"

#include <functional>

#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

/// Now and whenever the theme changes, as long as `owner` lives.
void keep(QObject& owner, const std::function<void(const Theme&)>& set) {
    set(Theme::get());
    QObject::connect(&Theme::get(), &Theme::changed, &owner, [set] { set(Theme::get()); });
}

QMargins scaled(const Theme& theme, const QMargins& m) {
    return {theme.px(m.left()), theme.px(m.top()), theme.px(m.right()), theme.px(m.bottom())};
}

template <class Layout>
Layout* made(QWidget* owner, const QMargins& margins, int spacing) {
    auto* layout = new Layout(owner);
    keep(*layout, [=](const Theme& theme) {
        layout->setContentsMargins(scaled(theme, margins));
        layout->setSpacing(theme.px(spacing));
    });
    return layout;
}

}  // namespace

QVBoxLayout* makeColumn(QWidget* owner, const QMargins& margins, int spacing) {
    return made<QVBoxLayout>(owner, margins, spacing);
}

QHBoxLayout* makeRow(QWidget* owner, const QMargins& margins, int spacing) {
    return made<QHBoxLayout>(owner, margins, spacing);
}

QGridLayout* makeGrid(QWidget* owner, const QMargins& margins, int spacing) {
    return made<QGridLayout>(owner, margins, spacing);
}

QHBoxLayout* addRow(QBoxLayout* into, int spacing, const QMargins& margins) {
    auto* row = new QWidget;
    into->addWidget(row);
    return makeRow(row, margins, spacing);
}

void clearWidgets(QBoxLayout& layout, int from) {
    while (QLayoutItem* item = layout.takeAt(from)) {
        delete item->widget();
        delete item;
    }
}

void clearWidgetsLater(QBoxLayout& layout) {
    while (QLayoutItem* item = layout.takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater();
        delete item;
    }
}

void keepSize(QWidget& widget, int width, int height) {
    keep(widget, [&widget, width, height](const Theme& theme) {
        if (width > 0)
            widget.setFixedWidth(theme.px(width));
        if (height > 0)
            widget.setFixedHeight(theme.px(height));
    });
}

void keepMinimumWidth(QWidget& widget, int width) {
    keep(widget, [&widget, width](const Theme& theme) { widget.setMinimumWidth(theme.px(width)); });
}

void keepMinimumHeight(QWidget& widget, int height) {
    keep(widget, [&widget, height](const Theme& theme) { widget.setMinimumHeight(theme.px(height)); });
}

void keepMaximumWidth(QWidget& widget, int width) {
    keep(widget, [&widget, width](const Theme& theme) { widget.setMaximumWidth(theme.px(width)); });
}

void keepMaximumHeight(QWidget& widget, int height) {
    keep(widget, [&widget, height](const Theme& theme) { widget.setMaximumHeight(theme.px(height)); });
}

}  // namespace noctule::ui
