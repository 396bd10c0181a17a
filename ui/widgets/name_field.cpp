// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/name_field.h"

#include <QKeyEvent>
#include <utility>

namespace noctule::ui {

NameField::NameField(const QString& what, const QString& name, QWidget* parent) : QLineEdit(name, parent) {
    setAccessibleName(what);
    setPlaceholderText(tr("Name"));
    selectAll();
}

void NameField::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape)
        end(false);
    else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        end(true);
    else
        QLineEdit::keyPressEvent(event);
}

void NameField::focusOutEvent(QFocusEvent* event) {
    QLineEdit::focusOutEvent(event);
    if (event->reason() != Qt::PopupFocusReason)  // its own menu
        end(true);
}

void NameField::end(bool keep) {
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
