// SPDX-License-Identifier: Apache-2.0
// What the screens show of a take, as plain values read part by part: the overview at once, the long tables
// when they are looked at. Every function opens the file itself and may run on any thread; none changes it.
// Times in seconds of the take's clock (0 = first sample).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/acoustics/range.h"
#include "core/body/actor.h"
#include "core/job/job.h"
#include "core/job/result.h"
#include "core/motion/foot_contacts.h"
#include "core/motion/timed_poses.h"
#include "core/processing/pose_runs.h"
#include "core/recording/rows.h"
#include "core/review/series.h"
#include "core/suit/calibration.h"
#include "core/suit/calibration_lack.h"
#include "core/suit/suit.h"

namespace noctule {

/// A take as one of its suits sees it: that suit's boards, sources, clock and body.
struct TakeView {
    TakeView(std::string of_path, int of_suit = kSuitInView, int with_sources_of = kSuitInView)
        : path(std::move(of_path)), suit(of_suit), sources_of(with_sources_of) {}

    std::string path;
    int suit;                      ///< kSuitInView: that of the first subject
    int sources_of = kSuitInView;  ///< whose pulses its boards heard; kSuitInView: its own
};

/// Who sends and hears sound in a take: a person, or the anchors of the room.
struct TakeParty {
    TakeSubject subject;
    Suit suit;
    Calibration calibration;  ///< in force; nominal when the take holds none
    /// Its box was lost then, before the rest pose ended: no run has a motion of it.
    std::optional<double> lost_in_rest_s{};
};

/// A pose run as listed; its motion is loaded by loadPoses().
struct ReviewRun {
    DerivedRun run;
    RunSettings settings;
    int number{};  ///< resultNumber()
};

struct ReviewMarker {
    double t_s = 0;
    std::string kind, label;
};

/// A board delivered nothing for a while, though others did.
struct BoardSilence {
    int board = 0;
    double from_s = 0;
    std::optional<double> back_s;  ///< absent: not before the take ended
};

struct TakeOverview {
    std::string path;
    TakeHeader header;
    std::string state;  ///< complete, recovered, recording
    std::string performer;
    std::vector<TakeSubject> subjects;  ///< the people, in the take's order
    std::vector<TakeParty> parties;     ///< the people in the same order, then the room
    int suit_in_view = kSuitInView;     ///< whose suit, calibration, actor, marks and gaps these are
    TakeLevel level = TakeLevel::kSignal;
    double duration_s = 0;
    double sample_rate_hz = 0;
    int64_t bytes = 0;
    Suit suit;
    Calibration calibration;  ///< in force; nominal when the take holds none
    CalibrationLack lack;     ///< of it
    std::optional<Actor> actor;
    std::vector<ReviewRun> runs;        ///< pose runs in the order they were made
    std::vector<ReviewMarker> markers;  ///< user and sync; rest is in rest_s
    std::optional<std::pair<double, double>> rest_s;
    std::vector<std::pair<double, double>> gaps_s;  ///< of all boards
    std::vector<BoardSilence> silences;             ///< of single boards, in order of time
    std::vector<NoteRow> notes;
    bool has_reference = false;
    bool has_external_root = false;
    bool contacts_edited = false;  ///< by an operator: they hold for all runs
    std::string reference_kind;
    std::vector<std::string> problems;  ///< whole sentences
    std::optional<Error> damage;        ///< a part could not be read since the database is torn

    /// Null: no party wears that suit.
    const TakeParty* partyOf(int of_suit) const;
};
Result<TakeOverview> overviewTake(const TakeView& view, const JobContext& job);

/// The motion of a pose run, or the reference when `run` is absent.
Result<TimedMotion> loadPoses(const TakeView& view, std::optional<int64_t> run, const JobContext& job);

/// When the feet stood while `motion` came out of `run` (processing/contacts_in_force.h).
Result<std::vector<FootContacts>> loadContacts(const TakeView& view, const ReviewRun& run,
                                               const TimedMotion& motion);

/// All ranges of one source-board pair, equally long arrays in order of time.
struct PairTrack {
    std::vector<double> t_s;                                           ///< of the pulse
    std::vector<float> distance_m, confidence, sigma_m, innovation_m;  ///< innovation NaN: not tried
    std::vector<RangeFate> fate;
};
struct RangeTable {
    int source_count = 0, board_count = 0;
    std::vector<PairTrack> pairs;                ///< source * board_count + board
    std::vector<std::vector<double>> pulse_t_s;  ///< of every source, heard or not
    const PairTrack& pair(int source, int board) const {
        return pairs[static_cast<size_t>(source * board_count + board)];
    }
};
/// A stretch of a take, for several readers at once: one of `count` with equally many pulses.
struct TakeStretch {
    int index = 0, count = 1;
};
/// `run`: of kind range, or kPrimaryRun. Only the ranges of that stretch, all the pulses. The sources are
/// those of the view's `sources_of`, the boards its suit's.
Result<RangeTable> loadRanges(const TakeView& view, int64_t run, const JobContext& job,
                              const TakeStretch& stretch = {});
/// The whole table of all its stretches, in whatever order they come.
RangeTable joinRanges(std::vector<RangeTable> stretches);

/// Calibrated readings of one board: gyroscope x y z in rad/s, accelerometer x y z in m/s^2; NaN: lost.
struct BoardTrack {
    std::vector<double> t_s;
    std::array<std::vector<float>, 6> value;
    std::vector<double> lost_s, clipped_s;
};
struct ReadingTable {
    std::vector<BoardTrack> boards;
};
/// `run`: of kind inertial, or kPrimaryRun.
Result<ReadingTable> loadReadings(const TakeView& view, int64_t run, const JobContext& job);

/// The raw sound of one board between two times, full scale 1, NaN in gaps, and the pulses sent meanwhile.
struct SoundWindow {
    double from_s = 0;
    double sample_rate_hz = 0;
    std::vector<float> value;
    struct PulseMark {
        double sent_s = 0;
        int source = 0;
        std::optional<double> arrival_s;  ///< as detected, in the range run given
    };
    std::vector<PulseMark> pulses;
};
/// At most 10 s at a time (kUsage). kUnusable for takes without sound.
Result<SoundWindow> loadSound(const TakeView& view, int board, double from_s, double to_s,
                              std::optional<int64_t> range_run, const JobContext& job);

/// Lowest and highest value of the raw sound in `columns` equal columns over the whole take, for an overview.
struct SoundEnvelope {
    std::vector<float> min, max;  ///< full scale 1; NaN where there is none
};
Result<SoundEnvelope> loadSoundEnvelope(const TakeView& view, int board, int columns, const JobContext& job);

}  // namespace noctule
