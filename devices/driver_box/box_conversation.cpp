// SPDX-License-Identifier: Apache-2.0
#include "devices/driver_box/box_conversation.h"

#include <algorithm>

#include "core/job/contract.h"

namespace noctule::link {

BoxConversation::BoxConversation(Hello hello, BoxOptions options)
    : hello_(std::move(hello)),
      options_(options),
      queue_(static_cast<int64_t>(std::max(options.buffer_s, kLeastBuffer_s) * hello_.sample_rate_hz),
             options.adc_format) {
    require(hello_.boardCount() > 0 && hello_.boardCount() <= kMaxBoards && !hello_.serial.empty(),
            "BoxConversation: HELLO names no boards or no serial number");
    conditions_.board_flags.assign(hello_.suit.boards.size(), kBoardConnected);
}

void BoxConversation::connected(int64_t now_ns) {
    if (has_client_)
        disconnected(now_ns);
    has_client_ = true;
    heard_ns_ = status_ns_ = now_ns;
    reader_.restart();
    queue_.restart();
}

void BoxConversation::disconnected(int64_t now_ns) {
    if (!has_client_)
        return;
    has_client_ = started_by_this_client_ = false;
    alone_since_ns_ = now_ns;
    queue_.restart();
    if (!streaming_)
        queue_.clearData();
    stops_.clear();
}

void BoxConversation::receive(ByteView bytes, int64_t now_ns) {
    if (!has_client_)
        return;
    heard_ns_ = now_ns;
    reader_.push(bytes, now_ns, [&](const LinkFrame& frame) { handle(frame); });
    answerStops();
}

void BoxConversation::tick(int64_t now_ns) {
    if (!has_client_) {
        if (streaming_ && now_ns - alone_since_ns_ >= kAloneAtMost_ns) {
            stopStreaming();
            queue_.clearData();
        }
        return;
    }
    reader_.idle(now_ns, [&](const LinkFrame& frame) { handle(frame); });
    if (now_ns - status_ns_ >= kStatusEvery_ns) {
        status_ns_ += (now_ns - status_ns_) / kStatusEvery_ns * kStatusEvery_ns;
        sendStatus();
    }
    if (options_.drops_silent_clients && now_ns - heard_ns_ >= kSilence_ns)
        dropClient("the client has been silent for 10 s", now_ns);
    else if (queue_.heldSmallBytes() > kMostSmallBytes)
        dropClient("the client does not read", now_ns);
}

void BoxConversation::dropClient(const std::string& why, int64_t now_ns) {
    events_.push_back(ClientDropped{why});
    disconnected(now_ns);
}

void BoxConversation::handle(const LinkFrame& frame) {
    const uint32_t request = frame.header.sequence;
    switch (static_cast<Type>(frame.header.type)) {
        case Type::kQuery:
            return frame.payload.empty() ? sayHello() : answer(request, Code::kBadPayload);
        case Type::kStop:
            return frame.payload.empty() ? stop(request) : answer(request, Code::kBadPayload);
        case Type::kPing:
            if (frame.payload.size() > kMaxPingBytes)
                return answer(request, Code::kBadPayload);
            return queue_.pushControl(Type::kPong, {frame.payload.begin(), frame.payload.end()});
        default:
            answer(request, handleRequest(frame));
    }
}

Code BoxConversation::handleRequest(const LinkFrame& frame) {
    switch (static_cast<Type>(frame.header.type)) {
        case Type::kStart:
            return start(frame.payload);
        case Type::kIdentify:
            return identify(frame.payload);
        case Type::kSet:
            return set(frame.payload);
        default:
            return Code::kUnknownType;
    }
}

void BoxConversation::answer(uint32_t request, Code code) {
    queue_.pushControl(Type::kAck, toPayload(Ack{request, code, code == Code::kOk ? "" : nameOf(code)}));
}

/// Answers go before data, so a stream that goes on does so right after this HELLO.
void BoxConversation::sayHello() {
    hello_.streaming = streaming_;
    queue_.pushControl(Type::kHello, toPayload(hello_));
    if (streaming_)
        queue_.allowData(true);
}

Code BoxConversation::start(ByteView payload) {
    if (payload.size() != startPayload().size())
        return Code::kBadPayload;
    if (streaming_ && started_by_this_client_)
        return Code::kOk;
    if (streaming_ || !stops_.empty())
        return Code::kNotNow;
    queue_.clearData();
    queue_.allowData(true);
    streaming_ = started_by_this_client_ = true;
    next_sample_ = dropped_samples_ = 0;
    events_.push_back(StartWanted{});
    return Code::kOk;
}

void BoxConversation::stopStreaming() {
    streaming_ = started_by_this_client_ = false;
    events_.push_back(StopWanted{});
}

void BoxConversation::stop(uint32_t request) {
    if (streaming_)
        stopStreaming();
    queue_.allowData(true);
    stops_.push_back(request);
}

void BoxConversation::answerStops() {
    if (stops_.empty() || queue_.holdsData())
        return;
    for (const uint32_t request : stops_)
        answer(request, Code::kOk);
    stops_.clear();
}

Code BoxConversation::identify(ByteView payload) {
    const auto wish = readIdentify(payload);
    if (!wish || (wish->board != kAllBoardsOff && wish->board >= hello_.boardCount()))
        return Code::kBadPayload;
    events_.push_back(IdentifyWanted{*wish});
    return Code::kOk;
}

Code BoxConversation::set(ByteView payload) {
    const Result<Settings> settings = readSettings(payload);
    const auto known = [&](int source) { return source < static_cast<int>(hello_.suit.sources.size()); };
    if (!settings ||
        (settings.value().enabled_sources && !std::all_of(settings.value().enabled_sources->begin(),
                                                          settings.value().enabled_sources->end(), known)))
        return Code::kBadPayload;
    const Settings& wish = *settings;
    if ((!options_.sets_pulses && (wish.pulse_interval_samples || wish.pulse_cycles)) ||
        (!options_.sets_sources && wish.enabled_sources))
        return Code::kNotSupported;
    if (streaming_ || !stops_.empty())
        return Code::kNotNow;
    hello_.pulse_interval_samples = wish.pulse_interval_samples.value_or(hello_.pulse_interval_samples);
    hello_.pulse_cycles = wish.pulse_cycles.value_or(hello_.pulse_cycles);
    hello_.name = wish.name.value_or(hello_.name);
    events_.push_back(SettingsWanted{wish});
    return Code::kOk;
}

void BoxConversation::sendStatus() {
    BoxStatus status = conditions_;
    status.sample = queue_.firstUnsentSample().value_or(next_sample_);
    status.dropped_samples = static_cast<uint32_t>(dropped_samples_);
    status.board_flags.resize(hello_.suit.boards.size());
    queue_.pushControl(Type::kStatus, toPayload(status));
}

void BoxConversation::offer(const std::vector<EmittedPulse>& pulses) {
    if (streaming_ && !pulses.empty())
        queue_.pushPulses(pulses);
}

void BoxConversation::offer(SoundBlock block) {
    if (!streaming_)
        return;
    require(block.board_count == hello_.boardCount() && block.first_sample >= next_sample_ &&
                block.sampleCount() >= 1 && block.sampleCount() <= kMaxBlockSamples,
            "BoxConversation::offer: blocks rise, of 1 to 4096 samples of all boards");
    next_sample_ = block.first_sample + block.sampleCount();
    const auto dropped = queue_.pushSound(std::move(block));
    if (!dropped)
        return;
    dropped_samples_ += dropped->sample_count;
    if (!queue_.holdsOverrun())
        report({Code::kOverrun, dropped->first_sample, "the link is too slow, sound was dropped"});
}

void BoxConversation::report(const BoxError& error) {
    if (has_client_ || streaming_)
        queue_.pushControl(Type::kError, toPayload(error));
}

Bytes BoxConversation::read(size_t most_bytes) {
    if (!has_client_)
        return {};
    Bytes bytes = queue_.read(most_bytes);
    if (stops_.empty() || queue_.holdsData())
        return bytes;
    answerStops();
    const Bytes answers = queue_.read(most_bytes - bytes.size());
    bytes.insert(bytes.end(), answers.begin(), answers.end());
    return bytes;
}

}  // namespace noctule::link
