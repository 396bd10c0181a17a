// SPDX-License-Identifier: Apache-2.0
// The name of a marker, typed where its flag stands. Enter and a click elsewhere keep it, Esc does not.
#pragma once

#include <QLineEdit>

namespace noctule::ui {

class MarkerField : public QLineEdit {
    Q_OBJECT
public:
    explicit MarkerField(const QString& label, QWidget* parent);

signals:
    void named(const QString& label);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void end(bool keep);

    bool ended_ = false;
};

}  // namespace noctule::ui
