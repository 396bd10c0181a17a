// SPDX-License-Identifier: Apache-2.0
// The large drawing of a calibration page, readable from three metres: the plate with its boards on a table
// or on the turntable, turned as the page asks for, the jig of the range finder, or the performer in the rest
// pose. Boards carry their numbers and marks; the wrong one is called out.
#pragma once

#include <QImage>
#include <QString>
#include <QWidget>
#include <memory>
#include <vector>

#include "core/suit/suit.h"
#include "ui/views/body_figure.h"

namespace noctule::ui {

enum class BoardMark { kWaiting, kRight, kDone, kWrong, kSkipped, kAbsent };

struct RigPicture {
    enum class Kind { kPlate, kTurntable, kJig, kStand } kind = Kind::kPlate;
    /// kPlate, kTurntable: which of the six sides is up, index 0..5 = +x -x +y -y +z -z of the boards; -1:
    /// none asked for (set-up drawing).
    int side = -1;
    bool turns = false;                     ///< kTurntable: the arrow of turning is emphasised
    std::vector<BoardMark> boards;          ///< one per board, numbers from 1
    int wrong_board = -1;                   ///< its index: gets a call-out with a leader; -1: none
    QString call_out_title, call_out_text;  ///< "Board 7", "left forearm, 4.2° askew"
    bool operator==(const RigPicture&) const = default;
};

class RigDrawing : public QWidget {
    Q_OBJECT
public:
    explicit RigDrawing(QWidget* parent = nullptr);
    /// Repaints only when something changed.
    void setPicture(const RigPicture& picture);
    /// For kStand: boards are dots on the figure, in the colours of their marks.
    void setBody(std::shared_ptr<const BodyFigure> figure, const Suit& suit);
    /// Null: none yet.
    const BodyFigure* figure() const { return figure_.get(); }
    /// For those who do not see the drawing.
    void setDescription(const QString& words);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    RigPicture picture_;
    std::shared_ptr<const BodyFigure> figure_;
    Suit suit_;
    QImage figure_image_;  ///< as painted last
};

}  // namespace noctule::ui
