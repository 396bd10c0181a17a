// SPDX-License-Identifier: Apache-2.0
// Dot of 8 px in front of a name. State never by colour alone: a full dot is fine, a hollow one not there, a
// triangle wants a look, a diamond does not work; the words are its tooltip and accessible name.
#pragma once

#include <QWidget>

#include "ui/style/ink.h"

namespace noctule::ui {

class StatusDot : public QWidget {
    Q_OBJECT
public:
    StatusDot(Tone tone, const QString& words, QWidget* parent = nullptr);

    void setState(Tone tone, const QString& words);
    Tone tone() const { return tone_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

    /// Centred in `area`, for table cells.
    static void paint(QPainter& painter, const QRect& area, Tone tone);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Tone tone_;
};

}  // namespace noctule::ui
