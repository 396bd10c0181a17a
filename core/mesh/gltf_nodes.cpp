// SPDX-License-Identifier: Apache-2.0
// Nodes, their animations and the humanoid table of VRM.
#include <algorithm>
#include <cmath>
#include <set>

#include "core/body/bone_spelling.h"
#include "core/math/json.h"
#include "core/mesh/gltf_scene.h"

namespace noctule {
namespace {

Eigen::Affine3d gltfLocal(const nlohmann::json& node) {
    const auto numbersOf = [&](const char* member, size_t count) {
        std::vector<double> numbers;
        for (const nlohmann::json& value : gltfMember(node, member))
            numbers.push_back(json::number(value).value_or(std::nan("")));
        return numbers.size() == count ? numbers : std::vector<double>();
    };
    Eigen::Affine3d T = Eigen::Affine3d::Identity();
    if (const auto m = numbersOf("matrix", 16); !m.empty()) {
        T.matrix().topRows<3>() = Eigen::Map<const Eigen::Matrix4d>(m.data()).topRows<3>();
        return T;
    }
    const auto t = numbersOf("translation", 3), r = numbersOf("rotation", 4), s = numbersOf("scale", 3);
    if (!t.empty())
        T.translation() = Vector3d(t[0], t[1], t[2]);
    if (!r.empty()) {
        const Quaterniond q(r[3], r[0], r[1], r[2]);
        if (q.norm() > 1e-9)
            T.linear() = q.normalized().toRotationMatrix();
    }
    if (!s.empty())
        T.linear() = T.linear() * Vector3d(s[0], s[1], s[2]).asDiagonal();
    return T;
}

std::set<size_t> gltfJoints(const GltfDocument& document) {
    std::set<size_t> joints;
    for (size_t s = 0; s < document.count("skins"); ++s)
        for (const nlohmann::json& joint : gltfMember(document.item("skins", s), "joints"))
            if (joint.is_number_unsigned())
                joints.insert(joint.get<size_t>());
    return joints;
}

/// Bones first, so that they keep their names.
void nameNodes(const GltfDocument& document, GltfNodes& nodes) {
    const std::set<size_t> joints = gltfJoints(document);
    std::set<std::string> taken;
    for (const bool are_joints : {true, false})
        for (size_t n = 0; n < nodes.names.size(); ++n) {
            if (joints.contains(n) != are_joints)
                continue;
            std::string name = json::text(document.item("nodes", n), "name").value_or("");
            if (name.empty())
                name = "node_" + std::to_string(n);
            nodes.names[n] = name;
            for (int number = 2; !taken.insert(nodes.names[n]).second; ++number)
                nodes.names[n] = name + "_" + std::to_string(number);
        }
}

Status linkNodes(const GltfDocument& document, GltfNodes& nodes) {
    for (size_t n = 0; n < nodes.names.size(); ++n)
        for (const nlohmann::json& child : gltfMember(document.item("nodes", n), "children")) {
            if (!child.is_number_unsigned() || !nodes.has(child.get<size_t>()))
                return document.damaged("node " + std::to_string(n) + " has a child that does not exist");
            const auto c = child.get<size_t>();
            if (nodes.parents[c] >= 0)
                return document.damaged("node " + nodes.names[c] + " hangs on two others");
            nodes.parents[c] = static_cast<int>(n);
            nodes.children[n].push_back(static_cast<int>(c));
        }
    for (size_t n = nodes.names.size(); n-- > 0;)
        if (nodes.parents[n] < 0)
            nodes.order.push_back(static_cast<int>(n));
    std::reverse(nodes.order.begin(), nodes.order.end());
    for (size_t i = 0; i < nodes.order.size(); ++i)
        for (const int child : nodes.children[static_cast<size_t>(nodes.order[i])])
            nodes.order.push_back(child);
    if (nodes.order.size() != nodes.names.size())
        return document.damaged("its nodes hang on each other in a circle");
    return Done{};
}

/// The keys of one channel of an animation, at its times in seconds.
struct GltfKeys {
    std::vector<double> t_s;
    std::vector<std::vector<float>> values;
};

/// Stepped and cubic curves as straight pieces.
class GltfCurve {
public:
    GltfCurve(const GltfNumbers& times, const GltfNumbers& values, const std::string& interpolation)
        : times_(times),
          values_(values),
          cubic_(interpolation == "CUBICSPLINE"),
          stepped_(interpolation == "STEP") {}

    bool fits() const { return times_.count() > 0 && values_.count() == times_.count() * (cubic_ ? 3 : 1); }

    GltfKeys keys() const {
        constexpr int kPieces = 8;
        GltfKeys keys;
        for (size_t k = 0; k < times_.count(); ++k) {
            const double t = static_cast<double>(times_.values[k]);
            const double before = keys.t_s.empty() ? t - 1 : static_cast<double>(times_.values[k - 1]);
            if (!(t > before))
                continue;
            if (stepped_ && !keys.t_s.empty())
                add(keys, t - 1e-3 * (t - before), keys.values.back());
            for (int piece = 1; cubic_ && !keys.t_s.empty() && piece < kPieces; ++piece)
                add(keys, before + (t - before) * piece / kPieces,
                    hermite(k, static_cast<float>(piece) / kPieces));
            add(keys, t, value(k));
        }
        return keys;
    }

private:
    static void add(GltfKeys& keys, double t_s, std::vector<float> value) {
        keys.t_s.push_back(t_s);
        keys.values.push_back(std::move(value));
    }
    const float* part(size_t key, size_t which) const { return values_.at(cubic_ ? 3 * key + which : key); }
    std::vector<float> value(size_t key) const {
        const float* from = part(key, 1);
        return {from, from + values_.components};
    }
    /// Between the key before and this one.
    std::vector<float> hermite(size_t key, float f) const {
        const float step = times_.values[key] - times_.values[key - 1], f2 = f * f, f3 = f2 * f;
        const float *from = part(key - 1, 1), *out = part(key - 1, 2), *to = part(key, 1), *in = part(key, 0);
        std::vector<float> point;
        for (size_t c = 0; c < values_.components; ++c)
            point.push_back((2 * f3 - 3 * f2 + 1) * from[c] + step * (f3 - 2 * f2 + f) * out[c] +
                            (3 * f2 - 2 * f3) * to[c] + step * (f3 - f2) * in[c]);
        return point;
    }

    const GltfNumbers &times_, &values_;
    bool cubic_, stepped_;
};

aiQuaternion gltfQuaternion(const std::vector<float>& xyzw) {
    return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]};
}

class GltfClips {
public:
    GltfClips(const GltfDocument& document, const GltfNodes& nodes) : document_(document), nodes_(nodes) {}

    Result<std::unique_ptr<aiAnimation>> clip(const nlohmann::json& told) {
        std::map<size_t, std::map<std::string, GltfKeys>> curves;
        for (const nlohmann::json& channel : gltfMember(told, "channels")) {
            const nlohmann::json& target = gltfMember(channel, "target");
            const auto node = gltfIndex(target, "node");
            const auto path = json::text(target, "path");
            const size_t components = path == "rotation"                         ? 4
                                      : path == "translation" || path == "scale" ? 3
                                                                                 : 0;
            if (!node || !nodes_.has(*node) || components == 0)
                continue;
            auto keys = keysOf(gltfMember(told, "samplers"), gltfIndex(channel, "sampler"), components);
            if (!keys)
                return keys.error();
            curves[*node][*path] = std::move(*keys);
        }
        auto animation = std::make_unique<aiAnimation>();
        animation->mName = json::text(told, "name").value_or("");
        animation->mTicksPerSecond = 1;
        animation->mNumChannels = static_cast<unsigned>(curves.size());
        animation->mChannels = new aiNodeAnim*[curves.size()];
        unsigned c = 0;
        for (const auto& [node, of_node] : curves)
            animation->mChannels[c++] = channelOf(node, of_node).release();
        return animation;
    }

private:
    Result<GltfKeys> keysOf(const nlohmann::json& samplers, std::optional<size_t> index, size_t components) {
        const auto wrong = [&] { return document_.damaged("an animation of it holds no usable keys"); };
        if (!index || !samplers.is_array() || *index >= samplers.size())
            return wrong();
        const nlohmann::json& sampler = samplers[*index];
        const auto input = gltfIndex(sampler, "input"), output = gltfIndex(sampler, "output");
        if (!input || !output)
            return wrong();
        const auto times = document_.numbers(*input, 1);
        if (!times)
            return times.error();
        const auto values = document_.numbers(*output, components);
        if (!values)
            return values.error();
        const GltfCurve curve(*times, *values, json::text(sampler, "interpolation").value_or("LINEAR"));
        return curve.fits() ? Result<GltfKeys>(curve.keys()) : Result<GltfKeys>(wrong());
    }

    template <class Key, class Convert>
    static void fill(const std::map<std::string, GltfKeys>& curves, const char* path, const Key& still,
                     Key*& keys, unsigned& count, Convert convert) {
        const auto curve = curves.find(path);
        count = curve == curves.end() ? 1 : static_cast<unsigned>(curve->second.t_s.size());
        keys = new Key[count];
        keys[0] = still;
        for (unsigned k = 0; curve != curves.end() && k < count; ++k)
            keys[k] = Key(curve->second.t_s[k], convert(curve->second.values[k]));
    }

    /// What no curve moves stays as the node has it.
    std::unique_ptr<aiNodeAnim> channelOf(size_t node, const std::map<std::string, GltfKeys>& curves) {
        aiVector3D scale, place;
        aiQuaternion turn;
        gltfMatrix(nodes_.T_parent_node[node]).Decompose(scale, turn, place);
        const auto vector = [](const std::vector<float>& v) { return gltfVector(v.data()); };
        auto channel = std::make_unique<aiNodeAnim>();
        channel->mNodeName = nodes_.names[node];
        fill(curves, "translation", aiVectorKey(0, place), channel->mPositionKeys, channel->mNumPositionKeys,
             vector);
        fill(curves, "rotation", aiQuatKey(0, turn), channel->mRotationKeys, channel->mNumRotationKeys,
             gltfQuaternion);
        fill(curves, "scale", aiVectorKey(0, scale), channel->mScalingKeys, channel->mNumScalingKeys, vector);
        return channel;
    }

    const GltfDocument& document_;
    const GltfNodes& nodes_;
};

/// VRM's names of our joints. Of two the later one wins: the upper chest carries the arms.
constexpr struct {
    const char* vrm;
    JointRole role;
} kVrmRoles[] = {
    {"hips", JointRole::kHips},         {"spine", JointRole::kSpine},    {"chest", JointRole::kChest},
    {"upperChest", JointRole::kChest},  {"neck", JointRole::kNeck},      {"head", JointRole::kHead},
    {"Shoulder", JointRole::kShoulder}, {"UpperArm", JointRole::kArm},   {"LowerArm", JointRole::kForeArm},
    {"Hand", JointRole::kHand},         {"UpperLeg", JointRole::kUpLeg}, {"LowerLeg", JointRole::kLeg},
    {"Foot", JointRole::kFoot},         {"Toes", JointRole::kToeBase}};

/// VRM's bone -> node, of either version.
std::map<std::string, size_t> vrmBones(const nlohmann::json& extensions) {
    std::map<std::string, size_t> bones;
    const auto bonesOf = [&](const char* extension) -> const nlohmann::json& {
        return gltfMember(gltfMember(gltfMember(extensions, extension), "humanoid"), "humanBones");
    };
    if (const nlohmann::json& one = bonesOf("VRMC_vrm"); one.is_object())
        for (const auto& [bone, told] : one.items())
            if (const auto node = gltfIndex(told, "node"))
                bones[bone] = *node;
    for (const nlohmann::json& told : bonesOf("VRM"))
        if (const auto node = gltfIndex(told, "node"))
            if (const auto bone = json::text(told, "bone"))
                bones.try_emplace(*bone, *node);
    return bones;
}

}  // namespace

Result<GltfNodes> gltfNodes(const GltfDocument& document) {
    const size_t count = document.count("nodes");
    if (count > MeshLimits::kNodes)
        return document.damaged("it has more than " + std::to_string(MeshLimits::kNodes) + " nodes");
    GltfNodes nodes;
    nodes.names.resize(count);
    nodes.parents.assign(count, -1);
    nodes.children.resize(count);
    nameNodes(document, nodes);
    if (const Status linked = linkNodes(document, nodes); !linked)
        return linked.error();
    for (size_t n = 0; n < count; ++n)
        nodes.T_parent_node.push_back(gltfLocal(document.item("nodes", n)));
    nodes.T_file_node = nodes.T_parent_node;
    for (const int node : nodes.order)
        if (const int parent = nodes.parents[static_cast<size_t>(node)]; parent >= 0)
            nodes.T_file_node[static_cast<size_t>(node)] = nodes.T_file_node[static_cast<size_t>(parent)] *
                                                           nodes.T_parent_node[static_cast<size_t>(node)];
    return nodes;
}

Status addGltfClips(const GltfDocument& document, const GltfNodes& nodes, aiScene& scene) {
    const size_t count = std::min(document.count("animations"), MeshLimits::kClips);
    GltfClips clips(document, nodes);
    scene.mAnimations = count ? new aiAnimation*[count]() : nullptr;
    for (size_t a = 0; a < count; ++a) {
        auto clip = clips.clip(document.item("animations", a));
        if (!clip)
            return clip.error();
        scene.mAnimations[scene.mNumAnimations++] = clip->release();
    }
    return Done{};
}

std::map<std::string, std::string> gltfHumanoid(const GltfDocument& document, const GltfNodes& nodes) {
    const std::map<std::string, size_t> bones = vrmBones(gltfMember(document.json(), "extensions"));
    std::map<std::string, std::string> joints;
    const auto take = [&](const std::string& bone, JointRole role, BodySide side) {
        if (const auto found = bones.find(bone); found != bones.end() && nodes.has(found->second))
            joints[canonicalJoint(role, side)] = nodes.names[found->second];
    };
    for (const auto& [vrm, role] : kVrmRoles) {
        if (role < JointRole::kShoulder) {
            take(vrm, role, BodySide::kMiddle);
            continue;
        }
        take("left" + std::string(vrm), role, BodySide::kLeft);
        take("right" + std::string(vrm), role, BodySide::kRight);
    }
    return joints;
}

}  // namespace noctule
