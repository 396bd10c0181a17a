// SPDX-License-Identifier: Apache-2.0
// How good distances are on a moving body with echoes, against the simulator's truth: as the detector gives
// them and as the estimator used them (A+G+D, root given). Scenario nominal, sampled sound, the sources'
// offsets true so that only ranging is judged (the scenario's calibration is 1.5 us off, 0.5 mm).
//
//     measure_ranging [MOTION.bvh [SECONDS]]
//
// False direct path: an error of more than 15 mm. Of the rest, errors are of pairs that nothing obstructs and
// that move at 5 m/s at most, with one common scale taken off (as a wrong temperature makes it); a wrong
// cycle is an error of more than half a cycle, 4.3 mm. Obstructed: sound came around the body, some
// millimetres late.
#include <cstdio>
#include <cstdlib>

#include "core/live/live_pipeline.h"
#include "core/simulation/signal_sampler.h"
#include "tests/benchmark/nominal_stage.h"

namespace noctule {
namespace {

constexpr double kRest_s = 1, kFastest_m_per_s = 5, kFar_m = 0.015;
constexpr int64_t kBlock = 6000;

/// One distance and the truth about it.
struct Judged {
    RangeMeasurement range;
    double truth_m = 0, speed_m_per_s = 0;
    bool unobstructed = false, behind = false;

    double error_m() const { return range.distance_m - truth_m; }
    bool used() const { return range.fate == RangeFate::kUsed || range.fate == RangeFate::kWeighted; }
    bool confident() const { return range.w_s * range.w_t > 0.3; }
    bool isFalse() const { return std::abs(error_m()) > kFar_m; }
};

simulation::Stage stageOf(const std::string& motion, double seconds) {
    simulation::StageRequest request = nominalStage(motion, seconds);
    request.rest_seconds = kRest_s;
    simulation::Stage stage = std::move(simulation::prepareStage(request).value());
    for (size_t s = 0; s < stage.calibration.sources.size(); ++s)
        stage.calibration.sources[s].offsets_s = {{"start", stage.truth.sound.sources[s].start_delay_s},
                                                  {"inflection", stage.truth.inflection_offset_s[s]}};
    return stage;
}

void pushRoots(const simulation::Stage& stage, double seconds, LivePipeline& pipeline) {
    for (int frame = 0; frame < static_cast<int>(seconds * stage.scenario.external_root_rate_hz); ++frame) {
        const double time_s = frame / stage.scenario.external_root_rate_hz;
        const Pose pose = stage.body->performance().pose(time_s);
        pipeline.pushRoot({time_s, pose.p_world_root, pose.q_parent_joint[0],
                           stage.scenario.external_root_sigma_position_m,
                           stage.scenario.external_root_sigma_rotation_rad});
    }
}

Judged judge(const simulation::Stage& stage, const RangeMeasurement& range) {
    const simulation::World& world = *stage.world;
    const auto source = static_cast<size_t>(range.source);
    const double c = stage.truth.air.speedOfSound_m_per_s();
    const double sent_s = static_cast<double>(range.pulse_sample) / stage.scenario.sample_rate_hz +
                          stage.truth.sound.sources[source].start_delay_s;
    const auto distanceAt = [&](double time_s) {
        return simulation::directFlight(world, range.source, range.board, time_s, c).distance_m;
    };
    std::vector<simulation::WorldCapsule> capsules;
    world.capsules(sent_s, capsules);
    const auto path = simulation::directPath(
        {world.source(range.source, sent_s), world.sourceNormal(range.source, sent_s),
         world.microphone(range.board, sent_s)},
        capsules, stage.truth.sound.sources[source].ka, simulation::mediumOf(stage.scenario.sound, c));
    const double truth_m = distanceAt(sent_s);
    return {range, truth_m, (distanceAt(sent_s + 1e-3) - truth_m) / 1e-3, !path.occluded, path.behind_source};
}

std::vector<Judged> distances(const simulation::Stage& stage, double seconds, Detector detector) {
    const simulation::PulseSchedule schedule = stage.scenario.schedule();
    PipelineSettings settings;
    settings.decoder = {{static_cast<double>(stage.scenario.sample_rate_hz), schedule.interval_samples,
                         schedule.drive_hz, schedule.cycles},
                        detector};
    settings.tracker.root_given = true;
    settings.rest = {0, static_cast<int64_t>(kRest_s * stage.scenario.sample_rate_hz)};
    auto pipeline =
        std::move(LivePipeline::create(stage.suit, stage.calibration, stage.actor, settings).value());
    for (int64_t k = 0; k * schedule.interval_samples < stage.sampleCount(); ++k)
        pipeline->pushPulse(schedule.pulse(k, static_cast<int>(stage.suit.sources.size())));
    pipeline->pushStatus({0, stage.truth.air.temperature_c, stage.truth.air.humidity_percent});
    pushRoots(stage, seconds, *pipeline);
    simulation::SignalSampler sampler(*stage.world, stage.scenario, stage.truth);
    std::vector<Judged> all;
    const auto collect = [&] {
        for (const RangeMeasurement& range : pipeline->takeRanges())
            if (range.fate != RangeFate::kNotTried)
                all.push_back(judge(stage, range));
    };
    for (int64_t first = 0; first < stage.sampleCount(); first += kBlock) {
        pipeline->pushBlock(first, sampler.next(std::min(kBlock, stage.sampleCount() - first)));
        collect();
    }
    pipeline->finish();
    collect();
    return all;
}

/// Of those that are unobstructed and near enough to be right.
double commonScale(const std::vector<Judged>& all) {
    double product = 0, square = 0;
    for (const Judged& one : all)
        if (one.unobstructed && std::abs(one.error_m()) < 2e-3) {
            product += one.error_m() * one.truth_m;
            square += one.truth_m * one.truth_m;
        }
    return square > 0 ? product / square : 0;
}

void report(const char* what, const std::vector<Judged>& all) {
    if (all.empty())
        return;
    const double scale = commonScale(all);
    std::vector<double> errors_m;
    int falsely = 0, wrong = 0, obstructed = 0;
    double squares = 0, squares_right = 0, sigmas = 0;
    for (const Judged& one : all) {
        falsely += one.isFalse();
        obstructed += !one.isFalse() && !one.unobstructed;
        if (one.isFalse() || !one.unobstructed || std::abs(one.speed_m_per_s) > kFastest_m_per_s)
            continue;
        const double error_m = one.error_m() - scale * one.truth_m;
        errors_m.push_back(std::abs(error_m));
        squares += error_m * error_m;
        const bool other_cycle = std::abs(error_m) > 0.00431;
        wrong += other_cycle;
        squares_right += other_cycle ? 0 : error_m * error_m;
        sigmas += std::pow(error_m / one.range.sigma_m, 2);
    }
    std::ranges::sort(errors_m);
    const double n = static_cast<double>(errors_m.size());
    std::printf(
        "  %-34s %6zu, false direct paths %5.2f %%, obstructed %5.2f %%; wrong cycles %5.2f %%, rms %.3f mm "
        "(right cycle %.3f), "
        "median %.3f, 95 %% %.3f, error over sigma %.2f\n",
        what, all.size(), 100.0 * falsely / static_cast<double>(all.size()),
        100.0 * obstructed / static_cast<double>(all.size()), 100 * wrong / n, 1e3 * std::sqrt(squares / n),
        1e3 * std::sqrt(squares_right / (n - wrong)), 1e3 * errors_m[errors_m.size() / 2],
        1e3 * errors_m[errors_m.size() * 95 / 100], std::sqrt(sigmas / n));
}

template <class Wanted>
std::vector<Judged> those(const std::vector<Judged>& all, Wanted wanted) {
    std::vector<Judged> some;
    std::ranges::copy_if(all, std::back_inserter(some), wanted);
    return some;
}

/// As it was before the estimator said which cycle: the nearest to the envelope, or the envelope itself.
Judged beforePose(Judged one, bool carrier) {
    const CarrierRange& by_phase = one.range.carrier;
    if (by_phase.cycle_m > 0) {
        one.range.distance_m = carrier ? by_phase.distance_m : by_phase.envelope_m;
        one.range.sigma_m = carrier ? by_phase.sigma_m : by_phase.envelope_sigma_m;
    }
    return one;
}

void measure(const std::string& motion, double seconds) {
    const simulation::Stage stage = stageOf(motion, seconds);
    for (const Detector detector : {Detector::kInflection, Detector::kMatched}) {
        const std::vector<Judged> all = distances(stage, seconds, detector);
        std::printf("%s, %s, %.0f s\n", motion.c_str(), detectorName(detector), seconds);
        const auto confident = those(all, [](const Judged& one) { return one.confident() && !one.behind; });
        for (const bool carrier : {false, true}) {
            std::vector<Judged> before;
            for (const Judged& one : confident)
                before.push_back(beforePose(one, carrier));
            report(carrier ? "confident, nearest cycle" : "confident, envelope", before);
        }
        report("confident, after the pose", confident);
        report("used", those(all, [](const Judged& one) { return one.used(); }));
        report("used, by carrier", those(all, [](const Judged& one) {
                   return one.used() && one.range.carrier.cycle_m > 0 &&
                          one.range.sigma_m == one.range.carrier.sigma_m;
               }));
    }
}

}  // namespace
}  // namespace noctule

int main(int argc, char** argv) {
    noctule::measure(argc > 1 ? argv[1] : "/usr/share/assimp/models/BVH/01_01.bvh",
                     argc > 2 ? std::atof(argv[2]) : 10);
    return 0;
}
