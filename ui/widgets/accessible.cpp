// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/accessible.h"

#include <QAccessibleValueInterface>
#include <QAccessibleWidget>
#include <QHash>

namespace noctule::ui {

namespace {

QHash<const QObject*, AccessibleParts>& described() {
    static QHash<const QObject*, AccessibleParts> parts;
    return parts;
}

class DescribedWidget : public QAccessibleWidget, public QAccessibleValueInterface {
public:
    DescribedWidget(QWidget* widget, AccessibleParts parts)
        : QAccessibleWidget(widget, parts.role), parts_(std::move(parts)) {}

    void* interface_cast(QAccessible::InterfaceType type) override {
        if (type == QAccessible::ValueInterface && parts_.value)
            return static_cast<QAccessibleValueInterface*>(this);
        return QAccessibleWidget::interface_cast(type);
    }
    QString text(QAccessible::Text text) const override {
        if (text == QAccessible::Value && parts_.value_text)
            return parts_.value_text();
        return QAccessibleWidget::text(text);
    }
    QAccessible::State state() const override {
        QAccessible::State state = QAccessibleWidget::state();
        state.readOnly = !parts_.set_value;
        return state;
    }
    QVariant currentValue() const override { return parts_.value(); }
    void setCurrentValue(const QVariant& value) override {
        if (parts_.set_value)
            parts_.set_value(value.toDouble());
    }
    QVariant minimumValue() const override { return parts_.minimum; }
    QVariant maximumValue() const override { return parts_.maximum; }
    QVariant minimumStepSize() const override { return parts_.step; }

private:
    AccessibleParts parts_;
};

QAccessibleInterface* makeInterface(const QString&, QObject* object) {
    const auto found = described().constFind(object);
    return found == described().constEnd() ? nullptr
                                           : new DescribedWidget(static_cast<QWidget*>(object), *found);
}

}  // namespace

void describe(QWidget& widget, AccessibleParts parts) {
    static const bool installed = (QAccessible::installFactory(makeInterface), true);
    Q_UNUSED(installed)
    described().insert(&widget, std::move(parts));
    QObject::connect(&widget, &QObject::destroyed, [object = &widget] { described().remove(object); });
}

void tellValueChanged(QWidget& widget, double value) {
    QAccessibleValueChangeEvent event(&widget, value);
    QAccessible::updateAccessibility(&event);
}

void announce(QWidget& widget) {
    QAccessibleEvent event(&widget, QAccessible::Alert);
    QAccessible::updateAccessibility(&event);
}

}  // namespace noctule::ui
