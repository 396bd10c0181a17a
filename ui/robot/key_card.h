// SPDX-License-Identifier: Apache-2.0
// One of the operator's keys as a card of 56 px: icon, what is so, what to do, and the key on the keyboard.
#pragma once

#include <QAbstractButton>
#include <QKeySequence>

#include "ui/style/ink.h"

namespace noctule::ui {

class KeyCard : public QAbstractButton {
    Q_OBJECT
public:
    KeyCard(const QString& icon_name, const QString& title, const QString& about, const QKeySequence& keys,
            QWidget* parent = nullptr);

    /// kNeutral: outlined only.
    void setLook(Tone tone, const QString& title, const QString& about);

    QSize sizeHint() const override;
    /// Half of it: cards that stand in a row give way until they are arranged anew.
    QSize minimumSizeHint() const override { return {sizeHint().width() / 2, sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QString icon_name_, about_;
    QKeySequence keys_;
    Tone tone_ = Tone::kNeutral;
};

}  // namespace noctule::ui
