// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/take_source.h"

#include <algorithm>
#include <deque>

#include "app/batch/option.h"
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
    std::vector<link::EmittedPulse> pulses;
};

class TakeSource : public SoundSource {
public:
    TakeSource(TakeContent content, bool loop) : content_(std::move(content)), loop_(loop) {}

    Status restart() override {
        lap_start_ = 0;
        rewind();
        return Done{};
    }

    Result<std::optional<SoundBlock>> next() override {
        while (ahead_.empty()) {
            if (read_to_ >= content_.sample_count) {
                if (!loop_ || played_in_lap_ == 0)
                    return std::optional<SoundBlock>();
                lap_start_ += content_.sample_count;
                rewind();
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
    void rewind() {
        ahead_.clear();
        read_to_ = played_in_lap_ = 0;
        next_pulse_ = 0;
    }

    Status readAhead() {
        const int64_t first = read_to_;
        read_to_ += content_.read_ahead_samples;
        return content_.take.forEachBlock(content_.suit_id, {first, read_to_ - 1},
                                          [&](const AdcBlock& block) {
                                              if (block.first_sample >= first)  // else it was read before
                                                  cut(block);
                                              return true;
                                          });
    }

    /// Into the pieces that a box sends: whole ones of kUsualBlockSamples where the take has no seam.
    void cut(const AdcBlock& block) {
        const int64_t end =
            std::min(content_.sample_count,
                     block.first_sample + static_cast<int64_t>(block.values.size()) / content_.board_count);
        for (int64_t at = block.first_sample; at < end;) {
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
    int64_t read_to_ = 0, lap_start_ = 0, played_in_lap_ = 0;
    size_t next_pulse_ = 0;
};

Error noSound(const std::string& path, const std::string& why) {
    return {ErrorKind::kUnusable, path + ": " + why,
            "Only takes with sound can be played; `noctule --batch simulate --level signal` makes one"};
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
    TakeContent content{std::move(take), suit_id, *boards, *samples, 0, {}};
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
    const int64_t lap = content->sample_count;
    return SoundOfSuit{std::make_unique<TakeSource>(std::move(*content), loop), std::move(hello),
                       [rows = *rows, lap](int64_t sample) { return measured(rows, sample % lap); }};
}

}  // namespace noctule::virtual_suit
