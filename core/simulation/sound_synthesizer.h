// SPDX-License-Identifier: Apache-2.0
// What the microphones of a suit would have sampled: every pulse of the round robin over its direct way and
// its echoes, with both ends moving, and the noise of the place. ADC counts, not rounded and not clipped. The
// board's digital stream is added by others.
// Work goes from pulse to pulse: the body is frozen at the emission for what concerns levels and who stands
// in the way; for the time of flight the source stands where it is at each instant of emission and the
// microphone where it is at arrival (exact for the pulse's beginning and 0.5 ms later, linear in between and
// beyond).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/simulation/sound_click.h"
#include "core/simulation/sound_noise.h"
#include "core/simulation/sound_room.h"
#include "core/simulation/sound_scenario.h"
#include "core/simulation/sound_tone.h"
#include "core/simulation/sound_track.h"
#include "core/simulation/world.h"

namespace noctule::simulation {

/// Clock and air of one take.
struct SoundConditions {
    double sample_rate_hz = 150000;
    double speed_of_sound_m_per_s = 345;
    PulseSchedule schedule;
};

/// The pulses of another suit that the same boards hear, on its own carrier.
struct OtherVoice {
    const World* world = nullptr;  ///< its sources and the same boards; must outlive the synthesizer
    SoundScenario scenario;
    PulseSchedule schedule;
    SoundTruth truth;                                 ///< of its sources
    std::function<double(int64_t sample)> drive_s{};  ///< when the listening boards' clock shows its sample
};

class SoundSynthesizer {
public:
    /// `world` must outlive the synthesizer. `room`: of another one with the same world, scenario and seed,
    /// or the one that several suits are in.
    SoundSynthesizer(const World& world, const SoundScenario& scenario, const SoundConditions& conditions,
                     uint64_t seed, const std::optional<Room>& room = {});
    /// Before anything is rendered. Its pulses from time 0 on are heard.
    void add(const OtherVoice& other);

    /// Adds the sound of `count` samples from `first_sample` to `interleaved` (count x boards). Calls follow
    /// each other without a hole from sample 0 on; the result does not depend on how they divide the time.
    void render(int64_t first_sample, int64_t count, float* interleaved);

    const SoundTruth& truth() const { return truth_; }
    const Room& room() const { return room_; }

private:
    /// Whose pulses are heard: the first is the suit's own.
    struct Voice {
        OtherVoice of;
        Medium medium;
        std::vector<ToneSum> pulses;  ///< per source, peak 1
        int64_t next = 0;
    };
    struct Emission;
    Voice voiceOf(const OtherVoice& of) const;
    void renderInterval();
    void addPulses(Voice& voice);
    void addPulse(const Voice& voice, const Pulse& pulse);
    void addEchoes(const Emission& emission, int board);
    void addClicks();
    void addPath(const EchoPath& path, const Emission& emission, int board);
    Placement arrival(const EchoPath& path, double emission_s, double gain, int board);
    double arrivalTime(const EchoPath::Leg& leg, double emission_s, double guess_s, int board);

    const World& world_;
    SoundScenario scenario_;
    SoundConditions conditions_;
    Medium medium_;
    SoundTruth truth_;
    Room room_;
    MicrophoneTrack microphones_;
    AmbientNoise noise_;
    ClickProcess clicks_;
    std::vector<Voice> voices_;
    std::vector<double> board_gains_;

    // Sounds under way: per board, from the beginning of the present interval. Pulses, clicks and noise are
    // summed once at the end, so that none of them changes the rounding of another.
    std::vector<std::vector<float>> pulse_sound_, click_sound_;
    std::vector<float> interval_;  ///< finished, samples x boards
    int64_t intervals_ = 0;        ///< rendered so far
    int64_t next_sample_ = 0;
    std::vector<float> scratch_;
    std::vector<WorldCapsule> capsules_;
    std::vector<EchoPath> echoes_;
};

}  // namespace noctule::simulation
