// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/take_source.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <limits>

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
    int rate_hz = 0;
    SuitClock clock;
    std::vector<link::EmittedPulse> pulses;

    int64_t roundSamples() const { return sample_count - loops_from; }
};

/// The sample of the take that is played then, where rounds from `from` follow its first `count` samples.
int64_t inRounds(int64_t sample, int64_t count, int64_t from) {
    return sample < count ? sample : from + (sample - from) % (count - from);
}

class TakeSource : public SoundSource {
public:
    TakeSource(TakeContent content, bool loop, std::optional<int64_t> start_ns,
               std::shared_ptr<std::atomic<int64_t>> begun_at)
        : content_(std::move(content)), loop_(loop), start_ns_(start_ns), begun_at_(std::move(begun_at)) {}

    bool isTimed() const override { return start_ns_.has_value(); }
    Status restart(int64_t begin_ns) override {
        const int64_t at = start_ns_ ? sampleAt(begin_ns) : 0;
        *begun_at_ = at;
        const int64_t played = loop_ ? inRounds(at, content_.sample_count, content_.loops_from) : at;
        lap_start_ = -played;
        next_silent_ = 0;
        rewind(std::max<int64_t>(0, played));
        return Done{};
    }

    Result<std::optional<SoundBlock>> next() override {
        if (next_silent_ < lap_start_)
            return std::optional(silence());
        while (ahead_.empty()) {
            if (read_to_ >= content_.sample_count) {
                const bool is_empty = lap_first_ == content_.loops_from && played_in_lap_ == 0;
                if (!loop_ || is_empty)
                    return std::optional<SoundBlock>();
                lap_start_ += content_.roundSamples();
                next_silent_ = lap_start_;
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
    /// Of the suit's own time, which may be before the take or behind it. Rounds go as they are played: by
    /// the clock of the wall, whatever the suit's clock did.
    int64_t sampleAt(int64_t instant_ns) const {
        const double take_s = 1e-9 * static_cast<double>(instant_ns - *start_ns_);
        const double rate_hz = content_.rate_hz;
        const auto from = static_cast<double>(content_.loops_from);
        const double behind_s = take_s - content_.clock.takeTime_s(from / rate_hz);
        return std::llround(loop_ && behind_s > 0 ? from + behind_s * rate_hz
                                                  : content_.clock.suitTime_s(take_s) * rate_hz);
    }

    /// The take has not begun yet.
    SoundBlock silence() {
        const int64_t count = std::min<int64_t>(link::kUsualBlockSamples, lap_start_ - next_silent_);
        const std::vector<int16_t> zeros(static_cast<size_t>(count * content_.board_count));
        SoundBlock block{{next_silent_, content_.board_count, zeros}, {}};
        next_silent_ += count;
        return block;
    }

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
    std::optional<int64_t> start_ns_;
    std::shared_ptr<std::atomic<int64_t>> begun_at_;  ///< sample of the suit's time of the last restart
    int64_t next_silent_ = 0;
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
    const SuitClock clock = take.suitClock(suit_id);
    TakeContent content{
        std::move(take), suit_id, *boards, *samples, 0, loops_from, static_cast<int>(*rate_hz), clock, {}};
    content.read_ahead_samples = static_cast<int64_t>(kReadAhead_s * static_cast<double>(*rate_hz));
    for (const Pulse& pulse : *pulses)
        if (pulse.source < static_cast<int>(source_count))
            content.pulses.push_back({pulse.sample, pulse.source});
    return content;
}

/// Rounds from where all suits have begun to where the first one ends, of as many samples for each of them.
Status takeCommonRounds(TakeContent& content) {
    const Take& take = content.take;
    const double rate_hz = content.rate_hz;
    std::vector<std::pair<int64_t, SuitClock>> suits;  // samples of each
    double begin_s = -std::numeric_limits<double>::infinity();
    for (const int suit : take.suitIds()) {
        const auto samples = take.sampleCount(suit);
        if (!samples)
            return samples.error();
        const auto& [count, clock] = suits.emplace_back(*samples, take.suitClock(suit));
        const auto from = static_cast<double>(loopsFrom(take, count, content.rate_hz));
        begin_s = std::max(begin_s, clock.takeTime_s(from / rate_hz));
    }
    const auto beginOf = [&](const SuitClock& clock) {
        return std::llround(clock.suitTime_s(begin_s) * rate_hz);
    };
    int64_t round = content.sample_count;
    for (const auto& [count, clock] : suits)
        round = std::min<int64_t>(round, count - beginOf(clock));
    if (round <= 0)
        return Error{ErrorKind::kUnusable, take.path() + ": its suits were recorded one after the other",
                     "Leave out --start-at or --loop"};
    content.loops_from = beginOf(content.clock);
    content.sample_count = content.loops_from + round;
    return Done{};
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

Result<SoundOfSuit> openTakeSource(const std::string& path, const std::string& subject, bool loop,
                                   std::optional<int64_t> start_ns) {
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
    if (start_ns && loop)
        if (Status common = takeCommonRounds(*content); !common)
            return common.error();
    const auto begun_at = std::make_shared<std::atomic<int64_t>>(0);
    const auto measurements = [rows = *rows, begun_at, count = content->sample_count,
                               from = content->loops_from](int64_t sample) {
        return measured(rows, inRounds(*begun_at + sample, count, from));
    };
    return SoundOfSuit{std::make_unique<TakeSource>(std::move(*content), loop, start_ns, begun_at),
                       std::move(hello), measurements};
}

}  // namespace noctule::virtual_suit
