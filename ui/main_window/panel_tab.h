// SPDX-License-Identifier: Apache-2.0
// Stands above the page, at the side of a panel that was folded away for want of room: a click shows the
// panel.
#pragma once

#include <QAbstractButton>

namespace noctule::ui {

class PanelTab : public QAbstractButton {
    Q_OBJECT
public:
    enum class Edge { kLeft, kRight };

    explicit PanelTab(Edge edge, QWidget* parent = nullptr);

    void setTitle(const QString& title);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    Edge edge_;
};

}  // namespace noctule::ui
