// SPDX-License-Identifier: Apache-2.0
// The figure behind Connect's boards: made of the mannequin once for each body, and drawn at the height of a
// window of 1920 x 1080 whenever a board's state changes its colours.
#include <benchmark/benchmark.h>

#include "core/body/actor.h"
#include "core/mesh/import/glb_reader.h"
#include "ui/views/body_figure.h"

namespace noctule::ui {
namespace {

constexpr int kHeight_px = 900;

std::shared_ptr<const SkinnedMesh> mannequin() {
    static const auto mesh = std::make_shared<const SkinnedMesh>(*readSkinnedMesh(NOCTULE_BODY));
    return mesh;
}

void made(benchmark::State& state) {
    const Actor actor = defaultActor();
    for (auto _ : state)
        benchmark::DoNotOptimize(BodyFigure(actor, mannequin()));
}

void drawnFirst(benchmark::State& state) {
    for (auto _ : state) {
        state.PauseTiming();
        const BodyFigure figure(defaultActor(), mannequin());
        state.ResumeTiming();
        benchmark::DoNotOptimize(figure.paint(kHeight_px, Qt::gray));
    }
}

void drawnAgain(benchmark::State& state) {
    const BodyFigure figure(defaultActor(), mannequin());
    for (auto _ : state)
        benchmark::DoNotOptimize(figure.paint(kHeight_px, Qt::gray));
}

BENCHMARK(made)->Unit(benchmark::kMillisecond);
BENCHMARK(drawnFirst)->Unit(benchmark::kMillisecond);
BENCHMARK(drawnAgain)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace noctule::ui

BENCHMARK_MAIN();
