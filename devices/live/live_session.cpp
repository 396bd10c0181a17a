// SPDX-License-Identifier: Apache-2.0
#include "devices/live/live_session.h"

#include "devices/machine/clock.h"

namespace noctule {

LiveSession::LiveSession(std::unique_ptr<Device> device) : device_(std::move(device)) {}

LiveSession::~LiveSession() {
    device_.reset();
    endStream(std::nullopt, LinkState::kClosed);
    while (newest())
        finish();
}

void LiveSession::connect() {
    change([](SessionStatus& s) { s.link = LinkState::kOpening; });
    device_->open([this](DeviceEvent event) { onEvent(std::move(event)); });
}

void LiveSession::stop() {
    const int64_t due = dueSample();
    change([&](SessionStatus& s) {
        due_sample_ = due_sample_.value_or(due);
        if (s.stream_is_open && s.link != LinkState::kLost)
            s.link = LinkState::kStopping;
    });
    device_->stop();
}

void LiveSession::onEvent(DeviceEvent event) {
    follow(event.event);
    feed(std::move(event));
}

void LiveSession::feed(DeviceEvent&& event) {
    const std::lock_guard lock(order_);
    if (!started_)
        return;
    const auto data = streamEventOf(std::move(event), board_count_);
    if (!data)
        return;
    if (const auto* block = std::get_if<ArrivedBlock>(&*data)) {
        newest_sound_ns_ = block->arrived_ns;
        is_silent_ = false;
    }
    if (past_)
        past_->add(*data);
    for (const auto& fed : feeds_)
        fed->take(*data);
}

void LiveSession::markStarted() {
    const std::lock_guard lock(order_);
    started_ = true;
    newest_sound_ns_ = steadyNow_ns();
}

/// `link`: as it is from then on.
void LiveSession::endStream(const std::optional<Error>& why, LinkState link) {
    {
        const std::lock_guard lock(order_);
        started_ = false;
        is_silent_ = false;
        for (const auto& fed : feeds_)
            fed->flush();
    }
    change([&](SessionStatus& s) {
        if (why && (s.stream_is_open || link == LinkState::kRefused))
            s.trouble = why;
        s.stream_is_open = false;
        if (s.link != LinkState::kRefused)
            s.link = link;
    });
}

/// What flows while the box is being stopped is the rest.
void LiveSession::showFlow(LinkState link) {
    change([&](SessionStatus& s) {
        if (s.stream_is_open && s.link != LinkState::kStopping)
            s.link = link;
    });
}

/// A lost link stays lost until the box has greeted again.
LinkState LiveSession::linkWithoutStream() const {
    return status()->link == LinkState::kLost ? LinkState::kLost : LinkState::kReady;
}

void LiveSession::follow(const link::StudioEvent& event) {
    if (const auto* greeted = std::get_if<link::Greeted>(&event)) {
        change([&](SessionStatus& s) {
            s.hello = greeted->hello;
            if (!s.stream_is_open && s.link != LinkState::kStopping)
                s.link = LinkState::kReady;
        });
    } else if (std::get_if<link::Started>(&event)) {
        markStarted();
        showFlow(LinkState::kStreaming);
    } else if (std::get_if<link::Flowing>(&event)) {
        showFlow(LinkState::kStreaming);
    } else if (std::get_if<link::Stalled>(&event)) {
        is_silent_ = status()->stream_is_open;
        showFlow(LinkState::kStalled);
    } else if (const auto* lost = std::get_if<link::LinkLost>(&event)) {
        is_silent_ = status()->stream_is_open;
        change([&](SessionStatus& s) {
            s.link = LinkState::kLost;
            s.last_message = lost->why.text();
        });
    } else if (std::get_if<link::Resumed>(&event)) {
        showFlow(LinkState::kStreaming);
        change([](SessionStatus& s) { ++s.reconnections; });
    } else if (std::get_if<link::Stopped>(&event)) {
        endStream(std::nullopt, linkWithoutStream());
    } else if (const auto* ended = std::get_if<link::TakeEnded>(&event)) {
        endStream(ended->why, LinkState::kReady);
    } else if (const auto* failed = std::get_if<link::RequestFailed>(&event)) {
        if (failed->type == link::Type::kStart)
            endStream(failed->why, linkWithoutStream());
        else
            change([&](SessionStatus& s) { s.last_message = failed->why.text(); });
    } else if (const auto* refused = std::get_if<link::Refused>(&event)) {
        endStream(refused->why, LinkState::kRefused);
    } else if (const auto* error = std::get_if<link::BoxError>(&event)) {
        change([&](SessionStatus& s) { s.last_message = nameOf(error->code) + ": " + error->text; });
    } else if (const auto* status = std::get_if<link::BoxStatus>(&event)) {
        change([&](SessionStatus& s) { s.board_flags = status->board_flags; });
    }
}

LiveSession::StreamPointer LiveSession::newest() const {
    const std::lock_guard lock(mutex_);
    return take_ ? take_ : stream_;
}

void LiveSession::addMarker(const std::string& kind, const std::string& label,
                            std::optional<int64_t> sample) {
    if (const auto stream = newest())
        stream->feed->addMarker(kind, label, sample);
}

void LiveSession::addNote(const std::string& text) {
    if (const auto stream = newest())
        stream->feed->addNote(text);
}

std::shared_ptr<const LiveFrame> LiveSession::latest() const {
    const std::lock_guard lock(mutex_);
    for (const auto& stream : {stream_, take_})
        if (stream && stream->processor)
            return stream->processor->latest();
    return nullptr;
}

std::optional<Error> LiveSession::Stream::processingTrouble() const {
    return processor ? processor->latest()->trouble : not_processed;
}

std::optional<Error> LiveSession::processingTrouble() const {
    const std::lock_guard lock(mutex_);
    for (const auto& stream : {take_, stream_})
        if (const auto trouble = stream ? stream->processingTrouble() : std::nullopt)
            return trouble;
    return std::nullopt;
}

std::optional<RecorderState> LiveSession::recording() const {
    const auto stream = newest();
    return stream && stream->recorder ? std::optional(stream->recorder->state()) : std::nullopt;
}

std::optional<LiveSession::TakeInput> LiveSession::takeInput() const {
    const auto stream = newest();
    if (!stream || !stream->recorder)
        return std::nullopt;
    return TakeInput{stream->recorder, stream->feed->origin_ns()};
}

int64_t LiveSession::reachedSample() const {
    const auto stream = newest();
    return stream ? stream->feed->reachedSample() : 0;
}

}  // namespace noctule
