// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/sound_synthesizer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/core/simulation/sound_test_world.h"

namespace noctule::simulation {
namespace {

constexpr double kSound = 345;

TestWorld pair(const Vector3d& microphone, const Vector3d& v_microphone = Vector3d::Zero(),
               const Vector3d& v_source = Vector3d::Zero()) {
    TestWorld world;
    world.sources = {{.p_m = {0, 1, 0}, .v_m_per_s = v_source}};
    world.boards = {{.p_m = microphone, .v_m_per_s = v_microphone}};
    return world;
}

/// Eight sources and six boards around a trunk and an arm, all moving a little.
TestWorld body() {
    TestWorld world;
    for (int s = 0; s < 8; ++s)
        world.sources.push_back(
            {.p_m = {0.05 * s - 0.2, 1.1, 0.2}, .v_m_per_s = {0, 0, 0.001}, .segment = 0});
    for (int b = 0; b < 6; ++b)
        world.boards.push_back({.p_m = {0.3, 0.3 + 0.25 * b, 0.5 - 0.2 * b}, .v_m_per_s = {0.001, 0, 0}});
    world.body = {{{0, 0.9, 0}, {0, 1.4, 0}, 0.15, 0}, {{0.25, 0.8, 0.2}, {0.25, 1.3, 0.2}, 0.05, 1}};
    return world;
}

SoundScenario everything() {
    SoundScenario scenario;
    scenario.source_resonance_hz = {39600, 40600};
    scenario.source_q = {15, 35};
    scenario.source_start_delay_s = {4e-6, 3e-5};
    scenario.source_gain_db = scenario.board_gain_db = 1.5;
    scenario.board_mic_delay_s = 1e-6;
    scenario.ka = {2.8, 3.6};
    scenario.late_path = scenario.reflections = true;
    scenario.acoustic_noise_counts = 8;
    scenario.low_frequency_noise_counts = 30;
    scenario.impulses_per_s = 30;
    return scenario;
}

std::vector<float> rendered(const World& world, const SoundScenario& scenario, int64_t count,
                            uint64_t seed = 1, int64_t block = 1 << 20, double rate_hz = 150000,
                            int interval = 1200) {
    SoundConditions conditions{.sample_rate_hz = rate_hz, .speed_of_sound_m_per_s = kSound, .schedule = {}};
    conditions.schedule.interval_samples = interval;
    SoundSynthesizer synthesizer(world, scenario, conditions, seed);
    std::vector<float> samples(static_cast<size_t>(count * world.boardCount()));
    for (int64_t first = 0; first < count; first += block)
        synthesizer.render(first, std::min(block, count - first),
                           samples.data() + first * world.boardCount());
    return samples;
}

double peak(const std::vector<float>& samples) {
    double most = 0;
    for (const float sample : samples)
        most = std::max(most, std::abs(static_cast<double>(sample)));
    return most;
}

TEST(Sound, PeaksAtTheStatedCountsOnTheAxisAtOneMetre) {
    SoundScenario scenario;
    scenario.absorption_db_per_m = 0;
    // Sampled densely, so that the peak is not missed.
    const auto near = rendered(pair({0, 1, 1}), scenario, 60000, 1, 60000, 6e6, 60000);
    EXPECT_NEAR(peak(near), 1500, 1.5);
    const auto far = rendered(pair({0, 1, 1.5}), scenario, 60000, 1, 60000, 6e6, 60000);
    EXPECT_NEAR(peak(far), 1000, 1);
}

TEST(Sound, SpreadsAbsorbsAndIsDirected) {
    const Vector3d aside(std::sin(0.7), 1, std::cos(0.7));
    const auto samples =
        rendered(pair({1.5 * aside.x(), 1, 1.5 * aside.z()}), {}, 60000, 1, 60000, 6e6, 60000);
    const double x = 3.2 * std::sin(0.7);
    EXPECT_NEAR(peak(samples), 1500 / 1.5 * std::pow(10.0, -1.3 * 1.5 / 20) * 2 * std::cyl_bessel_j(1, x) / x,
                1);
    const auto behind = rendered(pair({0, 1, -1}), {}, 60000, 1, 60000, 6e6, 60000);
    EXPECT_NEAR(peak(behind), 150 * std::pow(10.0, -1.3 / 20), 0.2);
}

// A hundredth of a sample would change the steepest samples by 20 counts.
TEST(Sound, ArrivesWhenItShouldAndRingsIntoTheNextInterval) {
    SoundScenario scenario = everything();
    scenario.reflections = false;
    scenario.acoustic_noise_counts = scenario.low_frequency_noise_counts = scenario.impulses_per_s = 0;
    const TestWorld world = pair({0, 1, 2.6});
    const SoundTruth truth = drawSoundTruth(scenario, 1, 1, 1);
    const auto samples = rendered(world, scenario, 2300);
    const ToneSum pulse = receivedPulse(40000, 10, truth.sources[0].resonance_hz, truth.sources[0].q);
    const double gain =
        1500 * std::pow(10.0, (truth.sources[0].gain_db + truth.boards[0].gain_db - 1.3 * 2.6) / 20) / 2.6;
    const double begin_s = truth.sources[0].start_delay_s + 2.6 / kSound + truth.boards[0].mic_delay_s;
    EXPECT_GT(begin_s * 150000, 1130);
    for (size_t i = 0; i < samples.size(); ++i)
        ASSERT_NEAR(samples[i], gain * toneValue(pulse, static_cast<double>(i) / 150000 - begin_s), 0.06)
            << i;
}

/// The sound of a microphone and a source in uniform radial motion from `distance`, exactly.
double retarded(const ToneSum& pulse, double t_s, double distance_m, double v_microphone, double v_source) {
    // c (t - u) = distance + v_microphone t - v_source u
    const double u = ((kSound - v_microphone) * t_s - distance_m) / (kSound - v_source);
    return toneValue(pulse, u);
}

TEST(Sound, IsStretchedByDoppler) {
    const ToneSum pulse = receivedPulse(40000, 10, 40000, 25);
    for (const auto& [v_microphone, v_source] : {std::pair{10.0, 0.0}, {0.0, 8.0}, {-6.0, 5.0}}) {
        SoundScenario scenario;
        scenario.absorption_db_per_m = 0;
        const TestWorld world = pair({0, 1, 1}, {0, 0, v_microphone}, {0, 0, v_source});
        const auto samples = rendered(world, scenario, 1100);
        for (size_t i = 0; i < samples.size(); ++i) {
            const double expected =
                1500 * retarded(pulse, static_cast<double>(i) / 150000, 1, v_microphone, v_source);
            ASSERT_NEAR(samples[i], expected, 0.2)
                << i << " at " << v_microphone << " and " << v_source << " m/s";
        }
    }
}

TEST(Sound, CarrierShiftsAsMeasured) {
    // Zero crossings of the driven part, sampled densely: f = F (1 - v / c) for a microphone that flees.
    const auto samples = rendered(pair({0, 1, 0.5}, {0, 0, 10}), {}, 20000, 1, 20000, 6e6, 20000);
    std::vector<double> crossings;
    const auto begin = static_cast<size_t>(0.5 / (kSound - 10) * 6e6);
    for (size_t i = begin + 300; i < begin + 1450; ++i) {
        const double a = samples[i], b = samples[i + 1];
        if (a < 0 && b >= 0)
            crossings.push_back(static_cast<double>(i) + a / (a - b));
    }
    ASSERT_GE(crossings.size(), 6u);
    const double cycles = static_cast<double>(crossings.size() - 1);
    const double measured_hz = cycles / (crossings.back() - crossings.front()) * 6e6;
    EXPECT_NEAR(measured_hz, 40000 * (1 - 10 / kSound), 5);
}

TEST(Sound, GoesLateAndWeaklyAroundTheBody) {
    SoundScenario scenario;
    scenario.late_path = true;
    TestWorld world = pair({0, 1, 0.6});
    const auto open = rendered(world, scenario, 1100);
    world.body = {{{-0.3, 1.02, 0.3}, {0.3, 1.02, 0.3}, 0.05, 0}};
    const double detour_m = detourAround(world.body[0], {0, 1, 0}, {0, 1, 0.6});
    ASSERT_GT(detour_m, 0.002);
    const auto hidden = rendered(world, scenario, 1100);
    const ToneSum pulse = receivedPulse(40000, 10, 40000, 25);
    const double gain = 1500 * airGain(0.6, 1.3) * std::pow(10.0, -(20 + 400 * detour_m) / 20);
    for (size_t i = 0; i < hidden.size(); ++i) {
        const double u = static_cast<double>(i) / 150000 - (0.6 + detour_m) / kSound;
        ASSERT_NEAR(hidden[i], gain * toneValue(pulse, u), 0.06) << i;
    }
    scenario.late_path = false;
    EXPECT_EQ(peak(rendered(world, scenario, 1100)), 0);
    scenario.occlusion = false;
    EXPECT_EQ(rendered(world, scenario, 1100), open);
}

TEST(Sound, EchoesComeAfterTheDirectSoundAndLeaveItAlone) {
    SoundScenario scenario;
    scenario.source_start_delay_s = {1e-5, 1e-5};
    const TestWorld world = pair({0, 1, 0.5});
    const auto direct = rendered(world, scenario, 1200);
    scenario.reflections = true;
    scenario.walls = scenario.scattering_points = 0;
    const auto both = rendered(world, scenario, 1200);
    // The floor's way is hypot(0.5, 2).
    const auto floor_sample = static_cast<size_t>((std::hypot(0.5, 2) / kSound + 1e-5) * 150000);
    for (size_t i = 0; i <= floor_sample; ++i)
        ASSERT_EQ(direct[i], both[i]);
    double echo = 0;
    for (size_t i = floor_sample; i < 1200; ++i)
        echo = std::max(echo, std::abs(static_cast<double>(both[i] - direct[i])));
    EXPECT_GT(echo, 5);
    EXPECT_LT(echo, 1500 * std::pow(10.0, -8 / 20.0) * airGain(std::hypot(0.5, 2), 1.3));
}

TEST(Sound, DoesNotDependOnTheBlocks) {
    const TestWorld world = body();
    const auto whole = rendered(world, everything(), 30000);
    EXPECT_EQ(whole, rendered(world, everything(), 30000, 1, 1));
    EXPECT_EQ(whole, rendered(world, everything(), 30000, 1, 777));
    EXPECT_EQ(whole, rendered(world, everything(), 30000, 1, 1200));
}

TEST(Sound, FollowsTheSeed) {
    const TestWorld world = body();
    EXPECT_EQ(rendered(world, everything(), 5000, 4), rendered(world, everything(), 5000, 4));
    EXPECT_NE(rendered(world, everything(), 5000, 4), rendered(world, everything(), 5000, 5));
}

TEST(Sound, AddsToWhatIsThere) {
    const TestWorld world = pair({0, 1, 0.5});
    SoundSynthesizer synthesizer(world, {}, {.speed_of_sound_m_per_s = kSound, .schedule = {}}, 1);
    std::vector<float> samples(1200, 100.0f);
    synthesizer.render(0, 1200, samples.data());
    const auto alone = rendered(world, {}, 1200);
    for (size_t i = 0; i < samples.size(); ++i)
        ASSERT_EQ(samples[i], 100.0f + alone[i]);
    EXPECT_THROW(synthesizer.render(0, 1, samples.data()), std::logic_error);
}

// Each effect draws and rounds for itself: the sum of the parts is the whole, bit for bit.
TEST(Sound, EffectsDoNotTouchEachOther) {
    const TestWorld world = body();
    SoundScenario silent = everything();
    silent.amplitude_counts_at_1m = silent.impulses_per_s = 0;
    silent.acoustic_noise_counts = silent.low_frequency_noise_counts = 0;
    EXPECT_EQ(peak(rendered(world, silent, 30000)), 0);
    SoundScenario pulses = silent, clicks = silent, noise = silent;
    pulses.amplitude_counts_at_1m = everything().amplitude_counts_at_1m;
    clicks.impulses_per_s = everything().impulses_per_s;
    noise.acoustic_noise_counts = everything().acoustic_noise_counts;
    noise.low_frequency_noise_counts = everything().low_frequency_noise_counts;
    const auto pulse_part = rendered(world, pulses, 30000), click_part = rendered(world, clicks, 30000);
    const auto noise_part = rendered(world, noise, 30000), whole = rendered(world, everything(), 30000);
    EXPECT_GT(peak(pulse_part), 100);
    EXPECT_GT(peak(click_part), 20);
    EXPECT_GT(peak(noise_part), 50);
    for (size_t i = 0; i < whole.size(); ++i)
        ASSERT_EQ(whole[i], pulse_part[i] + click_part[i] + noise_part[i]) << i;
}

TEST(SoundTruth, StaysWhenOtherEffectsGo) {
    SoundScenario bare = everything();
    bare.source_gain_db = bare.board_mic_delay_s = 0;
    const SoundTruth all = drawSoundTruth(everything(), 8, 18, 9), some = drawSoundTruth(bare, 8, 18, 9);
    for (size_t s = 0; s < 8; ++s) {
        EXPECT_EQ(all.sources[s].resonance_hz, some.sources[s].resonance_hz);
        EXPECT_EQ(all.sources[s].start_delay_s, some.sources[s].start_delay_s);
        EXPECT_EQ(all.sources[s].ka, some.sources[s].ka);
        EXPECT_EQ(some.sources[s].gain_db, 0);
        EXPECT_GE(all.sources[s].resonance_hz, 39600);
        EXPECT_LE(all.sources[s].resonance_hz, 40600);
        EXPECT_GE(all.sources[s].q, 15);
        EXPECT_LE(all.sources[s].q, 35);
        EXPECT_GE(all.sources[s].start_delay_s, 4e-6);
        EXPECT_LE(all.sources[s].start_delay_s, 3e-5);
    }
    for (size_t b = 0; b < 18; ++b) {
        EXPECT_EQ(all.boards[b].gain_db, some.boards[b].gain_db);
        EXPECT_EQ(some.boards[b].mic_delay_s, 0);
        EXPECT_LT(std::abs(all.boards[b].mic_delay_s), 5e-6);
    }
}

TEST(SoundTruth, IsTheSynthesizers) {
    const TestWorld world = body();
    const SoundSynthesizer synthesizer(world, everything(), {}, 9);
    EXPECT_EQ(synthesizer.truth().sources[3].q, drawSoundTruth(everything(), 8, 6, 9).sources[3].q);
    EXPECT_EQ(synthesizer.truth().boards.size(), 6u);
}

/// A hand that shakes at 5 Hz with 200 m/s^2, for 1.0035 s.
struct Shaker : TestWorld {
    double duration_s() const override { return 1.0035; }
    Vector3d microphone(int, double t_s) const override {
        return Vector3d::UnitX() * 0.2 * std::sin(2 * std::numbers::pi * 5 * t_s);
    }
};

TEST(MicrophoneTrack, FollowsFastMotionToAMicrometre) {
    Shaker world;
    world.boards.resize(1);
    MicrophoneTrack track(world);
    for (double t_s = 0; t_s < 0.99; t_s += 0.00037) {
        ASSERT_NEAR(track.position(0, t_s).x(), world.microphone(0, t_s).x(), 1e-6) << t_s;
        track.forgetBefore(t_s - 0.01);
    }
    for (double t_s = 0.99; t_s < 1.0035; t_s += 0.00037)
        ASSERT_NEAR(track.position(0, t_s).x(), world.microphone(0, t_s).x(), 5e-6) << t_s;
    EXPECT_EQ(track.position(0, 1.0035), track.position(0, 1.5));
    EXPECT_THROW(track.position(0, 0.2), std::logic_error);
}

}  // namespace
}  // namespace noctule::simulation
