// SPDX-License-Identifier: Apache-2.0
#include "ui/views/body_figure.h"

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

/// The outside of a closed mesh is where its corners run anticlockwise.
bool facesViewer(const std::array<QPointF, 3>& corners) {
    const QPointF a = corners[1] - corners[0], b = corners[2] - corners[0];
    return a.x() * b.y() > a.y() * b.x();
}

/// Every pixel whose centre lies inside gets the code. Tens of thousands of small triangles: QPainter takes
/// several times as long for them.
void fillTriangle(QImage& image, const std::array<QPointF, 3>& corners, uchar code) {
    const auto [left, right] = std::minmax({corners[0].x(), corners[1].x(), corners[2].x()});
    const auto [top, bottom] = std::minmax({corners[0].y(), corners[1].y(), corners[2].y()});
    const int first = std::max(0, static_cast<int>(left)),
              last = std::min(image.width() - 1, static_cast<int>(right));
    const int lowest = std::min(image.height() - 1, static_cast<int>(bottom));
    const double turn = facesViewer(corners) ? 1 : -1;
    for (int y = std::max(0, static_cast<int>(top)); y <= lowest; ++y) {
        // Of each edge: how far inside the row begins, and what each pixel adds.
        std::array<double, 3> inside{}, step{};
        for (size_t i = 0; i < 3; ++i) {
            const QPointF along = turn * (corners[(i + 1) % 3] - corners[i]);
            const QPointF to = QPointF(first + 0.5, y + 0.5) - corners[i];
            inside[i] = along.x() * to.y() - along.y() * to.x();
            step[i] = -along.y();
        }
        uchar* row = image.scanLine(y);
        for (int x = first; x <= last; ++x) {
            if (std::min({inside[0], inside[1], inside[2]}) >= 0)
                row[x] = code;
            for (size_t i = 0; i < 3; ++i)
                inside[i] += step[i];
        }
    }
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
        if (facesViewer(corners))
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

/// Each pixel: index of its segment plus 1. Asked for with every change of colour.
QImage BodyFigure::segmentImage(int height_px) const {
    if (segment_image_.height() == height_px)
        return segment_image_;
    const double scale = this->scale(height_px);
    QImage image(static_cast<int>(std::ceil(2 * half_width_m_ * scale)), height_px,
                 QImage::Format_Grayscale8);
    image.fill(0);
    const QPointF centre(image.width() / 2.0, height_px);
    for (const Face& face : faces_) {
        std::array<QPointF, 3> corners;
        for (size_t i = 0; i < 3; ++i)
            corners[i] = centre + scale * QPointF(face.corners_m[i].x(), -face.corners_m[i].y());
        fillTriangle(image, corners, static_cast<uchar>(face.segment + 1));
    }
    return segment_image_ = image;
}

std::shared_ptr<const BodyFigure> BodyFigure::of(const Actor& actor,
                                                 const std::shared_ptr<const SkinnedMesh>& mesh) {
    static std::weak_ptr<const SkinnedMesh> last_mesh;
    static std::vector<double> last_bones;
    static std::shared_ptr<const BodyFigure> last;
    std::vector<double> bones;
    for (const Joint& joint : actor.skeleton.joints())
        bones.insert(bones.end(), joint.offset_m.begin(), joint.offset_m.end());
    if (!mesh || !last || last_mesh.lock() != mesh || last_bones != bones) {
        last = std::make_shared<const BodyFigure>(actor, mesh);
        last_mesh = mesh;
        last_bones = std::move(bones);
    }
    return last;
}

QImage BodyFigure::paint(int height_px, const QColor& body,
                         const std::map<std::string, QColor>& marked) const {
    const QImage codes = segmentImage(height_px * kOversampling);
    std::vector<QRgb> colors{0};
    for (const std::string& segment : segments_) {
        const auto mark = marked.find(segment);
        colors.push_back((mark == marked.end() ? body : mark->second).rgb());
    }
    QImage picture(codes.width() / kOversampling, height_px, QImage::Format_ARGB32_Premultiplied);
    constexpr int kParts = kOversampling * kOversampling;
    constexpr int kGap = kOversampling;  // of one pixel, where two segments meet; the outer edge stays whole
    const uchar* bits = codes.constBits();
    const int line = codes.bytesPerLine(), wide = codes.width(), high = codes.height();
    const auto colorAt = [&](int x, int y) {
        const uchar* at = bits + static_cast<ptrdiff_t>(y) * line + x;
        const int segment = *at;
        const int right = x + kGap < wide ? at[kGap] : 0;
        const int below = y + kGap < high ? at[kGap * line] : 0;
        const bool gap = (right != segment && right != 0) || (below != segment && below != 0);
        return gap ? 0 : colors[static_cast<size_t>(segment)];
    };
    for (int y = 0; y < picture.height(); ++y) {
        auto* out = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < wide / kOversampling; ++x) {
            int alpha = 0, red = 0, green = 0, blue = 0;
            for (int i = 0; i < kParts; ++i) {
                const QRgb color =
                    colorAt(kOversampling * x + i % kOversampling, kOversampling * y + i / kOversampling);
                alpha += qAlpha(color);
                red += qRed(color);
                green += qGreen(color);
                blue += qBlue(color);
            }
            out[x] = qRgba(red / kParts, green / kParts, blue / kParts, alpha / kParts);
        }
    }
    return picture;
}

}  // namespace noctule::ui
