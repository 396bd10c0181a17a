// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <numeric>

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

/// Pulses of other programs may be numbered in another order than they were sent.
void sortByTime(PairTrack& track) {
    if (std::is_sorted(track.t_s.begin(), track.t_s.end()))
        return;
    std::vector<size_t> order(track.t_s.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return track.t_s[a] < track.t_s[b]; });
    reorder(track.t_s, order);
    reorder(track.distance_m, order), reorder(track.confidence, order);
    reorder(track.sigma_m, order), reorder(track.innovation_m, order);
    reorder(track.fate, order);
}

Result<RangeTable> emptyTable(const ReviewFile& file) {
    const auto boards = file.take.boardCount();
    if (!boards)
        return boards.error();
    const auto sources = file.take.sourceCount();
    if (!sources)
        return sources.error();
    const auto pulses = file.take.pulses();
    if (!pulses)
        return pulses.error();
    RangeTable table{*sources, *boards, {}, {}};
    table.pairs.resize(static_cast<size_t>(*sources * *boards));
    table.pulse_t_s.resize(static_cast<size_t>(*sources));
    for (const Pulse& pulse : *pulses)
        table.pulse_t_s[static_cast<size_t>(pulse.source)].push_back(
            file.seconds(static_cast<double>(pulse.sample)));
    return table;
}

}  // namespace

Result<RangeTable> loadRanges(const std::string& path, int64_t run, const JobContext& job) {
    const auto file = ReviewFile::open(path);
    if (!file)
        return file.error();
    auto table = emptyTable(*file);
    if (!table)
        return table;
    auto ranges = file->take.ranges(run);
    if (!ranges)
        return ranges.error();
    const auto samples = file->take.sampleCount();
    RowProgress progress(job, "Loading ranges", samples ? file->seconds(static_cast<double>(*samples)) : 0);
    while (true) {
        const auto range = ranges->next();
        if (!range)
            return range.error();
        if (!*range)
            break;
        const double t_s = file->seconds(static_cast<double>((*range)->pulse_sample));
        const int pair = (*range)->source * table->board_count + (*range)->board;
        append(table->pairs[static_cast<size_t>(pair)], t_s, **range);
        if (!progress.at(t_s))
            return JobContext::cancelledError();
    }
    for (PairTrack& track : table->pairs)
        sortByTime(track);
    return table;
}

}  // namespace noctule
