// SPDX-License-Identifier: Apache-2.0
// Time, the stream and the operator's wishes; what the box says is in studio_messages.cpp.
#include "devices/driver_box/studio_conversation.h"

#include <algorithm>
#include <array>

namespace noctule::link {

namespace {

constexpr std::array<int64_t, 4> kPauses_ms = {500, 1000, 2000, 4000};

}  // namespace

Error StudioConversation::trouble(const std::string& what, const std::string& remedy) const {
    return {ErrorKind::kDevice, where_ + ": " + what, remedy};
}

LinkStatistics StudioConversation::statistics() const {
    LinkStatistics statistics = statistics_;
    statistics.frames = reader_.statistics();
    statistics.lost_samples = sequence_ ? sequence_->lostSamples() : 0;
    return statistics;
}

void StudioConversation::opened(int64_t now_ns) {
    if (isOpen())
        return;
    reader_.restart();
    greeting_error_.reset();
    next_sequence_ = 0;
    unknown_versions_when_opened_ = reader_.statistics().unknown_versions;
    opened_ns_ = queried_ns_ = pinged_ns_ = last_frame_ns_ = now_ns;
    state_ = State::kGreeting;
    send(Type::kQuery, {});
}

void StudioConversation::closed(int64_t now_ns) {
    if (state_ == State::kClosed || state_ == State::kPausing)
        return;
    if (!hello_)
        refuse(trouble("the connection was closed before a box answered",
                       "Is another program connected to it?"));
    else if (state_ == State::kOpening)
        pause(now_ns);
    else
        loseLink("the connection was closed", now_ns);
}

void StudioConversation::receive(ByteView bytes, int64_t now_ns) {
    if (!isOpen())
        return;
    // A frame may end the connection; what follows it in the same piece is not looked at.
    reader_.push(bytes, now_ns, [&](const LinkFrame& frame) {
        if (isOpen())
            handle(frame, now_ns);
    });
    const FrameStatistics& counts = reader_.statistics();
    if (state_ == State::kGreeting && counts.unknown_versions > unknown_versions_when_opened_ &&
        counts.last_unknown_version->type == static_cast<uint8_t>(Type::kHello))
        refuse(trouble("the box speaks version " + std::to_string(counts.last_unknown_version->version) +
                           " of the link, this program speaks 1",
                       "Update this program or the box's firmware"));
}

void StudioConversation::tick(int64_t now_ns) {
    if (state_ == State::kPausing && now_ns >= pause_until_ns_) {
        state_ = State::kOpening;
        events_.push_back(ConnectWanted{attempt_});
    }
    if (!isOpen())
        return;
    reader_.idle(now_ns, [&](const LinkFrame& frame) {
        if (isOpen())
            handle(frame, now_ns);
    });
    if (state_ == State::kGreeting)
        tickGreeting(now_ns);
    if (isOpen())
        expireRequests(now_ns);
    if (isOpen())
        tickSound(now_ns);
    if (isOpen())
        ping(now_ns);
}

void StudioConversation::tickGreeting(int64_t now_ns) {
    if (now_ns - opened_ns_ >= kGiveUpGreeting_ns) {
        if (hello_)
            loseLink("the box does not answer", now_ns);
        else
            refuse(greeting_error_.value_or(
                trouble("no driver box answers",
                        "Check that it is switched on and that this is its address or port")));
    } else if (now_ns - queried_ns_ >= kQueryEvery_ns) {
        queried_ns_ = now_ns;
        send(Type::kQuery, {});
    }
}

void StudioConversation::tickSound(int64_t now_ns) {
    if (state_ == State::kStarting && start_acknowledged_ns_ &&
        now_ns - *start_acknowledged_ns_ >= kFirstSound_ns)
        requestFailed(Type::kStart, trouble("the box accepted START but sends no sound", "Start again"));
    if (state_ == State::kIdle && now_ns - last_frame_ns_ >= kLost_ns)
        loseLink("the box has been silent for 3 s", now_ns);
    if (state_ != State::kStreaming)
        return;
    if (now_ns - last_sound_ns_ >= kLost_ns)
        loseLink("no sound for 3 s", now_ns);
    else if (now_ns - last_sound_ns_ >= kStalled_ns && !std::exchange(stalled_, true))
        events_.push_back(Stalled{});
}

void StudioConversation::ping(int64_t now_ns) {
    if (now_ns - pinged_ns_ < kPingEvery_ns)
        return;
    pinged_ns_ = now_ns;
    Bytes payload;
    WireWriter(payload).number(static_cast<uint64_t>(now_ns));
    send(Type::kPing, payload);
}

void StudioConversation::start(int64_t now_ns) {
    if (state_ != State::kIdle) {
        events_.push_back(RequestFailed{
            Type::kStart, trouble("no box is ready to start", "Connect, or stop the running take first")});
    } else if (box_streams_for_nobody_) {
        state_ = State::kClearing;
        start_wanted_ = true;
        request(Type::kStop, {}, now_ns);
    } else {
        sendStart(now_ns);
    }
}

void StudioConversation::sendStart(int64_t now_ns) {
    state_ = State::kStarting;
    sequence_.emplace(hello_->boardCount(), hello_->sample_rate_hz);
    losses_at_last_block_ = losses();
    start_acknowledged_ns_.reset();
    request(Type::kStart, startPayload(), now_ns);
}

void StudioConversation::stop(int64_t now_ns) {
    if (state_ == State::kStreaming || state_ == State::kStarting) {
        requests_.forget(Type::kStart);
        state_ = State::kStopping;
        last_sound_ns_ = now_ns;
        request(Type::kStop, {}, now_ns);
    } else if (state_ == State::kClearing) {
        start_wanted_ = false;
    } else if (take_ && state_ != State::kStopping) {
        // Without a link: the box will be found streaming for nobody.
        finishTake();
    }
}

void StudioConversation::identify(const Identify& identify, int64_t now_ns) {
    request(Type::kIdentify, toPayload(identify), now_ns);
}

void StudioConversation::set(const Settings& settings, int64_t now_ns) {
    request(Type::kSet, toPayload(settings), now_ns);
}

void StudioConversation::hangUp() {
    if (take_)
        endTake("the link was closed while recording");
    requests_.giveUp();
    outgoing_.clear();
    hello_.reset();
    state_ = State::kClosed;
}

void StudioConversation::request(Type type, Bytes payload, int64_t now_ns) {
    if (state_ < State::kIdle)
        events_.push_back(RequestFailed{type, trouble("no box is connected", "Connect first")});
    else
        requests_.send(type, std::move(payload), now_ns,
                       [&](Type sent, ByteView bytes) { return send(sent, bytes); });
}

void StudioConversation::expireRequests(int64_t now_ns) {
    const auto failed = requests_.expire(now_ns, last_sound_ns_,
                                         [&](Type type, ByteView bytes) { return send(type, bytes); });
    for (const Type type : failed)
        requestFailed(type,
                      trouble("the box does not answer " + nameOf(type), "Check the cable and try again"));
}

void StudioConversation::requestFailed(Type type, const Error& why) {
    const bool was_clearing = state_ == State::kClearing && type == Type::kStop;
    const bool was_stopping =
        type == Type::kStop && (state_ == State::kStopping || (was_clearing && !start_wanted_));
    const bool was_starting = state_ == State::kStarting && type == Type::kStart;
    // A box that does not start may begin later, one that does not stop goes on: STOP comes before the next
    // START.
    if (type == Type::kStop || was_starting)
        box_streams_for_nobody_ = true;
    if (was_clearing || was_starting || was_stopping)
        state_ = State::kIdle;
    events_.push_back(RequestFailed{was_clearing && start_wanted_ ? Type::kStart : type, why});
    if (was_stopping)
        finishTake();
}

uint32_t StudioConversation::send(Type type, ByteView payload) {
    const Bytes frame = encodeFrame(static_cast<uint8_t>(type), next_sequence_, payload);
    outgoing_.insert(outgoing_.end(), frame.begin(), frame.end());
    return next_sequence_++;
}

void StudioConversation::loseLink(const std::string& why, int64_t now_ns) {
    const Error error =
        trouble(why, "The studio tries again by itself; check the cable and the box's battery");
    for (const Type type : requests_.giveUp())
        requestFailed(type, error);
    if (state_ == State::kStarting)
        events_.push_back(RequestFailed{Type::kStart, error});
    events_.push_back(LinkLost{error});
    pause(now_ns);
}

void StudioConversation::pause(int64_t now_ns) {
    const auto index = std::min<size_t>(static_cast<size_t>(attempt_), kPauses_ms.size() - 1);
    pause_until_ns_ = now_ns + kPauses_ms[index] * kMillisecond_ns;
    ++attempt_;
    stalled_ = false;
    outgoing_.clear();
    state_ = State::kPausing;
}

void StudioConversation::endTake(const std::string& why) {
    take_.reset();
    events_.push_back(TakeEnded{trouble(why, "What was recorded until then is complete; start a new take")});
}

void StudioConversation::finishTake() {
    take_.reset();
    events_.push_back(Stopped{});
}

void StudioConversation::refuse(const Error& why) {
    events_.push_back(Refused{why});
    hangUp();
}

}  // namespace noctule::link
