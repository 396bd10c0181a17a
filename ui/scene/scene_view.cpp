// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/scene_view.h"

#include <QEvent>
#include <QLayout>
#include <QPainter>
#include <QResizeEvent>
#include <QStandardPaths>
#include <utility>

#include "ui/models/file_choice.h"
#include "ui/scene/scene_accessible.h"
#include "ui/scene/scene_parts.h"
#include "ui/scene/scene_words.h"
#include "ui/style/words.h"

namespace noctule::ui {

namespace {

const QString kFigure = QStringLiteral("figure"), kLive = QStringLiteral("live");

constexpr double kClockWidth = 300;  ///< at 100 percent

bool isPlayed(ReviewContext& review) {
    return review.time().isPlaying();
}

/// The box of a body's joints and parts with its flesh, and with room for what covers the top of the picture.
Eigen::AlignedBox3d roomy(Eigen::AlignedBox3d box, double covered_share) {
    const Vector3d flesh(0.12, 0.06, 0.12);
    box.extend(Vector3d(box.min() - flesh));
    box.extend(Vector3d(box.max() + flesh));
    box.max().y() += box.sizes().y() * covered_share / (1 - covered_share);
    return box;
}

}  // namespace

SceneView::SceneView(ReviewContext& review, QWidget* parent, Step step)
    : QWidget(parent), review_(review), parts_(std::make_unique<Parts>(review, step)) {
    installSceneAccessibility();
    setAccessibleName(tr("3D view"));
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(200, 160);
    parts_->control = new CameraControl(this);
    parts_->tools = new SceneTools(this);
    const QString missing = SceneCanvas::missing();
    if (missing.isEmpty())
        makeCanvas();
    parts_->overlay = new SceneOverlay(this);
    parts_->message = new EmptyState(missing, {}, {}, this);
    parts_->message->setAttribute(Qt::WA_TransparentForMouseEvents);
    parts_->tools->raise();
    parts_->tools->setVisible(parts_->canvas);
    parts_->overlay->setVisible(parts_->canvas);
    connectTools();
    followReview();
    updateMessage();
    qApp->installEventFilter(this);
}

SceneView::~SceneView() {
    qApp->removeEventFilter(this);
    // The canvas draws through this view's parts: it goes first.
    delete parts_->canvas;
    parts_->canvas = nullptr;
}

void SceneView::makeCanvas() {
    parts_->canvas = new SceneCanvas([this]() -> const Scene& { return compose(); },
                                     [this] { return parts_->control->camera(); }, this);
    parts_->canvas->installEventFilter(this);
    parts_->canvas->setFocusProxy(this);
    connect(parts_->canvas, &SceneCanvas::asked, this, [this](quint64 number) {
        parts_->asked[number] = {parts_->live ? parts_->live->frame() : nullptr, parts_->since_frame,
                                 parts_->control->camera()};
    });
    connect(parts_->canvas, &SceneCanvas::arrived, this, &SceneView::updateOverlay);
    connect(parts_->canvas, &SceneCanvas::shown, this, &SceneView::noteShown);
    connect(parts_->canvas, &SceneCanvas::unavailable, this, [this](const QString& message) {
        parts_->canvas->hide();  // asks for nothing any more
        parts_->asked.clear();
        parts_->tools->hide();
        parts_->overlay->hide();
        parts_->trouble = message;
        updateMessage();
    });
}

void SceneView::connectTools() {
    SceneTools& tools = *parts_->tools;
    tools.setLayers(parts_->layers);
    connect(&tools, &SceneTools::layerToggled, this, &SceneView::setShown);
    connect(&tools, &SceneTools::followToggled, this, &SceneView::setFollow);
    connect(&tools, &SceneTools::viewChosen, this, &SceneView::setView);
    connect(&tools, &SceneTools::pictureWanted, this, &SceneView::exportPicture);
    connect(parts_->control, &CameraControl::changed, this, &SceneView::refresh);
    connect(parts_->control, &CameraControl::viewChanged, this, [this] {
        parts_->tools->setView(view());
        keepCamera();
        emit viewChanged();
    });
    const QString view_key = settingsGroup(parts_->step) + QStringLiteral("/view");
    const auto kept = static_cast<CameraView>(review_.shared().settings().value(view_key, 0).toInt());
    Camera camera = parts_->control->camera();
    camera.setView(kept);
    parts_->control->setCamera(camera, kept);
}

void SceneView::followReview() {
    TakeDocument& take = review_.take();
    const auto renew = [this] {
        updateMessage();
        refresh();
    };
    connect(&take, &TakeDocument::opened, this, renew);
    connect(&take, &TakeDocument::runsChanged, this, renew);
    connect(&take, &TakeDocument::processingChanged, this, renew);
    connect(&take, &TakeDocument::motionChanged, this, renew);
    connect(&take, &TakeDocument::rangesChanged, this, renew);
    connect(&review_.time(), &TimeCursor::timeChanged, this, [this] {
        if (parts_->canvas)
            parts_->canvas->refresh(true);  // where the cursor moves once, it mostly moves on
    });
    connect(&review_.time(), &TimeCursor::playingChanged, this, &SceneView::refresh);
    connect(&review_.selection(), &Selection::pairChanged, this, &SceneView::refresh);
    connect(&Theme::get(), &Theme::changed, this, [this] {
        layOut();
        refresh();
    });
    review_.shared().whenBodyIsThere(this, [this] { refresh(); });
    connect(&review_.shared().shownBody(), &ShownBody::changed, this, [this] {
        if (parts_->untouched)
            parts_->framed.clear();
        refresh();
    });
}

void SceneView::showMessage(const QString& sentence) {
    parts_->message->setSentence(sentence);
    parts_->message->setVisible(!sentence.isEmpty());
}

void SceneView::updateMessage() {
    if (parts_->canvas)
        showMessage(!parts_->trouble.isEmpty()   ? parts_->trouble
                    : parts_->composed.hasBody() ? QString()
                                                 : whyNoBody());
}

void SceneView::layOut() {
    const int margin = Theme::get().px(12);
    if (parts_->canvas) {
        parts_->canvas->setGeometry(rect());
        parts_->control->setSize(parts_->canvas->surfaceSize());
    }
    parts_->overlay->setGeometry(rect());
    QRect column(0, 0, std::min(width(), Theme::get().px(640)), height());
    column.moveCenter(rect().center());
    parts_->message->setGeometry(column);
    // The clock of what is recorded stands at the left.
    const int left = parts_->live ? Theme::get().px(kClockWidth) : margin;
    const int right = width() - margin - parts_->beside_tools_px;
    parts_->tools->fitInto(right - left);
    parts_->tools->move(parts_->live ? right - parts_->tools->width() : margin, margin);
}

void SceneView::addTool(QWidget* tool) {
    parts_->tools->layout()->addWidget(tool);
    layOut();
}

void SceneView::setRoomBesideTools(int width_px) {
    if (std::exchange(parts_->beside_tools_px, width_px) != width_px)
        layOut();
}

void SceneView::resizeEvent(QResizeEvent*) {
    layOut();
    if (parts_->untouched)
        parts_->framed.clear();
    refresh();
}

void SceneView::showEvent(QShowEvent*) {
    const QString navigation =
        review_.shared().settings().value(QStringLiteral("scene/navigation")).toString();
    parts_->control->setNavigation(navigation == QLatin1String("maya") ? Navigation::kMaya
                                                                       : Navigation::kBlender);
    layOut();
    refresh();
}

const Scene& SceneView::compose() {
    Parts& parts = *parts_;
    parts.composed = parts.figure ? parts.figure->compose(parts.layers, review_.shared().body())
                     : parts.live ? parts.live->compose(review_, parts.layers)
                                  : parts.take.compose(parts.layers);
    const QString shown = parts.figure ? kFigure : parts.live ? kLive : review_.take().path();
    if (parts.composed.hasBody() && parts.framed != shown) {
        parts.framed = shown;
        parts.followed_m.reset();
        parts.control->frame(bodyBox(), true);
        parts.untouched = true;
    }
    keepFollowing();
    if (!parts.figure && callout()) {
        const BodyPlaces& places = parts.composed.places;
        const int board = review_.selection().board(), source = review_.selection().source();
        const bool has_board = board >= 0 && board < static_cast<int>(places.boards.size());
        const Vector3d at = has_board ? places.boards[static_cast<size_t>(board)].p_m
                                      : places.sources[static_cast<size_t>(source)].p_m;
        parts.composed.scene.rings.push_back({at.cast<float>(), 11, 2, rgba(Theme::get().tokens().acc)});
    }
    return parts.composed.scene;
}

Eigen::AlignedBox3d SceneView::bodyBox() const {
    constexpr double kMostCovered = 0.3;
    constexpr double kReach = 0.22;   // of the height with raised arms
    constexpr double kCaption = 0.2;  // below the feet, for the words of a narrow view
    constexpr double kDistanceLine = 0.1;
    const double covered = parts_->tools->geometry().bottom() / std::max(1.0, 1.0 * height());
    Eigen::AlignedBox3d box = parts_->composed.places.box();
    box.extend(parts_->composed.others);
    if (review_.shared().look().worn)  // whose head may be far larger than its bones say
        for (const SceneBody& body : parts_->composed.scene.bodies)
            for (const Eigen::Vector3f& p_m : skinned(*body.mesh, body.skin, body.blending).points_m)
                box.extend(p_m.cast<double>());
    if (!parts_->figure && !parts_->live)
        extendByMotion(box);
    if (SceneOverlay::isNarrow(*this)) {
        const double caption = kCaption + (parts_->composed.others.isEmpty() ? 0 : kDistanceLine);
        box.extend(box.min() - Vector3d(0, caption * box.sizes().y(), 0));
    }
    return roomy(box, std::clamp(covered, parts_->live ? kReach : 0.0, kMostCovered));
}

void SceneView::keepFollowing() {
    Parts& parts = *parts_;
    if (!parts.layers.follow || !parts.composed.hasBody()) {
        parts.followed_m.reset();
        return;
    }
    // Along the ground only: a camera that bobs with every step makes sick.
    const Vector3d root = parts.composed.places.joints.p_world_joint.front().cwiseProduct(Vector3d(1, 0, 1));
    if (parts.followed_m)
        parts.control->shift(root - *parts.followed_m);
    parts.followed_m = root;
}

void SceneView::refresh() {
    if (parts_->canvas)
        parts_->canvas->refresh(isPlayed(review_) || parts_->control->isMoving());
}

void SceneView::updateOverlay(quint64 number) {
    Parts& parts = *parts_;
    const auto asked = parts.asked.find(number);
    const Camera& camera = asked == parts.asked.end() ? parts.control->camera() : asked->second.camera;
    OverlayContent content;
    content.camera_axes = camera.axes();
    std::optional<Vector3d> at;
    if (parts.figure) {
        content.callout = figureCallout(*parts.figure);
        if (parts.composed.scene.gizmo)
            at = parts.composed.scene.gizmo->p_m.cast<double>();
    } else {
        if (!parts.live)
            content.legends = takeLegends(review_.take(), parts.composed, parts.layers, parts.beside_other);
        content.has_rays = !parts.composed.scene.rays.empty();
        content.callout = callout();
        if (!parts.composed.scene.rings.empty())
            at = parts.composed.scene.rings.back().p_m.cast<double>();
    }
    const auto place = [&](const Vector3d& p_m) -> std::optional<QPointF> {
        const auto pixel = camera.project(p_m, parts.control->size());
        return pixel ? std::optional(QPointF(pixel->x(), pixel->y()) / parts.canvas->devicePixelRatioF())
                     : std::nullopt;
    };
    for (const ComposedScene::Tag& tag : parts.composed.tags)
        if (const auto on_screen = place(tag.p_m))
            content.tags.push_back({tag.performer, *on_screen});
    if (const auto& distance = parts.composed.distance)
        if (const auto from = place(distance->middle_m),
            floor = place(distance->middle_m.cwiseProduct(Vector3d(1, 0, 1)));
            from && floor)
            content.distance =
                SceneDistance{*from, *floor, distanceInWords(*distance), pairOfDistance(*distance)};
    const auto on_screen = at ? place(*at) : std::nullopt;
    if (content.callout && on_screen) {
        content.callout->at = *on_screen;
        for (const auto* bones : {&parts.composed.places.bones, &parts.composed.ghost_bones})
            for (const BonePlace& bone : *bones)
                for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0})
                    if (const auto p = place((1 - part) * bone.from_m + part * bone.to_m))
                        content.callout->bodies.push_back(*p);
    } else {
        content.callout.reset();
    }
    parts.overlay->setContent(std::move(content));
    updateMessage();
}

bool SceneView::isShown(SceneLayer layer) const {
    return parts_->layers.has(layer);
}

void SceneView::setShown(SceneLayer layer, bool shown) {
    parts_->layers.set(layer, shown);
    changeLayers();
}

void SceneView::toggle(SceneLayer layer) {
    setShown(layer, !isShown(layer));
}

bool SceneView::follows() const {
    return parts_->layers.follow;
}

void SceneView::setFollow(bool follow) {
    parts_->layers.follow = follow;
    changeLayers();
}

void SceneView::changeLayers() {
    parts_->tools->setLayers(parts_->layers);
    saveLayers(review_.shared().settings(), parts_->step, parts_->layers);
    refresh();
    emit layersChanged();
}

void SceneView::keepCamera() {
    review_.shared().settings().setValue(settingsGroup(parts_->step) + QStringLiteral("/view"),
                                         static_cast<int>(view()));
}

void SceneView::setView(CameraView view) {
    parts_->control->setView(view);
}

CameraView SceneView::view() const {
    return parts_->control->view();
}

const Camera& SceneView::camera() const {
    return parts_->control->camera();
}

void SceneView::setCamera(const Camera& camera) {
    parts_->control->setCamera(camera);
    parts_->untouched = false;
}

void SceneView::frameBody() {
    compose();  // the body where it is now, which may not have been drawn yet
    if (parts_->composed.hasBody())
        parts_->control->frame(bodyBox());
    parts_->untouched = true;
}

QImage SceneView::picture(double scale) const {
    if (!parts_->canvas)
        return {};
    QImage image = parts_->canvas->picture(scale);
    if (image.isNull())
        return image;
    QPainter painter(&image);
    const double to_image = scale * parts_->canvas->devicePixelRatioF();
    painter.scale(to_image, to_image);
    SceneOverlay::paint(painter, QRectF(QPointF(0, 0), QSizeF(size())), parts_->overlay->content());
    return image;
}

QString SceneView::descriptionInWords() const {
    if (!parts_->canvas)
        return SceneCanvas::missing();
    if (parts_->figure)
        return figureDescription(*parts_->figure);
    if (!parts_->composed.hasBody())
        return whyNoBody();
    return parts_->live ? liveDescription(parts_->composed, callout())
                        : takeDescription(review_, parts_->composed, callout());
}

void SceneView::exportPicture() {
    const QString path =
        FileChoice{"pictures", tr("Save as picture"), tr("PNG picture (*.png)"), "noctule.png",
                   QStandardPaths::writableLocation(QStandardPaths::PicturesLocation)}
            .toSave(this);
    if (path.isEmpty())
        return;
    if (picture(2).save(path, "PNG"))
        review_.shared().sayOfFile(tr("Picture written: %1").arg(path));
    else
        emit review_.shared().failed(tr("The picture could not be written to %1.").arg(path),
                                     tr("Free space on the disk or choose another folder."), About::kFile);
}

}  // namespace noctule::ui
