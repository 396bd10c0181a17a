// SPDX-License-Identifier: Apache-2.0
// Words of the status line that can be clicked: quiet until the mouse or the keyboard is on them.
#pragma once

#include <QAbstractButton>
#include <QKeySequence>

#include "ui/style/ink.h"

namespace noctule::ui {

class StatusButton : public QAbstractButton {
    Q_OBJECT
public:
    explicit StatusButton(const QString& text = {}, QWidget* parent = nullptr);

    /// Drawn in front of the words.
    void setKeys(const QKeySequence& keys);
    /// Anything but neutral adds the icon of the tone.
    void setTone(Tone tone);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    int leading() const;

    QString keys_;
    Tone tone_ = Tone::kNeutral;
};

}  // namespace noctule::ui
