// SPDX-License-Identifier: Apache-2.0
// The page with the notices above it. While the mouse is over the page nothing of it moves: a notice that
// comes lies over the page, away from the mouse, and one that goes leaves its room empty. Once the mouse has
// left the page, the notices have just their room.
#pragma once

#include <QWidget>

namespace noctule::ui {

class NoticedPage : public QWidget {
    Q_OBJECT
public:
    NoticedPage(QWidget* notices, QWidget* page, QWidget* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void arrange();

    QWidget *notices_, *page_;
    QWidget* room_;           ///< of the notices, above the page
    bool lie_below_ = false;  ///< at the page's bottom, since the mouse is at its top
};

}  // namespace noctule::ui
