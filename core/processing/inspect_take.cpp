// SPDX-License-Identifier: Apache-2.0
#include "core/processing/inspect_take.h"

#include <algorithm>

#include "core/job/limits.h"
#include "core/math/json.h"
#include "core/processing/ingredients.h"
#include "core/processing/take_quality.h"
#include "core/report/range_statistics.h"

namespace noctule {
namespace {

constexpr int kClipped = 32767;

class Inspector {
public:
    Inspector(const Take& take, const JobContext& job) : take_(take), job_(job) {}

    Result<TakeInspection> inspect() {
        readHead();
        readRows();
        readDrives();
        listen();
        judgeBoards();
        judgePairs();
        if (job_.cancelled())
            return JobContext::cancelledError();
        for (const auto& [rows, what] :
             {std::pair(in_.gaps.size(), "gaps"), std::pair(in_.markers.size(), "markers"),
              std::pair(in_.notes.size(), "notes"), std::pair(in_.runs.size(), "runs")})
            if (rows > limits::kListedRows)
                in_.problems.push_back("Of " + std::to_string(rows) + " " + what + " only the first " +
                                       std::to_string(limits::kListedRows) + " are listed.");
        for (const SkippedRows& skipped : take_.skippedRows())
            in_.problems.push_back(std::to_string(skipped.count) + " rows of " + skipped.table +
                                   " could not be used, first " + skipped.first + ".");
        return std::move(in_);
    }

private:
    /// The value, or nothing and a problem noted (once).
    template <class T>
    std::optional<T> keep(Result<T> result) {
        if (result)
            return std::move(*result);
        const std::string problem = result.error().text() + ".";
        if (std::find(in_.problems.begin(), in_.problems.end(), problem) == in_.problems.end())
            in_.problems.push_back(problem);
        return std::nullopt;
    }

    std::string meta(const char* key) const {
        const auto found = take_.meta().find(key);
        return found == take_.meta().end() ? "" : found->second;
    }

    /// The last document in force, read to see that it is one.
    template <class T>
    std::string inForce(const Result<std::vector<DocumentRow>>& rows,
                        Result<Stored<T>> (Take::*read)(int) const) {
        const auto documents = keep(rows);
        if (!documents || documents->empty())
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

    void readHead() {
        in_.path = take_.path();
        in_.header = take_.header();
        in_.state = meta("state");
        in_.performer = meta("performer");
        in_.level = take_.level();
        in_.missing = keep(take_.missingParts()).value_or(std::vector<std::string>{});
        const int64_t samples = keep(take_.sampleCount()).value_or(0);
        if (in_.header.sample_rate_hz > 0)
            in_.duration_s = static_cast<double>(samples) / static_cast<double>(in_.header.sample_rate_hz);
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
        if (gradeOf(in_.lack, "AGD") == Grade::kNotUsable)
            in_.problems.push_back("Not usable: " + lackClause(in_.lack));
        else if (!in_.lack.isNone())
            in_.problems.push_back(lackSentence(in_.lack));
    }

    void readRows() {
        in_.pulses = static_cast<int64_t>(keep(take_.pulses()).value_or(std::vector<Pulse>{}).size());
        in_.gaps = keep(take_.gaps()).value_or(std::vector<GapRow>{});
        in_.markers = keep(take_.markers()).value_or(std::vector<MarkerRow>{});
        in_.notes = keep(take_.notes()).value_or(std::vector<NoteRow>{});
        in_.status = keep(take_.statusRows()).value_or(std::vector<StatusRow>{});
        in_.runs = keep(take_.derivedRuns()).value_or(std::vector<DerivedRun>{});
        if (const auto reference = keep(take_.reference()))
            in_.reference_frames = static_cast<int64_t>(reference->frames.size());
        if (in_.reference_frames > 0)
            in_.reference_kind = meta("reference_kind");
        if (const auto root = keep(take_.externalRoot()))
            in_.external_root_rows = static_cast<int64_t>(root->size());
        if (in_.state == "recording")
            in_.problems.push_back(
                "The take was never closed: it is being recorded, or the recording was cut short.");
    }

    void readDrives() {
        for (const RobotDriveRow& row : keep(take_.robotDrives()).value_or(std::vector<RobotDriveRow>{})) {
            if (job_.cancelled() || in_.drives.size() >= limits::kListedRows)
                return;
            if (const auto drive = keep(readRecordedDrive(take_, row.drive)))
                in_.drives.push_back(summaryOf(*drive));
        }
    }

    void listen() {
        if (in_.level != TakeLevel::kSignal)
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
            if (in_.duration_s > 0)
                job_.progress(static_cast<double>(end) / static_cast<double>(in_.header.sample_rate_hz) /
                                  in_.duration_s,
                              "Listening");
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
        if (in_.level == TakeLevel::kReadings)
            last = kPrimaryRun;
        for (const DerivedRun& run : in_.runs)
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
    const JobContext& job_;
    TakeInspection in_;
    std::optional<Suit> suit_;
    Calibration calibration_;  ///< in force, else the nominal one
};

template <class Rows>
int64_t sizeOf(const Result<Rows>& rows, std::vector<std::string>& problems) {
    if (rows)
        return std::ssize(*rows);
    problems.push_back(rows.error().text() + ".");
    return 0;
}

/// The suit that is in view.
SuitSummary summariseSuit(const Take& take, std::vector<std::string>& problems) {
    SuitSummary summary;
    summary.suit = take.viewed();
    summary.carrier_hz = take.header().drive_hz;
    if (const auto suit = take.suit()) {
        summary.name = suit->name;
        summary.boards = suit->boards.size();
        summary.sources = suit->sources.size();
    }
    summary.pulses = sizeOf(take.pulses(), problems);
    summary.status_rows = sizeOf(take.statusRows(), problems);
    summary.external_root_rows = sizeOf(take.externalRoot(), problems);
    if (const auto there = take.hasRows("reference"); there && *there) {
        const auto reference = take.reference();
        summary.reference_frames = reference ? std::ssize(reference->frames) : 0;
        if (!reference)
            problems.push_back(reference.error().text() + ".");
    }
    const Status read = take.forEachBlock(kSuitInView, [&](const AdcBlock&) {
        ++summary.blocks;
        return true;
    });
    if (!read)
        problems.push_back(read.error().text() + ".");
    return summary;
}

/// Of a take with one suit none: it is described anyway.
std::vector<SuitSummary> summariseSuits(Take& take, std::vector<std::string>& problems) {
    std::vector<SuitSummary> suits;
    const auto subjects = take.subjects();
    if (!subjects)
        problems.push_back(subjects.error().text() + ".");
    if (take.suitIds().size() < 2)
        return suits;
    for (const int suit : take.suitIds()) {
        take.view(suit);
        suits.push_back(summariseSuit(take, problems));
        if (!subjects)
            continue;
        for (const TakeSubject& subject : *subjects)
            if (std::ranges::count(subject.suits, suit) > 0) {
                suits.back().subject = subject.name;
                suits.back().room = subject.room;
            }
    }
    return suits;
}

nlohmann::json suitJson(const SuitSummary& suit) {
    return {{"suit", suit.suit},
            {"name", suit.name},
            {"subject", suit.subject.empty() ? nlohmann::json(nullptr) : nlohmann::json(suit.subject)},
            {"room", suit.room},
            {"boards", suit.boards},
            {"sources", suit.sources},
            {"carrier_hz", suit.carrier_hz},
            {"blocks", suit.blocks},
            {"pulses", suit.pulses},
            {"status_rows", suit.status_rows},
            {"reference_frames", suit.reference_frames},
            {"external_root_rows", suit.external_root_rows}};
}

template <class T, class ToJson>
nlohmann::json list(const std::vector<T>& values, ToJson toJson) {
    nlohmann::json array = nlohmann::json::array();
    for (size_t i = 0; i < std::min(values.size(), limits::kListedRows); ++i)
        array.push_back(toJson(values[i]));
    return array;
}

nlohmann::json textOrNull(const std::string& text) {
    return text.empty() ? nlohmann::json(nullptr) : nlohmann::json(text);
}

nlohmann::json rowsJson(const TakeInspection& in) {
    using nlohmann::json;
    const auto optional = [](const auto& value) { return value ? json(*value) : json(nullptr); };
    return {{"gaps", list(in.gaps,
                          [&](const GapRow& gap) {
                              return json{{"first_sample", gap.first_sample},
                                          {"sample_count", gap.sample_count},
                                          {"board", optional(gap.board)},
                                          {"reason", gap.reason}};
                          })},
            {"markers",
             list(in.markers,
                  [](const MarkerRow& marker) {
                      return json{{"sample", marker.sample}, {"kind", marker.kind}, {"label", marker.label}};
                  })},
            {"notes", list(in.notes,
                           [](const NoteRow& note) {
                               return json{{"created_utc", note.created_utc}, {"text", note.text}};
                           })},
            {"drives", list(in.drives, [](const DriveSummary& drive) { return toJson(drive); })},
            {"runs", list(in.runs, [](const DerivedRun& run) {
                 const json settings = noctule::json::parse(run.settings_json);
                 return json{{"run", run.run},
                             {"kind", run.kind},
                             {"name", run.name},
                             {"created_utc", run.created_utc},
                             {"software", run.software},
                             {"settings", settings.is_discarded() ? json(nullptr) : settings}};
             })}};
}

nlohmann::json qualityJson(const TakeInspection& in) {
    using nlohmann::json;
    return {{"sound", list(in.wires,
                           [](const WireQuality& wire) {
                               return json{{"board", wire.board},
                                           {"samples", wire.samples},
                                           {"clipped", wire.clipped},
                                           {"silent", wire.silent}};
                           })},
            {"inertia", list(in.board_quality,
                             [](const ReportBoard& board) {
                                 return json{{"board", board.id},
                                             {"frames_expected", board.frames_expected},
                                             {"frames_lost", board.frames_lost},
                                             {"readings_expected", board.readings_expected},
                                             {"readings_present", board.readings_present},
                                             {"clipped", board.clipped_gyro + board.clipped_accel},
                                             {"corrected_bits", board.corrected_bits}};
                             })},
            {"pairs", list(in.pairs, [](const PairSummary& pair) {
                 return json{{"source", pair.source},
                             {"board", pair.board},
                             {"heard_share", pair.heard_share},
                             {"used_share", pair.used_share},
                             {"confidence", pair.confidence}};
             })}};
}

}  // namespace

Result<TakeInspection> inspectTake(const std::string& path, const JobContext& job) {
    auto take = Take::open(path, Access::kRead, {job.cancel});
    if (!take)
        return take.error();
    std::vector<std::string> problems;
    const std::vector<SuitSummary> suits = summariseSuits(*take, problems);
    // The first performer: suit 1 may be the room.
    const auto subjects = take->subjects();
    const auto first =
        subjects ? std::ranges::find(*subjects, false, &TakeSubject::room) : decltype(subjects->begin()){};
    take->view(subjects && first != subjects->end() ? first->suit() : 1);
    auto inspection = Inspector(*take, job).inspect();
    if (!inspection)
        return inspection;
    inspection->suits = suits;
    inspection->problems.insert(inspection->problems.end(), problems.begin(), problems.end());
    return inspection;
}

nlohmann::json toJson(const TakeInspection& in) {
    nlohmann::json json = {
        {"take", in.path},
        {"name", in.header.name},
        {"uuid", in.header.uuid},
        {"created_utc", in.header.created_utc},
        {"software", in.header.software},
        {"kind", in.header.take_kind},
        {"state", textOrNull(in.state)},
        {"performer", textOrNull(in.performer)},
        {"level", in.level == TakeLevel::kReadings ? "readings" : "signal"},
        {"duration_s", in.duration_s},
        {"sample_rate_hz", in.header.sample_rate_hz},
        {"suit", textOrNull(in.suit_name)},
        {"boards", in.boards},
        {"sources", in.sources},
        {"calibration", textOrNull(in.calibration)},
        {"actor", textOrNull(in.actor)},
        {"not_calibrated", textOrNull(lackInWords(in.lack))},
        {"blocks", in.blocks},
        {"block_samples", in.block_samples},
        {"hole_samples", in.hole_samples},
        {"pulses", in.pulses},
        {"reference", {{"frames", in.reference_frames}, {"kind", textOrNull(in.reference_kind)}}},
        {"external_root_rows", in.external_root_rows},
        {"quality", qualityJson(in)},
        {"missing", in.missing},
        {"problems", in.problems}};
    if (!in.suits.empty())
        json["suits"] = list(in.suits, suitJson);
    json.update(rowsJson(in));
    return json;
}

}  // namespace noctule
