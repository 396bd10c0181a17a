// SPDX-License-Identifier: Apache-2.0
// Scrolls up and down and never sideways: the content keeps to the width and the area is never narrower than
// the content can be, so that nothing clips at large type. Keyboard focus scrolls into view.
#pragma once

#include <QScrollArea>

namespace noctule::ui {

class ScrollArea : public QScrollArea {
    Q_OBJECT
public:
    explicit ScrollArea(QWidget* content = nullptr, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
};

}  // namespace noctule::ui
