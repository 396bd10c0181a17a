// SPDX-License-Identifier: Apache-2.0
// Animations of a glTF document.
#include <algorithm>

#include "core/math/json.h"
#include "core/mesh/import/gltf_scene.h"

namespace noctule {
namespace {

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

}  // namespace

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

}  // namespace noctule
