// SPDX-License-Identifier: Apache-2.0
#include "ui/views/body_figure.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace noctule::ui {
namespace {

constexpr double kArmsDown_rad = 0.87, kLegsApart_rad = 0.09;
constexpr double kMargin_m = 0.03;
constexpr int kOversampling = 2;

/// Arms half-way down and legs a little apart: nothing hides anything else.
Pose openStance(const Skeleton& skeleton) {
    Pose pose = skeleton.zeroPose();
    const auto turn = [&](const char* joint, double angle_rad) {
        if (const int index = skeleton.find(joint); index >= 0)
            pose.q_parent_joint[static_cast<size_t>(index)] =
                Quaterniond(Eigen::AngleAxisd(angle_rad, Vector3d::UnitZ()));
    };
    turn("LeftArm", -kArmsDown_rad);
    turn("RightArm", kArmsDown_rad);
    turn("LeftUpLeg", kLegsApart_rad);
    turn("RightUpLeg", -kLegsApart_rad);
    return pose;
}

/// The bone with the most weight at a point of a triangle, given in barycentric coordinates.
int strongestBone(const std::array<const SkinnedVertex*, 3>& corners, const std::array<double, 3>& at) {
    std::array<double, 64> weight_of_bone{};
    int strongest = corners[0]->bones[0];
    for (size_t corner = 0; corner < 3; ++corner)
        for (size_t i = 0; i < 4; ++i) {
            const size_t bone = corners[corner]->bones[i] % weight_of_bone.size();
            weight_of_bone[bone] += at[corner] * static_cast<double>(corners[corner]->weights[i]);
            if (weight_of_bone[bone] > weight_of_bone[static_cast<size_t>(strongest)])
                strongest = static_cast<int>(bone);
        }
    return strongest;
}

Eigen::Vector3f skinned(const SkinnedVertex& vertex, const std::vector<Eigen::Matrix4f>& matrices) {
    Eigen::Vector3f p = Eigen::Vector3f::Zero();
    for (size_t i = 0; i < vertex.weights.size(); ++i)
        if (vertex.weights[i] > 0)
            p += vertex.weights[i] * (matrices[vertex.bones[i]] * vertex.p_m.homogeneous()).head<3>();
    return p;
}

}  // namespace

BodyFigure::BodyFigure(const Actor& actor, std::shared_ptr<const SkinnedMesh> mesh)
    : skeleton_(actor.skeleton), stance_(globalPose(actor.skeleton, openStance(actor.skeleton))) {
    if (mesh && !mesh->vertices.empty())
        addMesh(*mesh);
    else
        addCapsules(actor);
    double lowest = 0, highest = 0, widest = 0;
    for (const Face& face : faces_)
        for (const QPointF& corner : face.corners_m) {
            lowest = std::min(lowest, corner.y());
            highest = std::max(highest, corner.y());
            widest = std::max(widest, std::abs(corner.x()));
        }
    for (Face& face : faces_)
        for (QPointF& corner : face.corners_m)
            corner.ry() += kMargin_m - lowest;
    for (Vector3d& p : stance_.p_world_joint)
        p.y() += kMargin_m - lowest;
    height_m_ = highest - lowest + 2 * kMargin_m;
    half_width_m_ = widest + kMargin_m;
    std::stable_sort(faces_.begin(), faces_.end(),
                     [](const Face& a, const Face& b) { return a.depth_m < b.depth_m; });
}

int BodyFigure::segmentIndex(const std::string& name) {
    const auto found = std::find(segments_.begin(), segments_.end(), name);
    if (found == segments_.end())
        segments_.push_back(name);
    return static_cast<int>(
        std::distance(segments_.begin(), std::find(segments_.begin(), segments_.end(), name)));
}

void BodyFigure::addMesh(const SkinnedMesh& mesh) {
    const std::vector<Eigen::Matrix4f> matrices = skinMatrices(mesh, skeleton_, stance_);
    std::vector<Eigen::Vector3f> points;
    points.reserve(mesh.vertices.size());
    for (const SkinnedVertex& vertex : mesh.vertices)
        points.push_back(skinned(vertex, matrices));
    std::vector<int> segments;
    for (const SkinBone& bone : mesh.bones)
        segments.push_back(segmentIndex(bone.joint));
    for (const auto& triangle : mesh.triangles) {
        Corners corners{};
        std::array<const SkinnedVertex*, 3> vertices{};
        double depth_m = -1e9;
        for (size_t i = 0; i < 3; ++i) {
            const Eigen::Vector3f& p = points[triangle[i]];
            corners[i] = {p.x(), p.y()};
            vertices[i] = &mesh.vertices[triangle[i]];
            depth_m = std::max(depth_m, static_cast<double>(p.z()));
        }
        addTriangle(corners, vertices, segments, depth_m);
    }
}

/// Where two bones share a triangle it is cut into small ones, so that the border between segments is smooth.
void BodyFigure::addTriangle(const Corners& corners, const std::array<const SkinnedVertex*, 3>& vertices,
                             const std::vector<int>& segments, double depth_m) {
    const auto boneAt = [&](double a, double b, double c) { return strongestBone(vertices, {a, b, c}); };
    const int first = boneAt(1, 0, 0);
    if (first == boneAt(0, 1, 0) && first == boneAt(0, 0, 1)) {
        faces_.push_back({corners, depth_m, segments[static_cast<size_t>(first)]});
        return;
    }
    constexpr int kParts = 6;
    const auto point = [&](int i, int j) {
        const double a = 1.0 * i / kParts, b = 1.0 * j / kParts;
        return corners[0] * (1 - a - b) + corners[1] * a + corners[2] * b;
    };
    const auto add = [&](const Corners& part, double i, double j) {
        const double a = i / kParts, b = j / kParts;
        faces_.push_back({part, depth_m, segments[static_cast<size_t>(boneAt(1 - a - b, a, b))]});
    };
    for (int i = 0; i < kParts; ++i)
        for (int j = 0; i + j < kParts; ++j) {
            add({point(i, j), point(i + 1, j), point(i, j + 1)}, i + 1.0 / 3, j + 1.0 / 3);
            if (i + j + 1 < kParts)
                add({point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)}, i + 2.0 / 3, j + 2.0 / 3);
        }
}

void BodyFigure::addCapsules(const Actor& actor) {
    constexpr int kCorners = 24;
    for (const Capsule& capsule : actor.capsules) {
        const int joint = skeleton_.find(capsule.segment);
        if (joint < 0)
            continue;
        const QPointF a = place(capsule.segment, capsule.a_m), b = place(capsule.segment, capsule.b_m);
        const double depth = stance_.p_world_joint[static_cast<size_t>(joint)].z();
        const double heading = std::atan2(b.y() - a.y(), b.x() - a.x());
        std::vector<QPointF> outline;
        for (int i = 0; i < kCorners; ++i) {
            const bool around_b = i < kCorners / 2;
            const double angle = heading - M_PI / 2 + 2 * M_PI * i / (kCorners - 2) -
                                 (around_b ? 0 : 2 * M_PI / (kCorners - 2));
            const QPointF centre = around_b ? b : a;
            outline.push_back(centre + capsule.radius_m * QPointF(std::cos(angle), std::sin(angle)));
        }
        for (size_t i = 2; i < outline.size(); ++i)
            faces_.push_back(
                {{outline[0], outline[i - 1], outline[i]}, depth, segmentIndex(capsule.segment)});
    }
}

QPointF BodyFigure::place(const std::string& segment, const Vector3d& p_segment_m) const {
    const int joint = std::max(0, skeleton_.find(segment));
    const auto index = static_cast<size_t>(joint);
    const Vector3d p = stance_.p_world_joint[index] + stance_.q_world_joint[index] * p_segment_m;
    return {p.x(), p.y()};
}

QPointF BodyFigure::board(const Board& board) const {
    return place(board.segment, board.p_segment_board_m);
}

QPointF BodyFigure::source(const Source& source) const {
    return place(source.segment, source.p_segment_source_m);
}

/// Colour of each pixel: index of its segment plus 1.
QImage BodyFigure::segmentImage(int height_px) const {
    const double scale = this->scale(height_px);
    QImage image(static_cast<int>(std::ceil(2 * half_width_m_ * scale)), height_px, QImage::Format_RGB32);
    image.fill(QColor(0, 0, 0));
    QPainter painter(&image);
    painter.setPen(Qt::NoPen);
    const QPointF centre(image.width() / 2.0, height_px);
    for (const Face& face : faces_) {
        std::array<QPointF, 3> corners;
        for (size_t i = 0; i < 3; ++i)
            corners[i] = centre + scale * QPointF(face.corners_m[i].x(), -face.corners_m[i].y());
        const QColor code(face.segment + 1, 0, 0);
        painter.setBrush(code);
        painter.drawConvexPolygon(corners.data(), 3);
    }
    return image;
}

QImage BodyFigure::paint(int height_px, const QColor& body,
                         const std::map<std::string, QColor>& marked) const {
    if (codes_height_px_ != height_px)
        codes_ = segmentImage(height_px * kOversampling);
    codes_height_px_ = height_px;
    const QImage& codes = codes_;
    std::vector<QRgb> colors{0};
    for (const std::string& segment : segments_) {
        const auto mark = marked.find(segment);
        colors.push_back((mark == marked.end() ? body : mark->second).rgb());
    }
    QImage picture(codes.size(), QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    constexpr int kGap = kOversampling;  // of one pixel, where two segments meet; the outer edge stays whole
    for (int y = 0; y + kGap < codes.height(); ++y) {
        const auto* here = reinterpret_cast<const QRgb*>(codes.constScanLine(y));
        const auto* below = reinterpret_cast<const QRgb*>(codes.constScanLine(y + kGap));
        auto* out = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x + kGap < codes.width(); ++x) {
            const int segment = qRed(here[x]), right = qRed(here[x + kGap]), under = qRed(below[x]);
            const bool gap = (right != segment && right != 0) || (under != segment && under != 0);
            if (segment != 0 && !gap)
                out[x] = colors[static_cast<size_t>(segment)];
        }
    }
    return picture.scaledToHeight(height_px, Qt::SmoothTransformation);
}

}  // namespace noctule::ui
