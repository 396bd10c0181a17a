// SPDX-License-Identifier: Apache-2.0
// A person of blocks as glTF, in the many ways in which programs write the same body. Blocks: one around each
// joint, with three different sides, so that a turned or exchanged one is seen.
#pragma once

#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>

#include "tests/support/named_rig.h"

namespace noctule::test {

/// How a body is written; the world that it describes is always the same person in a T pose.
struct GlbDialect {
    std::function<std::string(const std::string&)> name = [](const std::string& joint) { return joint; };
    Eigen::Affine3d T_armature = Eigen::Affine3d::Identity();   ///< node above the hips
    Eigen::Affine3d T_mesh = Eigen::Affine3d::Identity();       ///< node that shows the mesh: must not count
    Eigen::Affine3d T_file_skin = Eigen::Affine3d::Identity();  ///< space in which the skin is bound
    bool mesh_below_armature = false;
    std::map<std::string, Quaterniond> turned;  ///< how nodes stand turned in the file; the bind stays
    double size = 1;
};

class GlbBody {
public:
    explicit GlbBody(const GlbDialect& dialect = {}) {
        json["asset"] = {{"version", "2.0"}};
        json["scene"] = 0;
        json["scenes"] = {{{"nodes", nlohmann::json::array()}}};
        for (const char* list : {"nodes", "meshes", "skins", "accessors", "bufferViews"})
            json[list] = nlohmann::json::array();
        add(dialect);
    }

    /// One more person, with a mesh, skin and armature of its own.
    void add(const GlbDialect& dialect) {
        const RiggedMesh rig =
            namedRig([](const std::string& joint) { return joint; },
                     [](const std::string&) { return Quaterniond::Identity(); }, dialect.size);
        const size_t armature = addNode("Armature", dialect.T_armature);
        json["scenes"][0]["nodes"].push_back(armature);
        std::vector<size_t> joints;
        std::vector<float> matrices;
        for (size_t n = 1; n < rig.nodes.size(); ++n) {
            const RigNode& node = rig.nodes[n];
            const bool is_top = node.parent <= 0;
            const Eigen::Affine3d T_above =
                is_top ? dialect.T_armature : worldOf(rig, static_cast<size_t>(node.parent), dialect);
            Eigen::Affine3d T_local = T_above.inverse() * worldOf(rig, n, dialect);
            const Eigen::Matrix4d inverse_bind =
                worldOf(rig, n, dialect).inverse().matrix() * dialect.T_file_skin.matrix();
            for (Eigen::Index i = 0; i < 16; ++i)
                matrices.push_back(static_cast<float>(inverse_bind.data()[i]));
            if (const auto turn = dialect.turned.find(node.name); turn != dialect.turned.end())
                T_local = T_local * turn->second;
            joints.push_back(addNode(dialect.name(node.name), T_local));
            json["nodes"][is_top ? armature : joints[static_cast<size_t>(node.parent) - 1]]["children"]
                .push_back(joints.back());
        }
        const size_t mesh = addMesh(rig, dialect);
        json["skins"].push_back({{"joints", joints}, {"inverseBindMatrices", accessor(matrices, "MAT4")}});
        const size_t shown = addNode("Body", dialect.T_mesh);
        json["nodes"][shown]["mesh"] = mesh;
        json["nodes"][shown]["skin"] = json["skins"].size() - 1;
        if (dialect.mesh_below_armature)
            json["nodes"][armature]["children"].push_back(shown);
        else
            json["scenes"][0]["nodes"].push_back(shown);
    }

    template <class Number>
    size_t accessor(const std::vector<Number>& values, const std::string& type, bool normalized = false) {
        const std::map<std::string, size_t> components = {
            {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
        json["accessors"].push_back({{"bufferView", view(values)},
                                     {"componentType", codeOf(Number())},
                                     {"count", values.size() / components.at(type)},
                                     {"type", type},
                                     {"normalized", normalized}});
        return json["accessors"].size() - 1;
    }

    template <class Number>
    size_t view(const std::vector<Number>& values) {
        binary.append((4 - binary.size() % 4) % 4, '\0');
        const size_t bytes = values.size() * sizeof(Number), offset = binary.size();
        binary.append(reinterpret_cast<const char*>(values.data()), bytes);
        json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes}});
        return json["bufferViews"].size() - 1;
    }

    nlohmann::json& node(const std::string& name) {
        for (nlohmann::json& node : json["nodes"])
            if (node["name"] == name)
                return node;
        throw std::runtime_error("no node " + name);
    }
    nlohmann::json& primitive() { return json["meshes"][0]["primitives"][0]; }

    std::string glb() const {
        nlohmann::json told = json;
        std::string data = binary;
        data.append((4 - data.size() % 4) % 4, '\0');
        told["buffers"] = {{{"byteLength", data.size()}}};
        std::string text = told.dump();
        text.append((4 - text.size() % 4) % 4, ' ');
        std::string bytes = "glTF";
        for (const size_t word : {size_t{2}, 28 + text.size() + data.size(), text.size()})
            putWord(bytes, word);
        bytes += "JSON" + text;
        putWord(bytes, data.size());
        return bytes + std::string("BIN\0", 4) + data;
    }

    /// With its data in a file of the name `uri`, or within it.
    std::string gltf(const std::string& uri) const {
        nlohmann::json told = json;
        told["buffers"] = {{{"byteLength", binary.size()}, {"uri", uri}}};
        return told.dump();
    }

    nlohmann::json json;
    std::string binary;

private:
    /// Of a joint where it is bound; its frame has the armature's turn and scale.
    static Eigen::Affine3d worldOf(const RiggedMesh& rig, size_t node, const GlbDialect& dialect) {
        Eigen::Affine3d T = rig.nodes[node].T_world_rest;
        T.linear() = dialect.T_armature.linear();
        return T;
    }

    size_t addNode(const std::string& name, const Eigen::Affine3d& T) {
        const Eigen::Matrix4d m = T.matrix();
        json["nodes"].push_back({{"name", name}, {"matrix", std::vector<double>(m.data(), m.data() + 16)}});
        return json["nodes"].size() - 1;
    }

    size_t addMesh(const RiggedMesh& rig, const GlbDialect& dialect) {
        std::vector<float> points, weights;
        std::vector<uint8_t> joints;
        std::vector<uint16_t> corners;
        for (size_t n = 1; n < rig.nodes.size(); ++n) {
            const auto first = static_cast<uint16_t>(points.size() / 3);
            for (int corner = 0; corner < 8; ++corner) {
                const Vector3d off(corner & 1 ? 0.05 : -0.02, corner & 2 ? 0.07 : -0.03,
                                   corner & 4 ? 0.09 : -0.04);
                const Vector3d p = dialect.T_file_skin.inverse() *
                                   Vector3d(rig.nodes[n].T_world_rest.translation() + dialect.size * off);
                for (int axis = 0; axis < 3; ++axis)
                    points.push_back(static_cast<float>(p[axis]));
                const auto joint = static_cast<uint8_t>(n - 1);
                joints.insert(joints.end(), {joint, 0, 0, 0});
                weights.insert(weights.end(), {1, 0, 0, 0});
            }
            constexpr uint16_t kBlock[] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                           2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
            for (const uint16_t corner : kBlock)
                corners.push_back(static_cast<uint16_t>(first + corner));
        }
        json["meshes"].push_back({{"name", "blocks"},
                                  {"primitives",
                                   {{{"attributes",
                                      {{"POSITION", accessor(points, "VEC3")},
                                       {"JOINTS_0", accessor(joints, "VEC4")},
                                       {"WEIGHTS_0", accessor(weights, "VEC4")}}},
                                     {"indices", accessor(corners, "SCALAR")}}}}});
        return json["meshes"].size() - 1;
    }

    static int codeOf(float) { return 5126; }
    static int codeOf(uint32_t) { return 5125; }
    static int codeOf(uint16_t) { return 5123; }
    static int codeOf(uint8_t) { return 5121; }
    static void putWord(std::string& bytes, size_t word) {
        const auto value = static_cast<uint32_t>(word);
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
};

}  // namespace noctule::test
