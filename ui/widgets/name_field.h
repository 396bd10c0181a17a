// SPDX-License-Identifier: Apache-2.0
// A name that is typed where it stands, over the widget that shows it. Enter and a click elsewhere keep it,
// Esc does not.
#pragma once

#include <QLineEdit>

namespace noctule::ui {

class NameField : public QLineEdit {
    Q_OBJECT
public:
    /// `what`: what is named, for screen readers.
    NameField(const QString& what, const QString& name, QWidget* parent);

signals:
    void named(const QString& name);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void end(bool keep);

    bool ended_ = false;
};

}  // namespace noctule::ui
