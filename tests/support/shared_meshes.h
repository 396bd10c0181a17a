// SPDX-License-Identifier: Apache-2.0
// Meshes that other programs made. They lie beside the repository (../shared/data) and are not part of it:
// tests that need them skip, with a word, when they are missing.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "core/mesh/import/mesh_import.h"

namespace noctule::test {

inline std::string sharedPath(const std::string& name) {
    return NOCTULE_SOURCE_DIR "/../shared/data/" + name;
}

inline const std::string kKenney = "fbx/maya_kenney_character_7700_binary.fbx";
inline const std::string kCesiumMan = "mesh/gltf/CesiumMan.glb";
inline const std::string kMakeHuman = "mesh/makehuman/";

inline bool isShared(const std::string& name) {
    return std::filesystem::exists(sharedPath(name));
}

inline std::string sayMissing(const std::string& name) {
    return sharedPath(name) + " is missing";
}

/// Fails the test when it cannot be read.
inline RiggedMesh sharedMesh(const std::string& name) {
    auto mesh = importMesh(sharedPath(name));
    EXPECT_TRUE(mesh) << mesh.error().text();
    return mesh ? std::move(*mesh) : RiggedMesh();
}

/// The "v" lines of an OBJ file, in its unit.
inline std::vector<Vector3d> objPoints(const std::string& path) {
    std::vector<Vector3d> points;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("v ")) {
            std::istringstream numbers(line.substr(2));
            Vector3d p;
            numbers >> p.x() >> p.y() >> p.z();
            points.push_back(p);
        }
    return points;
}

/// The skin of MakeHuman's base mesh, standing on the ground, without its helpers.
inline RiggedMesh makeHumanSkin() {
    RiggedMesh all = sharedMesh(kMakeHuman + "base.obj");
    std::vector<bool> keep;
    for (const MeshPart& part : all.parts)
        keep.push_back(part.name == "body");
    RiggedMesh body = withParts(all, keep);
    float ground = 1e9F;
    for (const SkinnedVertex& vertex : body.skin.vertices)
        ground = std::min(ground, vertex.p_m.y());
    for (SkinnedVertex& vertex : body.skin.vertices)
        vertex.p_m.y() -= ground;
    body.nodes.resize(1);
    return body;
}

/// makeHumanSkin() on MakeHuman's own rig: joints are the means of vertices, weights are those of its file.
class MakeHuman {
public:
    MakeHuman() : mesh_(makeHumanSkin()) {
        std::ifstream(sharedPath(kMakeHuman + "default.mhskel")) >> rig_;
        std::ifstream(sharedPath(kMakeHuman + "default_weights.mhw")) >> weights_;
        points_dm_ = objPoints(sharedPath(kMakeHuman + "base.obj"));
        findGround();
        mesh_.nodes.clear();
        for (const auto& [name, bone] : rig_["bones"].items())
            add(name);
        giveWeights();
    }
    const RiggedMesh& mesh() const { return mesh_; }

private:
    static constexpr double kUnit_m = 0.1;

    /// How far the skin was lifted: the vertex of least height is the same in both.
    void findGround() {
        std::vector<bool> used(points_dm_.size(), false);
        std::ifstream file(sharedPath(kMakeHuman + "base.obj"));
        bool body = false;
        for (std::string line; std::getline(file, line);) {
            if (line.starts_with("g "))
                body = line == "g body";
            if (!body || !line.starts_with("f "))
                continue;
            std::istringstream corners(line.substr(2));
            for (std::string corner; corners >> corner;)
                used[std::stoul(corner) - 1] = true;
        }
        ground_m_ = 1e9;
        for (size_t v = 0; v < points_dm_.size(); ++v)
            if (used[v])
                ground_m_ = std::min(ground_m_, kUnit_m * points_dm_[v].y());
    }

    Vector3d place(size_t v) const { return kUnit_m * points_dm_[v] - ground_m_ * Vector3d::UnitY(); }

    Vector3d joint(const std::string& name) const {
        Vector3d sum = Vector3d::Zero();
        const auto& vertices = rig_["joints"][name];
        for (const auto& v : vertices)
            sum += place(v.get<size_t>());
        return sum / static_cast<double>(vertices.size());
    }

    int add(const std::string& name) {
        if (const int known = mesh_.find(name); known >= 0)
            return known;
        const auto& bone = rig_["bones"][name];
        const int parent = bone["parent"].is_null() ? -1 : add(bone["parent"].get<std::string>());
        RigNode node{name, parent};
        node.T_world_rest.translation() = joint(bone["head"].get<std::string>());
        node.T_parent_node =
            parent < 0 ? node.T_world_rest
                       : mesh_.nodes[static_cast<size_t>(parent)].T_world_rest.inverse() * node.T_world_rest;
        mesh_.nodes.push_back(node);
        return static_cast<int>(mesh_.nodes.size()) - 1;
    }

    void giveWeights() {
        std::vector<std::map<uint16_t, float>> weights(points_dm_.size());
        for (const auto& [name, list] : weights_["weights"].items()) {
            const int node = mesh_.find(name);
            Eigen::Affine3d bind = mesh_.nodes[static_cast<size_t>(node)].T_world_rest.inverse();
            mesh_.skin.bones.push_back({name, bind.matrix().cast<float>()});
            mesh_.node_of_bone.push_back(node);
            for (const auto& pair : list)
                weights[pair[0].get<size_t>()][static_cast<uint16_t>(mesh_.skin.bones.size() - 1)] +=
                    pair[1].get<float>();
        }
        std::map<std::tuple<int, int, int>, size_t> vertex_at;
        for (size_t v = 0; v < points_dm_.size(); ++v)
            vertex_at.try_emplace(cell(place(v)), v);
        for (SkinnedVertex& vertex : mesh_.skin.vertices)
            give(vertex, weights[vertex_at.at(cell(vertex.p_m.cast<double>()))]);
    }

    static std::tuple<int, int, int> cell(const Vector3d& p_m) {
        const auto rounded = [](double x) { return static_cast<int>(std::lround(x * 2e4)); };
        return {rounded(p_m.x()), rounded(p_m.y()), rounded(p_m.z())};
    }

    static void give(SkinnedVertex& vertex, const std::map<uint16_t, float>& weights) {
        std::vector<std::pair<float, uint16_t>> heaviest;
        for (const auto& [bone, weight] : weights)
            heaviest.emplace_back(weight, bone);
        std::sort(heaviest.rbegin(), heaviest.rend());
        heaviest.resize(std::min<size_t>(4, heaviest.size()));
        float sum = 0;
        for (const auto& [weight, bone] : heaviest)
            sum += weight;
        for (size_t i = 0; i < heaviest.size(); ++i) {
            vertex.bones[i] = heaviest[i].second;
            vertex.weights[i] = heaviest[i].first / sum;
        }
    }

    RiggedMesh mesh_;
    nlohmann::json rig_, weights_;
    std::vector<Vector3d> points_dm_;
    double ground_m_ = 0;
};

}  // namespace noctule::test
