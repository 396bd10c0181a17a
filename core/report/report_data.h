// SPDX-License-Identifier: Apache-2.0
// All that the report of a take says, as plain values: the caller reads them from the take and its runs, the
// report only counts, draws and words. Times in seconds of the take's clock (0 = first sample); absent parts
// are left empty, and the report then says that they are unknown instead of drawing nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/motion/comparison.h"
#include "core/suit/calibration_lack.h"

namespace noctule {

using NamedValues = std::vector<std::pair<std::string, std::string>>;

struct ReportTake {
    std::string name, file, uuid, created_utc, performer, actor_name, software;
    std::string level = "signal";  ///< or "readings": the take holds no sound
    double duration_s = 0;
    double begin_s = 0;  ///< on the take's clock; not 0 where the box of another suit began first
    double rest_s = 0;   ///< end of the rest pose on the take's clock; what is before is never compared

    double end_s() const { return begin_s + duration_s; }
    /// From the end of the rest pose, without one from the beginning, to the end.
    double afterRest_s() const { return end_s() - std::max(begin_s, rest_s); }
    bool ends_in_rest = false;  ///< its box was lost while the rest pose was held: there is no motion
    double sample_rate_hz = 0;
    std::string reference_kind;  ///< "simulated", "optical", ...; empty: none
    std::string reference_name;  ///< file, when it has one
    std::vector<std::string> notes;
};

/// One processing of the take.
struct ReportRun {
    int number = 0;  ///< resultNumber(); 0: not known
    std::string name;
    std::string sensors;    ///< subset of "AGD", in this order
    std::string estimator;  ///< "manifold", "paper"
    std::string smoother = "none";
    bool root_given = false;  ///< the root came from another system (table external_root)
    std::string created_utc, software, calibration;
    NamedValues settings;
    std::optional<Comparison> comparison;  ///< absent without a reference
    std::optional<Comparison> from_shown;  ///< how far it is from the shown run; absent for that one
    bool is_shown = false;  ///< the run that the curves and verdict are about; else the last one
};

struct ReportSource {
    std::string id;     ///< "s8"
    std::string label;  ///< "hat"; may be empty
};

/// A board and what its stream delivered.
struct ReportBoard {
    std::string id;                                ///< "l_shin"
    std::string segment;                           ///< canonical joint name, empty when fixed in the room
    int64_t frames_expected = 0, frames_lost = 0;  ///< of the inertial stream; lost: no reading at all
    int64_t frames_absent = 0;                     ///< of the lost: before it joined and after it left
    std::optional<double> joined_s{}, left_s{};    ///< take's clock, where not with the take
    int64_t readings_expected = 0, readings_present = 0;  ///< single axes
    int64_t clipped_gyro = 0, clipped_accel = 0;          ///< readings at the end of their range
    int64_t corrected_bits = 0;

    double lostShare() const {
        return frames_expected <= 0 ? 0 : double(frames_lost) / double(frames_expected);
    }
    /// While it was there.
    double lostShareWhileThere() const {
        const int64_t there = frames_expected - frames_absent;
        return there <= 0 ? 0 : double(frames_lost - frames_absent) / double(there);
    }
    /// It came late or left early rather than losing frames in between.
    bool lostMostlyByAbsence() const { return 2 * frames_absent > frames_lost; }
    double readingShare() const {
        return readings_expected <= 0 ? 1 : double(readings_present) / double(readings_expected);
    }
};

/// What became of one pulse at one board.
enum class PulseFate : unsigned char {
    kUsed,      ///< heard, and the filter took its range
    kRejected,  ///< heard, and the filter's gate threw it out
    kUnused,    ///< heard, but not trusted enough to be tried, or the run used no distances
    kOccluded,  ///< not heard, and the pose explains why
    kMissing,   ///< not heard, although the pose should let it, or the pose is not known
};
inline constexpr int kPulseFates = 5;

/// A range counts for so long after its pulse: sources send every 64 ms where there are eight, three times.
inline constexpr double kPairHold_s = 0.192;

struct PulseAtBoard {
    float time_s = 0;  ///< on the take's clock
    PulseFate fate = PulseFate::kMissing;
    float confidence = 0;    ///< 0..1; 0 when not heard
    float distance_m = NAN;  ///< NaN when not heard
    float residual_m = NAN;  ///< measured minus predicted, NaN when not tried
};

struct ReportPair {
    int source = 0, board = 0;         ///< indices into ReportData
    std::vector<PulseAtBoard> pulses;  ///< every pulse of the source, in order of time
};

/// How one joint's angle was known: share of the frames after the rest, 0..1. See joint_support.h.
struct JointSupport {
    std::string joint;
    double ranges = 0;   ///< a used range constrained it a moment ago
    double inertia = 0;  ///< not so, but a board on its segment or beyond delivered readings
    /// When ranges stopped backing it, though they had until then; empty: they did not stop.
    std::optional<double> lost_from_s;
    double lost_share = 0;  ///< by how much the share with ranges fell there, 0..1
    double alone() const { return std::max(0.0, 1 - ranges - inertia); }  ///< predicted by the model only
};

struct ReportData {
    ReportTake take;
    std::vector<ReportRun> runs;
    std::vector<ReportSource> sources;
    std::vector<ReportBoard> boards;
    std::vector<ReportPair> pairs;  ///< of the shown run; any order, absent pairs allowed
    std::vector<std::pair<int, int>>
        chosen_pairs;  ///< source, board for the curves; empty: chosen by segment
    std::vector<JointSupport> support;
    std::vector<std::pair<double, double>> gaps_s;       ///< without any signal; may overlap
    CalibrationLack lack;                                ///< of what the shown run was made with
    int64_t distances_given = 0, distances_refused = 0;  ///< of a take of readings; refused: no such distance
    bool people_apart = false;          ///< not all performers' places to each other are known
    std::vector<std::string> unjoined;  ///< those of them who stand alone; empty: all do
    /// Performers of the shown run, of a take of several: those of one joint estimate, and the others.
    std::vector<std::string> together, alone;
    std::vector<std::pair<std::string, NamedValues>>
        provenance;                     ///< headed lists: calibration, versions, ...
    std::vector<std::string> warnings;  ///< whole sentences found while reading or processing

    /// The run that the report is about: is_shown, else the last; null without runs.
    const ReportRun* shownRun() const;
};

}  // namespace noctule
