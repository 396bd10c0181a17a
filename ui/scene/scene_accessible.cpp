// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/scene_accessible.h"

#include <QAccessibleWidget>

#include "ui/scene/scene_view.h"

namespace noctule::ui {

namespace {

class SceneAccessible : public QAccessibleWidget {
public:
    explicit SceneAccessible(SceneView* view) : QAccessibleWidget(view, QAccessible::Graphic) {}

    QString text(QAccessible::Text kind) const override {
        if (kind == QAccessible::Description || kind == QAccessible::Value)
            return static_cast<SceneView*>(widget())->descriptionInWords();
        return QAccessibleWidget::text(kind);
    }
};

QAccessibleInterface* makeInterface(const QString&, QObject* object) {
    auto* view = qobject_cast<SceneView*>(object);
    return view ? new SceneAccessible(view) : nullptr;
}

}  // namespace

void installSceneAccessibility() {
    static const bool installed = [] {
        QAccessible::installFactory(makeInterface);
        return true;
    }();
    (void)installed;
}

}  // namespace noctule::ui
