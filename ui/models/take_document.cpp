// SPDX-License-Identifier: Apache-2.0
// Opening a take and choosing runs; its parts are in take_document_parts.cpp.
#include "ui/models/take_document.h"

#include <algorithm>

#include "ui/language/core_words.h"
#include "ui/models/take_document_loading.h"

namespace noctule::ui {
namespace {

/// Whether a run of an earlier overview is still the same one: numbers may be given anew.
bool isSame(const DerivedRun& a, const DerivedRun& b) {
    return a.run == b.run && a.name == b.name && a.created_utc == b.created_utc &&
           a.settings_json == b.settings_json;
}

int indexOf(const TakeOverview& overview, const DerivedRun& run) {
    const auto found = std::find_if(overview.runs.begin(), overview.runs.end(),
                                    [&](const ReviewRun& other) { return isSame(other.run, run); });
    return found == overview.runs.end() ? -1 : static_cast<int>(found - overview.runs.begin());
}

/// The newest of that name, else the newest of all.
int indexOf(const TakeOverview& overview, const std::string& name) {
    const auto newest = static_cast<int>(overview.runs.size()) - 1;
    for (int run = newest; run >= 0; --run)
        if (overview.runs[static_cast<size_t>(run)].run.name == name)
            return run;
    return newest;
}

}  // namespace

TakeDocument::TakeDocument(Jobs& jobs, TimeCursor& time, QObject* parent)
    : QObject(parent), jobs_(jobs), time_(time) {}

TakeDocument::~TakeDocument() {
    forget();
}

template <class Visit>
void TakeDocument::forEachKind(Visit visit) {
    visit(motions_), visit(contacts_), visit(ranges_), visit(readings_), visit(reports_);
    visit(range_curves_), visit(reading_curves_), visit(motion_curves_), visit(others_), visit(between_);
}

void TakeDocument::open(const QString& path, const std::string& result) {
    close();
    path_ = path;
    first_shown_ = result;
    loadOverview(view(), true);
}

void TakeDocument::close() {
    const bool was_open = isOpen();
    forget();
    path_.clear();
    if (was_open) {
        time_.setExtent(0, time_.frameStep());
        emit opened();
        emit runsChanged();
    }
}

void TakeDocument::followMove(const QString& path) {
    path_ = path;
    // What is being read would not find its file.
    forEachKind([](auto& parts) { drop(parts, [&](const auto& key) { return !parts.at(key).ended; }); });
    reload(false);
}

void TakeDocument::reload(bool show_newest) {
    if (path_.isEmpty())
        return;
    damaged_ = false;  // another file may stand there; whoever reads it tells anew
    loadOverview(view(), show_newest);
}

TakeView TakeDocument::view() const {
    TakeView view{path_.toStdString(), isOpen() ? overview_->suit_in_view : kSuitInView};
    if (isOpen() && !showsOwnPairs())
        view.sources_of = overview_->parties[static_cast<size_t>(sources_of_)].subject.suit();
    return view;
}

void TakeDocument::setSourcesOf(int party) {
    if (!isOpen() || party == sources_of_ || party < 0 ||
        party >= static_cast<int>(overview_->parties.size()))
        return;
    listenTo(party);
    emit rangesChanged();
    emit curvesChanged();
}

void TakeDocument::listenTo(int party) {
    sources_of_ = party;
    composePairSuit();
    drop(ranges_, [](int64_t) { return true; });
    drop(range_curves_, [](const RangeCurveKey&) { return true; });
}

void TakeDocument::composePairSuit() {
    auto suit = std::make_shared<Suit>(overview_->suit);
    if (!showsOwnPairs())
        suit->sources = overview_->parties[static_cast<size_t>(sources_of_)].suit.sources;
    pair_suit_ = std::move(suit);
}

const std::vector<TakeSubject>& TakeDocument::subjects() const {
    static const std::vector<TakeSubject> nobody;
    return isOpen() ? overview_->subjects : nobody;
}

int TakeDocument::subject() const {
    const auto& all = subjects();
    const auto found = std::ranges::find_if(
        all, [this](const TakeSubject& subject) { return subject.suit() == overview_->suit_in_view; });
    return found == all.end() ? 0 : static_cast<int>(found - all.begin());
}

void TakeDocument::setSubject(int index) {
    if (index >= 0 && index < static_cast<int>(subjects().size()) && index != subject())
        loadOverview({path_.toStdString(), subjects()[static_cast<size_t>(index)].suit()}, false);
}

void TakeDocument::loadOverview(const TakeView& view, bool show_newest) {
    if (overview_job_)
        overview_job_->cancel();
    const uint64_t ticket = overview_ticket_ = ++ticket_;
    overview_job_ = jobs_.start<TakeOverview>(
        {tr("Opening %1"), path_.section('/', -1)},
        [view](const JobContext& job) { return overviewTake(view, job); },
        [document = QPointer(this), ticket, show_newest](Result<TakeOverview> overview) -> QString {
            if (!document || document->overview_ticket_ != ticket)
                return {};
            if (overview)
                document->accept(std::move(*overview), show_newest);
            else
                document->refuse(overview.error());
            return {};
        },
        Jobs::Loudness::kQuiet);
}

void TakeDocument::accept(TakeOverview overview, bool show_newest) {
    const auto earlier = std::exchange(overview_, std::make_shared<const TakeOverview>(std::move(overview)));
    problem_.clear();
    const bool still_there = sources_of_ < static_cast<int>(overview_->parties.size());
    if (!earlier || overview_->suit_in_view != earlier->suit_in_view || (!showsOwnPairs() && !still_there))
        listenTo(subject());
    else
        composePairSuit();
    const auto newest = static_cast<int>(overview_->runs.size()) - 1;
    const auto same = [&](int index) {
        return index >= 0 ? indexOf(*overview_, earlier->runs[static_cast<size_t>(index)].run) : index;
    };
    if (!earlier) {
        shown_ = indexOf(*overview_, first_shown_), compared_ = -1;
        time_.setExtent(overview_->duration_s, time_.frameStep());
    } else {
        shown_ = same(shown_), compared_ = same(compared_);
        if (show_newest || shown_ < 0)
            shown_ = newest;
        if (compared_ == shown_ || (compared_ == kReference && !overview_->has_reference))
            compared_ = -1;
        forgetOutdated(*earlier);
        if (overview_->suit_in_view != earlier->suit_in_view)
            forEachKind([](auto& parts) { drop(parts, [](const auto&) { return true; }); });
        if (overview_->duration_s != earlier->duration_s) {
            const double at_s = time_.time();
            time_.setExtent(overview_->duration_s, time_.frameStep());
            time_.setTime(at_s);  // another performer at the same instant
        }
    }
    forgetUnshown();
    emit opened();
    emit runsChanged();
    if (overview_ && overview_->damage && !damaged_)
        noteDamage(path_, *overview_->damage);
}

void TakeDocument::refuse(const Error& error) {
    if (error.kind == ErrorKind::kCancelled)
        return;
    const QString path = path_;
    if (!isOpen())
        path_.clear();
    if (error.is_damage)
        noteDamage(path, error);
    else
        emit failed(coreWords(error));
}

void TakeDocument::noteDamage(const QString& path, const Error& error) {
    if (isOpen() && path == path_)
        damaged_ = true;
    emit torn(path, coreWords(error));
}

void TakeDocument::setShownRun(int index) {
    if (!isOpen() || index == shown_ || index < -1 || index >= static_cast<int>(overview_->runs.size()))
        return;
    shown_ = index;
    problem_.clear();  // of the result before
    if (compared_ == shown_)
        compared_ = -1;
    forgetUnshown();
    showFrames();
    emit runsChanged();
}

void TakeDocument::setComparedRun(int index) {
    const bool exists =
        isOpen() && (index == kReference ? overview_->has_reference
                                         : index >= -1 && index != shown_ &&
                                               index < static_cast<int>(overview_->runs.size()));
    if ((!exists && index != -1) || index == compared_)
        return;
    compared_ = index;
    forgetUnshown();
    emit runsChanged();
}

void TakeDocument::followProcessing(const QString& path, Job* job) {
    processing_[path] = job;
    connect(job, &Job::ended, this, &TakeDocument::processingChanged);
    emit processingChanged();
}

Job* TakeDocument::processing() const {
    const auto found = processing_.find(path_);
    return found != processing_.end() && found->second && found->second->state() == Job::State::kRunning
               ? found->second
               : nullptr;
}

bool TakeDocument::isLoading() const {
    bool loading = overview_job_ && overview_job_->state() == Job::State::kRunning;
    const auto look = [&](const auto& parts) {
        for (const auto& [key, part] : parts)
            loading = loading || !part.ended;
    };
    const_cast<TakeDocument*>(this)->forEachKind(look);
    return loading;
}

void TakeDocument::forget() {
    if (overview_job_)
        overview_job_->cancel();
    overview_ticket_ = 0;
    forEachKind([](auto& parts) { drop(parts, [](const auto&) { return true; }); });
    overview_ = nullptr;
    pair_suit_ = nullptr;
    problem_.clear();
    damaged_ = false;
    shown_ = compared_ = -1;
}

void TakeDocument::forgetUnshown() {
    const auto shown_run = runNumber(shown_), compared_run = runNumber(compared_);
    const ReviewRun* run = shown();
    const auto range_run = run ? run->settings.range_run : std::nullopt;
    const auto inertial_run = run ? run->settings.inertial_run : std::nullopt;
    const auto unwatched = [&](int64_t key) {
        return key != shown_run && key != compared_run && key != kReference;
    };
    drop(motions_, unwatched);
    drop(motion_curves_, [&](const MotionCurveKey& key) { return unwatched(key.run); });
    drop(others_, [&](const auto& key) { return key.first != shown_run; });
    drop(between_, [&](const BetweenKey& key) { return key.run != shown_run && key.run != kReference; });
    drop(contacts_, [&](int64_t key) { return key != shown_run; });
    drop(reports_, [&](int64_t key) { return key != shown_run; });
    drop(ranges_, [&](int64_t key) { return key != range_run; });
    drop(range_curves_, [&](const RangeCurveKey& key) { return key.run != range_run; });
    drop(readings_, [&](int64_t key) { return key != inertial_run; });
    drop(reading_curves_, [&](const ReadingCurveKey& key) { return key.run != inertial_run; });
}

void TakeDocument::forgetOutdated(const TakeOverview& earlier) {
    // The reference may be another one, and the report depends on it; contacts may be an operator's now.
    const auto gone = [&](int64_t number) {
        const auto was = std::find_if(earlier.runs.begin(), earlier.runs.end(),
                                      [&](const ReviewRun& run) { return run.run.run == number; });
        return was == earlier.runs.end() || indexOf(*overview_, was->run) < 0;
    };
    drop(motions_, gone);
    drop(motion_curves_, [&](const MotionCurveKey& key) { return gone(key.run); });
    drop(others_, [&](const auto& key) { return gone(key.first); });
    drop(between_, [&](const BetweenKey& key) { return gone(key.run); });
    drop(contacts_, [](int64_t) { return true; });
    drop(reports_, [](int64_t) { return true; });
    forEachKind([](auto& parts) {
        std::erase_if(parts, [](const auto& entry) { return entry.second.ended && !entry.second.value; });
    });
}

QString TakeDocument::numberOf(int index) const {
    const bool exists = isOpen() && index >= 0 && index < static_cast<int>(overview_->runs.size());
    return exists ? QString::number(overview_->runs[static_cast<size_t>(index)].number) : QString();
}

std::optional<int64_t> TakeDocument::runNumber(int index) const {
    if (index == kReference)
        return kReference;
    if (!isOpen() || index < 0)
        return std::nullopt;
    return overview_->runs[static_cast<size_t>(index)].run.run;
}

const ReviewRun* TakeDocument::shown() const {
    return isOpen() && shown_ >= 0 ? &overview_->runs[static_cast<size_t>(shown_)] : nullptr;
}

}  // namespace noctule::ui
