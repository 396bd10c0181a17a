// SPDX-License-Identifier: Apache-2.0
// What can be asked of a TakeDocument, part by part.
#include <future>

#include "core/processing/evaluate_take.h"
#include "ui/models/take_document_loading.h"

namespace noctule::ui {
namespace {

/// Shares the life of the whole.
template <class Whole, class T>
std::shared_ptr<const T> partOf(const std::shared_ptr<const Whole>& whole, T Whole::*member) {
    return whole ? std::shared_ptr<const T>(whole, &(whole.get()->*member)) : nullptr;
}

/// One thread of SQLite reads half a million rows in a second: two read a half each; the later tells the
/// progress.
Result<RangeTable> loadRangesByTwo(const TakeView& view, int64_t run, const JobContext& job) {
    const JobContext silent{nullptr, job.cancel};
    auto other = std::async(std::launch::async,
                            [&] { return loadRanges(view, run, silent, {.index = 0, .count = 2}); });
    auto mine = loadRanges(view, run, job, {.index = 1, .count = 2});
    auto others = other.get();
    if (!mine || !others)
        return mine ? others : mine;
    std::vector<RangeTable> both;
    both.push_back(std::move(*others));
    both.push_back(std::move(*mine));
    return joinRanges(std::move(both));
}

}  // namespace

std::optional<int64_t> TakeDocument::runOf(Whose whose) const {
    if (whose == Whose::kReference)
        return isOpen() && overview_->has_reference ? std::optional<int64_t>(kReference) : std::nullopt;
    return runNumber(whose == Whose::kShown ? shown_ : compared_);
}

bool TakeDocument::hasMotion(int suit) const {
    const TakeParty* party = overview_->partyOf(suit);
    return !party || !party->lost_in_rest_s;
}

std::shared_ptr<const TimedMotion> TakeDocument::motion(std::optional<int64_t> run) {
    if (!run || (*run != kReference && !hasMotion(overview_->suit_in_view)))
        return nullptr;
    const auto number = *run == kReference ? std::nullopt : run;
    return ask<int64_t, TimedMotion>(
        motions_, *run, tr("Loading the motion"), &TakeDocument::motionLoaded,
        [view = view(), number](const JobContext& job) { return loadPoses(view, number, job); });
}

std::shared_ptr<const TimedMotion> TakeDocument::motionOf(int subject) {
    const auto run = runOf(Whose::kShown);
    if (!run || subject < 0 || subject >= static_cast<int>(subjects().size()))
        return nullptr;
    if (subject == this->subject())
        return shownMotion();
    const int suit = subjects()[static_cast<size_t>(subject)].suit();
    if (!hasMotion(suit))
        return nullptr;
    return ask<std::pair<int64_t, int>, TimedMotion>(
        others_, {*run, suit}, tr("Loading the motion"), &TakeDocument::motionChanged,
        [path = path_.toStdString(), suit, number = *run](const JobContext& job) {
            return loadPoses({path, suit}, number, job);
        });
}

std::shared_ptr<const std::vector<BetweenTrack>> TakeDocument::betweenTracks(int subject, int other,
                                                                             Whose whose) {
    const auto run = runOf(whose);
    if (!run || subject < 0 || other <= subject || other >= static_cast<int>(subjects().size()))
        return nullptr;
    const TakeView view{path_.toStdString(), subjects()[static_cast<size_t>(subject)].suit()};
    const int other_suit = subjects()[static_cast<size_t>(other)].suit();
    if (*run != kReference && (!hasMotion(view.suit) || !hasMotion(other_suit)))
        return nullptr;
    const auto number = *run == kReference ? std::nullopt : run;
    return ask<BetweenKey, std::vector<BetweenTrack>>(
        between_, {*run, view.suit, other_suit}, tr("Measuring between performers"),
        &TakeDocument::curvesChanged, [view, number, other_suit](const JobContext& job) {
            return loadBetween(view, number, other_suit, job);
        });
}

std::shared_ptr<const TimedMotion> TakeDocument::shownMotion() {
    return motion(runOf(Whose::kShown));
}

std::shared_ptr<const TimedMotion> TakeDocument::comparedMotion() {
    return motion(runOf(Whose::kCompared));
}

std::shared_ptr<const TimedMotion> TakeDocument::reference() {
    return motion(runOf(Whose::kReference));
}

void TakeDocument::motionLoaded() {
    showFrames();
    emit motionChanged();
    emit curvesChanged();
    judgeWhenAwaited();
}

void TakeDocument::rangesLoaded() {
    emit rangesChanged();
    emit curvesChanged();
    judgeWhenAwaited();
}

void TakeDocument::readingsLoaded() {
    emit readingsChanged();
    emit curvesChanged();
    judgeWhenAwaited();
}

void TakeDocument::showFrames() {
    const auto run = runNumber(shown_);
    const auto found = run ? motions_.find(*run) : motions_.end();
    if (found == motions_.end() || !found->second.value || found->second.value->frames.empty())
        return;
    const TimedMotion& motion = *found->second.value;
    time_.setFrames(static_cast<double>(motion.frames.front().time_ns) * 1e-9,
                    static_cast<double>(usualStep_ns(motion)) * 1e-9);
}

std::shared_ptr<const std::vector<FootContacts>> TakeDocument::contacts() {
    const ReviewRun* run = shown();
    const auto shown_motion = shownMotion();
    if (!run || !shown_motion)
        return nullptr;
    return ask<int64_t, std::vector<FootContacts>>(
        contacts_, run->run.run, tr("Looking for foot contacts"), &TakeDocument::motionChanged,
        [view = view(), run = *run, shown_motion](const JobContext&) {
            return loadContacts(view, run, *shown_motion);
        });
}

std::shared_ptr<const TakeDocument::Ranges> TakeDocument::rangesWithSummaries() {
    const ReviewRun* run = shown();
    if (!run || !run->settings.range_run)
        return nullptr;
    return ask<int64_t, Ranges>(
        ranges_, *run->settings.range_run, tr("Loading the ranges"), &TakeDocument::rangesLoaded,
        [view = view(), number = *run->settings.range_run](const JobContext& job) -> Result<Ranges> {
            auto table = view.sources_of == kSuitInView ? loadRangesByTwo(view, number, job)
                                                        : loadRanges(view, number, job);
            if (!table)
                return table.error();
            PairSummaries summaries(*table);
            return Ranges{std::move(*table), std::move(summaries)};
        });
}

std::shared_ptr<const RangeTable> TakeDocument::ranges() {
    return partOf(rangesWithSummaries(), &Ranges::table);
}

std::shared_ptr<const PairSummaries> TakeDocument::pairSummaries() {
    return partOf(rangesWithSummaries(), &Ranges::summaries);
}

std::shared_ptr<const ReadingTable> TakeDocument::readings() {
    const ReviewRun* run = shown();
    if (!run || !run->settings.inertial_run)
        return nullptr;
    return ask<int64_t, ReadingTable>(
        readings_, *run->settings.inertial_run, tr("Loading the readings"), &TakeDocument::readingsLoaded,
        [view = view(), number = *run->settings.inertial_run](const JobContext& job) {
            return loadReadings(view, number, job);
        });
}

bool TakeDocument::readsForViews() const {
    const auto runs = [](const auto& parts) {
        return std::any_of(parts.begin(), parts.end(), [](const auto& entry) { return !entry.second.ended; });
    };
    return runs(motions_) || runs(ranges_) || runs(readings_);
}

void TakeDocument::judgeWhenAwaited() {
    if (report_awaited_ && !readsForViews())
        judged();
}

/// Judging reads all of the take once more; what moves and is plotted does not wait for that, whoever asks
/// first.
std::shared_ptr<const TakeDocument::Judged> TakeDocument::judged() {
    const ReviewRun* run = shown();
    shownMotion();
    report_awaited_ = run && !reports_.contains(run->run.run) && readsForViews();
    if (!run || report_awaited_)
        return nullptr;
    EvaluateRequest request;
    request.take_path = path_.toStdString();
    request.run_number = run->run.run;
    request.suit = overview_->suit_in_view;
    return ask<int64_t, Judged>(
        reports_, run->run.run, tr("Judging the take"), &TakeDocument::reportChanged,
        [request, overview = overview_](const JobContext& job) -> Result<Judged> {
            auto report = evaluateTake(request, job);
            if (!report)
                return report.error();
            TakeVerdict verdict = judgeTake(*report);
            auto between = evaluateBetween(request, overview->subjects, job);
            if (!between)
                return between.error();
            return Judged{std::move(*report), std::move(verdict), std::move(*between)};
        });
}

std::shared_ptr<const ReportData> TakeDocument::report() {
    return partOf(judged(), &Judged::report);
}

std::shared_ptr<const TakeVerdict> TakeDocument::verdict() {
    return partOf(judged(), &Judged::verdict);
}

std::shared_ptr<const std::vector<BetweenEvaluation>> TakeDocument::between() {
    return partOf(judged(), &Judged::between);
}

std::shared_ptr<const SeriesPyramid> TakeDocument::rangeCurve(int source, int board, RangeQuantity quantity) {
    const auto table = ranges();
    if (!table || source < 0 || source >= table->source_count || board < 0 || board >= table->board_count)
        return nullptr;
    const RangeCurveKey key{*shown()->settings.range_run, source, board, quantity};
    auto curve = ask<RangeCurveKey, SeriesPyramid>(
        range_curves_, key, tr("Drawing ranges"), &TakeDocument::curvesChanged,
        [table, source, board, quantity](const JobContext&) {
            return SeriesPyramid(rangeSeries(*table, source, board, quantity));
        });
    keepNewest(range_curves_);
    return curve;
}

std::shared_ptr<const SeriesPyramid> TakeDocument::readingCurve(int board, int axis) {
    const auto table = readings();
    if (!table || board < 0 || board >= static_cast<int>(table->boards.size()) || axis < 0 || axis > 5)
        return nullptr;
    const ReadingCurveKey key{*shown()->settings.inertial_run, board, axis};
    auto curve = ask<ReadingCurveKey, SeriesPyramid>(
        reading_curves_, key, tr("Drawing readings"), &TakeDocument::curvesChanged,
        [table, board, axis](const JobContext&) {
            return SeriesPyramid(readingSeries(*table, board, axis));
        });
    keepNewest(reading_curves_);
    return curve;
}

bool TakeDocument::hasSources() const {
    return !overview_ || !overview_->suit.sources.empty() ||
           std::ranges::any_of(overview_->parties,
                               [](const TakeParty& party) { return !party.suit.sources.empty(); });
}

std::shared_ptr<const MotionCurve> TakeDocument::motionCurve(const CurveChoice& choice, Whose whose) {
    const auto run = runOf(whose);
    const auto base = motion(run);
    if (!base)
        return nullptr;
    auto curve = ask<MotionCurveKey, MotionCurve>(
        motion_curves_, {*run, choice}, tr("Drawing joint angles"), &TakeDocument::curvesChanged,
        [base, choice, overview = overview_](const JobContext&) -> Result<MotionCurve> {
            // A reference's knee may be a ball: its flexion is the actor's.
            return noctule::motionCurve(*base, choice,
                                        overview->actor ? &overview->actor->skeleton : nullptr);
        });
    keepNewest(motion_curves_);
    return curve;
}

}  // namespace noctule::ui
