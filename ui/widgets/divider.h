// SPDX-License-Identifier: Apache-2.0
// Hairline between parts; decoration only, nothing that must be seen.
#pragma once

#include <QWidget>

namespace noctule::ui {

class Divider : public QWidget {
    Q_OBJECT
public:
    explicit Divider(Qt::Orientation orientation = Qt::Horizontal, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {1, 1}; }

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace noctule::ui
