// SPDX-License-Identifier: Apache-2.0
// Nodes and animations.
#include <algorithm>
#include <cmath>

#include "core/mesh/import/scene_import.h"

namespace noctule {
namespace {

/// The value of a curve at a time; `between` blends two neighbours.
template <class Key, class Between>
auto curveAt(const Key* keys, unsigned count, double time, Between between) {
    const Key* after =
        std::upper_bound(keys, keys + count, time, [](double t, const Key& key) { return t < key.mTime; });
    if (after == keys)
        return toEigen(keys[0].mValue);
    if (after == keys + count)
        return toEigen(keys[count - 1].mValue);
    const Key& before = *(after - 1);
    return between(toEigen(before.mValue), toEigen(after->mValue),
                   (time - before.mTime) / (after->mTime - before.mTime));
}

Vector3d straight(const Vector3d& a, const Vector3d& b, double f) {
    return (1 - f) * a + f * b;
}

template <class Key>
void addTimes(const Key* keys, unsigned count, std::vector<double>& times) {
    for (unsigned k = 0; k < count; ++k)
        if (std::isfinite(keys[k].mTime))
            times.push_back(keys[k].mTime);
}

std::vector<double> timesOf(const aiNodeAnim& channel) {
    std::vector<double> times;
    addTimes(channel.mPositionKeys, channel.mNumPositionKeys, times);
    addTimes(channel.mRotationKeys, channel.mNumRotationKeys, times);
    addTimes(channel.mScalingKeys, channel.mNumScalingKeys, times);
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

RigTrack trackOf(const SceneImport& import, const aiNodeAnim& channel, int node, double ticks_per_s) {
    RigTrack track;
    track.node = node;
    const bool is_root = import.mesh.nodes[static_cast<size_t>(node)].parent < 0;
    const Quaterniond turn(is_root ? import.change.turn : Matrix3d(Matrix3d::Identity()));
    for (const double time : timesOf(channel)) {
        const Vector3d p = curveAt(channel.mPositionKeys, channel.mNumPositionKeys, time, straight);
        const Quaterniond q =
            curveAt(channel.mRotationKeys, channel.mNumRotationKeys, time,
                    [](const Quaterniond& a, const Quaterniond& b, double f) { return a.slerp(f, b); });
        track.t_s.push_back(time / ticks_per_s);
        track.p_m.push_back(import.change.scale * (turn * p));
        track.q_parent_node.push_back(turn * q);
        track.scale.push_back(curveAt(channel.mScalingKeys, channel.mNumScalingKeys, time, straight));
    }
    return track;
}

Status addClip(SceneImport& import, const aiAnimation& animation, size_t& keys) {
    const double ticks_per_s = animation.mTicksPerSecond > 0 ? animation.mTicksPerSecond : 25;
    RigClip clip{animation.mName.C_Str(), 0, {}};
    for (unsigned c = 0; c < animation.mNumChannels; ++c) {
        const aiNodeAnim& channel = *animation.mChannels[c];
        const auto node = import.node_of_name.find(channel.mNodeName.C_Str());
        if (node == import.node_of_name.end() || !channel.mNumPositionKeys || !channel.mNumRotationKeys ||
            !channel.mNumScalingKeys)
            continue;
        keys += channel.mNumPositionKeys + channel.mNumRotationKeys + channel.mNumScalingKeys;
        if (keys > 3 * MeshLimits::kKeys)
            return Error{ErrorKind::kUnusable, import.path + ": its animations hold too many keys",
                         "Export the body without its animations"};
        RigTrack track = trackOf(import, channel, node->second, ticks_per_s);
        if (!track.t_s.empty()) {
            clip.duration_s = std::max(clip.duration_s, track.t_s.back());
            clip.tracks.push_back(std::move(track));
        }
    }
    import.mesh.clips.push_back(std::move(clip));
    return Done{};
}

}  // namespace

Eigen::Affine3d toEigen(const aiMatrix4x4& m) {
    Eigen::Affine3d T = Eigen::Affine3d::Identity();
    T.matrix().row(0) << m.a1, m.a2, m.a3, m.a4;
    T.matrix().row(1) << m.b1, m.b2, m.b3, m.b4;
    T.matrix().row(2) << m.c1, m.c2, m.c3, m.c4;
    return T;
}

void importNodes(SceneImport& import) {
    struct Visit {
        const aiNode* node;
        int parent;
    };
    std::vector<Visit> open{{import.scene.mRootNode, -1}};
    while (!open.empty()) {
        const auto [node, parent] = open.back();
        open.pop_back();
        const Eigen::Affine3d T_local = toEigen(node->mTransformation);
        RigNode made{node->mName.C_Str(), parent, T_local};
        made.T_parent_node.translation() *= import.change.scale;
        if (parent < 0)
            made.T_parent_node = Eigen::Affine3d(import.change.turn) * made.T_parent_node;
        const int index = static_cast<int>(import.mesh.nodes.size());
        import.node_of_name.try_emplace(made.name, index);
        import.mesh.nodes.push_back(std::move(made));
        import.ai_nodes.push_back(node);
        import.T_file_node.push_back(parent < 0 ? T_local
                                     : import.T_file_node[static_cast<size_t>(parent)] * T_local);
        for (unsigned c = node->mNumChildren; c-- > 0;)
            open.push_back({node->mChildren[c], index});
    }
}

Status importClips(SceneImport& import) {
    size_t keys = 0;
    for (unsigned a = 0; a < import.scene.mNumAnimations; ++a)
        if (const Status added = addClip(import, *import.scene.mAnimations[a], keys); !added)
            return added;
    return Done{};
}

}  // namespace noctule
