// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <numeric>

#include "core/job/contract.h"
#include "core/review/review_file.h"
#include "core/review/take_review.h"

namespace noctule {
namespace {

bool wasTried(RangeFate fate) {
    return fate == RangeFate::kUsed || fate == RangeFate::kWeighted || fate == RangeFate::kGated;
}

void append(PairTrack& track, double t_s, const RangeMeasurement& range) {
    track.t_s.push_back(t_s);
    track.distance_m.push_back(static_cast<float>(range.distance_m));
    track.confidence.push_back(static_cast<float>(range.confidence()));
    track.sigma_m.push_back(static_cast<float>(range.sigma_m));
    track.innovation_m.push_back(wasTried(range.fate) ? static_cast<float>(range.innovation_m)
                                                      : std::numeric_limits<float>::quiet_NaN());
    track.fate.push_back(range.fate);
}

template <class T>
void reorder(std::vector<T>& values, const std::vector<size_t>& order) {
    std::vector<T> sorted;
    sorted.reserve(values.size());
    for (const size_t i : order)
        sorted.push_back(values[i]);
    values = std::move(sorted);
}

/// Calls visit(column of the first track, same column of the second, ...).
template <class Visit, class... Track>
void forEachColumn(Visit visit, Track&... tracks) {
    visit(tracks.t_s...), visit(tracks.distance_m...), visit(tracks.confidence...);
    visit(tracks.sigma_m...), visit(tracks.innovation_m...), visit(tracks.fate...);
}

/// Pulses of other programs may be numbered in another order than they were sent.
void sortByTime(PairTrack& track) {
    if (std::is_sorted(track.t_s.begin(), track.t_s.end()))
        return;
    std::vector<size_t> order(track.t_s.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return track.t_s[a] < track.t_s[b]; });
    forEachColumn([&order](auto& column) { reorder(column, order); }, track);
}

/// First and last id of the pulses of the stretch; the first and the last stretch have no end, for ranges
/// whose pulse is not there.
std::pair<int64_t, int64_t> pulsesOf(const TakeStretch& stretch, const std::vector<Pulse>& pulses) {
    std::vector<int64_t> ids;
    ids.reserve(pulses.size());
    for (const Pulse& pulse : pulses)
        ids.push_back(pulse.id);
    std::sort(ids.begin(), ids.end());
    using Limits = std::numeric_limits<int64_t>;
    const auto begin = [&](int index) {
        if (index == 0)
            return Limits::min();
        const size_t first = ids.size() * static_cast<size_t>(index) / static_cast<size_t>(stretch.count);
        return first < ids.size() ? ids[first] : Limits::max();
    };
    const bool is_last = stretch.index + 1 == stretch.count;
    return {begin(stretch.index), is_last ? Limits::max() : begin(stretch.index + 1) - 1};
}

/// Boards of `file`, sources and pulses of `sender`.
Result<RangeTable> emptyTable(const ReviewFile& file, const ReviewFile& sender,
                              const std::vector<Pulse>& pulses) {
    const auto boards = file.take.boardCount();
    if (!boards)
        return boards.error();
    const auto sources = sender.take.sourceCount();
    if (!sources)
        return sources.error();
    RangeTable table{*sources, *boards, {}, {}};
    table.pairs.resize(static_cast<size_t>(*sources * *boards));
    table.pulse_t_s.resize(static_cast<size_t>(*sources));
    for (const Pulse& pulse : pulses)
        table.pulse_t_s[static_cast<size_t>(pulse.source)].push_back(
            sender.seconds(static_cast<double>(pulse.sample)));
    return table;
}

/// How far the reading has come, in seconds of all the stretches.
struct ReadSoFar {
    RowProgress progress;
    double duration_s;
    TakeStretch stretch;

    bool at(double t_s) { return progress.at(t_s * stretch.count - duration_s * stretch.index); }
};

void append(RangeTable& table, double t_s, const RangeMeasurement& range) {
    append(table.pairs[static_cast<size_t>(range.source * table.board_count + range.board)], t_s, range);
}

Status readOwn(const ReviewFile& file, int64_t run, std::pair<int64_t, int64_t> ids, RangeTable& table,
               ReadSoFar& so_far) {
    auto ranges = file.take.rangesOfPulses(run, ids.first, ids.second);
    if (!ranges)
        return ranges.error();
    while (true) {
        const auto range = ranges->next();
        if (!range)
            return range.error();
        if (!*range)
            return Done{};
        const double t_s = file.seconds(static_cast<double>((*range)->pulse_sample));
        append(table, t_s, **range);
        if (!so_far.at(t_s))
            return JobContext::cancelledError();
    }
}

/// What the boards heard of another suit.
Status readCrossing(const ReviewFile& file, const ReviewFile& sender, int64_t run,
                    std::pair<int64_t, int64_t> ids, RangeTable& table, ReadSoFar& so_far) {
    bool cancelled = false;
    const Status walked = file.take.forEachCrossRange(run, file.suit, [&](const Take::CrossRange& cross) {
        const RangeMeasurement& range = cross.range;
        const double t_s = sender.seconds(static_cast<double>(range.pulse_sample));
        if (cross.from_suit == sender.suit && range.pulse >= ids.first && range.pulse <= ids.second)
            append(table, t_s, range);
        cancelled = !so_far.at(t_s);
        return !cancelled;
    });
    return cancelled ? Status(JobContext::cancelledError()) : walked;
}

}  // namespace

Result<RangeTable> loadRanges(const TakeView& view, int64_t run, const JobContext& job,
                              const TakeStretch& stretch) {
    require(stretch.index >= 0 && stretch.index < stretch.count, "a stretch that the take does not have");
    const auto file = ReviewFile::open(view);
    if (!file)
        return file.error();
    const bool crosses = view.sources_of != kSuitInView && view.sources_of != file->suit;
    const auto sender = ReviewFile::open({view.path, crosses ? view.sources_of : file->suit});
    if (!sender)
        return sender.error();
    const auto pulses = sender->take.pulses();
    if (!pulses)
        return pulses.error();
    auto table = emptyTable(*file, *sender, *pulses);
    if (!table)
        return table;
    const auto ids = pulsesOf(stretch, *pulses);
    const auto samples = file->take.sampleCount();
    const double duration_s = samples ? file->seconds(static_cast<double>(*samples)) : 0;
    ReadSoFar so_far{RowProgress(job, "Loading ranges", duration_s), duration_s, stretch};
    const Status read = crosses ? readCrossing(*file, *sender, run, ids, *table, so_far)
                                : readOwn(*file, run, ids, *table, so_far);
    if (!read)
        return read.error();
    for (PairTrack& track : table->pairs)
        sortByTime(track);
    return table;
}

RangeTable joinRanges(std::vector<RangeTable> stretches) {
    require(!stretches.empty(), "no ranges to be joined");
    RangeTable whole = std::move(stretches.front());
    for (size_t i = 1; i < stretches.size(); ++i)
        for (size_t pair = 0; pair < whole.pairs.size(); ++pair)
            forEachColumn([](auto& to, const auto& more) { to.insert(to.end(), more.begin(), more.end()); },
                          whole.pairs[pair], stretches[i].pairs[pair]);
    for (PairTrack& track : whole.pairs)
        sortByTime(track);
    return whole;
}

}  // namespace noctule
