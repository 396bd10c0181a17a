// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/marker_field.h"

#include <QKeyEvent>
#include <utility>

namespace noctule::ui {

MarkerField::MarkerField(const QString& label, QWidget* parent) : QLineEdit(label, parent) {
    setAccessibleName(tr("Name of the marker"));
    setPlaceholderText(tr("Name"));
    selectAll();
}

void MarkerField::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape)
        end(false);
    else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        end(true);
    else
        QLineEdit::keyPressEvent(event);
}

void MarkerField::focusOutEvent(QFocusEvent* event) {
    QLineEdit::focusOutEvent(event);
    if (event->reason() != Qt::PopupFocusReason)  // its own menu
        end(true);
}

void MarkerField::end(bool keep) {
    if (std::exchange(ended_, true))
        return;
    if (keep)
        emit named(text());
    if (hasFocus() && parentWidget())
        parentWidget()->setFocus();
    hide();
    deleteLater();
}

}  // namespace noctule::ui
