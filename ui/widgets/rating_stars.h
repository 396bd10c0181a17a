// SPDX-License-Identifier: Apache-2.0
// Rating of a take, 0 to 5 stars. Click sets it (the same star again takes it back to 0), keys 0 to 5 and
// arrows. For table rows, sizeOf() and paint() draw the same without a widget.
#pragma once

#include <QWidget>

namespace noctule::ui {

class RatingStars : public QWidget {
    Q_OBJECT
    Q_PROPERTY(int rating READ rating WRITE setRating NOTIFY ratingChanged USER true)
public:
    explicit RatingStars(int rating = 0, QWidget* parent = nullptr);

    int rating() const { return rating_; }
    void setRating(int rating);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

    static QSize sizeOf();
    static void paint(QPainter& painter, const QRect& area, int rating, const QColor& color);
    /// 0..5 for a click at `x` in an area that begins at 0.
    static int ratingAt(int x);

signals:
    void ratingChanged(int rating);  ///< by the user only

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void choose(int rating);

    int rating_;
    int hovered_ = -1;
};

}  // namespace noctule::ui
