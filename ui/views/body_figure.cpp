// SPDX-License-Identifier: Apache-2.0
#include "ui/views/body_figure.h"

#include <algorithm>
#include <cmath>

namespace noctule::ui {
namespace {

constexpr double kArmsDown_rad = 0.87, kLegsApart_rad = 0.09;
constexpr double kMargin_m = 0.03;
constexpr double kRoomToReach =
    1.25;  // of the height: hands overhead, or from one to the other and a little more

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

/// The outside of a closed mesh is where its corners run anticlockwise.
bool facesViewer(const std::array<QPointF, 3>& corners) {
    const QPointF a = corners[1] - corners[0], b = corners[2] - corners[0];
    return a.x() * b.y() > a.y() * b.x();
}

Eigen::Vector3f skinned(const SkinnedVertex& vertex, const std::vector<Eigen::Matrix4f>& matrices) {
    Eigen::Vector3f p = Eigen::Vector3f::Zero();
    for (size_t i = 0; i < vertex.weights.size(); ++i)
        if (vertex.weights[i] > 0)
            p += vertex.weights[i] * (matrices[vertex.bones[i]] * vertex.p_m.homogeneous()).head<3>();
    return p;
}

}  // namespace

BodyFigure::BodyFigure(const Actor& actor, const std::shared_ptr<const SkinnedMesh>& mesh, Stance stance)
    : skeleton_(actor.skeleton),
      stance_(globalPose(actor.skeleton,
                         stance == Stance::kRest ? actor.restPose() : openStance(actor.skeleton))) {
    stand(actor, mesh);
}

BodyFigure::BodyFigure(const Actor& actor, const std::shared_ptr<const SkinnedMesh>& mesh, const Pose& pose)
    : skeleton_(actor.skeleton), stance_(globalPose(actor.skeleton, pose)) {
    stand(actor, mesh);
    height_m_ = std::max(height_m_, kRoomToReach * actor.height_m);
    half_width_m_ = std::max(half_width_m_, kRoomToReach * actor.height_m / 2);
}

void BodyFigure::stand(const Actor& actor, const std::shared_ptr<const SkinnedMesh>& mesh) {
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
    std::vector<int> segment_of_bone;
    for (const SkinBone& bone : mesh.bones)
        segment_of_bone.push_back(segmentIndex(bone.joint));
    const auto cornersOf = [&](const std::array<uint32_t, 3>& triangle) {
        Corners corners;
        for (size_t i = 0; i < 3; ++i)
            corners[i] = {points[triangle[i]].x(), points[triangle[i]].y()};
        return corners;
    };
    std::vector<std::pair<float, const std::array<uint32_t, 3>*>> visible;  // depth of the nearest corner, m
    for (const auto& triangle : mesh.triangles)
        if (facesViewer(cornersOf(triangle)))
            visible.emplace_back(
                std::max({points[triangle[0]].z(), points[triangle[1]].z(), points[triangle[2]].z()}),
                &triangle);
    std::ranges::stable_sort(visible, {}, [](const auto& entry) { return entry.first; });
    faces_.reserve(visible.size());
    for (const auto& [depth_m, triangle] : visible)
        faces_.push_back(
            {cornersOf(*triangle), sharesOf({&mesh.vertices[(*triangle)[0]], &mesh.vertices[(*triangle)[1]],
                                             &mesh.vertices[(*triangle)[2]]},
                                            segment_of_bone)});
}

/// The strongest alone where it is so at every corner: weights are linear, so it is so in between.
std::vector<BodyFigure::Share> BodyFigure::sharesOf(const std::array<const SkinnedVertex*, 3>& vertices,
                                                    const std::vector<int>& segment_of_bone) {
    std::vector<Share> shares;
    for (size_t corner = 0; corner < 3; ++corner)
        for (size_t i = 0; i < vertices[corner]->weights.size(); ++i) {
            const double weight = vertices[corner]->weights[i];
            if (weight <= 0)
                continue;
            const int segment = segment_of_bone[vertices[corner]->bones[i]];
            auto share = std::ranges::find(shares, segment, &Share::segment);
            if (share == shares.end())
                share = shares.insert(share, {segment, {}});
            share->weights[corner] += weight;
        }
    const auto everywhere = std::ranges::find_if(shares, [&](const Share& strongest) {
        return std::ranges::all_of(shares, [&](const Share& other) {
            return std::ranges::equal(strongest.weights, other.weights, std::greater_equal());
        });
    });
    return everywhere == shares.end() ? shares : std::vector<Share>{*everywhere};
}

void BodyFigure::addCapsules(const Actor& actor) {
    constexpr int kCorners = 24;
    const auto depthOf = [this](const Capsule& capsule) {
        return stance_.p_world_joint[static_cast<size_t>(skeleton_.find(capsule.segment))].z();
    };
    std::vector<Capsule> capsules = actor.capsules;
    std::erase_if(capsules, [this](const Capsule& capsule) { return skeleton_.find(capsule.segment) < 0; });
    std::ranges::stable_sort(capsules, {}, depthOf);
    for (const Capsule& capsule : capsules) {
        const QPointF a = place(capsule.segment, capsule.a_m), b = place(capsule.segment, capsule.b_m);
        const double heading = std::atan2(b.y() - a.y(), b.x() - a.x());
        std::vector<QPointF> outline;
        for (int i = 0; i < kCorners; ++i) {
            const bool around_b = i < kCorners / 2;
            const double angle = heading - M_PI / 2 + 2 * M_PI * i / (kCorners - 2) -
                                 (around_b ? 0 : 2 * M_PI / (kCorners - 2));
            const QPointF centre = around_b ? b : a;
            outline.push_back(centre + capsule.radius_m * QPointF(std::cos(angle), std::sin(angle)));
        }
        const std::vector<Share> flesh{{segmentIndex(capsule.segment), {1, 1, 1}}};
        for (size_t i = 2; i < outline.size(); ++i)
            faces_.push_back({{outline[0], outline[i - 1], outline[i]}, flesh});
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

std::shared_ptr<const BodyFigure> BodyFigure::of(const Actor& actor,
                                                 const std::shared_ptr<const SkinnedMesh>& mesh,
                                                 Stance stance) {
    struct Last {
        std::weak_ptr<const SkinnedMesh> mesh;
        std::vector<double> body;
        std::shared_ptr<const BodyFigure> figure;
    };
    static std::map<Stance, Last> of_stance;
    Last& last = of_stance[stance];
    std::vector<double> body;
    for (const Joint& joint : actor.skeleton.joints())
        body.insert(body.end(), joint.offset_m.begin(), joint.offset_m.end());
    if (stance == Stance::kRest)
        for (const Quaterniond& q : actor.rest_q_parent_joint)
            body.insert(body.end(), q.coeffs().begin(), q.coeffs().end());
    if (!mesh || !last.figure || last.mesh.lock() != mesh || last.body != body)
        last = {mesh, std::move(body), std::make_shared<const BodyFigure>(actor, mesh, stance)};
    return last.figure;
}

}  // namespace noctule::ui
