// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/pulse_receiver.h"

#include <algorithm>
#include <tuple>

#include "core/suit/suit.h"

namespace noctule {
namespace {

constexpr double kHistory_s = 2;
constexpr int64_t kMaxSample = int64_t(1) << 60;  // sums of samples stay far from overflow

/// Variance of rounding to whole counts; what noise is never below.
constexpr double kRoundingPower = 1.0 / 12;

}  // namespace

Result<PulseReceiver> PulseReceiver::create(Detector detector, const PulseTrain& train, int board_count,
                                            const PulseShapes& shapes) {
    auto made = makeDetector(detector, train, shapes);
    if (!made)
        return made.error();
    return create(std::move(made.value()), train, board_count);
}

Result<PulseReceiver> PulseReceiver::create(std::shared_ptr<PulseDetector> detector, const PulseTrain& train,
                                            int board_count) {
    if (board_count < 1 || board_count > int(Suit::kMaxPerSuit))
        return Error{ErrorKind::kUnusable,
                     "A suit of " + std::to_string(board_count) + " boards cannot be heard",
                     "Check the suit: 1 to 32 boards"};
    return PulseReceiver(std::move(detector), train, board_count);
}

PulseReceiver::PulseReceiver(std::shared_ptr<PulseDetector> detector, const PulseTrain& train,
                             int board_count)
    : detector_(std::move(detector)),
      history_(board_count, std::max<int64_t>(std::llround(kHistory_s * train.sample_rate_hz),
                                              2 * detector_->windowSamples())),
      noise_(board_count),
      arrivals_(board_count) {}

int64_t PulseReceiver::windowEnd(const Pulse& pulse) const {
    return pulse.sample - detector_->marginSamples() + detector_->windowSamples();
}

void PulseReceiver::pushBlock(int64_t first_sample, std::span<const int16_t> interleaved) {
    if (first_sample >= 0 && first_sample < kMaxSample)
        history_.push(first_sample, interleaved);
}

bool PulseReceiver::pushPulse(const Pulse& pulse) {
    if (pulse.sample < 0 || pulse.sample >= kMaxSample || windowEnd(pulse) <= complete_until_)
        return false;
    const auto later = [](const Pulse& a, const Pulse& b) {
        return std::tie(a.sample, a.id) < std::tie(b.sample, b.id);
    };
    waiting_.insert(std::upper_bound(waiting_.begin(), waiting_.end(), pulse, later), pulse);
    return true;
}

void PulseReceiver::markMissing(int64_t first_sample, int64_t sample_count, std::optional<int> board) {
    if (board && (*board < 0 || *board >= int(noise_.size())))
        return;
    const int64_t first = std::clamp<int64_t>(first_sample, 0, kMaxSample);
    const int64_t count = std::clamp<int64_t>(sample_count, 0, kMaxSample);
    history_.markMissing(first, count, board);
}

void PulseReceiver::advance(int64_t complete_until, std::vector<PulseDetection>& detections) {
    complete_until_ = std::max(complete_until_, complete_until);
    while (!waiting_.empty() && windowEnd(waiting_.front()) <= complete_until_) {
        receive(waiting_.front(), detections);
        waiting_.pop_front();
    }
    history_.dropBefore(std::min(complete_until_, history_.end()) - detector_->windowSamples());
}

void PulseReceiver::finish(std::vector<PulseDetection>& detections) {
    advance(2 * kMaxSample, detections);
}

void PulseReceiver::receive(const Pulse& pulse, std::vector<PulseDetection>& detections) {
    const int64_t first = pulse.sample - detector_->marginSamples();
    const auto window = history_.window(first, detector_->windowSamples());
    const uint32_t missing =
        window.empty() ? ~uint32_t(0) : history_.missingBoards(first, detector_->windowSamples());
    if (!window.empty())
        detector_->detect(window, arrivals_, pulse);
    for (int board = 0; board < int(arrivals_.size()); ++board) {
        PulseDetection detection{.pulse = pulse, .board = board, .gap = ((missing >> board) & 1) != 0};
        if (!detection.gap) {
            const PulseArrival& arrival = arrivals_[board];
            noise_[board].push(arrival.noise_power);
            detection.clipped = arrival.clipped;
            detection.arrival_sample = double(pulse.sample) + arrival.sample;
            detection.peak_power = arrival.peak_power;
            detection.carrier = arrival.carrier;
            if (detection.carrier)
                detection.carrier->sample += double(pulse.sample);
            detection.noise_power = std::max(noise_[board].power(), kRoundingPower);
        }
        detections.push_back(detection);
    }
}

}  // namespace noctule
