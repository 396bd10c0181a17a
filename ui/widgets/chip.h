// SPDX-License-Identifier: Apache-2.0
// Rounded state with icon and count ("17/18 boards"). Clicking opens what it talks about; a chip that opens
// nothing is not interactive (setInteractive(false)).
#pragma once

#include <QAbstractButton>

#include "ui/style/ink.h"

namespace noctule::ui {

class Chip : public QAbstractButton {
    Q_OBJECT
public:
    /// `icon_name` empty: the icon of the tone.
    explicit Chip(Tone tone, const QString& text, const QString& icon_name = {}, QWidget* parent = nullptr);

    void setState(Tone tone, const QString& text, const QString& icon_name = {});
    Tone tone() const { return tone_; }
    void setInteractive(bool interactive);
    /// The icon alone; the words stay for screen readers.
    void setBrief(bool brief);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    Tone tone_;
    QString icon_name_;
    bool interactive_ = true, brief_ = false;
};

}  // namespace noctule::ui
