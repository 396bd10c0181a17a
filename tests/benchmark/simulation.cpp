// SPDX-License-Identifier: Apache-2.0
// How much faster than real time a whole suit is simulated on one core; each benchmark reports x_realtime.
#include <benchmark/benchmark.h>

#include <cmath>

#include "core/math/rotation.h"
#include "core/simulation/pulse_readings.h"
#include "core/simulation/signal_sampler.h"
#include "core/simulation/simulate.h"
#include "core/suit/default_suit.h"

namespace noctule::simulation {
namespace {

constexpr double kSeconds = 5;

MotionClip swingingClip() {
    MotionClip clip;
    clip.name = "benchmark";
    clip.skeleton = freedActor(defaultActor()).skeleton;
    for (int f = 0; f < 600; ++f) {
        Pose pose = clip.skeleton.zeroPose();
        pose.p_world_root = {0, 1, f / 200.0};
        for (int j = 1; j < clip.skeleton.size(); ++j)
            pose.q_parent_joint[j] = expQuaternion(0.3 * std::sin(f / 20.0 + j) * Vector3d(1, 0.5, -0.7));
        clip.frames.push_back(pose);
    }
    return clip;
}

Stage makeStage(const Scenario& scenario) {
    StageRequest request;
    request.clip = swingingClip();
    request.suit = defaultSuit();
    request.scenario = scenario;
    request.rest_seconds = 0.5;
    return prepareStage(request).value();
}

void reportRealTime(benchmark::State& state) {
    state.counters["x_realtime"] =
        benchmark::Counter(kSeconds * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

Scenario scenarioOf(const benchmark::State& state) {
    return state.range(0) ? Scenario::realistic() : Scenario::nominal();
}

void wholeSignal(benchmark::State& state) {
    const Stage stage = makeStage(scenarioOf(state));
    for (auto _ : state) {
        SignalSampler sampler(*stage.world, stage.scenario, stage.truth);
        for (int block = 0; block < static_cast<int>(kSeconds * 25); ++block)
            benchmark::DoNotOptimize(sampler.next(6000));
    }
    reportRealTime(state);
}

void sound(benchmark::State& state) {
    const Stage stage = makeStage(scenarioOf(state));
    std::vector<float> values(6000 * 18);
    for (auto _ : state) {
        SoundSynthesizer synthesizer(
            *stage.world, stage.scenario.sound,
            {150000, stage.truth.air.speedOfSound_m_per_s(), stage.scenario.schedule()}, 1);
        for (int64_t block = 0; block < static_cast<int64_t>(kSeconds * 25); ++block)
            synthesizer.render(block * 6000, 6000, values.data());
    }
    reportRealTime(state);
}

void inertia(benchmark::State& state) {
    const Stage stage = makeStage(scenarioOf(state));
    for (auto _ : state)
        for (int b = 0; b < 18; ++b) {
            BoardReadings readings(*stage.world, b, stage.truth.inertia[b], stage.scenario, 1);
            for (int64_t frame = 0; frame < static_cast<int64_t>(kSeconds * 140); ++frame)
                benchmark::DoNotOptimize(readings.next(frame));
        }
    reportRealTime(state);
}

void rangeReadings(benchmark::State& state) {
    const Stage stage = makeStage(scenarioOf(state));
    std::vector<PulseDetection> detections;
    for (auto _ : state) {
        PulseReadings readings(*stage.world, stage.scenario, stage.truth);
        for (int64_t k = 0; k < static_cast<int64_t>(kSeconds * 125); ++k)
            readings.hear(stage.scenario.schedule().pulse(k, 8), detections);
    }
    reportRealTime(state);
}

BENCHMARK(wholeSignal)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(sound)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(inertia)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(rangeReadings)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace noctule::simulation

BENCHMARK_MAIN();
