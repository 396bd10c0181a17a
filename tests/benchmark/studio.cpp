// SPDX-License-Identifier: Apache-2.0
// What one waits for at the screen: a long take that opens, from the click to a body that moves and plots
// that show, and the cursor dragged through it, from its move to the painted frame, 3D view and plots both,
// in the window's own size of 1440 x 900. 25 Hz leave 40 ms a step; plots repaint at 30 Hz at most, so a step
// in a row takes 33 ms at least, and `busy_ms` is what the interface's thread computed of it. Needs a screen
// and a processed take, best one of ten minutes:
//   NOCTULE_BENCH_TAKE=take.noctule xvfb-run -a -s "-screen 0 1440x900x24 +extension GLX" bench_studio
#include <benchmark/benchmark.h>

#include <QApplication>
#include <QElapsedTimer>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>

#include "tests/benchmark/studio_stage.h"

namespace noctule::ui {
namespace {

using bench::StudioStage;

constexpr double kFrame_s = 1.0 / 25;
constexpr double kLimit_ms = 40;

QString takePath() {
    return qEnvironmentVariable("NOCTULE_BENCH_TAKE");
}

double threadTime_ms() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

void opening(benchmark::State& state) {
    double worst_ms = 0, first_ms = 0;
    for (auto _ : state) {
        StudioStage stage;
        QElapsedTimer clock;
        clock.start();
        stage.window().open(takePath());
        const bool there = stage.until([&] { return stage.hasBodyAndPlots(); }) && stage.show(1);
        const double ms = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
        if (!there) {
            state.SkipWithError("the take did not open, or its plots stay empty");
            return;
        }
        state.SetIterationTime(ms * 1e-3);
        worst_ms = std::max(worst_ms, ms);
        first_ms = first_ms > 0 ? first_ms : ms;
        stage.settle();
    }
    state.counters["first_ms"] = first_ms;
    state.counters["worst_ms"] = worst_ms;
}

/// The times that a hand on the timeline asks for.
struct Drag {
    bool in_order = true;
    std::mt19937 random{1};
    double t_s = 0;

    double next(double duration_s) {
        if (in_order)
            return t_s = std::fmod(t_s + kFrame_s, duration_s);
        return std::uniform_real_distribution<double>(0, duration_s)(random);
    }
};

void scrub(benchmark::State& state, bool in_order, bool with_ghost) {
    StudioStage stage;
    stage.window().open(takePath());
    if (!stage.until([&] { return stage.hasBodyAndPlots(); })) {
        state.SkipWithError("the take did not open");
        return;
    }
    if (with_ghost)
        stage.studio().take().setComparedRun(TakeDocument::kReference);
    stage.settle();
    Drag drag{in_order};
    double worst_ms = 0, busy_ms = 0, late = 0;
    for (auto _ : state) {
        QElapsedTimer clock;
        clock.start();
        const double busy_before_ms = threadTime_ms();
        if (!stage.show(drag.next(stage.studio().time().duration()))) {
            state.SkipWithError("a step was not painted within ten seconds");
            return;
        }
        const double ms = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
        busy_ms += threadTime_ms() - busy_before_ms;
        worst_ms = std::max(worst_ms, ms);
        late += ms > kLimit_ms ? 1 : 0;
        state.SetIterationTime(ms * 1e-3);
    }
    state.counters["worst_ms"] = worst_ms;
    state.counters["busy_ms"] = benchmark::Counter(busy_ms, benchmark::Counter::kAvgIterations);
    state.counters["late"] = benchmark::Counter(late, benchmark::Counter::kAvgIterations);
}

void registerAll() {
    benchmark::RegisterBenchmark("opening", opening)
        ->Iterations(5)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
    for (const bool ghost : {false, true})
        for (const bool in_order : {true, false}) {
            const std::string name =
                std::string(in_order ? "scrubInOrder" : "scrubAtRandom") + (ghost ? "/ghost" : "");
            benchmark::RegisterBenchmark(name.c_str(), scrub, in_order, ghost)
                ->Iterations(300)
                ->UseManualTime()
                ->Unit(benchmark::kMillisecond);
        }
}

}  // namespace
}  // namespace noctule::ui

int main(int argc, char** argv) {
    if (qEnvironmentVariableIsEmpty("NOCTULE_BENCH_TAKE")) {
        std::puts("set NOCTULE_BENCH_TAKE to a processed take; a screen is needed too");
        return 0;
    }
    noctule::ui::bench::prepareApplication();
    QApplication application(argc, argv);
    noctule::ui::bench::dressApplication();
    benchmark::Initialize(&argc, argv);
    noctule::ui::registerAll();
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
