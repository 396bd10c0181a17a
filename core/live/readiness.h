// SPDX-License-Identifier: Apache-2.0
// Whether a suit that is worn is ready to be recorded, and what hinders it, as data that the screens word.
// Pairs come and go as the performer moves: what was heard well half a second ago still counts, and a source
// or a board has to be unheard for seconds before it is a problem. Time is the suit's clock.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "core/live/health.h"
#include "core/suit/calibration_lack.h"
#include "core/suit/calibration_steps.h"

namespace noctule {

/// Most harmful first.
enum class ProblemKind {
    kLinkLost,
    kNoSound,           ///< the link is there, nothing comes over it
    kBoardSilent,       ///< unplugged, or its cable is broken
    kBoardUnreadable,   ///< its wire is alive, its digital stream is not understood
    kBatteryEmpty,      ///< the box stops in about a minute
    kStorageShort,      ///< seconds
    kNotCalibrated,     ///< see Readiness::lack
    kStepNotUsable,     ///< a step of the calibration was saved all the same
    kMoved,             ///< the last check found that something sits otherwise than calibrated
    kSourceSilent,      ///< no board has heard it for seconds
    kBoardLosesFrames,  ///< frames a second
    kBoardClips,        ///< clipped samples or readings a second
    kBoardDeaf,         ///< hears no source
    kBatteryLow,        ///< percent
    kSourceFaint,       ///< good pairs
    kNotAssigned,       ///< nobody has said which board sits where
    kRestPoseOld,       ///< hours; not checked since, and nobody wears a suit for so long
    kNotChecked,        ///< calibrated, but not since the suit was put on
    kStepOld,           ///< hours; a step of the calibration is due again
};

struct ReadinessProblem {
    ProblemKind kind = ProblemKind::kLinkLost;
    bool hinders = false;  ///< else it can be recorded, with less
    int board = -1, source = -1;
    double value = 0;       ///< as the kind says
    bool accepted = false;  ///< the operator goes on without it
    std::vector<int>
        alike{};  ///< boards, or sources, that suffer the same at once: one cause; board is -1 then
    std::optional<CalibrationStep> step{};  ///< of the calibration, that it is about

    bool operator==(const ReadinessProblem&) const = default;
};

struct ReadinessLimits {
    /// A frame lost now and then costs nothing; with every tenth gone the gyroscopes bridge holes all the
    /// time.
    double least_frames_per_s = 126;
    /// Below this it is noise that happens to look like frames.
    double readable_frames_per_s = 14;
    /// So long it may be so: a stream that begins anew (a take streamed in a loop) is found within a second.
    double frames_poor_s = 2;
    double good_confidence = 0.5;   ///< style guide: "good" on every screen
    double heard_confidence = 0.2;  ///< of the sound alone, as faint_confidence
    double pair_holds_s = 0.5;      ///< eight rounds
    /// Nobody hides all boards from a source for so long by moving.
    double source_unheard_s = 2;
    /// A foot may be hidden for long while its performer sits.
    double board_unheard_s = 10;
    /// Best confidence of a source, over all boards, when other sources are heard well.
    double faint_confidence = 0.35;
    int64_t clipped_per_s = 30;
    double battery_low_percent = 20, battery_empty_percent = 5;
    double storage_short_s = 600, storage_empty_s = 60;
    double settles_s = 1.5;  ///< after a start nothing is judged
};

/// What is known of the suit's fit since it was put on.
enum class SuitFit {
    kUnchecked,
    kChecked,  ///< or calibrated just now, or known exactly, as of a simulated suit
    kMoved,    ///< the check found that something has moved
};

struct ReadinessFacts {
    const HealthReport* health = nullptr;  ///< null: nothing has come yet
    bool link_is_lost = false, sound_stalls = false, is_assigned = true;
    bool is_room = false;                ///< anchors: they need not hear each other, and nobody wears them
    std::vector<bool> board_is_plugged;  ///< as the box says; empty: it does not
    std::optional<double> storage_left_s;
    CalibrationLack lack{};                   ///< of the calibration in force
    std::vector<CalibrationStepState> steps;  ///< of it, with their age
    SuitFit fit = SuitFit::kChecked;
    std::set<int> without_boards, without_sources;  ///< accepted by the operator
};

struct BoardReadiness {
    enum class State { kUnknown, kFine, kPoor, kSilent };
    State state = State::kUnknown;
    int good_pairs = 0;
};

struct Readiness {
    enum class Verdict { kWaiting, kNotReady, kReady };
    Verdict verdict = Verdict::kWaiting;
    std::vector<ReadinessProblem> problems;  ///< sorted by harm, accepted ones last
    std::vector<BoardReadiness> boards;
    std::vector<int> source_good_pairs;
    std::vector<bool> pair_is_good;  ///< source * boards + board
    int boards_there = 0, sources_heard = 0, good_pairs = 0;
    CalibrationLack lack{};
    bool is_room = false;  ///< as in ReadinessFacts

    /// Calibrated well enough, and checked since it was put on: only then may a screen say "Ready" or
    /// "Recording well".
    bool isFit() const;
};

class ReadinessJudge {
public:
    ReadinessJudge(int board_count, int source_count, int sample_rate_hz, const ReadinessLimits& limits = {});

    /// Of what is known now; to be asked several times a second.
    Readiness judge(const ReadinessFacts& facts);

private:
    void remember(const HealthReport& health);
    void forgive();
    void judgeFit(const ReadinessFacts& facts, Readiness& readiness) const;
    void judgeSteps(const ReadinessFacts& facts, Readiness& readiness) const;
    void judgeWearing(const ReadinessFacts& facts, Readiness& readiness) const;
    void judgePairs(const HealthReport& health, Readiness& readiness) const;
    void judgeBoards(const ReadinessFacts& facts, Readiness& readiness) const;
    void judgeBoard(const ReadinessFacts& facts, int board, Readiness& readiness) const;
    void judgeSources(const HealthReport& health, Readiness& readiness) const;
    void judgeSupplies(const ReadinessFacts& facts, Readiness& readiness) const;
    double secondsSince(int64_t sample) const;

    const int board_count_, source_count_, sample_rate_hz_;
    const ReadinessLimits limits_;
    int64_t now_ = 0;
    bool was_broken_ = false;            ///< the link, when it was judged last
    std::vector<int64_t> pair_good_at_;  ///< samples; kNever
    std::vector<int64_t> board_heard_at_, board_whole_at_, source_heard_at_, source_clear_at_;
};

}  // namespace noctule
