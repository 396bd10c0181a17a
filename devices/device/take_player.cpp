// SPDX-License-Identifier: Apache-2.0
#include "devices/device/take_player.h"

#include <algorithm>

#include "devices/device/take_hello.h"

namespace noctule {

namespace {

Error unplayable(const Take& take, const std::string& what, const std::string& remedy) {
    return {ErrorKind::kUnusable, take.path() + ": " + what, remedy};
}

std::optional<float> toFloat(const std::optional<double>& value) {
    return value ? std::optional(static_cast<float>(*value)) : std::nullopt;
}

}  // namespace

Result<TakePlayer> TakePlayer::open(const std::string& path) {
    Result<Take> take = Take::open(path);
    if (!take)
        return take.error();
    TakePlayer player(std::move(*take));
    if (const Status loaded = player.load(); !loaded)
        return loaded.error();
    return player;
}

Status TakePlayer::load() {
    if (take_.level() != TakeLevel::kSignal)
        return unplayable(take_, "it holds readings and no sound, which a driver box would send",
                          "Choose a take recorded from a suit or simulated with --level signal");
    if (!take_.suitIds().empty())
        suit_ = take_.suitIds().front();
    if (const Status hello = loadHello(); !hello)
        return hello;
    const auto has_sound = take_.hasRows("adc_block", suit_);
    const auto samples = take_.sampleCount(suit_);
    const auto pulses = take_.pulses(suit_);
    auto statuses = take_.statusRows(suit_);
    const auto gaps = take_.gaps(suit_);
    for (const Error* error : {has_sound ? nullptr : &has_sound.error(), samples ? nullptr : &samples.error(),
                               pulses ? nullptr : &pulses.error(), statuses ? nullptr : &statuses.error(),
                               gaps ? nullptr : &gaps.error()})
        if (error)
            return *error;
    if (!*has_sound)
        return unplayable(take_, "it holds no sound", "Choose another take");
    end_sample_ = *samples;
    for (const Pulse& pulse : *pulses)
        if (pulse.source < static_cast<int>(hello_.suit.sources.size()))
            pulses_.push_back({pulse.sample, pulse.source});
    statuses_ = std::move(*statuses);
    loadGaps(*gaps);
    std::ranges::stable_sort(pulses_, {}, &link::EmittedPulse::sample);
    std::ranges::stable_sort(statuses_, {}, &StatusRow::sample);
    return Done{};
}

Status TakePlayer::loadHello() {
    Result<Suit> suit = take_.suit(suit_);
    const Result<int64_t> rate_hz = take_.sampleRate_hz();
    if (!suit || !rate_hz)
        return suit ? rate_hz.error() : suit.error();
    if (suit->boards.empty())
        return unplayable(take_, "its suit has no boards", "Choose another take");
    const TakeHeader& header = take_.header();
    const std::string name = header.name.empty() ? "take" : header.name;
    hello_ = helloOf(take_, *suit, header.uuid.empty() ? name : header.uuid);
    hello_.model = "take";
    hello_.name = header.name;
    return Done{};
}

void TakePlayer::loadGaps(const std::vector<GapRow>& gaps) {
    for (const GapRow& gap : gaps) {
        if (!gap.board) {
            gaps_.push_back(gap);
        } else if (*gap.board >= 0 && *gap.board < hello_.boardCount()) {
            board_gaps_.push_back({gap.first_sample, *gap.board, true});
            board_gaps_.push_back({gap.first_sample + gap.sample_count, *gap.board, false});
        }
    }
    std::ranges::stable_sort(board_gaps_, {}, &BoardGap::sample);
}

/// What no row explains was lost on the way.
link::GapReason TakePlayer::reasonOf(int64_t first_sample) const {
    for (const GapRow& gap : gaps_)
        if (first_sample >= gap.first_sample && first_sample < gap.first_sample + gap.sample_count)
            return gap.reason == "box" ? link::GapReason::kBox : link::GapReason::kLink;
    return link::GapReason::kLink;
}

link::BoxStatus TakePlayer::statusOf(const StatusRow& row) const {
    link::BoxStatus status{row.sample,
                           toFloat(row.temperature_c),
                           toFloat(row.humidity_percent),
                           toFloat(row.battery_v),
                           toFloat(row.battery_percent),
                           0,
                           {}};
    status.board_flags.assign(hello_.suit.boards.size(), link::kBoardConnected);
    return status;
}

std::optional<link::BoxStatus> TakePlayer::idleStatus() const {
    if (statuses_.empty())
        return std::nullopt;
    StatusRow row = statuses_.front();
    row.sample = 0;
    return statusOf(row);
}

/// How far a play has come.
class TakePlayer::Course {
public:
    Course(const TakePlayer& player, const Sink& sink)
        : player_(player), sink_(sink), lost_(player.hello_.suit.boards.size(), false) {}

    bool goesOn() const { return goes_on_; }

    /// In pieces as small as those of a box.
    void sound(const AdcBlock& block) {
        const auto boards = static_cast<size_t>(player_.hello_.boardCount());
        const size_t piece_values = boards * link::kUsualBlockSamples;
        for (size_t at = 0; at < block.values.size() && goes_on_; at += piece_values) {
            const auto values = block.values.subspan(at, std::min(piece_values, block.values.size() - at));
            const auto first = block.first_sample + static_cast<int64_t>(at / boards);
            const auto end = first + static_cast<int64_t>(values.size() / boards);
            jumpTo(first);
            announceUntil(end);
            send(link::SoundBlock{first, static_cast<int>(boards), {values.begin(), values.end()}}, end);
            next_sample_ = end;
        }
    }

    void finish() {
        jumpTo(player_.end_sample_);
        announceUntil(std::max(next_sample_, player_.end_sample_) + 1);
    }

private:
    void send(link::StudioEvent event, int64_t due_sample) {
        goes_on_ = goes_on_ && sink_(std::move(event), due_sample);
    }

    void jumpTo(int64_t sample) {
        if (sample <= next_sample_)
            return;
        send(link::Gap{next_sample_, sample - next_sample_, player_.reasonOf(next_sample_)}, sample);
        next_sample_ = sample;
    }

    /// What comes before the block that ends there; a box knows its pulses ahead.
    void announceUntil(int64_t end) {
        const auto& gaps = player_.board_gaps_;
        for (; gap_ < gaps.size() && gaps[gap_].sample < end; ++gap_)
            boardGap(gaps[gap_], end);
        const auto& statuses = player_.statuses_;
        for (; status_ < statuses.size() && statuses[status_].sample < end; ++status_)
            status(statuses[status_], end);
        link::Pulses pulses;
        for (; pulse_ < player_.pulses_.size() && player_.pulses_[pulse_].sample < end; ++pulse_)
            pulses.push_back(player_.pulses_[pulse_]);
        if (!pulses.empty())
            send(std::move(pulses), end);
    }

    void boardGap(const BoardGap& gap, int64_t due_sample) {
        const auto board = static_cast<size_t>(gap.board);
        lost_[board] = gap.begins;
        send(link::BoxError{gap.begins ? link::Code::kBoardLost : link::Code::kBoardFound, gap.sample,
                            player_.hello_.suit.boards[board].id},
             due_sample);
    }

    void status(const StatusRow& row, int64_t due_sample) {
        link::BoxStatus status = player_.statusOf(row);
        for (size_t board = 0; board < lost_.size(); ++board)
            if (lost_[board])
                status.board_flags[board] = 0;
        send(std::move(status), due_sample);
    }

    const TakePlayer& player_;
    const Sink& sink_;
    bool goes_on_ = true;
    int64_t next_sample_ = 0;
    size_t gap_ = 0, status_ = 0, pulse_ = 0;
    std::vector<bool> lost_;
};

Status TakePlayer::play(const Sink& sink) const {
    Course course(*this, sink);
    const Status walked = take_.forEachBlock(suit_, [&](const AdcBlock& block) {
        course.sound(block);
        return course.goesOn();
    });
    if (walked)
        course.finish();
    return walked;
}

}  // namespace noctule
