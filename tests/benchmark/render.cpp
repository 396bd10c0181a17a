// SPDX-License-Identifier: Apache-2.0
// A frame of the 3D view at 1280 x 720: body of 12 000 triangles, ghost, grid, 144 rays, suit. First
// argument: samples; second: with the ghost. What the screen needs is 40 ms at most (25 Hz).
#include <benchmark/benchmark.h>

#include "core/mesh/mannequin/mannequin.h"
#include "core/render/body_scene.h"
#include "core/render/offscreen.h"

namespace noctule {
namespace {

constexpr PictureSize kSize{1280, 720};

Scene fullScene(bool with_ghost) {
    const Actor actor = defaultActor();
    const auto mesh = std::make_shared<const SkinnedMesh>(makeMannequin(actor));
    const BodyPlaces places = placeBody(actor.skeleton, actor.restPose(), {}, nullptr);
    Scene scene;
    scene.background = {{0.06F, 0.08F, 0.1F, 1}, {0.1F, 0.12F, 0.16F, 1}};
    scene.grid.emplace().line = {0.2F, 0.2F, 0.25F, 1};
    SceneBody body;
    body.mesh = mesh;
    body.skin = skinMatrices(*mesh, actor.skeleton, places.joints);
    body.color = {0.5F, 0.55F, 0.6F, 1};
    body.opacity = 0.86F;
    scene.bodies.push_back(body);
    if (with_ghost) {
        body.style = BodyStyle::kOutline;
        for (Eigen::Matrix4f& matrix : body.skin)
            matrix(0, 3) += 0.05F;
        scene.bodies.push_back(body);
    }
    for (const BonePlace& bone : places.bones)
        scene.bones.push_back(
            {bone.from_m.cast<float>(), bone.to_m.cast<float>(), {1, 1, 1, 0.3F}, 1.2F, false});
    for (int source = 0; source < 8; ++source)
        for (int board = 0; board < 18; ++board)
            scene.rays.push_back({{0.02F * static_cast<float>(source), 1.2F, 0.12F},
                                  places.joints.p_world_joint[static_cast<size_t>(board)].cast<float>(),
                                  {0.5F, 0.9F, 0.7F, 0.6F},
                                  1.2F,
                                  board % 3 == 0});
    scene.boards.resize(18);
    scene.sources.resize(8);
    return scene;
}

void drawFrame(benchmark::State& state) {
    auto offscreen = Offscreen::create();
    if (!offscreen) {
        state.SkipWithError(offscreen.error().text().c_str());
        return;
    }
    const Scene scene = fullScene(state.range(1) != 0);
    Camera camera;
    for (auto _ : state) {
        camera.orbit(0.01, 0);
        benchmark::DoNotOptimize(
            (*offscreen)->render(scene, camera, kSize, static_cast<int>(state.range(0))));
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(drawFrame)
    ->ArgNames({"samples", "ghost"})
    ->Args({0, 0})
    ->Args({0, 1})
    ->Args({4, 0})
    ->Args({4, 1})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace noctule

BENCHMARK_MAIN();
