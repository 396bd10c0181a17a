// SPDX-License-Identifier: Apache-2.0
// Raw sound of the whole default suit to poses, on one core; each benchmark reports x_realtime. The parts are
// those of the whole: inertial decoding, acoustics, and the filter fed with what these two found. Poses come
// with the root given, as the simulated body's own with the noise of an optical system.
#include <benchmark/benchmark.h>

#include "core/acoustics/baseband_filter.h"
#include "core/live/live_pipeline.h"
#include "core/math/rotation.h"
#include "core/simulation/signal_sampler.h"
#include "tests/benchmark/nominal_stage.h"

namespace noctule {
namespace {

constexpr double kSeconds = 5, kRestSeconds = 1;
constexpr int64_t kBlockSamples = 6000, kHopSamples = 300;
constexpr const char* kMotion = "/usr/share/assimp/models/BVH/01_01.bvh";  // package assimp-testmodels

/// What became known in one hop of the decoder.
struct Hop {
    std::vector<InertialReading> readings;
    std::vector<RangeMeasurement> ranges;
    int64_t watermark = 0;
};

struct Recording {
    simulation::Stage stage;
    DecoderSettings decoder;
    std::pair<int64_t, int64_t> rest;
    std::vector<int16_t> sound;  ///< sample-interleaved
    std::vector<Pulse> pulses;
    TemperatureStatus air;
    std::vector<RootMeasurement> roots;
    std::vector<Hop> hops;

    size_t boards() const { return stage.suit.boards.size(); }
    int rate_hz() const { return stage.scenario.sample_rate_hz; }
    int64_t samples() const { return std::ssize(sound) / std::ssize(stage.suit.boards); }
    std::span<const int16_t> block(int64_t first, int64_t count) const {
        return std::span(sound).subspan(static_cast<size_t>(first) * boards(),
                                        static_cast<size_t>(std::min(count, samples() - first)) * boards());
    }
};

void addRoots(Recording& r) {
    const simulation::Scenario& s = r.stage.scenario;
    simulation::Random random(1, "external root");
    for (int frame = 0; frame < static_cast<int>(kSeconds * s.external_root_rate_hz); ++frame) {
        const double time_s = frame / s.external_root_rate_hz;
        const Pose pose = r.stage.body->performance().pose(time_s);
        const Quaterniond error = expQuaternion(random.gaussianVector(s.external_root_sigma_rotation_rad));
        r.roots.push_back({time_s,
                           pose.p_world_root + random.gaussianVector(s.external_root_sigma_position_m),
                           pose.q_parent_joint[0] * error, s.external_root_sigma_position_m,
                           s.external_root_sigma_rotation_rad});
    }
}

void decode(Recording& r) {
    auto decoder = std::move(SuitDecoder::create(r.stage.suit, r.stage.calibration, r.decoder).value());
    decoder->pushStatus(r.air);
    size_t next_pulse = 0;
    for (int64_t first = 0; first < r.samples(); first += kHopSamples) {
        for (; next_pulse < r.pulses.size() && r.pulses[next_pulse].sample < first + kHopSamples;
             ++next_pulse)
            decoder->pushPulse(r.pulses[next_pulse]);
        decoder->pushBlock(first, r.block(first, kHopSamples));
        r.hops.push_back({decoder->takeReadings(), decoder->takeRanges(), decoder->watermark()});
    }
}

Recording record() {
    Recording r;
    simulation::StageRequest request = nominalStage(kMotion, kSeconds);
    request.rest_seconds = kRestSeconds;
    r.stage = std::move(simulation::prepareStage(request).value());
    const simulation::PulseSchedule schedule = r.stage.scenario.schedule();
    r.decoder.train = {static_cast<double>(r.rate_hz()), schedule.interval_samples, schedule.drive_hz,
                       schedule.cycles};
    r.rest = {0, static_cast<int64_t>(kRestSeconds * r.rate_hz())};
    r.air = {0, r.stage.truth.air.temperature_c, r.stage.truth.air.humidity_percent};
    simulation::SignalSampler sampler(*r.stage.world, r.stage.scenario, r.stage.truth);
    for (int64_t left = r.stage.sampleCount(); left > 0; left -= kBlockSamples) {
        const auto block = sampler.next(std::min(left, kBlockSamples));
        r.sound.insert(r.sound.end(), block.begin(), block.end());
    }
    for (int64_t k = 0; k * schedule.interval_samples < r.samples(); ++k)
        r.pulses.push_back(schedule.pulse(k, static_cast<int>(r.stage.suit.sources.size())));
    addRoots(r);
    decode(r);
    return r;
}

const Recording& recording() {
    static const Recording made = record();
    return made;
}

TrackerSettings rootGiven() {
    TrackerSettings settings;
    settings.root_given = true;
    return settings;
}

void reportRealTime(benchmark::State& state) {
    state.counters["x_realtime"] =
        benchmark::Counter(kSeconds * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

void whole(benchmark::State& state) {
    const Recording& r = recording();
    size_t poses = 0;
    for (auto _ : state) {
        auto pipeline = std::move(LivePipeline::create(r.stage.suit, r.stage.calibration, r.stage.actor,
                                                       {r.decoder, rootGiven(), r.rest})
                                      .value());
        for (const Pulse& pulse : r.pulses)
            pipeline->pushPulse(pulse);
        pipeline->pushStatus(r.air);
        for (const RootMeasurement& root : r.roots)
            pipeline->pushRoot(root);
        poses = 0;
        for (int64_t first = 0; first < r.samples(); first += kBlockSamples) {
            pipeline->pushBlock(first, r.block(first, kBlockSamples));
            poses += pipeline->takePoses().size();
        }
        pipeline->finish();
        poses += pipeline->takePoses().size();
    }
    reportRealTime(state);
    state.counters["poses"] = static_cast<double>(poses);
}

void inertialDecoding(benchmark::State& state) {
    const Recording& r = recording();
    const int boards = static_cast<int>(r.boards());
    size_t readings = 0;
    for (auto _ : state) {
        readings = 0;
        for (int b = 0; b < boards; ++b) {
            StreamReceiver receiver(b, r.rate_hz(), false);
            for (int64_t first = 0; first < r.samples(); first += kHopSamples)
                receiver.push(first, r.block(first, kHopSamples), b, boards);
            receiver.finish();
            readings += receiver.takeReadings().size();
        }
    }
    reportRealTime(state);
    state.counters["readings"] = static_cast<double>(readings);
}

void acoustics(benchmark::State& state, Detector detector) {
    const Recording& r = recording();
    std::vector<PulseDetection> detections;
    int ranges = 0;
    for (auto _ : state) {
        auto receiver =
            std::move(PulseReceiver::create(detector, r.decoder.train, static_cast<int>(r.boards()),
                                            shapesOf(r.stage.suit, r.stage.calibration))
                          .value());
        auto finder = std::move(
            RangeFinder::create(r.stage.suit, r.stage.calibration, r.decoder.train, detector).value());
        finder.soundSpeed().add(r.air);
        for (const Pulse& pulse : r.pulses)
            receiver.pushPulse(pulse);
        ranges = 0;
        for (int64_t first = 0; first < r.samples(); first += kHopSamples) {
            receiver.pushBlock(first, r.block(first, kHopSamples));
            detections.clear();
            receiver.advance(receiver.samplesEnd(), detections);
            for (const PulseDetection& detection : detections)
                ranges += finder.process(detection).has_value();
        }
    }
    reportRealTime(state);
    state.counters["ranges"] = ranges;
}

/// All boards to baseband, of it every sixth value; direct: every value is computed and five are dropped.
void toBaseband(benchmark::State& state, bool polyphase) {
    const Recording& r = recording();
    const BasebandFilter baseband(r.decoder.train);
    const int stride = polyphase ? baseband.factor() : 1;
    std::vector<int16_t> board(static_cast<size_t>(kBlockSamples));
    std::vector<std::complex<float>> out(static_cast<size_t>(baseband.outputs(kBlockSamples)));
    for (auto _ : state)
        for (int64_t first = 0; first + kBlockSamples <= r.samples(); first += kBlockSamples) {
            const auto block = r.block(first, kBlockSamples);
            for (size_t b = 0; b < r.boards(); ++b) {
                for (size_t i = 0; i < board.size(); ++i)
                    board[i] = block[i * r.boards() + b];
                for (int phase = 0; phase < baseband.factor(); phase += stride) {
                    const auto from = std::span(board).subspan(static_cast<size_t>(phase));
                    baseband.run(from, -phase,
                                 std::span(out).first(
                                     static_cast<size_t>(baseband.outputs(static_cast<int>(from.size())))));
                    benchmark::DoNotOptimize(out.data());
                }
            }
        }
    reportRealTime(state);
}

void filter(benchmark::State& state) {
    const Recording& r = recording();
    size_t poses = 0;
    for (auto _ : state) {
        auto tracker = std::move(MotionTracker::create(r.stage.suit, r.stage.calibration, r.stage.actor,
                                                       r.rate_hz(), r.rest, rootGiven())
                                     .value());
        for (const RootMeasurement& root : r.roots)
            tracker->add(root);
        poses = 0;
        for (const Hop& hop : r.hops) {
            for (const InertialReading& reading : hop.readings)
                tracker->add(reading);
            for (const RangeMeasurement& range : hop.ranges)
                tracker->add(range);
            tracker->advanceTo(hop.watermark);
            poses += tracker->takePoses().size();
        }
    }
    reportRealTime(state);
    state.counters["poses"] = static_cast<double>(poses);
}

BENCHMARK(whole)->Unit(benchmark::kMillisecond);
BENCHMARK(inertialDecoding)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(acoustics, inflection, Detector::kInflection)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(acoustics, matched, Detector::kMatched)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(toBaseband, polyphase, 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(toBaseband, direct, 0)->Unit(benchmark::kMillisecond);
BENCHMARK(filter)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace noctule

BENCHMARK_MAIN();
