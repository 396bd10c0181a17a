// SPDX-License-Identifier: Apache-2.0
#include "ui/views/session/motion_picture.h"

#include <QPainter>
#include <algorithm>

#include "ui/language/core_words.h"
#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

constexpr int kFigureWidth = 400, kFigureHeight = 300, kEdge_px = 12;
constexpr double kHeadroom = 1.12;  ///< of the figure's height, with arms raised

bool isOfSide(const std::string& joint, const char* side) {
    return joint.rfind(side, 0) == 0;
}

}  // namespace

MotionPicture::MotionPicture(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("The figure from the front and from its left"));
    connect(&Theme::get(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void MotionPicture::setMotion(std::shared_ptr<const figure::UnderstoodMotion> motion) {
    motion_ = std::move(motion);
    const int frames = motion_ ? static_cast<int>(motion_->clip.frames.size()) : 0;
    frame_ = std::clamp(frame_, 0, std::max(0, frames - 1));
    findFloor();
    setAccessibleDescription(motion_ ? coreWords(figure::describe(*motion_)) : QString());
    update();
}

void MotionPicture::setFrame(int frame) {
    frame_ = frame;
    setMotion(motion_);
}

/// Lowest joint over the motion, from at most a hundred frames.
void MotionPicture::findFloor() {
    floor_m_ = 0;
    if (!motion_ || motion_->clip.frames.empty())
        return;
    const size_t frames = motion_->clip.frames.size(), step = std::max<size_t>(1, frames / 100);
    std::vector<double> lowest;
    for (size_t f = 0; f < frames; f += step) {
        double low = 1e9;
        for (const Vector3d& p : globalPose(motion_->clip, f).p_world_joint)
            low = std::min(low, p.y());
        lowest.push_back(low);
    }
    const auto tenth = lowest.begin() + static_cast<std::ptrdiff_t>(lowest.size() / 10);
    std::nth_element(lowest.begin(), tenth, lowest.end());
    floor_m_ = *tenth;
}

QSize MotionPicture::sizeHint() const {
    return {Theme::get().px(kFigureWidth), Theme::get().px(kFigureHeight)};
}

QSize MotionPicture::minimumSizeHint() const {
    return sizeHint() * 2 / 3;
}

std::vector<MotionPicture::Line> MotionPicture::linesFrom(bool front) const {
    std::vector<Line> lines;
    const GlobalPose pose = globalPose(motion_->clip, static_cast<size_t>(frame_));
    const auto place = [&](const char* joint) {
        return pose.p_world_joint[static_cast<size_t>(motion_->joints.at(joint))];
    };
    Vector3d left = place("LeftUpLeg") - place("RightUpLeg");
    left.y() = 0;
    left = left.norm() > 1e-6 ? Vector3d(left.normalized()) : Vector3d(Vector3d::UnitX());
    const Vector3d right_of_picture = front ? left : Vector3d(left.cross(Vector3d::UnitY()));
    const Vector3d middle = (place("LeftUpLeg") + place("RightUpLeg")) / 2;
    const auto seen = [&](const Vector3d& p) {
        return QPointF(right_of_picture.dot(p - middle), p.y() - floor_m_);
    };
    std::map<int, std::string> names;
    for (const auto& [name, joint] : motion_->joints)
        names[joint] = name;
    const Skeleton& skeleton = motion_->clip.skeleton;
    for (int j = 0; j < skeleton.size(); ++j) {
        const auto name = names.find(j);
        const Line::Kind kind = name == names.end()               ? Line::Kind::kOther
                                : isOfSide(name->second, "Left")  ? Line::Kind::kLeft
                                : isOfSide(name->second, "Right") ? Line::Kind::kRight
                                                                  : Line::Kind::kMiddle;
        const auto at = static_cast<size_t>(j);
        const Joint& joint = skeleton.joint(j);
        if (joint.parent >= motion_->joints.at("Hips"))
            lines.push_back({seen(pose.p_world_joint[static_cast<size_t>(joint.parent)]),
                             seen(pose.p_world_joint[at]), kind});
        if (joint.end_m && name != names.end())
            lines.push_back({seen(pose.p_world_joint[at]),
                             seen(pose.p_world_joint[at] + pose.q_world_joint[at] * *joint.end_m), kind});
    }
    return lines;
}

void MotionPicture::paintView(QPainter& painter, const QRect& area, bool front) const {
    const Tokens& tokens = Theme::get().tokens();
    const int edge = Theme::get().px(kEdge_px);
    painter.setFont(Theme::get().font(TextRole::kCaption));
    painter.setPen(tokens.t2);
    const QRect words = area.adjusted(edge, edge / 2, -edge, -edge / 2);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignTop, front ? tr("From the front") : tr("From its left"));
    if (front)
        painter.drawText(words, Qt::AlignRight | Qt::AlignTop, tr("its left"));
    if (!motion_)
        return;
    const double height = std::max(motion_->measures.height_m, 0.1);
    const double scale =
        std::min((area.height() - 4.0 * edge) / (kHeadroom * height), (area.width() - 2.0 * edge) / height);
    const double ground = area.bottom() - 1.5 * edge;
    painter.setPen(QPen(tokens.edge, 1));
    painter.drawLine(QPointF(area.left() + edge, ground), QPointF(area.right() - edge, ground));
    const auto at = [&](const QPointF& p) {
        return QPointF(area.center().x() + scale * p.x(), ground - scale * p.y());
    };
    for (const Line& line : linesFrom(front)) {
        const bool thin = line.kind == Line::Kind::kOther;
        const QColor ink = line.kind == Line::Kind::kLeft ? tokens.acc : thin ? tokens.t3 : tokens.t1;
        painter.setPen(QPen(ink, Theme::get().px(thin ? 1 : 2), Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(at(line.from), at(line.to));
    }
}

void MotionPicture::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), Theme::get().tokens().view);
    const int half = width() / 2;
    for (const bool front : {true, false}) {
        const QRect area(front ? 0 : half, 0, half, height());
        painter.setClipRect(area);
        paintView(painter, area, front);
    }
    painter.setClipping(false);
    painter.setPen(Theme::get().tokens().line);
    painter.drawLine(half, 0, half, height());
}

}  // namespace noctule::ui
