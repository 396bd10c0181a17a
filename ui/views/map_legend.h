// SPDX-License-Identifier: Apache-2.0
// What the marks of the body map stand for.
#pragma once

#include <QWidget>

namespace noctule::ui {

class MapLegend : public QWidget {
    Q_OBJECT
public:
    explicit MapLegend(QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString board_, source_;
};

}  // namespace noctule::ui
