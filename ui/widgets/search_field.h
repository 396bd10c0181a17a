// SPDX-License-Identifier: Apache-2.0
// Text field with a magnifying glass; Esc empties it. textChanged() comes at each letter, searched() after a
// pause of 150 ms.
#pragma once

#include <QLineEdit>
#include <QTimer>

namespace noctule::ui {

class SearchField : public QLineEdit {
    Q_OBJECT
public:
    explicit SearchField(const QString& placeholder, QWidget* parent = nullptr);

signals:
    void searched(const QString& text);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void restyle();

    QAction* glass_;
    QTimer pause_;
};

}  // namespace noctule::ui
