// SPDX-License-Identifier: Apache-2.0
#include "devices/driver_box/box_queue.h"

#include <algorithm>
#include <utility>

namespace noctule::link {

void BoxQueue::pushControl(Type type, Bytes payload) {
    small_bytes_ += payload.size() + kHeaderBytes + kTailBytes;
    control_.push_back({type, std::move(payload)});
}

void BoxQueue::pushPulses(const std::vector<EmittedPulse>& pulses) {
    pulses_.push_back({Type::kPulses, toPayload(pulses)});
    small_bytes_ += pulses_.back().payload.size() + kHeaderBytes + kTailBytes;
}

std::optional<BoxQueue::Dropped> BoxQueue::pushSound(SoundBlock block) {
    held_samples_ += block.sampleCount();
    sound_.push_back(std::move(block));
    std::optional<Dropped> dropped;
    while (held_samples_ - sound_.front().sampleCount() >= most_samples_) {
        const SoundBlock& oldest = sound_.front();
        if (!dropped)
            dropped = Dropped{oldest.first_sample, 0};
        dropped->sample_count += oldest.sampleCount();
        held_samples_ -= oldest.sampleCount();
        sound_.pop_front();
    }
    return dropped;
}

/// Answers and status were for the client that is gone; errors and data still matter.
void BoxQueue::restart() {
    std::erase_if(control_, [&](const Message& message) {
        if (message.type != Type::kError)
            small_bytes_ -= message.payload.size() + kHeaderBytes + kTailBytes;
        return message.type != Type::kError;
    });
    if (begun_ && (begun_->type == Type::kAdc || begun_->type == Type::kPulses))
        resend_ = std::move(begun_);
    else if (begun_ && begun_->type == Type::kError) {
        small_bytes_ += begun_->payload.size() + kHeaderBytes + kTailBytes;
        control_.push_front(std::move(*begun_));
    }
    begun_.reset();
    frame_.clear();
    written_ = 0;
    next_sequence_ = 0;
    data_allowed_ = false;
}

void BoxQueue::clearData() {
    for (const Message& message : pulses_)
        small_bytes_ -= message.payload.size() + kHeaderBytes + kTailBytes;
    resend_.reset();
    pulses_.clear();
    sound_.clear();
    held_samples_ = 0;
}

std::optional<int64_t> BoxQueue::firstUnsentSample() const {
    return sound_.empty() ? std::nullopt : std::optional(sound_.front().first_sample);
}

bool BoxQueue::holdsOverrun() const {
    return std::any_of(control_.begin(), control_.end(), [](const Message& message) {
        return message.type == Type::kError &&
               WireReader(message.payload).number<uint16_t>() == static_cast<uint16_t>(Code::kOverrun);
    });
}

BoxQueue::Message BoxQueue::take(std::deque<Message>& from) {
    Message message = std::move(from.front());
    from.pop_front();
    small_bytes_ -= message.payload.size() + kHeaderBytes + kTailBytes;
    return message;
}

std::optional<BoxQueue::Message> BoxQueue::next() {
    if (!control_.empty())
        return take(control_);
    if (!data_allowed_)
        return std::nullopt;
    if (resend_)
        return std::exchange(resend_, std::nullopt);
    if (!pulses_.empty())
        return take(pulses_);
    if (sound_.empty())
        return std::nullopt;
    Message message{Type::kAdc, toPayload(sound_.front(), format_)};
    held_samples_ -= sound_.front().sampleCount();
    sound_.pop_front();
    return message;
}

Bytes BoxQueue::read(size_t most_bytes) {
    Bytes bytes;
    while (bytes.size() < most_bytes) {
        if (written_ == frame_.size()) {
            begun_ = next();
            frame_ = begun_
                         ? encodeFrame(static_cast<uint8_t>(begun_->type), next_sequence_++, begun_->payload)
                         : Bytes();
            written_ = 0;
            if (!begun_)
                break;
        }
        const size_t count = std::min(most_bytes - bytes.size(), frame_.size() - written_);
        const auto from = frame_.begin() + static_cast<std::ptrdiff_t>(written_);
        bytes.insert(bytes.end(), from, from + static_cast<std::ptrdiff_t>(count));
        written_ += count;
    }
    if (written_ == frame_.size())
        begun_.reset();
    return bytes;
}

}  // namespace noctule::link
