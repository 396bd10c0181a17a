// SPDX-License-Identifier: Apache-2.0
#include "core/robot_film/robot_mesh.h"

#include <numbers>

namespace noctule::robot {
namespace {

constexpr int kAround = 20, kRings = 5;  ///< of each half ball

/// A capsule in the frame of its link; triangles are counter-clockwise seen from outside.
void addCapsule(const LinkShape& shape, uint16_t bone, SkinnedMesh& mesh) {
    const Vector3d way = shape.b_m - shape.a_m;
    const Vector3d up = way.norm() > 1e-9 ? Vector3d(way.normalized()) : Vector3d::UnitZ();
    const Vector3d side = up.unitOrthogonal(), front = up.cross(side);
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    const int rows = 2 * (kRings + 1);
    for (int row = 0; row < rows; ++row) {
        const bool is_upper = row > kRings;
        const double share = static_cast<double>(is_upper ? row - 1 : row) / (2 * kRings);
        const double tilt = std::numbers::pi * (share - 0.5);
        for (int i = 0; i < kAround; ++i) {
            const double turn = 2 * std::numbers::pi * i / kAround;
            const Vector3d normal =
                std::sin(tilt) * up + std::cos(tilt) * (std::cos(turn) * side + std::sin(turn) * front);
            SkinnedVertex vertex;
            vertex.p_m = ((is_upper ? shape.b_m : shape.a_m) + shape.radius_m * normal).cast<float>();
            vertex.normal = normal.cast<float>();
            vertex.bones[0] = bone;
            vertex.weights[0] = 1;
            mesh.vertices.push_back(vertex);
        }
    }
    for (int row = 0; row + 1 < rows; ++row)
        for (int i = 0; i < kAround; ++i) {
            const auto at = [&](int r, int k) {
                return first + static_cast<uint32_t>(r * kAround + k % kAround);
            };
            mesh.triangles.push_back({at(row, i), at(row, i + 1), at(row + 1, i + 1)});
            mesh.triangles.push_back({at(row, i), at(row + 1, i + 1), at(row + 1, i)});
        }
}

}  // namespace

Matrix3d worldOfRobot() {
    Matrix3d R;
    R << 0, 1, 0, 0, 0, 1, 1, 0, 0;
    return R;
}

std::shared_ptr<const SkinnedMesh> meshOf(const RobotModel& model, const RobotProfile& profile) {
    auto mesh = std::make_shared<SkinnedMesh>();
    for (size_t link = 0; link < model.links.size(); ++link) {
        const auto shapes = shapesOf(model, link, profile.capsule_radius_m);
        if (shapes.empty())
            continue;
        const auto bone = static_cast<uint16_t>(mesh->bones.size());
        mesh->bones.push_back({model.links[link].name, Eigen::Matrix4f::Identity()});
        for (const LinkShape& shape : shapes)
            addCapsule(shape, bone, *mesh);
    }
    return mesh;
}

Eigen::Isometry3d standingRoot(double lift_m) {
    Eigen::Isometry3d root = Eigen::Isometry3d::Identity();
    root.linear() = worldOfRobot();
    root.translation().y() = lift_m;
    return root;
}

std::vector<Eigen::Matrix4f> skinOf(const RobotModel& model, const SkinnedMesh& mesh,
                                    const JointValues& values, const Eigen::Isometry3d& T_world_root) {
    const auto places = linkPlaces(model, values);
    std::vector<Eigen::Matrix4f> skin;
    for (const SkinBone& bone : mesh.bones)
        skin.push_back(
            (T_world_root * places[static_cast<size_t>(model.findLink(bone.joint))]).matrix().cast<float>());
    return skin;
}

Eigen::AlignedBox3d boxOf(const RobotModel& model, const RobotProfile& profile, const JointValues& values,
                          const Eigen::Isometry3d& T_world_root) {
    const auto places = linkPlaces(model, values);
    Eigen::AlignedBox3d box;
    for (size_t link = 0; link < model.links.size(); ++link)
        for (const LinkShape& shape : shapesOf(model, link, profile.capsule_radius_m))
            for (const Vector3d& end : {shape.a_m, shape.b_m}) {
                const Vector3d p = T_world_root * (places[link] * end);
                box.extend(Vector3d(p.array() - shape.radius_m));
                box.extend(Vector3d(p.array() + shape.radius_m));
            }
    return box;
}

}  // namespace noctule::robot
