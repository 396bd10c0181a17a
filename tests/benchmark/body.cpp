// SPDX-License-Identifier: Apache-2.0
// Skinning 20 000 vertices on one core, linear and with dual quaternions, and their ratio in the same run;
// rigging a figure of 20 000 vertices by itself (10 s at most are wanted).
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "core/body/actor.h"
#include "core/math/rotation.h"
#include "core/mesh/mannequin/mannequin.h"
#include "core/mesh/rig/auto_rig.h"
#include "core/mesh/skinning.h"
#include "core/mesh/surface_graph.h"

namespace noctule {
namespace {

constexpr size_t kVertices = 20'000;

/// Every triangle of the mannequin in four, until it has as many points as are wanted.
SkinnedMesh fine(const SkinnedMesh& mesh) {
    SkinnedMesh made{mesh.vertices, {}, mesh.bones};
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> middle_of;
    const auto middle = [&](uint32_t a, uint32_t b) {
        const auto [entry, is_new] =
            middle_of.try_emplace(std::minmax(a, b), static_cast<uint32_t>(made.vertices.size()));
        if (is_new) {
            SkinnedVertex vertex = made.vertices[a];
            vertex.p_m = 0.5F * (made.vertices[a].p_m + made.vertices[b].p_m);
            made.vertices.push_back(vertex);
        }
        return entry->second;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        const uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        made.triangles.insert(made.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    return made;
}

const SkinnedMesh& body() {
    static const SkinnedMesh mesh = [] {
        SkinnedMesh made = makeMannequin(defaultActor());
        while (made.vertices.size() < kVertices)
            made = fine(made);
        return made;
    }();
    return mesh;
}

std::vector<Eigen::Matrix4f> bentPose() {
    const Skeleton skeleton = defaultActor().skeleton;
    Pose pose = skeleton.zeroPose();
    for (size_t j = 0; j < pose.q_parent_joint.size(); ++j)
        pose.q_parent_joint[j] = axisAngle(Vector3d(1, 0.2 * static_cast<double>(j), 0.5).normalized(), 0.4);
    return skinMatrices(body(), skeleton, globalPose(skeleton, pose));
}

void skin(benchmark::State& state, Blending blending) {
    const auto matrices = bentPose();
    for (auto _ : state)
        benchmark::DoNotOptimize(skinned(body(), matrices, blending));
    state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(body().vertices.size()));
}
BENCHMARK_CAPTURE(skin, linear, Blending::kLinear)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(skin, dual_quaternions, Blending::kDualQuaternion)->Unit(benchmark::kMicrosecond);

void rigByItself(benchmark::State& state) {
    RiggedMesh figure;
    figure.skin = body();
    for (auto _ : state) {
        const auto landmarks = findLandmarks(welded(figure.skin).mesh, "mannequin");
        if (!landmarks || !autoRigged(figure, *landmarks, "mannequin"))
            state.SkipWithError("not rigged");
    }
    state.counters["vertices"] = static_cast<double>(figure.skin.vertices.size());
}
BENCHMARK(rigByItself)->Unit(benchmark::kMillisecond);

/// Of single passes in turn, so that both meet the same machine.
double medianRatio() {
    const auto matrices = bentPose();
    const auto seconds = [&](Blending blending) {
        const auto begin = std::chrono::steady_clock::now();
        benchmark::DoNotOptimize(skinned(body(), matrices, blending));
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    std::vector<double> ratios;
    for (int i = 0; i < 201; ++i)
        ratios.push_back(seconds(Blending::kDualQuaternion) / seconds(Blending::kLinear));
    std::nth_element(ratios.begin(), ratios.begin() + 100, ratios.end());
    return ratios[100];
}

}  // namespace
}  // namespace noctule

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    std::printf("dual quaternions take %.2f times as long as linear blending\n", noctule::medianRatio());
}
