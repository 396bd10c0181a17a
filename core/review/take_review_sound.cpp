// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <map>

#include "core/review/review_file.h"
#include "core/review/take_review.h"

namespace noctule {
namespace {

constexpr float kFullScale = 32767;
constexpr double kLongestWindow_s = 10;

Result<ReviewFile> openSound(const TakeView& view, int board) {
    const std::string& path = view.path;
    auto file = ReviewFile::open(view);
    if (!file)
        return file;
    if (file->take.level() != TakeLevel::kSignal)
        return Error{ErrorKind::kUnusable, path + ": holds readings, not sound",
                     "Look at its ranges and readings instead"};
    const auto boards = file->take.boardCount();
    if (!boards)
        return boards.error();
    if (board < 0 || board >= *boards)
        return Error{ErrorKind::kUsage, path + ": has no board " + std::to_string(board + 1),
                     "Choose one of its " + std::to_string(*boards) + " boards"};
    const auto sound = file->take.hasRows("adc_block");
    if (!sound)
        return sound.error();
    if (!*sound)
        return Error{ErrorKind::kUnusable, path + ": holds no sound",
                     "Choose a take that was recorded with it"};
    return file;
}

/// Samples of one board that stand in the blocks as zeros because they were never received.
Result<std::vector<GapRow>> gapsOf(const Take& take, int board) {
    auto gaps = take.gaps();
    if (gaps)
        std::erase_if(*gaps, [&](const GapRow& gap) { return gap.board && *gap.board != board; });
    return gaps;
}

Status readSamples(const ReviewFile& file, int board, const SampleInterval& within, SoundWindow& window,
                   const JobContext& job) {
    const auto boards = static_cast<size_t>(*file.take.boardCount());
    return file.take.forEachBlock(file.suit, within, [&](const AdcBlock& block) {
        const auto samples = static_cast<int64_t>(block.values.size() / boards);
        const int64_t first = std::max(within.first, block.first_sample);
        const int64_t end = std::min(within.last + 1, block.first_sample + samples);
        for (int64_t sample = first; sample < end; ++sample) {
            const size_t place =
                static_cast<size_t>(sample - block.first_sample) * boards + static_cast<size_t>(board);
            window.value[static_cast<size_t>(sample - within.first)] =
                static_cast<float>(block.values[place]) / kFullScale;
        }
        return !job.cancelled();
    });
}

void blank(const std::vector<GapRow>& gaps, const SampleInterval& within, std::vector<float>& value) {
    for (const GapRow& gap : gaps) {
        const int64_t first = std::clamp(gap.first_sample, within.first, within.last + 1);
        const int64_t end = std::clamp(gap.first_sample + gap.sample_count, within.first, within.last + 1);
        std::fill(value.begin() + (first - within.first), value.begin() + (end - within.first), kNoValue);
    }
}

/// Arrivals at a board by pulse.
Result<std::map<int64_t, double>> arrivals(const ReviewFile& file, int board, int64_t range_run,
                                           const std::vector<Pulse>& pulses) {
    const auto [first, last] = std::minmax_element(
        pulses.begin(), pulses.end(), [](const Pulse& a, const Pulse& b) { return a.id < b.id; });
    auto ranges = file.take.rangesOfPulses(range_run, first->id, last->id);
    if (!ranges)
        return ranges.error();
    std::map<int64_t, double> arrival_s;
    while (true) {
        const auto range = ranges->next();
        if (!range)
            return range.error();
        if (!*range)
            return arrival_s;
        if ((*range)->board == board)
            arrival_s[(*range)->pulse] = file.seconds((*range)->arrival_sample);
    }
}

/// Pulses whose listening time overlaps the window.
Status addPulses(const ReviewFile& file, int board, const SampleInterval& within,
                 std::optional<int64_t> range_run, SoundWindow& window) {
    const int64_t listening = file.take.header().pulse_interval_samples;
    const auto pulses =
        file.take.pulses(file.suit, {std::max<int64_t>(0, within.first - listening + 1), within.last});
    if (!pulses)
        return pulses.error();
    std::map<int64_t, double> arrival_s;
    if (range_run && !pulses->empty()) {
        auto heard = arrivals(file, board, *range_run, *pulses);
        if (!heard)
            return heard.error();
        arrival_s = std::move(*heard);
    }
    for (const Pulse& pulse : *pulses) {
        const auto arrival = arrival_s.find(pulse.id);
        window.pulses.push_back({file.seconds(static_cast<double>(pulse.sample)), pulse.source,
                                 arrival == arrival_s.end() ? std::nullopt : std::optional(arrival->second)});
    }
    return Done{};
}

/// Collects the sound of one board into columns; samples must come in order.
class EnvelopeBuilder {
public:
    EnvelopeBuilder(int columns, int64_t sample_count, std::vector<GapRow> gaps)
        : columns_(columns), sample_count_(sample_count), gaps_(std::move(gaps)) {
        envelope_.min.assign(static_cast<size_t>(columns), kNoValue);
        envelope_.max = envelope_.min;
    }

    void add(int64_t sample, float value) {
        if (sample >= sample_count_ || isGap(sample))
            return;
        const auto column = static_cast<size_t>(sample * columns_ / sample_count_);
        envelope_.min[column] = std::fmin(envelope_.min[column], value);
        envelope_.max[column] = std::fmax(envelope_.max[column], value);
    }
    SoundEnvelope envelope() && { return std::move(envelope_); }

private:
    bool isGap(int64_t sample) {
        const auto end = [&] { return gaps_[next_].first_sample + gaps_[next_].sample_count; };
        while (next_ < gaps_.size() && end() <= sample)
            ++next_;
        return next_ < gaps_.size() && gaps_[next_].first_sample <= sample;
    }

    int64_t columns_, sample_count_;
    std::vector<GapRow> gaps_;
    size_t next_ = 0;  ///< gap that has not ended yet
    SoundEnvelope envelope_;
};

}  // namespace

Result<SoundWindow> loadSound(const TakeView& view, int board, double from_s, double to_s,
                              std::optional<int64_t> range_run, const JobContext& job) {
    if (!(to_s > from_s && to_s - from_s <= kLongestWindow_s))
        return Error{ErrorKind::kUsage, view.path + ": sound can be shown for 10 s at most",
                     "Zoom in on a shorter time"};
    const auto file = openSound(view, board);
    if (!file)
        return file.error();
    const auto sampleFrom =
        [&](double t_s) {  // a time that is a sample's own but for rounding means that one
            return std::clamp<int64_t>(std::llround(std::ceil(file->sampleAt(t_s) - 1e-3)), 0, kLastSample);
        };
    const SampleInterval within{sampleFrom(from_s), sampleFrom(to_s) - 1};
    SoundWindow window;
    window.from_s = file->seconds(static_cast<double>(within.first));
    window.sample_rate_hz = file->sample_rate_hz;
    if (within.last < within.first)
        return window;
    window.value.assign(static_cast<size_t>(within.last - within.first + 1), kNoValue);
    if (const Status read = readSamples(*file, board, within, window, job); !read)
        return read.error();
    if (job.cancelled())
        return JobContext::cancelledError();
    const auto gaps = gapsOf(file->take, board);
    if (!gaps)
        return gaps.error();
    blank(*gaps, within, window.value);
    if (const Status added = addPulses(*file, board, within, range_run, window); !added)
        return added.error();
    return window;
}

Result<SoundEnvelope> loadSoundEnvelope(const TakeView& view, int board, int columns, const JobContext& job) {
    if (columns < 1)
        return Error{ErrorKind::kUsage, view.path + ": an overview of the sound needs a column",
                     "Widen the plot"};
    const auto file = openSound(view, board);
    if (!file)
        return file.error();
    const auto samples = file->take.sampleCount();
    if (!samples)
        return samples.error();
    auto gaps = gapsOf(file->take, board);
    if (!gaps)
        return gaps.error();
    const int64_t length = std::max<int64_t>(1, *samples);
    EnvelopeBuilder builder(columns, length, std::move(*gaps));
    const auto boards = static_cast<size_t>(*file->take.boardCount());
    const Status read = file->take.forEachBlock(file->suit, [&](const AdcBlock& block) {
        int64_t sample = block.first_sample;
        for (size_t i = static_cast<size_t>(board); i < block.values.size(); i += boards)
            builder.add(sample++, static_cast<float>(block.values[i]) / kFullScale);
        job.progress(static_cast<double>(std::min(sample, length)) / static_cast<double>(length),
                     "Reading the sound");
        return !job.cancelled();
    });
    if (!read)
        return read.error();
    if (job.cancelled())
        return JobContext::cancelledError();
    return std::move(builder).envelope();
}

}  // namespace noctule
