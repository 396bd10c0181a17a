// SPDX-License-Identifier: Apache-2.0
// A key as drawn on a keyboard: "Ctrl+R" in a thin frame, 11 px.
#pragma once

#include <QKeySequence>
#include <QWidget>

namespace noctule::ui {

class KeyHint : public QWidget {
    Q_OBJECT
public:
    explicit KeyHint(const QKeySequence& keys, QWidget* parent = nullptr);

    void setKeys(const QKeySequence& keys);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

    /// For those who draw it inside themselves.
    static QSize sizeOf(const QString& keys);
    static void paint(QPainter& painter, const QRectF& frame, const QString& keys, const QColor& color);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString text_;
};

}  // namespace noctule::ui
