// SPDX-License-Identifier: Apache-2.0
#include "core/live/suit_decoder.h"

#include <algorithm>

namespace noctule {

Result<std::unique_ptr<SuitDecoder>> SuitDecoder::create(const Suit& suit, const Calibration& calibration,
                                                         const DecoderSettings& settings) {
    const int rate_hz = static_cast<int>(settings.train.sample_rate_hz);
    if (!StreamReceiver::supports(rate_hz))
        return Error{
            ErrorKind::kUnusable,
            "a sample rate of " + std::to_string(rate_hz) + " Hz is outside what boards can be received at",
            "Check sample_rate_hz in the take's meta table"};
    auto receiver = PulseReceiver::create(settings.detector, settings.train,
                                          static_cast<int>(suit.boards.size()), shapesOf(suit, calibration));
    if (!receiver)
        return receiver.error();
    auto finder = RangeFinder::create(suit, calibration, settings.train, settings.detector);
    if (!finder)
        return finder.error();
    return std::unique_ptr<SuitDecoder>(
        new SuitDecoder(suit, settings, std::move(*receiver), std::move(*finder)));
}

SuitDecoder::SuitDecoder(const Suit& suit, const DecoderSettings& settings, PulseReceiver receiver,
                         RangeFinder finder)
    : settings_(settings), pulses_(std::move(receiver)), finder_(std::move(finder)) {
    for (size_t b = 0; b < suit.boards.size(); ++b)
        boards_.push_back(std::make_unique<StreamReceiver>(static_cast<int>(b),
                                                           static_cast<int>(settings.train.sample_rate_hz),
                                                           suit.boards[b].has_magnetometer));
}

void SuitDecoder::pushPulse(const Pulse& pulse) {
    if (!pulses_.pushPulse(pulse))
        ++refused_pulses_;
}

void SuitDecoder::pushStatus(const TemperatureStatus& status) {
    finder_.soundSpeed().add(status);
}

void SuitDecoder::markMissing(int64_t first_sample, int64_t count, std::optional<int> board) {
    for (size_t b = 0; b < boards_.size(); ++b)
        if (!board || *board == static_cast<int>(b))
            boards_[b]->markMissing(first_sample, count);
    pulses_.markMissing(first_sample, count, board);
}

void SuitDecoder::pushBlock(int64_t first_sample, std::span<const int16_t> interleaved) {
    const int columns = static_cast<int>(boards_.size());
    for (int b = 0; b < columns; ++b)
        boards_[static_cast<size_t>(b)]->push(first_sample, interleaved, b, columns);
    pulses_.pushBlock(first_sample, interleaved);
    samples_end_ = std::max(samples_end_, first_sample + static_cast<int64_t>(interleaved.size()) / columns);
    std::vector<PulseDetection> detections;
    pulses_.advance(samples_end_, detections);
    collect(detections);
}

void SuitDecoder::finish() {
    for (auto& board : boards_)
        board->finish();
    std::vector<PulseDetection> detections;
    pulses_.finish(detections);
    collect(detections);
}

void SuitDecoder::collect(const std::vector<PulseDetection>& detections) {
    for (const PulseDetection& detection : detections) {
        gap_windows_ += detection.gap ? 1 : 0;
        if (const auto range = finder_.process(detection))
            ranges_.push_back(*range);
    }
}

std::vector<InertialReading> SuitDecoder::takeReadings() {
    std::vector<InertialReading> all;
    for (auto& board : boards_) {
        std::vector<InertialReading> readings = board->takeReadings();
        all.insert(all.end(), readings.begin(), readings.end());
    }
    return all;
}

int64_t SuitDecoder::watermark() const {
    // The last whole pulse window, and the millisecond beyond it that the zero-phase filters look at, end
    // here; a frame of a board is shorter.
    const auto millisecond = static_cast<int64_t>(settings_.train.sample_rate_hz / 1000);
    return std::max<int64_t>(0, samples_end_ - settings_.train.interval_samples - 3 * millisecond);
}

std::vector<StreamReport> SuitDecoder::streamReports() const {
    std::vector<StreamReport> reports;
    for (const auto& board : boards_)
        reports.push_back(board->report());
    return reports;
}

}  // namespace noctule
