// SPDX-License-Identifier: Apache-2.0
#include "ui/robot/robot_view.h"

#include <QMouseEvent>
#include <QResizeEvent>

#include "core/robot_film/robot_mesh.h"
#include "ui/robot/robot_words.h"
#include "ui/scene/camera_control.h"
#include "ui/scene/dressed_body.h"
#include "ui/scene/scene_canvas.h"
#include "ui/style/theme.h"
#include "ui/widgets/accessible.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/label.h"

namespace noctule::ui {

RobotView::RobotView(RobotDrive& drive, QWidget* parent)
    : QWidget(parent), drive_(drive), control_(new CameraControl(this)) {
    describe(*this, {QAccessible::Graphic});
    setAccessibleName(tr("Robot in 3D"));
    setMinimumSize(200, 160);
    const QString missing = SceneCanvas::missing();
    if (missing.isEmpty()) {
        canvas_ = new SceneCanvas([this]() -> const Scene& { return compose(); },
                                  [this] { return control_->camera(); }, this);
        canvas_->installEventFilter(this);
        connect(canvas_, &SceneCanvas::unavailable, this, [this](const QString& why) {
            canvas_->hide();
            message_->setSentence(why);
            message_->show();
        });
        connect(control_, &CameraControl::changed, this, [this] { canvas_->refresh(control_->isMoving()); });
    }
    message_ = new EmptyState(missing, {}, {}, this);
    message_->setAttribute(Qt::WA_TransparentForMouseEvents);
    message_->setVisible(!missing.isEmpty());
    title_ = new Label({}, TextRole::kBody, Ink::kValue, true, this);
    legend_ =
        new Label(tr("filled: achieved, outline: commanded"), TextRole::kCaption, Ink::kLabel, false, this);
    for (Label* label : {title_, legend_})
        label->setAttribute(Qt::WA_TransparentForMouseEvents);
    const auto redraw = [this] {
        if (canvas_)
            canvas_->refresh(true);
    };
    connect(&drive, &RobotDrive::ticked, this, redraw);
    connect(&drive, &RobotDrive::robotChanged, this, &RobotView::takeRobot);
    connect(&Theme::get(), &Theme::changed, this, redraw);
    takeRobot();
}

RobotView::~RobotView() {
    delete canvas_;  // it draws through this view
    canvas_ = nullptr;
}

void RobotView::takeRobot() {
    parts_ = drive_.parts();
    mesh_ = nullptr;
    is_framed_ = false;
    title_->setText(parts_ ? robotInWords(parts_->model.name) : QString());
    legend_->setVisible(parts_ != nullptr);
    if (parts_) {
        mesh_ = parts_->mesh;
        box_ = robot::boxOf(parts_->model, parts_->profile, valuesOf(parts_->driven.reference()),
                            robot::standingRoot(parts_->model, parts_->profile, 0));
        lift_m_ = box_.isEmpty() ? 0 : -box_.min().y();
        box_.translate(Vector3d(0, lift_m_, 0));
        frame();
    }
    resizeEvent(nullptr);
    if (canvas_)
        canvas_->refresh(false);
}

void RobotView::frame() {
    if (!canvas_ || !parts_ || box_.isEmpty() || width() < 50)
        return;
    control_->setSize(canvas_->surfaceSize());
    Eigen::AlignedBox3d roomy = box_;
    roomy.max().y() += 0.15 * box_.sizes().y();
    control_->frame(roomy, true);
    is_framed_ = true;
}

robot::JointValues RobotView::valuesOf(const std::vector<double>& q) const {
    robot::JointValues values;
    for (size_t i = 0; i < std::min(q.size(), parts_->axes.size()); ++i)
        values[parts_->axes[i].model_joint] = q[i];
    return values;
}

/// The way of the hand: achieved as a line that fades, commanded as dashes.
void RobotView::addHand(const robot::RobotArm& arm, const robot::JointValues& now) {
    const auto paths = drive_.handPaths(arm_);
    const int base = parts_->model.findLink(arm.profile.base);
    const Eigen::Isometry3d T_world_base = robot::standingRoot(parts_->model, parts_->profile, lift_m_) *
                                           robot::linkPlaces(parts_->model, now)[static_cast<size_t>(base)];
    const Tokens& tokens = Theme::get().tokens();
    const auto inWorld = [&](const Vector3d& p_body) -> Eigen::Vector3f {
        return (T_world_base * (arm.profile.R_base_body * p_body)).cast<float>();
    };
    SceneTrail trail;
    trail.color = rgba(tokens.acc);
    for (size_t i = 0; i < paths.achieved.size(); i += 3)
        trail.points_m.push_back(inWorld(paths.achieved[i].p_m));
    if (trail.points_m.size() > 1)
        scene_.trails.push_back(std::move(trail));
    constexpr size_t kStride = 8;
    for (size_t i = kStride; i < paths.commanded.size(); i += 2 * kStride)
        scene_.rays.push_back({inWorld(paths.commanded[i - kStride].p_m), inWorld(paths.commanded[i].p_m),
                               rgba(tokens.ref), 1, false});
}

const Scene& RobotView::compose() {
    const SceneColors colors = SceneColors::of(Theme::get());
    scene_ = {};
    addRoom(scene_, colors, {}, Vector3d::Zero());
    if (!parts_ || mesh_->vertices.empty())
        return scene_;
    const RobotMoment* newest = drive_.moments().empty() ? nullptr : &drive_.moments().back();
    SceneDisc shadow;
    shadow.radius_x_m = 0.35F;
    shadow.radius_z_m = 0.3F;
    shadow.color = colors.shadow;
    shadow.softness = 1;
    scene_.discs.push_back(shadow);
    SceneBody body;
    body.mesh = mesh_;
    body.color = colors.body;
    const robot::JointValues now = valuesOf(newest ? newest->actual : std::vector<double>());
    body.skin = robot::skinOf(parts_->model, *mesh_, now,
                              robot::standingRoot(parts_->model, parts_->profile, lift_m_));
    scene_.bodies.push_back(body);
    if (!newest)
        return scene_;
    const bool follows = drive_.word() == RobotWord::kFollowing;
    const std::vector<double>& wanted =
        follows || newest->output.ghost.empty() ? newest->output.q : newest->output.ghost;
    body.skin = robot::skinOf(parts_->model, *mesh_, valuesOf(wanted),
                              robot::standingRoot(parts_->model, parts_->profile, lift_m_));
    body.color = colors.ghost;
    body.style = BodyStyle::kOutline;
    scene_.bodies.push_back(std::move(body));
    if (arm_ < parts_->driven.arms.size())
        addHand(parts_->driven.arms[arm_], now);
    return scene_;
}

void RobotView::resizeEvent(QResizeEvent*) {
    const int margin = Theme::get().px(12);
    if (canvas_)
        canvas_->setGeometry(rect());
    message_->setGeometry(rect());
    for (Label* label : {title_, legend_})
        label->resize(label->sizeHint().boundedTo(QSize(std::max(10, width() - 2 * margin), height())));
    title_->move(margin, margin);
    legend_->move(width() - margin - legend_->width(), height() - margin - legend_->height());
    for (Label* label : {title_, legend_})
        label->raise();
    if (canvas_)
        control_->setSize(canvas_->surfaceSize());
    if (!is_framed_)
        frame();
}

bool RobotView::eventFilter(QObject* watched, QEvent* event) {
    if (watched != canvas_)
        return QWidget::eventFilter(watched, event);
    switch (event->type()) {
        case QEvent::MouseButtonPress:
            return control_->press(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseMove:
            return control_->move(*static_cast<QMouseEvent*>(event));
        case QEvent::MouseButtonRelease:
            return control_->release(*static_cast<QMouseEvent*>(event));
        case QEvent::Wheel:
            control_->wheel(*static_cast<QWheelEvent*>(event));
            return true;
        default:
            return false;
    }
}

}  // namespace noctule::ui
