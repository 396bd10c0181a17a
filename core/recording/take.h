// SPDX-License-Identifier: Apache-2.0
// A take file as README.md describes it, opened. Opening checks that it is a take of a version we know; what
// is missing inside is an error only of the function that needs it, so that notes and tables of a half take
// can still be shown. Bad rows are left out, counted and named in skippedRows(). Not for several threads at
// once.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/acoustics/range.h"
#include "core/body/actor.h"
#include "core/motion/foot_contacts.h"
#include "core/motion/timed_poses.h"
#include "core/recording/derived_cursor.h"
#include "core/recording/robot_rows.h"
#include "core/recording/rows.h"
#include "core/suit/calibration.h"
#include "core/suit/suit.h"

namespace noctule {

/// A value and the id of its row.
template <class T>
struct Stored {
    int64_t id = 0;
    T value;
};

/// Called for every block; false stops the walk. The values live until it returns.
using BlockSink = std::function<bool(const AdcBlock&)>;

class Take {
public:
    /// Opened to be written, a take that is being recorded is left alone (kUnusable). Everything that is read
    /// ends with kCancelled soon after the flag of `waiting` is raised.
    static Result<Take> open(const std::string& path, Access access = Access::kRead,
                             const Waiting& waiting = {});
    /// What is read while it lives is of one moment.
    Result<Snapshot> snapshot() const { return Snapshot::begin(*database_); }

    const std::string& path() const { return database_->path(); }
    /// The last failure was a lock of another program.
    bool isLocked() const { return database_->isLocked(); }
    const std::map<std::string, std::string>& meta() const { return meta_; }
    const TakeHeader& header() const { return header_; }
    /// Functions that are given no suit speak of the one in view, and so does header(). It is suit 1 until
    /// another one is chosen.
    void view(int suit);
    int viewed() const { return view_; }
    TakeLevel level() const;
    /// Of the driver box of the suit in view; empty: not stated.
    std::string boxSerial() const;
    /// What a complete take would have and this one does not, in plain words.
    Result<std::vector<std::string>> missingParts() const;
    /// Of everything that was read so far.
    std::vector<SkippedRows> skippedRows() const { return log_->all(); }

    int64_t lastSample() const;             ///< no row may lie beyond: the longest take at this rate
    Result<int64_t> sampleRate_hz() const;  ///< error: it is missing, nothing can be processed
    std::vector<int> suitIds() const;
    /// By meta `subjects`, else each suit with an actor; at least one. kUnreadable names a suit that is there
    /// twice or not at all, and a subject without an actor.
    Result<std::vector<TakeSubject>> subjects() const;
    Result<Suit> suit(int suit = kSuitInView) const;
    SuitClock suitClock(int suit = kSuitInView) const;
    Result<int> boardCount(int suit = kSuitInView) const;
    Result<int> sourceCount(int suit = kSuitInView) const;
    /// One after the last sample, from meta or else from the blocks; 0 when there are none.
    Result<int64_t> sampleCount(int suit = kSuitInView) const;
    /// Error: the rate is missing.
    Result<double> duration_s(int suit = kSuitInView) const;

    Result<std::vector<DocumentRow>> calibrations() const;
    Result<std::vector<DocumentRow>> actors() const;
    /// The calibration or actor with the highest id of the suit; kUnusable when there is none.
    Result<Stored<Calibration>> calibrationInForce(int suit = kSuitInView) const;
    Result<Stored<Actor>> actorInForce(int suit = kSuitInView) const;
    Result<Calibration> calibration(int64_t id) const;
    Result<Actor> actor(int64_t id) const;

    /// The raw sound in order of time. Holes between blocks are gaps.
    Status forEachBlock(int suit, const BlockSink& sink) const;
    /// Only the blocks that hold any of these samples.
    Status forEachBlock(int suit, const SampleInterval& within, const BlockSink& sink) const;
    Result<std::vector<Pulse>> pulses(int suit = kSuitInView) const;
    /// Only those sent within it.
    Result<std::vector<Pulse>> pulses(int suit, const SampleInterval& within) const;
    Result<std::vector<StatusRow>> statusRows(int suit = kSuitInView) const;
    Result<std::vector<GapRow>> gaps(int suit = kSuitInView) const;
    Result<std::vector<MarkerRow>> markers(int suit = kSuitInView) const;
    Result<std::vector<NoteRow>> notes() const;
    /// The first rest pose, begin to end; absent when none is marked.
    Result<std::optional<SampleInterval>> restInterval(int suit = kSuitInView) const;

    /// Truth of a simulation or an optical system, on its own skeleton; no frames when there is none.
    Result<TimedMotion> reference(int suit = kSuitInView) const;
    Result<std::vector<ExternalRootRow>> externalRoot(int suit = kSuitInView) const;
    /// Whether the table (reference, external_root, adc_block, ...) has any row of the suit; quick.
    Result<bool> hasRows(const std::string& table, int suit = kSuitInView) const;
    /// Of which sensors the primary readings and ranges hold any value.
    struct Measured {
        bool accelerometers = false, gyroscopes = false, distances = false;
    };
    Result<Measured> measured(int suit = kSuitInView) const;

    Result<std::vector<DerivedRun>> derivedRuns() const;
    Result<ReadingCursor> readings(int64_t run, int suit = kSuitInView) const;
    /// Of the suit's own pulses.
    Result<RangeCursor> ranges(int64_t run, int suit = kSuitInView) const;
    /// A pulse of another suit, as a board of `suit` heard it. distance_m is kNoDistance where only the
    /// arrival is stated.
    struct CrossRange {
        int from_suit = 0;
        RangeMeasurement range;  ///< pulse_sample on the clock of from_suit, arrival_sample on that of `suit`
    };
    /// In the order of the pulses' ids; false from the sink stops the walk.
    Status forEachCrossRange(int64_t run, int suit, const std::function<bool(const CrossRange&)>& sink) const;
    /// Only those of the pulses with ids `first` to `last`.
    Result<RangeCursor> rangesOfPulses(int64_t run, int64_t first, int64_t last,
                                       int suit = kSuitInView) const;
    /// Of a run of kind `clock`, in the order of time.
    Result<std::vector<ClockRow>> clocks(int64_t run, int suit = kSuitInView) const;
    /// Of a pose run that several bodies share, in the order of time.
    Result<std::vector<RelativeRow>> relatives(int64_t run, int suit = kSuitInView) const;
    /// Attitudes of one sensor in the order of time, of a run of kind `orientation`.
    Result<std::vector<OrientationRow>> orientations(int64_t run, int board, int suit = kSuitInView) const;

    /// Drives of robots that were recorded, and their rows in the order of time.
    Result<std::vector<RobotDriveRow>> robotDrives() const;
    Result<std::vector<RobotCommandRow>> robotCommands(const RobotDriveRow& drive) const;
    Result<std::vector<RobotStateRow>> robotStates(const RobotDriveRow& drive) const;

    /// When each foot stood as a pose run found it, kPrimaryRun: as an operator has set it. Feet without any
    /// are left out.
    Result<std::vector<FootContacts>> contacts(int64_t run, int suit = kSuitInView) const;
    /// What the operator says of the feet; nothing while that is left to the runs.
    Result<std::optional<std::vector<FootContacts>>> editedContacts(int suit = kSuitInView) const;
    /// On the skeleton of the actor that the run names, else of the one in force.
    Result<TimedMotion> poses(int64_t run, int suit = kSuitInView) const;
    /// The same, read anew, one frame at a time, whenever it is gone through. The take must outlive it.
    Result<PoseSource> poseSource(int64_t run, int suit = kSuitInView) const;

private:
    friend class TakeEdit;
    struct SuitEntry {
        Result<Suit> suit = Suit{};
        SuitClock clock;
    };

    Take() = default;
    Status checkIdentity() const;
    Status load();
    Status loadMeta();
    Status loadSuits();
    Result<std::vector<DocumentRow>> documents(const std::string& table) const;
    template <class T, class Parse>
    Result<Stored<T>> document(const std::string& table, const std::string& where, const std::string& who,
                               Parse parse) const;
    Result<Actor> referenceActor(int suit) const;
    PoseSource timedPoses(Skeleton skeleton, const std::string& table, const std::string& filter,
                          int suit) const;
    Result<RunOfTake> runOfTake(int64_t run, int suit) const;
    int seen(int suit) const { return suit == kSuitInView ? view_ : suit; }
    Result<TakeSubject> subjectFrom(const nlohmann::json& entry) const;
    std::vector<TakeSubject> subjectsByActor(const std::vector<DocumentRow>& actors) const;
    Error unusable(const std::string& what, const std::string& remedy) const;
    std::string ofSuit(const std::string& table, int suit) const;  ///< " WHERE suit=N"
    Result<std::vector<Pulse>> pulsesWhere(const std::string& filter, int suit) const;
    Status forEachBlockWhere(const std::string& filter, int suit, const BlockSink& sink) const;

    std::unique_ptr<Database> database_;  ///< on the heap: cursors and edits refer to them
    std::unique_ptr<TakeSchema> schema_;
    std::unique_ptr<SkipLog> log_;
    std::map<std::string, std::string> meta_;
    TakeHeader header_;
    std::map<int, SuitEntry> suits_;
    int view_ = 1;
};

}  // namespace noctule
