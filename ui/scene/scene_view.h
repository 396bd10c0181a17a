// SPDX-License-Identifier: Apache-2.0
// The body in its room: mesh, skeleton, boards, sources, rays coloured by confidence, trails, contacts, the
// ghost of a second motion, and the tools and legends on the picture. By itself it follows the take under
// review, its time and its selection; with setFigure() it shows a performer in the rest pose instead, whose
// boards and sources can be chosen and dragged; with setLive() it shows a suit that is worn right now.
#pragma once

#include <QImage>
#include <QWidget>
#include <memory>

#include "core/body/actor.h"
#include "core/live/latency.h"
#include "core/motion/timed_poses.h"
#include "core/render/camera.h"
#include "core/render/scene.h"
#include "core/suit/suit.h"
#include "ui/models/review_context.h"
#include "ui/scene/live_scene.h"
#include "ui/scene/scene_layers.h"
#include "ui/scene/suit_part.h"

namespace noctule::ui {

struct SceneCallout;

class SceneView : public QWidget {
    Q_OBJECT
public:
    /// `step`: under which the choice of layers and the camera are kept.
    explicit SceneView(ReviewContext& review, QWidget* parent = nullptr, Step step = Step::kReview);
    ~SceneView() override;

    bool isShown(SceneLayer layer) const;
    void setShown(SceneLayer layer, bool shown);
    bool follows() const;
    void setFollow(bool follow);
    void setView(CameraView view);
    CameraView view() const;
    const Camera& camera() const;
    void setCamera(const Camera& camera);

    /// Room at the right end of the row of tools for what somebody else puts there, in pixels.
    void setRoomBesideTools(int width_px);
    /// One more at the end of the row of tools, which owns it.
    void addTool(QWidget* tool);

    /// Which motion of the take; kShown at first.
    void setSubject(SceneSubject subject);
    /// Another view of the take stands beside this one: it always says which result it shows.
    void setBesideOther(bool beside);

    /// Shows this performer in the rest pose, dressed, instead of the take.
    void setFigure(const Actor& actor, const Suit& suit);
    /// Back to the take under review.
    void clearFigure();
    /// Shows what showFrame() brings from now on, instead of the take.
    void setLive(LiveWearer wearer);
    /// Of a live suit: who else is there, and its own place among them.
    void setCompany(int performer, std::vector<LiveCompanion> others);
    /// Null: nothing comes. Lost: its link broke after this frame.
    void showFrame(std::shared_ptr<const LiveFrame> frame, bool is_lost = false, const FloorMove& floor = {});
    /// From showFrame() to the picture on the screen.
    const LatencyHistogram& frameDelays() const;

    /// The part with the gizmo; figure only.
    SuitPart chosenPart() const;
    void setChosenPart(SuitPart part);

    /// What is seen, with legends; `scale` times as large as on the screen.
    QImage picture(double scale = 1) const;
    /// What is seen, in words.
    QString descriptionInWords() const;

public slots:
    void frameBody();
    void toggle(noctule::ui::SceneLayer layer);
    void exportPicture();  ///< asks for a PNG file

signals:
    void layersChanged();
    void viewChanged();
    /// Figure: chosen by a click or the keyboard.
    void partChosen(noctule::ui::SuitPart part);
    /// Figure: dragged or nudged. Of a source the rotation turns +Z onto its normal.
    void placementDragged(noctule::ui::SuitPart part, Eigen::Vector3d p_segment_m,
                          Eigen::Quaterniond q_segment);
    void dragEnded();
    /// Live: this frame is on the screen.
    void frameDrawn(const std::shared_ptr<const noctule::LiveFrame>& frame);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Parts;

    void makeCanvas();
    void connectTools();
    void followReview();
    void showMessage(const QString& sentence);
    void updateMessage();
    void layOut();
    QString whyNoBody() const;
    const Suit* shownSuit() const;
    std::optional<SceneCallout> callout() const;
    void noteShown(quint64 number);

    const Scene& compose();
    void refresh();
    void updateOverlay(quint64 number);
    void changeLayers();
    /// By all places that the shown take's joints get to.
    void extendByMotion(Eigen::AlignedBox3d& box) const;
    /// What the camera frames: the body, and room for the tools above it.
    Eigen::AlignedBox3d bodyBox() const;
    void keepFollowing();
    void keepCamera();

    bool canvasEvent(QEvent& event);
    bool mousePress(const QMouseEvent& event);
    bool mouseMove(const QMouseEvent& event);
    bool mouseRelease(const QMouseEvent& event);
    void pick(const QPointF& at);
    bool actOnKey(const QKeyEvent& event);
    bool nudge(const QKeyEvent& event);

    ReviewContext& review_;
    std::unique_ptr<Parts> parts_;
};

/// A small picture of a motion's body at a time (seconds of the take's clock), in the colours of the theme,
/// without a window. Null when there is no mesh, no pose near the time or no OpenGL. Must not be called while
/// an OpenGL context is current in the thread.
QImage thumbnail(const std::shared_ptr<const SkinnedMesh>& body, const TimedMotion& motion, double t_s,
                 const QSize& size_px);
QImage thumbnail(const std::shared_ptr<const SkinnedMesh>& body, const Actor& actor, const QSize& size_px);

}  // namespace noctule::ui
