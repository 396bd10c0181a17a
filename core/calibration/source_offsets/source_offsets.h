// SPDX-License-Identifier: Apache-2.0
// The offset of each ultrasonic source from a take on the jig, where boards and sources stand still at known
// distances, placement after placement (Vlasic 2007, section 4.3; 30 to 90 cm apart, leave-one-out error
// 2.35 mm mean, 1.92 mm deviation). Model, robust weighted least squares:
//   flight = distance / (c * scale) + offset of the source + delay of the board's microphone
// The speed of sound and the microphones' delays are never taken for exact: where they are not asked for they
// count with their tolerance, so that the offsets and their sigmas are honest. Seconds, metres.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/calibration/findings.h"
#include "core/calibration/observations.h"
#include "core/calibration/source_offsets/known_distances.h"

namespace noctule {

struct SourceOffsetSettings {
    /// kTemperature: the take's thermometer is right within its tolerance and the calibration keeps its scale
    /// of the speed of sound. kEstimate: the distances tell the scale, whatever the thermometer says.
    enum class SpeedOfSound { kTemperature, kEstimate } speed_of_sound = SpeedOfSound::kTemperature;
    double thermometer_sigma_k = 0.5;   ///< 0: exact
    double thermometer_noise_k = 0.05;  ///< from one placement to the next
    /// Else the delays in force stay, right within mic_delay_sigma_s. Estimated ones keep their mean, which
    /// no jig can tell from the offsets.
    bool estimate_mic_delays = false;
    double mic_delay_sigma_s = 1e-6;
    double settle_s = 0.3;        ///< of a stretch's begin and end, where parts may still move
    double min_confidence = 0.5;  ///< of a pulse
    int min_pulses = 3;           ///< of a pair in a placement
    int min_measurements = 4;     ///< of a source
};

/// One pair in one stretch of a take.
struct JigMeasurement {
    std::string placement;
    int stretch = 0;            ///< the how many-th of all takes, from 0
    int source = 0, board = 0;  ///< of the first take's suit
    double distance_m = 0, distance_sigma_m = 0;
    double flight_s = 0, flight_sigma_s = 0;  ///< robust mean of the pulses and its standard deviation
    double c_m_per_s = 340;
    int pulses = 0;
    bool moved = false;        ///< the flight time changed within the stretch
    bool mislabelled = false;  ///< belongs to labels that look exchanged
    bool used = false;         ///< has weight in the solution
    double residual_m = 0;     ///< distance by sound, with the result as applied, minus the known distance
    double left_out_m = 0;     ///< the same with a result made without this measurement
};

struct SourceOffset {
    std::string id;
    bool calibrated = false;  ///< else the values mean nothing
    double offset_s = 0, sigma_s = 0;
    int measurements = 0;                 ///< used
    double rms_m = 0;                     ///< of their residuals
    std::optional<double> before_s = {};  ///< the offset in force
};

struct MicDelay {
    std::string id;
    double delay_s = 0, sigma_s = 0;
};

/// Two labels of the file that stand for each other, in one placement or, `placement` empty, in all.
struct SwappedLabels {
    enum class Kind { kBoards, kSources, kPlacements } kind = Kind::kBoards;
    std::string first, second, placement;

    bool operator==(const SwappedLabels&) const = default;
};

/// Of absolute errors, as the paper states its own.
struct DistanceErrors {
    int count = 0;
    double mean_m = 0, deviation_m = 0, worst_m = 0;
};

struct SourceOffsetReport {
    Suit suit;  ///< of the first take
    std::string detector;
    std::vector<SourceOffset> sources;  ///< in the suit's order
    std::vector<MicDelay> mic_delays;   ///< only when estimated: boards that were heard
    SoundModel sound;                   ///< the take's; with the estimated scale where that was asked for
    bool sound_estimated = false;
    double sound_scale_sigma = 0;  ///< of the scale, estimated or not
    std::vector<JigMeasurement> measurements;
    DistanceErrors leave_one_out;  ///< over what is used
    DistanceErrors all_left_out;   ///< outliers included, labels that look exchanged not
    std::vector<SwappedLabels> swaps;
    std::vector<Finding> findings;

    Grade grade() const { return gradeOf(findings); }
    /// `base` with the offsets of the calibrated sources and what else was estimated; all else as it was.
    Calibration applied(const Calibration& base) const;
};

/// `takes` are of one suit and one detector; labels of placements are common to all of them. A result that
/// cannot be used says so in its findings and has fewer sources, perhaps none.
SourceOffsetReport calibrateSourceOffsets(const std::vector<Observations>& takes, const KnownDistances& known,
                                          const SourceOffsetSettings& settings = {});

}  // namespace noctule
