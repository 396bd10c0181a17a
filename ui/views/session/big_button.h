// SPDX-License-Identifier: Apache-2.0
// One of the few large choices of the start page: icon, title, one line about it, and its key.
#pragma once

#include <QAbstractButton>
#include <QKeySequence>

namespace noctule::ui {

class BigButton : public QAbstractButton {
    Q_OBJECT
public:
    /// `primary`: filled with the accent; one a page.
    BigButton(const QString& icon_name, const QString& title, const QString& about, bool primary,
              QWidget* parent = nullptr);

    /// Drawn at the right.
    void setKeys(const QKeySequence& keys);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void enterEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QFont titleFont() const;
    QFont aboutFont() const;
    QColor background() const;
    int keyWidth() const;

    QString icon_name_, about_;
    QKeySequence keys_;
    bool primary_;
};

}  // namespace noctule::ui
