// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/sound_synthesizer.h"

#include <algorithm>
#include <cmath>

#include "core/job/contract.h"

namespace noctule::simulation {
namespace {

/// A path with a lower peak is left out: the ADC's rounding alone is 0.3 counts rms.
constexpr double kFaintest_counts = 0.2;
/// Apart from the pulse's beginning, the flight is solved for what is emitted this much later.
constexpr double kLater_s = 5e-4;
/// A microphone hears the source of its own housing through the housing's wall.
constexpr double kHousing_db = -20;

/// Drops the first `count` values of what is under way.
void advance(std::vector<float>& samples, size_t count) {
    samples.erase(samples.begin(),
                  samples.begin() + static_cast<std::ptrdiff_t>(std::min(count, samples.size())));
}

}  // namespace

/// One pulse as it leaves.
struct SoundSynthesizer::Emission {
    const Voice& voice;
    int source = 0;
    double t_s = 0;  ///< the sound's beginning
    Vector3d source_m{}, source_later_m{}, normal{};
    double gain_counts = 0;  ///< peak on the axis at 1 m
};

SoundSynthesizer::SoundSynthesizer(const World& world, const SoundScenario& scenario,
                                   const SoundConditions& conditions, uint64_t seed,
                                   const std::optional<Room>& room)
    : world_(world),
      scenario_(scenario),
      conditions_(conditions),
      medium_(mediumOf(scenario, conditions.speed_of_sound_m_per_s)),
      truth_(drawSoundTruth(scenario, world.sourceCount(), world.boardCount(), seed)),
      room_(room ? *room : Room(world, scenario, seed)),
      microphones_(world),
      noise_({scenario.acoustic_noise_counts, scenario.low_frequency_noise_counts}, conditions.sample_rate_hz,
             world.boardCount(), seed),
      clicks_(scenario.impulses_per_s, seed),
      pulse_sound_(static_cast<size_t>(world.boardCount())),
      click_sound_(static_cast<size_t>(world.boardCount())) {
    const PulseSchedule& schedule = conditions_.schedule;
    require(conditions_.sample_rate_hz > 0 && schedule.interval_samples > 0 && schedule.drive_hz > 0,
            "SoundSynthesizer: the clock does not run");
    const auto drive_s = [rate_hz = conditions_.sample_rate_hz](int64_t sample) {
        return static_cast<double>(sample) / rate_hz;
    };
    voices_.push_back(voiceOf({&world_, scenario_, schedule, truth_, drive_s}));
    for (const BoardTruth& board : truth_.boards)
        board_gains_.push_back(gainFromDb(board.gain_db));
}

SoundSynthesizer::Voice SoundSynthesizer::voiceOf(const OtherVoice& of) const {
    Voice voice{of, mediumOf(of.scenario, conditions_.speed_of_sound_m_per_s), {}};
    for (const SourceTruth& source : of.truth.sources)
        voice.pulses.push_back(
            receivedPulse(of.schedule.drive_hz, of.schedule.cycles, source.resonance_hz, source.q));
    return voice;
}

void SoundSynthesizer::add(const OtherVoice& other) {
    require(next_sample_ == 0, "SoundSynthesizer: a voice comes too late");
    voices_.push_back(voiceOf(other));
    Voice& voice = voices_.back();
    while (!other.schedule.isSilent(other.world->sourceCount()) &&
           other.drive_s(voice.next * other.schedule.interval_samples) < 0)
        ++voice.next;
}

void SoundSynthesizer::render(int64_t first_sample, int64_t count, float* interleaved) {
    require(first_sample == next_sample_, "SoundSynthesizer: blocks must follow each other");
    const int64_t boards = world_.boardCount(), length = conditions_.schedule.interval_samples;
    for (int64_t done = 0; done < count;) {
        if (next_sample_ == intervals_ * length)
            renderInterval();
        const int64_t from = next_sample_ - (intervals_ - 1) * length;
        const int64_t part = std::min(length - from, count - done);
        for (int64_t i = 0; i < part * boards; ++i)
            interleaved[done * boards + i] += interval_[static_cast<size_t>(from * boards + i)];
        done += part;
        next_sample_ += part;
    }
}

void SoundSynthesizer::renderInterval() {
    const auto boards = static_cast<size_t>(world_.boardCount());
    const auto length = static_cast<size_t>(conditions_.schedule.interval_samples);
    microphones_.forgetBefore(static_cast<double>(next_sample_) / conditions_.sample_rate_hz);
    for (Voice& voice : voices_)
        addPulses(voice);
    addClicks();
    interval_.resize(length * boards);
    for (size_t b = 0; b < boards; ++b) {
        scratch_.assign(length, 0.0f);
        noise_.add(static_cast<int>(b), scratch_);
        pulse_sound_[b].resize(std::max(length, pulse_sound_[b].size()));
        click_sound_[b].resize(std::max(length, click_sound_[b].size()));
        for (size_t i = 0; i < length; ++i)
            interval_[i * boards + b] = pulse_sound_[b][i] + click_sound_[b][i] + scratch_[i];
        advance(pulse_sound_[b], length);
        advance(click_sound_[b], length);
    }
    ++intervals_;
}

/// All that leave within the present interval.
void SoundSynthesizer::addPulses(Voice& voice) {
    const PulseSchedule& schedule = voice.of.schedule;
    const int sources = voice.of.world->sourceCount();
    if (schedule.isSilent(sources))
        return;
    const double end_s = static_cast<double>((intervals_ + 1) * conditions_.schedule.interval_samples) /
                         conditions_.sample_rate_hz;
    for (; voice.of.drive_s(voice.next * schedule.interval_samples) < end_s; ++voice.next)
        addPulse(voice, schedule.pulse(voice.next, sources));
}

void SoundSynthesizer::addPulse(const Voice& voice, const Pulse& pulse) {
    const World& world = *voice.of.world;
    const SourceTruth& source = voice.of.truth.sources[static_cast<size_t>(pulse.source)];
    Emission emission{voice};
    emission.source = pulse.source;
    emission.t_s = voice.of.drive_s(pulse.sample) + source.start_delay_s;
    emission.source_m = world.source(pulse.source, std::min(emission.t_s, world_.duration_s()));
    emission.source_later_m =
        world.source(pulse.source, std::min(emission.t_s + kLater_s, world_.duration_s()));
    emission.normal = world.sourceNormal(pulse.source, std::min(emission.t_s, world_.duration_s()));
    emission.gain_counts = voice.of.scenario.amplitude_counts_at_1m * gainFromDb(source.gain_db);
    world.capsules(std::min(emission.t_s, world_.duration_s()), capsules_);
    for (int board = 0; board < world_.boardCount(); ++board) {
        const PathEnds ends{emission.source_m, emission.normal, microphones_.position(board, emission.t_s)};
        DirectPath direct = directPath(ends, capsules_, source.ka, voice.medium);
        if (world.sourceBoard(pulse.source) == board)
            direct.gain *= gainFromDb(kHousing_db);
        addPath(
            {{emission.source_m, direct.detour_m}, {emission.source_later_m, direct.detour_m}, direct.gain},
            emission, board);
        if (scenario_.reflections)
            addEchoes(emission, board);
    }
}

void SoundSynthesizer::addEchoes(const Emission& emission, int board) {
    Room::Query query;
    query.ends = {emission.source_m, emission.normal, microphones_.position(board, emission.t_s)};
    query.source_later_m = emission.source_later_m;
    query.source_segment = emission.voice.of.world->sourceSegment(emission.source);
    query.board_segment = emission.voice.of.world->boardSegment(board);
    query.ka = emission.voice.of.truth.sources[static_cast<size_t>(emission.source)].ka;
    query.least_gain =
        kFaintest_counts / (emission.gain_counts * board_gains_[static_cast<size_t>(board)] + 1e-12);
    room_.echoes(query, capsules_, emission.voice.medium, echoes_);
    for (const EchoPath& echo : echoes_)
        addPath(echo, emission, board);
}

void SoundSynthesizer::addPath(const EchoPath& path, const Emission& emission, int board) {
    const auto b = static_cast<size_t>(board);
    const double gain = path.gain * emission.gain_counts * board_gains_[b];
    if (std::abs(gain) >= kFaintest_counts)
        addTones(emission.voice.pulses[static_cast<size_t>(emission.source)],
                 arrival(path, emission.t_s, gain, board), pulse_sound_[b]);
}

void SoundSynthesizer::addClicks() {
    const double end_s = static_cast<double>((intervals_ + 1) * conditions_.schedule.interval_samples) /
                         conditions_.sample_rate_hz;
    while (const auto click = clicks_.nextBefore(end_s)) {
        const Vector3d middle = middleOfSuit(world_, std::min(click->t_s, world_.duration_s()));
        const Vector3d from = middle + click->from_middle_m;
        for (int board = 0; board < world_.boardCount(); ++board) {
            const auto b = static_cast<size_t>(board);
            const double distance_m = (microphones_.position(board, click->t_s) - from).norm();
            const double gain = board_gains_[b] * airGain(distance_m, medium_.absorption_db_per_m);
            addTones(click->tones, arrival({{from, 0}, {from, 0}, gain}, click->t_s, gain, board),
                     click_sound_[b]);
        }
    }
}

Placement SoundSynthesizer::arrival(const EchoPath& path, double emission_s, double gain, int board) {
    const double interval_begin_s =
        static_cast<double>(intervals_ * conditions_.schedule.interval_samples) / conditions_.sample_rate_hz;
    const double mic_delay_s = truth_.boards[static_cast<size_t>(board)].mic_delay_s;
    const double begin_s = arrivalTime(path.now, emission_s, emission_s, board);
    const double later_s = arrivalTime(path.later, emission_s + kLater_s, begin_s + kLater_s, board);
    return {.begin_sample = (begin_s + mic_delay_s - interval_begin_s) * conditions_.sample_rate_hz,
            .samples_per_second = conditions_.sample_rate_hz * (later_s - begin_s) / kLater_s,
            .gain = gain};
}

double SoundSynthesizer::arrivalTime(const EchoPath::Leg& leg, double emission_s, double guess_s, int board) {
    // Each round shrinks the error by the Mach number; 1e-10 s is 35 nm.
    double arrival_s = guess_s;
    for (int round = 0; round < 30; ++round) {
        const double way_m =
            leg.before_m + (microphones_.position(board, arrival_s) - leg.last_point_m).norm();
        const double next_s = emission_s + way_m / conditions_.speed_of_sound_m_per_s;
        const bool settled = std::abs(next_s - arrival_s) < 1e-10;
        arrival_s = next_s;
        if (settled)
            break;
    }
    return arrival_s;
}

}  // namespace noctule::simulation
