// SPDX-License-Identifier: Apache-2.0
// What the sound of one take is like: every effect with its own number or switch. Sigmas are Gaussian, bounds
// those of a uniform draw made once per take. The defaults are a perfect world with pulses in it and nothing
// else; the numbers of the three scenarios are filled in by Scenario.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/acoustics/range.h"

namespace noctule::simulation {

using Bounds = std::array<double, 2>;  ///< lowest and highest value of a uniform draw

/// Ratio of amplitudes.
inline double gainFromDb(double db) {
    return std::pow(10.0, db / 20);
}

/// Round robin: pulse k starts at sample k * interval and comes from source k mod source count, or from the
/// next of those that are enabled.
struct PulseSchedule {
    int interval_samples = 1200;
    int cycles = 10;
    double drive_hz = 40000;
    std::optional<std::vector<int>> enabled_sources{};  ///< none: all

    bool isSilent(int source_count) const {
        return source_count == 0 || (enabled_sources && enabled_sources->empty());
    }
    /// The pulse as the driver box logs it; `id` is `index`. Not of a silent schedule.
    Pulse pulse(int64_t index, int source_count) const {
        const int turn = static_cast<int>(
            index % (enabled_sources ? static_cast<int64_t>(enabled_sources->size()) : source_count));
        return {index, index * interval_samples, enabled_sources ? (*enabled_sources)[turn] : turn};
    }
};

struct SoundScenario {
    // Sources and boards
    double amplitude_counts_at_1m =
        1500;  ///< peak received on the axis at 1 m, absorption and gains excluded
    Bounds source_resonance_hz{40000, 40000};
    Bounds source_q{25, 25};
    Bounds source_start_delay_s{0, 0};  ///< from the drive's start to the first motion of the sound
    double source_gain_db = 0, board_gain_db = 0;  ///< sigma
    double board_mic_delay_s = 0;                  ///< sigma
    Bounds ka{3.2, 3.2};                           ///< wave number times radius of each source's piston
    bool directivity = true;
    double behind_source_db = -20;

    // On the way
    double absorption_db_per_m = 1.3;
    bool occlusion = true;
    bool late_path = false;  ///< weak way around what occludes
    double late_path_db = -20, late_path_db_per_cm = -4;
    bool reflections = false;
    int walls = 2;
    Bounds wall_distance_m{1, 3};
    Bounds wall_gain_db{-14, -8};  ///< of the floor too
    int scattering_points = 6;

    // Noise
    double acoustic_noise_counts = 0;       ///< rms between 37.5 and 42.5 kHz
    double low_frequency_noise_counts = 0;  ///< rms below 13 kHz
    double impulses_per_s = 0;
};

/// What the hidden world drew: the truth that a calibration looks for.
struct SourceTruth {
    double resonance_hz = 0, q = 0, start_delay_s = 0, gain_db = 0, ka = 0;
};
struct BoardTruth {
    double gain_db = 0, mic_delay_s = 0;
};
struct SoundTruth {
    std::vector<SourceTruth> sources;
    std::vector<BoardTruth> boards;
};

/// The draws of one take. Each quantity has a stream of its own.
SoundTruth drawSoundTruth(const SoundScenario& scenario, int source_count, int board_count, uint64_t seed);

}  // namespace noctule::simulation
