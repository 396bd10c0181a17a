// SPDX-License-Identifier: Apache-2.0
// What the box says: each frame's payload is checked against HELLO and the sample clock (README.md, section
// 6).
#include <algorithm>

#include "devices/driver_box/studio_conversation.h"

namespace noctule::link {

void StudioConversation::handle(const LinkFrame& frame, int64_t now_ns) {
    last_frame_ns_ = now_ns;
    switch (static_cast<Type>(frame.header.type)) {
        case Type::kHello:
            return handleHello(frame.payload, now_ns);
        case Type::kAdc:
            return handleAdc(frame.payload, now_ns);
        case Type::kPulses:
            return handlePulses(frame.payload, now_ns);
        case Type::kStatus:
            return handleStatus(frame.payload);
        case Type::kError:
            return handleError(frame.payload);
        case Type::kPong:
            return handlePong(frame.payload, now_ns);
        case Type::kAnnounce:
            return;
        case Type::kAck:
            if (const auto ack = readAck(frame.payload))
                handleAck(*ack, now_ns);
            else
                ++statistics_.bad_content;
            return;
        default:
            ++statistics_.unknown_types;
    }
}

void StudioConversation::handleHello(ByteView payload, int64_t now_ns) {
    Result<Hello> hello = readHello(payload, where_);
    if (!hello) {
        ++statistics_.bad_content;
        if (state_ == State::kGreeting && hello.error().kind == ErrorKind::kUnusable)
            refuse(hello.error());
        else
            greeting_error_ = hello.error();
        return;
    }
    const bool is_news =
        state_ == State::kGreeting ||
        !std::equal(payload.begin(), payload.end(), hello_payload_.begin(), hello_payload_.end());
    hello_payload_.assign(payload.begin(), payload.end());
    if (state_ == State::kGreeting)
        return greet(std::move(*hello), now_ns);
    if (state_ == State::kStreaming && (!hello->streaming || hello->serial != take_->serial)) {
        state_ = State::kIdle;
        stalled_ = false;
        endTake("the box has restarted");
    }
    if (state_ == State::kIdle)
        box_streams_for_nobody_ = hello->streaming;
    hello_ = *hello;
    if (is_news)
        events_.push_back(Greeted{std::move(*hello)});
}

void StudioConversation::greet(Hello hello, int64_t now_ns) {
    if (hello_)
        ++statistics_.reconnections;
    attempt_ = 0;
    const bool same_box = take_ && take_->serial == hello.serial &&
                          take_->board_count == hello.boardCount() &&
                          take_->sample_rate_hz == hello.sample_rate_hz;
    hello_ = hello;
    state_ = State::kIdle;
    box_streams_for_nobody_ = hello.streaming;
    events_.push_back(Greeted{std::move(hello)});
    if (same_box && hello_->streaming) {
        state_ = State::kStreaming;
        box_streams_for_nobody_ = stalled_ = false;
        last_sound_ns_ = now_ns;
        sequence_->expectReconnection();
        events_.push_back(Resumed{});
    } else if (take_) {
        endTake(same_box ? "the box has restarted" : "another box, or another suit, has answered");
    }
}

void StudioConversation::handleAck(const Ack& ack, int64_t now_ns) {
    const auto type = requests_.answered(ack.request);
    if (!type)
        return;
    if (ack.code != Code::kOk) {
        const std::string text = ack.text.empty() ? nameOf(ack.code) : nameOf(ack.code) + ": " + ack.text;
        return requestFailed(*type, trouble("the box refuses " + nameOf(*type) + ", " + text, "Try again"));
    }
    if (*type == Type::kStart) {
        start_acknowledged_ns_ = now_ns;
    } else if (*type == Type::kStop) {
        box_streams_for_nobody_ = false;
        if (state_ == State::kClearing && start_wanted_)
            return sendStart(now_ns);
        if (state_ == State::kStopping || state_ == State::kClearing) {
            state_ = State::kIdle;
            finishTake();
        }
    } else {
        events_.push_back(RequestDone{*type});
        if (*type == Type::kSet)
            send(Type::kQuery, {});  // what HELLO says has changed
    }
}

/// Data before the ACK of START: that ACK was lost, START was not.
void StudioConversation::soundCame(int64_t now_ns) {
    if (state_ == State::kStarting)
        state_ = State::kStreaming;
    if (!take_) {
        requests_.forget(Type::kStart);
        stalled_ = false;
        take_ = OpenTake{hello_->serial, hello_->boardCount(), hello_->sample_rate_hz};
        events_.push_back(Started{});
    }
    last_sound_ns_ = now_ns;
    if (std::exchange(stalled_, false))
        events_.push_back(Flowing{});
}

void StudioConversation::handleAdc(ByteView payload, int64_t now_ns) {
    if (!takesSound())
        return;
    auto block = readSoundBlock(payload);
    if (!block) {
        ++statistics_.bad_content;
        return;
    }
    const SampleSequence::Placement placement = sequence_->place(*block, losses() > losses_at_last_block_);
    if (placement.verdict == SampleSequence::Verdict::kDamaged)
        ++statistics_.bad_content;
    if (placement.verdict == SampleSequence::Verdict::kOld)
        ++statistics_.duplicate_blocks;
    if (placement.verdict != SampleSequence::Verdict::kNew)
        return;
    losses_at_last_block_ = losses();
    soundCame(now_ns);
    if (placement.gap)
        events_.push_back(*placement.gap);
    events_.push_back(std::move(*block));
}

void StudioConversation::handlePulses(ByteView payload, int64_t now_ns) {
    if (!takesSound())
        return;
    auto pulses = readPulses(payload);
    const auto possible = [&](const EmittedPulse& pulse) {
        return sequence_->isPlausible(pulse.sample) &&
               pulse.source < static_cast<int>(hello_->suit.sources.size());
    };
    if (!pulses || !std::all_of(pulses->begin(), pulses->end(), possible)) {
        ++statistics_.bad_content;
        return;
    }
    if (!take_)
        soundCame(now_ns);
    if (!pulses->empty())
        events_.push_back(std::move(*pulses));
}

void StudioConversation::handleStatus(ByteView payload) {
    if (state_ == State::kGreeting)
        return;
    auto status = readStatus(payload);
    const bool possible = status && status->board_flags.size() == hello_->suit.boards.size() &&
                          (state_ != State::kStreaming || sequence_->isPlausible(status->sample));
    if (possible)
        events_.push_back(std::move(*status));
    else
        ++statistics_.bad_content;
}

void StudioConversation::handleError(ByteView payload) {
    auto error = readError(payload);
    if (!error || (state_ == State::kStreaming && !sequence_->isPlausible(error->sample))) {
        ++statistics_.bad_content;
        return;
    }
    if (takesSound() && error->code == Code::kOverrun)
        sequence_->noteOverrun(error->sample);
    events_.push_back(std::move(*error));
}

void StudioConversation::handlePong(ByteView payload, int64_t now_ns) {
    WireReader reader(payload);
    const auto sent_ns = static_cast<int64_t>(reader.number<uint64_t>());
    if (reader.complete() && sent_ns <= now_ns && sent_ns >= opened_ns_)
        statistics_.round_trip_ns = now_ns - sent_ns;
}

}  // namespace noctule::link
