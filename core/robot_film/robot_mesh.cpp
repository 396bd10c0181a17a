// SPDX-License-Identifier: Apache-2.0
#include "core/robot_film/robot_mesh.h"

#include <filesystem>
#include <numbers>

#include "core/mesh/import/mesh_reader.h"

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

uint16_t addBone(const std::string& link, SkinnedMesh& mesh) {
    mesh.bones.push_back({link, Eigen::Matrix4f::Identity()});
    return static_cast<uint16_t>(mesh.bones.size() - 1);
}

void addCapsules(const RobotModel& model, const RobotProfile& profile, size_t link, SkinnedMesh& mesh) {
    const auto shapes = shapesOf(model, link, profile.capsule_radius_m);
    if (shapes.empty())
        return;
    const uint16_t bone = addBone(model.links[link].name, mesh);
    for (const LinkShape& shape : shapes)
        addCapsule(shape, bone, mesh);
}

/// Where a file is that a URDF names; empty: nowhere.
std::filesystem::path foundFile(const std::string& named, const std::filesystem::path& urdf) {
    namespace fs = std::filesystem;
    constexpr std::string_view kPackage = "package://", kFile = "file://";
    std::error_code ignored;
    const auto there = [&](const fs::path& path) { return fs::is_regular_file(path, ignored); };
    const fs::path folder = fs::absolute(urdf, ignored).parent_path();
    if (!named.starts_with(kPackage)) {
        const fs::path path = folder / (named.starts_with(kFile) ? named.substr(kFile.size()) : named);
        return there(path) ? path : fs::path();
    }
    const fs::path whole = named.substr(kPackage.size());
    fs::path inside;
    for (auto part = std::next(whole.begin(), whole.empty() ? 0 : 1); part != whole.end(); ++part)
        inside /= *part;
    for (fs::path above = folder;; above = above.parent_path()) {
        for (const fs::path& path : {above / whole, above / inside})
            if (there(path))
                return path;
        if (above == above.parent_path())
            return {};
    }
}

/// Meshes of links, each file read once.
class LinkMeshes {
public:
    LinkMeshes(std::filesystem::path urdf, const JobContext& job) : urdf_(std::move(urdf)), job_(job) {}

    /// False: the link has none that can be shown.
    bool add(const RobotLink& link, SkinnedMesh& mesh) {
        bool is_shown = false;
        for (const LinkMesh& wanted : link.meshes) {
            const SkinnedMesh* part = read(wanted.file);
            if (!part || mesh.triangles.size() + part->triangles.size() > kMostTriangles)
                continue;
            if (!is_shown)
                addBone(link.name, mesh);
            is_shown = true;
            append(*part, wanted, mesh);
        }
        return is_shown;
    }
    std::vector<std::string> notices() const {
        std::vector<std::string> told = broken_;
        if (missing_ > 0)
            told.push_back(std::to_string(missing_) + " of " + std::to_string(parts_.size()) +
                           " meshes are not there; capsules stand for their links");
        return told;
    }

private:
    const SkinnedMesh* read(const std::string& file) {
        const auto [entry, is_new] = parts_.try_emplace(file);
        if (!is_new)
            return entry->second ? &*entry->second : nullptr;
        const std::filesystem::path path = foundFile(file, urdf_);
        if (path.empty()) {
            ++missing_;
            return nullptr;
        }
        MeshImportSettings settings;
        settings.keeps_axes = true;
        if (auto mesh = importMeshApart(path.string(), settings, job_))
            entry->second = std::move(mesh->skin);
        else
            broken_.push_back(mesh.error().message);
        return entry->second ? &*entry->second : nullptr;
    }

    static void append(const SkinnedMesh& part, const LinkMesh& wanted, SkinnedMesh& mesh) {
        const auto first = static_cast<uint32_t>(mesh.vertices.size());
        const auto bone = static_cast<uint16_t>(mesh.bones.size() - 1);
        const bool is_mirrored = wanted.scale.prod() < 0;
        for (SkinnedVertex vertex : part.vertices) {
            const Vector3d p = vertex.p_m.cast<double>(), n = vertex.normal.cast<double>();
            vertex.p_m = (wanted.T_link_mesh * wanted.scale.cwiseProduct(p)).cast<float>();
            vertex.normal =
                (wanted.T_link_mesh.linear() * n.cwiseQuotient(wanted.scale)).normalized().cast<float>();
            vertex.bones = {bone, 0, 0, 0};
            vertex.weights = {1, 0, 0, 0};
            mesh.vertices.push_back(vertex);
        }
        for (const auto& [a, b, c] : part.triangles)
            mesh.triangles.push_back(is_mirrored ? std::array{first + a, first + c, first + b}
                                                 : std::array{first + a, first + b, first + c});
    }

    static constexpr size_t kMostTriangles = 3'000'000;
    const std::filesystem::path urdf_;
    const JobContext& job_;
    std::map<std::string, std::optional<SkinnedMesh>> parts_;
    std::vector<std::string> broken_;
    size_t missing_ = 0;
};

}  // namespace

std::shared_ptr<const SkinnedMesh> meshOf(const RobotModel& model, const RobotProfile& profile) {
    auto mesh = std::make_shared<SkinnedMesh>();
    for (size_t link = 0; link < model.links.size(); ++link)
        addCapsules(model, profile, link, *mesh);
    return mesh;
}

RobotLook lookOf(const RobotModel& model, const RobotProfile& profile, const std::string& urdf_path,
                 const JobContext& job) {
    auto mesh = std::make_shared<SkinnedMesh>();
    LinkMeshes files(urdf_path, job);
    for (size_t link = 0; link < model.links.size(); ++link) {
        job.progress(static_cast<double>(link) / static_cast<double>(model.links.size()),
                     "Reading meshes of the robot");
        if (!files.add(model.links[link], *mesh))
            addCapsules(model, profile, link, *mesh);
    }
    return {std::move(mesh), files.notices()};
}

Eigen::Isometry3d standingRoot(const RobotModel& model, const RobotProfile& profile, double lift_m) {
    Vector3d forward = Vector3d::UnitX();  // of the root; REP 103
    if (!profile.arms.empty()) {
        const ArmProfile& arm = profile.arms.front();
        forward = placeAtZero(model, 0, model.findLink(arm.base)).linear() * arm.R_base_body.col(2);
        forward.z() = 0;
    }
    if (forward.norm() < 0.1)
        forward = Vector3d::UnitX();
    forward.normalize();
    Eigen::Isometry3d root = Eigen::Isometry3d::Identity();
    root.linear().row(0) = Vector3d::UnitZ().cross(forward).transpose();
    root.linear().row(1) = Vector3d::UnitZ().transpose();
    root.linear().row(2) = forward.transpose();
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
