// SPDX-License-Identifier: Apache-2.0
#include "devices/live/stream_feed.h"

#include <algorithm>

#include "devices/device/clock.h"

namespace noctule {
namespace {

/// Not one of so many samples differs from 0: no converter does that, the board is unplugged. (Of boards the
/// box tells only once a second that one has gone; a rule on the samples alone gives the same gaps from
/// file.)
constexpr int64_t kFewestSilentSamples = 64;

bool isSilent(const link::AdcBlock& block, size_t board) {
    for (size_t i = board; i < block.values.size(); i += static_cast<size_t>(block.board_count))
        if (block.values[i] != 0)
            return false;
    return block.sampleCount() >= kFewestSilentSamples;
}

std::optional<double> widened(const std::optional<float>& value) {
    return value ? std::optional<double>(*value) : std::nullopt;
}

}  // namespace

StreamFeed::StreamFeed(std::shared_ptr<Recorder> recorder, std::shared_ptr<LiveProcessor> processor,
                       int board_count, int sample_rate_hz)
    : recorder_(std::move(recorder)),
      processor_(std::move(processor)),
      sample_rate_hz_(sample_rate_hz),
      silences_(static_cast<size_t>(board_count)) {}

void StreamFeed::take(DeviceEvent&& event) {
    const std::lock_guard lock(mutex_);
    if (auto* block = std::get_if<link::AdcBlock>(&event.event))
        give(std::move(*block), event.arrived_ns);
    else if (const auto* pulses = std::get_if<link::Pulses>(&event.event))
        give(*pulses);
    else if (const auto* gap = std::get_if<link::Gap>(&event.event))
        give(*gap);
    else if (const auto* status = std::get_if<link::BoxStatus>(&event.event))
        give(*status);
    else if (const auto* error = std::get_if<link::BoxError>(&event.event))
        give(*error);
}

void StreamFeed::hand(const LiveItem& item) {
    if (recorder_)
        recorder_->push(item);
    if (processor_)
        processor_->push(item);
}

void StreamFeed::give(link::AdcBlock&& block, int64_t arrived_ns) {
    if (block.values.empty() || block.board_count != static_cast<int>(silences_.size()))
        return;
    noteSilence(block);
    const ArrivedBlock arrived{std::make_shared<const link::AdcBlock>(std::move(block)), arrived_ns};
    reached_sample_ = std::max(reached_sample_.load(), arrived.endSample());
    hand(arrived);
}

void StreamFeed::noteSilence(const link::AdcBlock& block) {
    for (size_t board = 0; board < silences_.size(); ++board) {
        Silence& silence = silences_[board];
        if (!isSilent(block, board)) {
            flushSilence(board);
            continue;
        }
        if (processor_)
            processor_->push(
                GapRow{block.first_sample, block.sampleCount(), static_cast<int>(board), kGapOfBoard});
        if (silence.first_sample + silence.sample_count != block.first_sample ||
            silence.sample_count >= sample_rate_hz_)
            flushSilence(board);
        if (silence.sample_count == 0)
            silence.first_sample = block.first_sample;
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
}

void StreamFeed::give(const link::Pulses& pulses) {
    std::vector<Pulse> numbered;
    for (const link::Pulse& pulse : pulses)
        numbered.push_back({++last_pulse_id_, pulse.sample, pulse.source});
    hand(numbered);
}

void StreamFeed::give(const link::Gap& gap) {
    hand(GapRow{gap.first_sample, gap.sample_count, std::nullopt,
                gap.reason == link::GapReason::kBox ? kGapOfBox : kGapOfLink});
}

void StreamFeed::give(const link::BoxStatus& status) {
    // Never before what has come already: live and from file it must count from the same sample on.
    hand(StatusRow{std::max(status.sample, reached_sample_.load()), widened(status.temperature_c),
                   widened(status.humidity_percent), widened(status.battery_v),
                   widened(status.battery_percent)});
}

void StreamFeed::give(const link::BoxError& error) {
    handNote("Driver box, at sample " + std::to_string(error.sample) + ": " + nameOf(error.code) +
             (error.text.empty() ? "" : ": " + error.text));
}

void StreamFeed::addMarker(const std::string& kind, const std::string& label) {
    const std::lock_guard lock(mutex_);
    hand(MarkerRow{reached_sample_, kind, label});
}

void StreamFeed::addNote(const std::string& text) {
    const std::lock_guard lock(mutex_);
    handNote(text);
}

void StreamFeed::handNote(const std::string& text) {
    hand(NoteRow{utcNow(), text});
}

}  // namespace noctule
