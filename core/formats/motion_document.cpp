// SPDX-License-Identifier: Apache-2.0
#include "core/formats/motion_document.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "core/job/limits.h"
#include "core/math/rotation.h"
#include "core/math/rotation_fit.h"
#include "core/mesh/import/mesh_reader.h"

namespace noctule {
namespace {

constexpr double kSlowest_hz = 10, kFastest_hz = 240, kUsual_hz = 30;
constexpr double kWholeRate = 0.002;  ///< keys at 29.97 Hz are frames at 30 Hz, read between keys
constexpr size_t kMostValues = 200'000'000;

std::string endingOf(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
    return ending;
}

/// Tracks whose values change.
size_t movingTracks(const RigClip& clip) {
    return static_cast<size_t>(std::ranges::count_if(clip.tracks, [](const RigTrack& track) {
        for (size_t k = 1; k < track.t_s.size(); ++k)
            if (track.q_parent_node[k].angularDistance(track.q_parent_node[0]) > 1e-4 ||
                (track.p_m[k] - track.p_m[0]).norm() > 1e-5)
                return true;
        return false;
    }));
}

/// The median step between keys of the track with most of them.
double rateOf(const RigClip& clip) {
    const auto most =
        std::ranges::max_element(clip.tracks, {}, [](const RigTrack& track) { return track.t_s.size(); });
    if (most == clip.tracks.end() || most->t_s.size() < 2)
        return kUsual_hz;
    std::vector<double> steps;
    for (size_t k = 1; k < most->t_s.size(); ++k)
        steps.push_back(most->t_s[k] - most->t_s[k - 1]);
    const auto middle = steps.begin() + std::ssize(steps) / 2;
    std::ranges::nth_element(steps, middle);
    const double rate_hz = *middle > 0 ? 1 / *middle : kUsual_hz;
    const double whole = std::round(rate_hz);
    const double kept = std::abs(rate_hz - whole) < kWholeRate * whole ? whole : rate_hz;
    return std::clamp(kept, kSlowest_hz, kFastest_hz);
}

/// Bones of the skin, moved nodes, and all above them, of the tree with most of them; parents first.
std::vector<int> skeletonNodes(const RiggedMesh& mesh, const RigClip& clip) {
    std::set<int> wanted(mesh.node_of_bone.begin(), mesh.node_of_bone.end());
    for (const RigTrack& track : clip.tracks)
        wanted.insert(track.node);
    std::map<int, size_t> bones_of_root;
    const auto parentOf = [&](int node) { return mesh.nodes[static_cast<size_t>(node)].parent; };
    const auto rootOf = [&](int node) {
        while (parentOf(node) >= 0)
            node = parentOf(node);
        return node;
    };
    for (const int node : wanted)
        ++bones_of_root[rootOf(node)];
    if (bones_of_root.empty())
        return {};
    const int root =
        std::ranges::max_element(bones_of_root, {}, [](const auto& entry) { return entry.second; })->first;
    std::set<int> nodes;
    for (int node : wanted)
        if (rootOf(node) == root)
            for (; node >= 0; node = parentOf(node))
                nodes.insert(node);
    // Nodes that stand above everything and do not move are no joints of the body.
    std::vector<int> skeleton(nodes.begin(), nodes.end());
    const auto isStill = [&](int node) { return !wanted.contains(node); };
    while (skeleton.size() > 1 && isStill(skeleton[0]) &&
           std::ranges::count_if(skeleton, [&](int node) { return parentOf(node) == skeleton[0]; }) == 1)
        skeleton.erase(skeleton.begin());
    return skeleton;
}

/// Without the scale that a node's transform may hold.
Quaterniond turnOf(const Eigen::Affine3d& T) {
    return Quaterniond(nearestRotation(T.linear())).normalized();
}

struct Skeletal {
    std::vector<int> nodes, parents;  ///< parents: places in `nodes`
};

void addFrame(const Skeletal& skeleton, const RigPose& pose, std::vector<Vector3d>& angles_rad,
              std::vector<double>& values) {
    for (size_t j = 0; j < skeleton.nodes.size(); ++j) {
        const Eigen::Affine3d& T = pose[static_cast<size_t>(skeleton.nodes[j])];
        Vector3d p = T.translation();
        Quaterniond q = turnOf(T);
        if (const int above = skeleton.parents[j]; above >= 0) {
            const Eigen::Affine3d& T_above =
                pose[static_cast<size_t>(skeleton.nodes[static_cast<size_t>(above)])];
            const Quaterniond q_above = turnOf(T_above);
            p = q_above.conjugate() * (p - T_above.translation());
            q = q_above.conjugate() * q;
        }
        angles_rad[j] = eulerFromRotation(kEulerZXY, q, angles_rad[j]);
        values.insert(values.end(), {p.x(), p.y(), p.z()});
        for (int i = 0; i < 3; ++i)
            values.push_back(degrees(angles_rad[j][i]));
    }
}

BvhDocument emptyDocument(const RiggedMesh& mesh, const Skeletal& skeleton, const std::string& where) {
    BvhDocument document;
    document.name = std::filesystem::path(where).stem().string();
    const RigPose rest = restPose(mesh);
    std::map<std::string, int> used;
    for (size_t j = 0; j < skeleton.nodes.size(); ++j) {
        const auto node = static_cast<size_t>(skeleton.nodes[j]);
        BvhJoint joint;
        joint.name = mesh.nodes[node].name.empty() ? "joint" + std::to_string(j) : mesh.nodes[node].name;
        if (const int again = used[joint.name]++; again > 0)
            joint.name += "_" + std::to_string(again + 1);
        joint.parent = skeleton.parents[j];
        if (joint.parent >= 0) {
            const auto& T_above =
                rest[static_cast<size_t>(skeleton.nodes[static_cast<size_t>(joint.parent)])];
            joint.offset = turnOf(T_above).conjugate() * (rest[node].translation() - T_above.translation());
        }
        joint.channels = {BvhChannel::kXposition, BvhChannel::kYposition, BvhChannel::kZposition,
                          BvhChannel::kZrotation, BvhChannel::kXrotation, BvhChannel::kYrotation};
        joint.first_channel = document.channel_count;
        document.channel_count += joint.channels.size();
        document.joints.push_back(std::move(joint));
    }
    return document;
}

}  // namespace

bool isMotionFileName(const std::string& path) {
    static const std::set<std::string> kEndings = {".bvh", ".fbx", ".glb", ".gltf", ".vrm", ".dae"};
    return kEndings.contains(endingOf(path));
}

Result<BvhDocument> sampledMotion(const RiggedMesh& mesh, const std::string& where) {
    const auto clip = std::ranges::max_element(
        mesh.clips, {}, [](const RigClip& c) { return std::pair(movingTracks(c), c.duration_s); });
    if (clip == mesh.clips.end() || movingTracks(*clip) == 0)
        return Error{ErrorKind::kUnusable, where + ": no animation moves its skeleton",
                     "Export the animation too (in Blender: Bake Animation), or choose another file"};
    Skeletal skeleton{skeletonNodes(mesh, *clip), {}};
    for (const int node : skeleton.nodes) {
        const auto above = std::ranges::find(skeleton.nodes, mesh.nodes[static_cast<size_t>(node)].parent);
        skeleton.parents.push_back(
            above == skeleton.nodes.end() ? -1 : static_cast<int>(above - skeleton.nodes.begin()));
    }
    BvhDocument document = emptyDocument(mesh, skeleton, where);
    const double rate_hz = rateOf(*clip);
    double begin_s = clip->duration_s;
    for (const RigTrack& track : clip->tracks)
        if (!track.t_s.empty())
            begin_s = std::min(begin_s, track.t_s.front());
    const double frames = std::floor((clip->duration_s - begin_s) * rate_hz + 1e-6) + 1;
    if (!(frames * static_cast<double>(document.channel_count) <= static_cast<double>(kMostValues)) ||
        clip->duration_s > static_cast<double>(limits::kLongestTake_s))
        return Error{ErrorKind::kUnusable, where + ": its animation is too long to be read",
                     "Cut it into parts"};
    document.frame_time_s = 1 / rate_hz;
    document.declared_frames = static_cast<size_t>(frames);
    document.values.reserve(document.declared_frames * document.channel_count);
    std::vector<Vector3d> angles_rad(skeleton.nodes.size(), Vector3d::Zero());
    for (size_t f = 0; f < document.declared_frames; ++f)
        addFrame(skeleton, posed(mesh, *clip, begin_s + static_cast<double>(f) / rate_hz), angles_rad,
                 document.values);
    if (mesh.clips.size() > 1)
        document.warnings.push_back(
            {0, "of its " + std::to_string(mesh.clips.size()) +
                    " animations the one that moves most bones is taken: " + clip->name});
    return document;
}

Result<BvhDocument> readMotionDocument(const std::string& path, const JobContext& job) {
    if (!isMotionFileName(path) || endingOf(path) == ".bvh")
        return readBvh(path, job.cancel);
    MeshImportSettings settings;
    settings.needs_surface = false;
    const auto mesh = importMeshApart(path, settings, job);
    if (!mesh)
        return mesh.error();
    return sampledMotion(*mesh, path);
}

}  // namespace noctule
