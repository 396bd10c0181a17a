// SPDX-License-Identifier: Apache-2.0
#include "devices/live/live_session.h"

#include <cmath>

namespace noctule {

LiveSession::LiveSession(std::unique_ptr<Device> device) : device_(std::move(device)) {}

LiveSession::~LiveSession() {
    device_.reset();
    finish();
}

template <class Change>
void LiveSession::change(Change change) {
    const std::lock_guard lock(mutex_);
    change(state_);
    status_.set(state_);
}

void LiveSession::connect() {
    change([](SessionStatus& s) { s.link = LinkState::kOpening; });
    device_->open([this](DeviceEvent event) { onEvent(std::move(event)); });
}

void LiveSession::stop() {
    change([](SessionStatus& s) {
        if (s.stream_is_open && s.link != LinkState::kLost)
            s.link = LinkState::kStopping;
    });
    device_->stop();
}

std::shared_ptr<StreamFeed> LiveSession::feed() const {
    const std::lock_guard lock(mutex_);
    return stream_ && state_.stream_is_open && started_ ? stream_->feed : nullptr;
}

void LiveSession::onEvent(DeviceEvent event) {
    follow(event.event);
    if (const auto open = feed())
        open->take(std::move(event));
}

/// `link`: as it is from then on.
void LiveSession::endStream(const std::optional<Error>& why, LinkState link) {
    if (const auto open = feed())
        open->flush();
    change([&](SessionStatus& s) {
        if (why && (s.stream_is_open || link == LinkState::kRefused))
            s.trouble = why;
        s.stream_is_open = false;
        if (s.link != LinkState::kRefused)
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
            if (!s.stream_is_open)
                s.link = LinkState::kReady;
        });
    } else if (std::get_if<link::Started>(&event)) {
        change([this](SessionStatus& s) {
            s.link = LinkState::kStreaming;
            started_ = true;
        });
    } else if (std::get_if<link::Flowing>(&event)) {
        change([](SessionStatus& s) { s.link = LinkState::kStreaming; });
    } else if (std::get_if<link::Stalled>(&event)) {
        change([](SessionStatus& s) { s.link = LinkState::kStalled; });
    } else if (const auto* lost = std::get_if<link::LinkLost>(&event)) {
        change([&](SessionStatus& s) {
            s.link = LinkState::kLost;
            s.last_message = lost->why.text();
        });
    } else if (std::get_if<link::Resumed>(&event)) {
        change([](SessionStatus& s) {
            s.link = LinkState::kStreaming;
            ++s.reconnections;
        });
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

void LiveSession::addMarker(const std::string& kind, const std::string& label) {
    if (const auto open = feed())
        open->addMarker(kind, label);
}

void LiveSession::addNote(const std::string& text) {
    if (const auto open = feed())
        open->addNote(text);
}

std::shared_ptr<const LiveFrame> LiveSession::latest() const {
    const std::lock_guard lock(mutex_);
    return stream_ && stream_->processor ? stream_->processor->latest() : nullptr;
}

std::optional<Error> LiveSession::processingTrouble() const {
    const std::lock_guard lock(mutex_);
    return stream_ ? stream_->processingTrouble() : std::nullopt;
}

std::optional<Error> LiveSession::Stream::processingTrouble() const {
    return processor ? processor->latest()->trouble : not_processed;
}

std::optional<RecorderState> LiveSession::recording() const {
    std::shared_ptr<Recorder> recorder;
    {
        const std::lock_guard lock(mutex_);
        recorder = stream_ ? stream_->recorder : nullptr;
    }
    return recorder ? std::optional(recorder->state()) : std::nullopt;
}

int64_t LiveSession::reachedSample() const {
    const std::lock_guard lock(mutex_);
    return stream_ ? stream_->feed->reachedSample() : 0;
}

}  // namespace noctule
