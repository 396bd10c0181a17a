// SPDX-License-Identifier: Apache-2.0
// Stands above the page, at the side of a panel that was folded away for want of room: a click shows the
// panel.
#pragma once

#include <QAbstractButton>

namespace noctule::ui {

class PanelTab : public QAbstractButton {
    Q_OBJECT
public:
    enum class Side { kLeft, kRight };

    explicit PanelTab(Side side, QWidget* parent = nullptr);

    void setTitle(const QString& title);

    QSize sizeHint() const override;
    /// A long title is elided.
    QSize minimumSizeHint() const override { return {3 * sizeHint().height(), sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    Side side_;
};

}  // namespace noctule::ui
