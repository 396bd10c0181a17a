// SPDX-License-Identifier: Apache-2.0
// The figure of a motion as it is understood, in one of its frames: bones from the front and from its left at
// one scale, its left side in the accent, on the floor of the motion. Joints that play no part are thin.
#pragma once

#include <QWidget>
#include <memory>

#include "core/figure/understood_motion.h"

namespace noctule::ui {

class MotionPicture : public QWidget {
    Q_OBJECT
public:
    explicit MotionPicture(QWidget* parent = nullptr);

    /// Null: nothing is shown.
    void setMotion(std::shared_ptr<const figure::UnderstoodMotion> motion);
    void setFrame(int frame);
    int frame() const { return frame_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// A bone in the picture's plane, metres: right and up.
    struct Line {
        QPointF from, to;
        enum class Kind { kLeft, kRight, kMiddle, kOther } kind;
    };
    std::vector<Line> linesFrom(bool front) const;
    void paintView(QPainter& painter, const QRect& area, bool front) const;
    void findFloor();

    std::shared_ptr<const figure::UnderstoodMotion> motion_;
    int frame_ = 0;
    double floor_m_ = 0;
};

}  // namespace noctule::ui
