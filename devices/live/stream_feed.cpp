// SPDX-License-Identifier: Apache-2.0
#include "devices/live/stream_feed.h"

#include <algorithm>
#include <cstdio>

#include "core/job/limits.h"
#include "core/job/outside_text.h"
#include "devices/machine/clock.h"

namespace noctule {
namespace {

/// Not one of so many samples differs from 0: no converter does that, the board is unplugged. (Of boards the
/// box tells only once a second that one has gone; a rule on the samples alone gives the same gaps from
/// file.)
constexpr int64_t kFewestSilentSamples = 64;
constexpr size_t kBoxWarnings = 8;  ///< a box may send without end

bool isSilent(const link::SoundBlock& block, size_t board) {
    for (size_t i = board; i < block.values.size(); i += static_cast<size_t>(block.board_count))
        if (block.values[i] != 0)
            return false;
    return block.sampleCount() >= kFewestSilentSamples;
}

/// "0:07.8", as on the studio's screens; before the take "0:00.0".
std::string takeTime(int64_t sample, int sample_rate_hz) {
    const int64_t tenths = std::max<int64_t>(0, 10 * sample / std::max(1, sample_rate_hz));
    char text[32];
    std::snprintf(text, sizeof text, "%lld:%02lld.%lld", static_cast<long long>(tenths / 600),
                  static_cast<long long>(tenths / 10 % 60), static_cast<long long>(tenths % 10));
    return text;
}

std::optional<double> widened(const std::optional<float>& value) {
    return value ? std::optional<double>(*value) : std::nullopt;
}

}  // namespace

StreamFeed::StreamFeed(std::shared_ptr<Recorder> recorder, std::shared_ptr<LiveProcessor> processor,
                       int board_count, const Clock& clock)
    : recorder_(std::move(recorder)),
      processor_(std::move(processor)),
      clock_(clock),
      pulse_rate_(clock.sample_rate_hz),
      silences_(static_cast<size_t>(board_count)) {}

void StreamFeed::take(const StreamEvent& event) {
    const std::lock_guard lock(mutex_);
    std::visit([this](const auto& data) { give(data); }, event);
}

void StreamFeed::hand(const LiveItem& item) {
    if (recorder_)
        recorder_->push(item);
    if (processor_)
        processor_->push(item);
}

void StreamFeed::give(const ArrivedBlock& block) {
    const ArrivedBlock here{block.sound, block.arrived_ns, clock_.origin};
    noteSilence(here);
    reached_sample_ = std::max(reached_sample_.load(), here.endSample());
    hand(here);
}

void StreamFeed::noteSilence(const ArrivedBlock& block) {
    for (size_t board = 0; board < silences_.size(); ++board) {
        Silence& silence = silences_[board];
        if (!isSilent(*block.sound, board)) {
            flushSilence(board);
            continue;
        }
        if (processor_)
            processor_->push(
                GapRow{block.firstSample(), block.sampleCount(), static_cast<int>(board), kGapOfBoard});
        if (silence.first_sample + silence.sample_count != block.firstSample() ||
            silence.sample_count >= clock_.sample_rate_hz)
            flushSilence(board);
        if (silence.sample_count == 0)
            silence.first_sample = block.firstSample();
        silence.sample_count += block.sampleCount();
    }
}

void StreamFeed::flushSilence(size_t board) {
    const Silence silence = std::exchange(silences_[board], {});
    if (silence.sample_count > 0 && recorder_)
        recorder_->push(
            GapRow{silence.first_sample, silence.sample_count, static_cast<int>(board), kGapOfBoard});
}

void StreamFeed::flush() {
    const std::lock_guard lock(mutex_);
    for (size_t board = 0; board < silences_.size(); ++board)
        flushSilence(board);
    if (errors_left_out_ > 0)
        handNote("Driver box: " + std::to_string(std::exchange(errors_left_out_, 0)) +
                 " further errors came too fast to be noted.");
}

/// The first ones, then one a second of sound.
bool StreamFeed::Allowance::allow(int64_t sample, int64_t sample_rate_hz) {
    if (given_ >= limits::kBoxNotes && static_cast<double>(sample - last_sample_) <
                                           limits::kBoxNoteEvery_s * static_cast<double>(sample_rate_hz))
        return false;
    ++given_;
    last_sample_ = sample;
    return true;
}

void StreamFeed::give(const link::Pulses& pulses) {
    std::vector<Pulse> numbered;
    for (const link::EmittedPulse& pulse : pulses)
        if (pulse.sample >= clock_.origin && pulse_rate_.allows(pulse.sample))
            numbered.push_back({++last_pulse_id_, pulse.sample - clock_.origin, pulse.source});
    if (!numbered.empty())
        hand(numbered);
}

void StreamFeed::give(const link::Gap& gap) {
    hand(GapRow{gap.first_sample - clock_.origin, gap.sample_count, std::nullopt,
                gap.reason == link::GapReason::kBox ? kGapOfBox : kGapOfLink});
}

void StreamFeed::markMissing(int64_t until, const std::string& reason) {
    const std::lock_guard lock(mutex_);
    const int64_t from = reached_sample_;
    if (until <= from)
        return;
    hand(GapRow{from, until - from, std::nullopt, reason});
    reached_sample_ = until;
}

void StreamFeed::give(const link::BoxStatus& status) {
    if (!statuses_.allow(reached_sample_, clock_.sample_rate_hz))
        return;
    // Never before what has come already: live and from file it must count from the same sample on.
    hand(StatusRow{std::max(status.sample - clock_.origin, reached_sample_.load()),
                   widened(status.temperature_c), widened(status.humidity_percent), widened(status.battery_v),
                   widened(status.battery_percent)});
}

void StreamFeed::give(const link::BoxError& error) {
    const std::string at = takeTime(error.sample - clock_.origin, clock_.sample_rate_hz);
    const std::string said = visibleText(shortText(error.text, limits::kBoxText));
    const bool is_good = error.code == link::Code::kOk || error.code == link::Code::kBoardFound;
    if (!is_good && box_warnings_.size() < kBoxWarnings)
        box_warnings_.push_back("The driver box said at " + at + ": " + nameOf(error.code) +
                                (said.empty() ? "" : ", " + said) + ".");
    if (!errors_.allow(reached_sample_, clock_.sample_rate_hz)) {
        ++errors_left_out_;
        return;
    }
    handNote(at + " Driver box: " + (said.empty() ? nameOf(error.code) : said));
}

void StreamFeed::addMarker(const std::string& kind, const std::string& label, std::optional<int64_t> sample) {
    const std::lock_guard lock(mutex_);
    hand(MarkerRow{sample.value_or(reached_sample_), kind, label});
}

std::vector<std::string> StreamFeed::boxWarnings() {
    const std::lock_guard lock(mutex_);
    return box_warnings_;
}

void StreamFeed::addNote(const std::string& text) {
    const std::lock_guard lock(mutex_);
    handNote(text);
}

void StreamFeed::handNote(const std::string& text) {
    hand(NoteRow{utcNow(), text});
}

}  // namespace noctule
