// SPDX-License-Identifier: Apache-2.0
// same_scene A B FRAMES_PER_SECOND STEP: how far two rigged and animated files (GLB, FBX) are apart in every
// STEPth frame of A's first motion, as JSON: skin_mm (nearest points, both ways), joint_mm and turn_deg (how
// a bone has turned since the first frame, in the world; programs differ in the axes of their bones). Bones
// go by name. For files that another program opened and wrote again.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "core/math/rotation.h"
#include "core/mesh/import/mesh_reader.h"
#include "core/mesh/skinning.h"

namespace {

using namespace noctule;

struct Scene {
    RiggedMesh mesh;
    double begin_s = 0;

    const RigClip& clip() const { return mesh.clips.front(); }
    RigPose at(double since_s) const { return posed(mesh, clip(), begin_s + since_s); }
    std::vector<Eigen::Vector3f> skinAt(const RigPose& pose) const {
        return skinned(mesh.skin, skinMatrices(mesh, pose)).points_m;
    }
};

std::optional<Scene> opened(const char* path) {
    auto mesh = importMesh(path);
    if (!mesh || mesh->clips.empty()) {
        std::fprintf(stderr, "same_scene: %s\n",
                     mesh ? "a file without a motion" : mesh.error().text().c_str());
        return std::nullopt;
    }
    Scene scene{std::move(*mesh), 1e9};
    for (const RigTrack& track : scene.clip().tracks)
        if (track.t_s.size() > 1)
            scene.begin_s = std::min(scene.begin_s, track.t_s.front());
    return scene;
}

/// Of every 17th point of one from the nearest of the other.
double gap_m(const std::vector<Eigen::Vector3f>& from, const std::vector<Eigen::Vector3f>& to) {
    constexpr size_t kEvery = 17;
    float worst = 0;
    for (size_t p = 0; p < from.size(); p += kEvery) {
        float nearest = 1e18F;
        for (const Eigen::Vector3f& q : to)
            nearest = std::min(nearest, (from[p] - q).squaredNorm());
        worst = std::max(worst, nearest);
    }
    return std::sqrt(static_cast<double>(worst));
}

Quaterniond turnOf(const Eigen::Affine3d& now, const Eigen::Affine3d& first) {
    return Quaterniond(Matrix3d(now.rotation() * first.rotation().transpose()));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) {
        std::fputs("usage: same_scene A B FRAMES_PER_SECOND STEP\n", stderr);
        return 2;
    }
    const auto a = opened(argv[1]), b = opened(argv[2]);
    const double frames_per_second = std::atof(argv[3]);
    const int step = std::atoi(argv[4]);
    if (!a || !b || !(frames_per_second > 0) || step < 1)
        return 1;
    double skin_m = 0, joint_m = 0, turn_rad = 0;
    int frames = 0, bones = 0;
    const RigPose first_a = a->at(0), first_b = b->at(0);
    for (int f = 0; f <= (a->clip().duration_s - a->begin_s) * frames_per_second + 0.5; f += step, ++frames) {
        const RigPose pose_a = a->at(f / frames_per_second), pose_b = b->at(f / frames_per_second);
        const auto skin_a = a->skinAt(pose_a), skin_b = b->skinAt(pose_b);
        skin_m = std::max({skin_m, gap_m(skin_a, skin_b), gap_m(skin_b, skin_a)});
        bones = 0;
        for (const int node : a->mesh.node_of_bone) {
            const auto n = static_cast<size_t>(node);
            const int other = b->mesh.find(a->mesh.nodes[n].name);
            if (other < 0)
                continue;
            const auto o = static_cast<size_t>(other);
            ++bones;
            joint_m = std::max(joint_m, (pose_a[n].translation() - pose_b[o].translation()).norm());
            turn_rad = std::max(turn_rad,
                                turnOf(pose_a[n], first_a[n]).angularDistance(turnOf(pose_b[o], first_b[o])));
        }
    }
    std::printf(
        "{\"frames\": %d, \"bones\": %d, \"skin_mm\": %.5f, \"joint_mm\": %.5f, \"turn_deg\": %.5f}\n",
        frames, bones, 1e3 * skin_m, 1e3 * joint_m, degrees(turn_rad));
    return 0;
}
