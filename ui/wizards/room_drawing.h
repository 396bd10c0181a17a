// SPDX-License-Identifier: Apache-2.0
// A surveyed room from above or from the front: anchors with their uncertainty, which of them hear each
// other, and where the performer stood and walked. Metres of the room's frame.
#pragma once

#include <QWidget>

#include "core/room_survey/room_survey.h"
#include "ui/style/ink.h"

namespace noctule::ui {

/// How an anchor came out, in the colours and words of the page.
struct AnchorState {
    Tone tone;
    QString words;  ///< "good"
};
AnchorState stateOf(const room_survey::SurveyedAnchor& anchor);
/// The same while somebody walks past it: "nearly" of one that some more walking makes good.
AnchorState stateSoFar(const room_survey::SurveyedAnchor& anchor);

class RoomDrawing : public QWidget {
    Q_OBJECT
public:
    enum class From { kAbove, kFront };

    explicit RoomDrawing(From from, QWidget* parent = nullptr);

    /// Null: nothing is known yet. `performer`: who walked, 0 for A.
    void show(const room_survey::RoomSurvey* survey, int performer = 0);
    using QWidget::show;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// From metres to pixels.
    struct Scale {
        QPointF middle_m, middle;
        double pixels_per_m = 1;
    };
    QPointF flat(const Vector3d& place_m) const;
    Eigen::Matrix2d flatCovariance(const Matrix3d& cov_m2) const;
    QRectF extent() const;
    QPointF at(const Scale& scale, const QPointF& place) const;
    void paintGrid(QPainter& painter, const Scale& scale, const QRectF& field, const QRectF& extent_m) const;
    void paintWalk(QPainter& painter, const Scale& scale) const;
    void paintHearing(QPainter& painter, const Scale& scale) const;
    void paintUncertainty(QPainter& painter, const Scale& scale, size_t anchor) const;
    /// `taken`: where words stand.
    void paintAnchor(QPainter& painter, const Scale& scale, size_t anchor, std::vector<QRectF>& taken) const;
    void paintPerformer(QPainter& painter, const Scale& scale) const;
    QString legend() const;

    From from_;
    std::optional<room_survey::RoomSurvey> survey_;
    int performer_ = 0;
    double larger_ = 1;  ///< than it is, uncertainty is drawn
};

}  // namespace noctule::ui
