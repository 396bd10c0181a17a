// SPDX-License-Identifier: Apache-2.0
// Roles and values for widgets that Qt cannot describe by itself; names are the widgets' accessible names.
#pragma once

#include <QAccessible>
#include <QWidget>
#include <functional>

namespace noctule::ui {

/// What screen readers meet. Unset functions mean that there is no value.
struct AccessibleParts {
    QAccessible::Role role = QAccessible::StaticText;
    std::function<double()> value{};
    double minimum = 0, maximum = 1, step = 0;
    std::function<void(double)> set_value{};
    std::function<QString()> value_text{};
};

/// First in the widget's constructor, before it has a name: Qt keeps the first description it is given.
void describe(QWidget& widget, AccessibleParts parts);

/// After a value changed.
void tellValueChanged(QWidget& widget, double value);

/// Screen readers say it at once, one time.
void announce(QWidget& widget);

}  // namespace noctule::ui
