// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/timeline_accessible.h"

#include <QAccessible>
#include <QAccessibleWidget>

#include "ui/plots/timeline.h"

namespace noctule::ui {
namespace {

class SliderInterface : public QAccessibleWidget, public QAccessibleValueInterface {
public:
    explicit SliderInterface(Timeline* timeline)
        : QAccessibleWidget(timeline, QAccessible::Slider), timeline_(timeline) {}

    void* interface_cast(QAccessible::InterfaceType type) override {
        if (type == QAccessible::ValueInterface)
            return static_cast<QAccessibleValueInterface*>(this);
        return QAccessibleWidget::interface_cast(type);
    }
    QString text(QAccessible::Text which) const override {
        return which == QAccessible::Value ? timeline_->valueText() : QAccessibleWidget::text(which);
    }
    QVariant currentValue() const override { return timeline_->time().time(); }
    void setCurrentValue(const QVariant& value) override { timeline_->time().setTime(value.toDouble()); }
    QVariant maximumValue() const override { return timeline_->time().duration(); }
    QVariant minimumValue() const override { return 0.0; }
    QVariant minimumStepSize() const override { return timeline_->time().frameStep(); }

private:
    Timeline* timeline_;
};

QAccessibleInterface* makeSliderInterface(const QString&, QObject* object) {
    auto* timeline = qobject_cast<Timeline*>(object);
    return timeline ? new SliderInterface(timeline) : nullptr;
}

}  // namespace

void TimelineAccessible::install() {
    static const bool installed = [] {
        QAccessible::installFactory(makeSliderInterface);
        return true;
    }();
    static_cast<void>(installed);
}

}  // namespace noctule::ui
