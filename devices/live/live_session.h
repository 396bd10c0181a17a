// SPDX-License-Identifier: Apache-2.0
// A device at work: connects it, records and processes its streams, and shows how all of it fares. A stream
// reaches from begin() to finish(); with a take in its request it is recorded, without one it is only looked
// at. A link that breaks and comes back leaves a gap in the take; a box that restarts ends it, intact.
// For one thread of control; latest(), status() and recording() from any thread, without waiting.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "devices/device/device.h"
#include "devices/live/published.h"
#include "devices/live/stream_feed.h"

namespace noctule {

enum class LinkState {
    kClosed,
    kOpening,
    kReady,     ///< greeted, no stream
    kStarting,  ///< until the first sound
    kStreaming,
    kStalled,  ///< no sound for half a second
    kLost,     ///< reconnecting; the stream is still open
    kStopping,
    kRefused,  ///< for good
};

struct SessionStatus {
    LinkState link = LinkState::kClosed;
    std::optional<link::Hello> hello;
    bool stream_is_open = false;   ///< from begin() to the last sample
    std::optional<Error> trouble;  ///< why the last stream ended unasked, or none began, or the link is lost
    std::string last_message;      ///< of the box, for the operator
    std::vector<uint16_t> board_flags;  ///< link::kBoardConnected ...
    int64_t reconnections = 0;
};

struct RecordingRequest {
    std::filesystem::path folder;
    std::string name = "take";
    std::string take_kind = "motion";
    std::map<std::string, std::string> meta;  ///< performer, actor_name, ...
    int64_t reserve_bytes = RecorderSettings{}.reserve_bytes;
    bool compress = false;
};

struct StreamRequest {
    std::optional<RecordingRequest> take;
    std::optional<Suit> suit;  ///< as this performer wears it, matched by serial; else as the box says
    std::optional<Calibration> calibration;
    std::optional<Actor> actor;
    bool process = true;
    bool keep_results = false;  ///< the live results become derived runs of the take
    TrackerSettings tracker;
    Detector detector = Detector::kInflection;
    double rest_s = 0;  ///< the performer begins in the rest pose and holds it so long
    std::string software, created_utc;
};

struct StreamResult {
    std::optional<RecorderState> recording;
    std::shared_ptr<const LiveFrame> frame;  ///< the last one; null without processing
    std::optional<ProcessSummary> results;   ///< in the take
    std::vector<std::string> warnings;       ///< whole sentences
    std::optional<Error> trouble;            ///< of the device; the recorder's own stands in recording
};

class LiveSession {
public:
    explicit LiveSession(std::unique_ptr<Device> device);
    LiveSession(const LiveSession&) = delete;
    LiveSession& operator=(const LiveSession&) = delete;
    /// Closes the device; an open take ends where it is.
    ~LiveSession();

    void connect();
    /// In kReady: makes the take, then starts the device. A pipeline that cannot work does not hinder the
    /// recording; why is a warning of the result.
    Status begin(const StreamRequest& request);
    /// Asks the box to stop; the stream is open until all that it holds has come.
    void stop();
    /// Ends the stream here and now, completes the take and, if asked for, writes the results into it.
    StreamResult finish();

    /// Lights a board's lamp. A box that cannot says so in status().
    void identify(const link::Identify& identify) { device_->identify(identify); }
    /// Before begin(): holds from the next stream on.
    void set(const link::Settings& settings) { device_->set(settings); }

    void addMarker(const std::string& kind, const std::string& label);
    void addNote(const std::string& text);

    std::shared_ptr<const SessionStatus> status() const { return status_.get(); }
    /// Null without processing.
    std::shared_ptr<const LiveFrame> latest() const;
    /// Absent without a take.
    std::optional<RecorderState> recording() const;
    int64_t reachedSample() const;
    link::LinkStatistics linkStatistics() const { return device_->statistics(); }

private:
    struct Stream {
        StreamRequest request;
        std::shared_ptr<Recorder> recorder;
        std::shared_ptr<LiveProcessor> processor;
        std::shared_ptr<StreamFeed> feed;
        std::vector<std::string> warnings;
    };
    void onEvent(DeviceEvent event);
    template <class Change>
    void change(Change change);
    void follow(const link::StudioEvent& event);
    void endStream(std::optional<Error> why);
    std::shared_ptr<StreamFeed> feed() const;
    Result<std::shared_ptr<Recorder>> makeRecorder(const StreamRequest& request, const link::Hello& hello,
                                                   const Suit& suit);
    void startProcessor(Stream& stream, const link::Hello& hello, const Suit& suit);
    void keepResults(Stream& stream, StreamResult& result);

    mutable std::mutex mutex_;  ///< held for moments
    SessionStatus state_;
    std::shared_ptr<Stream> stream_;
    bool started_ = false;  ///< its first data have come
    Published<SessionStatus> status_;
    std::unique_ptr<Device> device_;  ///< last: it goes first, and its events with it
};

}  // namespace noctule
