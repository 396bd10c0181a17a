// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/take_source.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "app/batch/option.h"
#include "core/formats/number_text.h"
#include "core/inertial/frame_layout.h"
#include "core/inertial/reading.h"
#include "core/recording/take.h"
#include "devices/device/take_hello.h"

namespace noctule::virtual_suit {
namespace {

constexpr double kReadAhead_s = 0.2;
/// Instead of one that the take does not name; boxes have six digits, the last ones are the suit's.
constexpr int kSerialOfTakes = 800000;

struct TakeContent {
    Take take;
    int suit_id = 1;
    int board_count = 0;
    int64_t sample_count = 0, read_ahead_samples = 0;
    int64_t loops_from = 0;  ///< where each round but the first begins
    std::vector<link::EmittedPulse> pulses;
};

class TakeSource : public SoundSource {
public:
    TakeSource(TakeContent content, bool loop) : content_(std::move(content)), loop_(loop) {}

    Status restart(int64_t /*begin_ns*/) override {
        lap_start_ = 0;
        rewind(0);
        return Done{};
    }

    Result<std::optional<SoundBlock>> next() override {
        while (ahead_.empty()) {
            if (read_to_ >= content_.sample_count) {
                if (!loop_ || played_in_lap_ == 0)
                    return std::optional<SoundBlock>();
                lap_start_ += content_.sample_count - content_.loops_from;
                rewind(content_.loops_from);
            }
            if (Status read = readAhead(); !read)
                return read.error();
        }
        SoundBlock block = std::move(ahead_.front());
        ahead_.pop_front();
        ++played_in_lap_;
        for (; next_pulse_ < content_.pulses.size() && content_.pulses[next_pulse_].sample < block.end();
             ++next_pulse_) {
            const link::EmittedPulse& pulse = content_.pulses[next_pulse_];
            block.pulses.push_back({lap_start_ + pulse.sample, pulse.source});
        }
        block.adc.first_sample += lap_start_;
        return std::optional(std::move(block));
    }

    bool isSimulated() const override { return false; }
    Status accepts(const ControlCommand&) const override {
        return Error{ErrorKind::kUsage, "nothing can slip or be turned in a take made before",
                     "Use --motion or --rig"};
    }

private:
    void rewind(int64_t to) {
        ahead_.clear();
        read_to_ = lap_first_ = to;
        played_in_lap_ = 0;
        const auto next = std::ranges::lower_bound(content_.pulses, to, {}, &link::EmittedPulse::sample);
        next_pulse_ = static_cast<size_t>(next - content_.pulses.begin());
    }

    Status readAhead() {
        const int64_t first = read_to_;
        read_to_ += content_.read_ahead_samples;
        return content_.take.forEachBlock(content_.suit_id, {first, read_to_ - 1},
                                          [&](const AdcBlock& block) {
                                              // What began earlier was read before.
                                              if (block.first_sample >= first || first == lap_first_)
                                                  cut(block);
                                              return true;
                                          });
    }

    /// Into the pieces that a box sends: whole ones of kUsualBlockSamples where the take has no seam.
    void cut(const AdcBlock& block) {
        const int64_t end =
            std::min(content_.sample_count,
                     block.first_sample + static_cast<int64_t>(block.values.size()) / content_.board_count);
        for (int64_t at = std::max(block.first_sample, lap_first_); at < end;) {
            const int64_t until =
                std::min(end, (at / link::kUsualBlockSamples + 1) * link::kUsualBlockSamples);
            const auto values = block.values.subspan((at - block.first_sample) * content_.board_count,
                                                     (until - at) * content_.board_count);
            ahead_.push_back({{at, content_.board_count, {values.begin(), values.end()}}, {}});
            at = until;
        }
    }

    TakeContent content_;
    bool loop_;
    std::deque<SoundBlock> ahead_;  ///< in the take's own time
    int64_t read_to_ = 0, lap_first_ = 0, lap_start_ = 0, played_in_lap_ = 0;
    size_t next_pulse_ = 0;
};

Error noSound(const std::string& path, const std::string& why) {
    return {ErrorKind::kUnusable, path + ": " + why,
            "Only takes with sound can be played; `noctule --batch simulate --level signal` makes one"};
}

/// As the take says, where that leaves whole periods of the boards' streams: frames whose samples and
/// counters come again. Else 0: the streams break at the take's end, and receivers look for them for up to
/// two seconds.
int64_t loopsFrom(const Take& take, int64_t sample_count, int64_t rate_hz) {
    const auto said = take.meta().find(kLoopsFromKey);
    double from_s = 0;
    if (said == take.meta().end() || !parseFiniteNumber(said->second, from_s))
        return 0;
    const auto from = static_cast<int64_t>(std::llround(from_s * static_cast<double>(rate_hz)));
    const bool fits =
        from > 0 && from < sample_count && (sample_count - from) % (kStreamPeriod_s * rate_hz) == 0;
    return fits ? from : 0;
}

/// `source_count`: pulses of any other source are not of this suit.
Result<TakeContent> contentOf(Take take, int suit_id, size_t source_count) {
    const std::string path = take.path();
    if (take.level() != TakeLevel::kSignal)
        return noSound(path, "holds readings and no sound");
    const auto samples = take.sampleCount(suit_id);
    const auto boards = take.boardCount(suit_id);
    const auto pulses = take.pulses(suit_id);
    const auto rate_hz = take.sampleRate_hz();
    for (const std::optional<Error>& error : {samples ? std::nullopt : std::optional(samples.error()),
                                              boards ? std::nullopt : std::optional(boards.error()),
                                              pulses ? std::nullopt : std::optional(pulses.error()),
                                              rate_hz ? std::nullopt : std::optional(rate_hz.error())})
        if (error)
            return *error;
    if (*samples == 0)
        return noSound(path, "holds no sound");
    const int64_t loops_from = loopsFrom(take, *samples, *rate_hz);
    TakeContent content{std::move(take), suit_id, *boards, *samples, 0, loops_from, {}};
    content.read_ahead_samples = static_cast<int64_t>(kReadAhead_s * static_cast<double>(*rate_hz));
    for (const Pulse& pulse : *pulses)
        if (pulse.source < static_cast<int>(source_count))
            content.pulses.push_back({pulse.sample, pulse.source});
    return content;
}

/// What stood in the take's status then; in a later lap the same again.
Measurements measured(const std::vector<StatusRow>& rows, int64_t sample) {
    const auto later = std::upper_bound(rows.begin(), rows.end(), sample,
                                        [](int64_t at, const StatusRow& row) { return at < row.sample; });
    if (rows.empty())
        return {};
    const StatusRow& row = later == rows.begin() ? rows.front() : *std::prev(later);
    return {row.temperature_c, row.humidity_percent, row.battery_v, row.battery_percent};
}

std::string subjectName(const TakeSubject& subject) {
    return subject.room ? "room" : subject.name;
}

Result<int> suitOf(const Take& take, const std::string& name) {
    const std::vector<int> suits = take.suitIds();
    if (name.empty())
        return suits.empty() ? 1 : suits.front();
    const auto subjects = take.subjects();
    if (!subjects)
        return subjects.error();
    std::vector<std::string> known;
    for (const TakeSubject& subject : *subjects) {
        if (subjectName(subject) == name)
            return subject.suit();
        known.push_back(subjectName(subject));
    }
    return Error{ErrorKind::kUsage, take.path() + ": nobody in the take is called " + name,
                 "Give --subject " + batch::listed(known)};
}

}  // namespace

Result<SoundOfSuit> openTakeSource(const std::string& path, const std::string& subject, bool loop) {
    auto take = Take::open(path);
    if (!take)
        return take.error();
    const auto found = suitOf(*take, subject);
    if (!found)
        return found.error();
    const int suit_id = *found;
    take->view(suit_id);
    const auto suit = take->suit(suit_id);
    if (!suit)
        return suit.error();
    const auto rows = take->statusRows(suit_id);
    if (!rows)
        return rows.error();
    link::Hello hello = helloOf(*take, *suit, "NB-" + std::to_string(kSerialOfTakes + suit_id - 1));
    auto content = contentOf(std::move(*take), suit_id, suit->sources.size());
    if (!content)
        return content.error();
    if (content->board_count != hello.boardCount())
        return noSound(path, "its sound is of " + std::to_string(content->board_count) +
                                 " boards, its suit has " + std::to_string(hello.boardCount()));
    const int64_t count = content->sample_count, from = content->loops_from;
    return SoundOfSuit{std::make_unique<TakeSource>(std::move(*content), loop), std::move(hello),
                       [rows = *rows, count, from](int64_t sample) {
                           const bool again = sample >= count;
                           return measured(rows, again ? from + (sample - from) % (count - from) : sample);
                       }};
}

}  // namespace noctule::virtual_suit
