// SPDX-License-Identifier: Apache-2.0
// What is written on a 3D picture: the axes in the corner, legends, and the callout of what is chosen. Lets
// the mouse through.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/render/camera.h"

namespace noctule::ui {

struct SceneLegend {
    QString text;
    bool outline = false;  ///< a ghost's, else a surface's
};

struct SceneCallout {
    QPointF at;  ///< of the thing, in the widget's pixels
    QString title, detail;
    double clear_px = 13;           ///< radius around the thing, at 100 percent, that stays free
    std::vector<QPointF> bodies{};  ///< along the bones of the shown and the compared body: stays free too
};

/// Who somebody is, on a disc over the head.
struct SceneTag {
    int performer = 0;
    QPointF at;  ///< in the widget's pixels
};

/// How far two people are from each other: on the floor between them, never over a body.
struct SceneDistance {
    QPointF from, floor;  ///< between the hands, and below that
    QString text, pair;   ///< the distance, and between which joints it is
};

struct OverlayContent {
    Matrix3d camera_axes = Matrix3d::Identity();
    bool has_axes = true;
    std::vector<SceneLegend> legends;
    bool has_rays = false;
    std::optional<SceneCallout> callout;
    std::vector<SceneTag> tags;
    std::optional<SceneDistance> distance;
};

class SceneOverlay : public QWidget {
    Q_OBJECT
public:
    explicit SceneOverlay(QWidget* parent);

    void setContent(OverlayContent content);
    /// The view is hardly wider than its body.
    static bool isNarrow(const QWidget& view);
    const OverlayContent& content() const { return content_; }
    /// The same onto any picture of the area's size.
    static void paint(QPainter& painter, const QRectF& area, const OverlayContent& content);
    /// Where the distance stands, clear of everything else that is written; empty where it finds no room, and
    /// in a narrow view, where it is a line below the body.
    static std::optional<QRectF> distanceBox(const QRectF& area, const OverlayContent& content);
    /// Where the callout stands: at the height of its thing, beside the bodies, and wholly within the area.
    static QRectF calloutBox(const QRectF& area, const SceneCallout& callout);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    OverlayContent content_;
};

}  // namespace noctule::ui
