// SPDX-License-Identifier: Apache-2.0
#include "core/processing/inspect_take.h"

#include <algorithm>
#include <cmath>

#include "core/job/limits.h"
#include "core/job/outside_text.h"
#include "core/job/problems.h"
#include "core/processing/ingredients.h"
#include "core/processing/take_quality.h"
#include "core/report/range_statistics.h"

namespace noctule {
namespace {

constexpr int kClipped = 32767;

/// Looks at the suit that is in view. `who` begins sentences that are true of one suit only; `share` is its
/// part of the work, from 0 to 1.
class SuitInspector {
public:
    SuitInspector(const Take& take, const std::vector<DerivedRun>& runs, std::string who,
                  std::pair<double, double> share, Problems& problems, const JobContext& job)
        : take_(take),
          runs_(runs),
          who_(std::move(who)),
          share_(std::move(share)),
          problems_(problems),
          job_(job) {}

    /// Anchors keep still: the readings of a room's boards say nothing of its quality.
    SuitInspection inspect(bool is_room) {
        readDocuments();
        readRows();
        listen();
        if (!is_room)
            judgeBoards();
        judgePairs();
        return std::move(in_);
    }

private:
    template <class T>
    std::optional<T> keep(Result<T> result) {
        return problems_.keep(std::move(result));
    }

    /// The last document in force, read to see that it is one.
    template <class T>
    std::string inForce(const Result<std::vector<DocumentRow>>& rows,
                        Result<Stored<T>> (Take::*read)(int) const) {
        const auto documents = keep(rows);
        if (!documents || std::ranges::count(*documents, take_.viewed(), &DocumentRow::suit) == 0)
            return "";
        const auto document = keep((take_.*read)(kSuitInView));
        if (!document)
            return "";
        std::string text = std::to_string(document->id);
        for (const DocumentRow& row : *documents)
            if (row.id == document->id && !row.created_utc.empty())
                text += " of " + row.created_utc;
        return text;
    }

    void readDocuments() {
        const int64_t samples = keep(take_.sampleCount()).value_or(0);
        if (take_.header().sample_rate_hz > 0)
            in_.duration_s =
                static_cast<double>(samples) / static_cast<double>(take_.header().sample_rate_hz);
        if (!take_.suitIds().empty())
            suit_ = keep(take_.suit());
        if (suit_) {
            in_.suit_name = suit_->name;
            for (const Board& board : suit_->boards)
                in_.boards.push_back(board.id);
            for (const Source& source : suit_->sources)
                in_.sources.push_back(source.id);
        }
        in_.calibration = inForce(take_.calibrations(), &Take::calibrationInForce);
        in_.actor = inForce(take_.actors(), &Take::actorInForce);
        judgeCalibration();
    }

    void judgeCalibration() {
        if (!suit_)
            return;
        const auto stored = in_.calibration.empty() ? std::nullopt : keep(take_.calibrationInForce());
        calibration_ = stored ? stored->value : nominalCalibration(*suit_);
        in_.lack = lackOfTake(take_, *suit_, calibration_);
        if (in_.lack.isNone())
            return;
        const bool is_usable = gradeOf(in_.lack, "AGD") != Grade::kNotUsable;
        const std::string sentence =
            is_usable ? lackSentence(in_.lack) : "Not usable: " + lackClause(in_.lack);
        problems_.add(who_ + sentence);
    }

    void readRows() {
        in_.pulses = static_cast<int64_t>(keep(take_.pulses()).value_or(std::vector<Pulse>{}).size());
        in_.gaps = keep(take_.gaps()).value_or(std::vector<GapRow>{});
        in_.markers = keep(take_.markers()).value_or(std::vector<MarkerRow>{});
        in_.status = keep(take_.statusRows()).value_or(std::vector<StatusRow>{});
        if (keep(take_.hasRows("reference")).value_or(false))
            if (const auto reference = keep(take_.reference()))
                in_.reference_frames = std::ssize(reference->frames);
        if (const auto root = keep(take_.externalRoot()))
            in_.external_root_rows = std::ssize(*root);
    }

    void listen() {
        if (take_.level() != TakeLevel::kSignal)
            return;
        const auto boards = static_cast<size_t>(keep(take_.boardCount()).value_or(0));
        if (boards == 0)
            return;
        for (size_t b = 0; b < boards; ++b)
            in_.wires.push_back({b < in_.boards.size() ? in_.boards[b] : std::to_string(b + 1)});
        int64_t end = 0;
        keep(take_.forEachBlock(kSuitInView, [&](const AdcBlock& block) {
            in_.hole_samples += std::max<int64_t>(0, block.first_sample - end);
            const auto samples = static_cast<int64_t>(block.values.size() / boards);
            end = block.first_sample + samples;
            ++in_.blocks;
            in_.block_samples += samples;
            listen(block.values);
            if (in_.duration_s > 0) {
                const double part = static_cast<double>(end) /
                                    static_cast<double>(take_.header().sample_rate_hz) / in_.duration_s;
                job_.progress(std::lerp(share_.first, share_.second, part), "Listening");
            }
            return !job_.cancelled();
        }));
    }

    void listen(std::span<const int16_t> values) {
        const size_t boards = in_.wires.size();
        for (size_t i = 0; i < values.size(); i += boards)
            for (size_t b = 0; b < boards; ++b) {
                WireQuality& wire = in_.wires[b];
                const int value = values[i + b];
                ++wire.samples;
                wire.clipped += value >= kClipped || value <= -kClipped;
                wire.silent = wire.silent && value == 0;
            }
    }

    /// The last run of a kind; of readings takes without one the primary rows.
    std::optional<int64_t> lastRun(const char* kind) const {
        std::optional<int64_t> last;
        if (take_.level() == TakeLevel::kReadings)
            last = kPrimaryRun;
        for (const DerivedRun& run : runs_)
            if (run.kind == kind)
                last = run.run;
        return last;
    }

    void judgeBoards() {
        if (const auto run = lastRun("inertial"); run && suit_)
            in_.board_quality =
                keep(boardQuality(take_, *suit_, calibration_, *run)).value_or(std::vector<ReportBoard>{});
    }

    void judgePairs() {
        const auto run = lastRun("range");
        if (!run || !suit_)
            return;
        const auto pairs = keep(pairQuality(take_, *suit_, run, nullptr, nullptr, job_));
        if (!pairs)
            return;
        for (const ReportPair& pair : *pairs) {
            const RangeStatistics statistics = rangeStatistics(pair);
            const auto pulses = static_cast<double>(std::max<int64_t>(1, statistics.pulses()));
            in_.pairs.push_back({in_.sources[static_cast<size_t>(pair.source)],
                                 in_.boards[static_cast<size_t>(pair.board)],
                                 static_cast<double>(statistics.heard()) / pulses, statistics.usedShare(),
                                 statistics.meanConfidence()});
        }
    }

    const Take& take_;
    const std::vector<DerivedRun>& runs_;
    std::string who_;
    std::pair<double, double> share_;
    Problems& problems_;
    const JobContext& job_;
    SuitInspection in_;
    std::optional<Suit> suit_;
    Calibration calibration_;  ///< in force, else the nominal one
};

std::string metaEntry(const Take& take, const char* key) {
    const auto found = take.meta().find(key);
    return found == take.meta().end() ? "" : found->second;
}

/// What is true of the take whatever suit is in view.
void readHead(const Take& take, TakeInspection& in, Problems& problems) {
    in.path = take.path();
    in.state = metaEntry(take, "state");
    in.performer = metaEntry(take, "performer");
    in.level = take.level();
    in.missing = problems.keep(take.missingParts()).value_or(std::vector<std::string>{});
    in.notes = problems.keep(take.notes()).value_or(std::vector<NoteRow>{});
    if (in.state == "recording")
        problems.add("The take was never closed: it is being recorded, or the recording was cut short.");
}

void readDrives(const Take& take, TakeInspection& in, Problems& problems, const JobContext& job) {
    const auto rows = problems.keep(take.robotDrives()).value_or(std::vector<RobotDriveRow>{});
    for (const RobotDriveRow& row : rows) {
        if (job.cancelled() || in.drives.size() >= limits::kListedRows)
            return;
        if (const auto drive = problems.keep(readRecordedDrive(take, row.drive)))
            in.drives.push_back(summaryOf(*drive));
    }
}

/// Every suit of a take with several, with the first performer's part as that of the whole.
void inspectSuits(Take& take, TakeInspection& in, Problems& problems, const JobContext& job) {
    const auto subjects = problems.keep(take.subjects()).value_or(std::vector<TakeSubject>{});
    const auto first = std::ranges::find(subjects, false, &TakeSubject::room);
    const int shown = first == subjects.end() ? 1 : first->suit();
    const std::vector<int> suits = take.suitIds();
    const bool several = suits.size() > 1;
    for (size_t i = 0; several && i < suits.size() && !job.cancelled(); ++i) {
        SuitSummary summary;
        summary.suit = suits[i];
        for (const TakeSubject& subject : subjects)
            if (std::ranges::count(subject.suits, summary.suit) > 0) {
                summary.subject = subject.name;
                summary.room = subject.room;
            }
        take.view(summary.suit);
        summary.carrier_hz = take.header().drive_hz;
        const std::string who = summary.room              ? "The room"
                                : summary.subject.empty() ? "Suit " + std::to_string(summary.suit)
                                                          : summary.subject;
        const auto count = static_cast<double>(suits.size());
        const std::pair share{static_cast<double>(i) / count, static_cast<double>(i + 1) / count};
        static_cast<SuitInspection&>(summary) =
            SuitInspector(take, in.runs, who + ": ", share, problems, job).inspect(summary.room);
        if (summary.suit == shown)
            static_cast<SuitInspection&>(in) = summary;
        in.suits.push_back(std::move(summary));
    }
    take.view(shown);
    in.header = take.header();
    if (!several)
        static_cast<SuitInspection&>(in) =
            SuitInspector(take, in.runs, "", {0, 1}, problems, job).inspect(false);
    const auto isFollowed = [](const SuitInspection& suit) { return suit.reference_frames > 0; };
    if (isFollowed(in) || std::ranges::any_of(in.suits, isFollowed))
        in.reference_kind = shortText(metaEntry(take, "reference_kind"), limits::kName);
}

/// Lists that are cut short, and rows that could not be read.
void nameWhatIsLeftOut(const Take& take, const TakeInspection& in, Problems& problems) {
    size_t gaps = in.suits.empty() ? in.gaps.size() : 0, markers = in.suits.empty() ? in.markers.size() : 0;
    for (const SuitSummary& suit : in.suits) {
        gaps = std::max(gaps, suit.gaps.size());
        markers = std::max(markers, suit.markers.size());
    }
    for (const auto& [rows, what] : {std::pair(gaps, "gaps"), std::pair(markers, "markers"),
                                     std::pair(in.notes.size(), "notes"), std::pair(in.runs.size(), "runs")})
        if (rows > limits::kListedRows)
            problems.add("Of " + std::to_string(rows) + " " + what + " only the first " +
                         std::to_string(limits::kListedRows) + " are listed.");
    for (const SkippedRows& skipped : take.skippedRows())
        problems.add(std::to_string(skipped.count) + " rows of " + skipped.table +
                     " could not be used, first " + skipped.first + ".");
}

}  // namespace

Result<TakeInspection> inspectTake(const std::string& path, const JobContext& job) {
    auto take = Take::open(path, Access::kRead, {job.cancel});
    if (!take)
        return take.error();
    TakeInspection in;
    Problems problems;
    readHead(*take, in, problems);
    in.runs = problems.keep(take->derivedRuns()).value_or(std::vector<DerivedRun>{});
    inspectSuits(*take, in, problems, job);
    readDrives(*take, in, problems, job);
    if (job.cancelled())
        return JobContext::cancelledError();
    nameWhatIsLeftOut(*take, in, problems);
    in.problems = std::move(problems).sentences();
    return in;
}

}  // namespace noctule
