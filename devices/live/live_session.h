// SPDX-License-Identifier: Apache-2.0
// A device at work: connects it, records and processes its streams, and shows how all of it fares. A stream
// reaches from begin() to finish(); with a take in its request it is recorded, without one it is only looked
// at. While somebody only looks, takes can begin and end in the stream's midst, even some seconds before they
// were asked for. A link that breaks leaves a gap in the take, to its end where it does not come back; a box
// that restarts ends it, intact.
//
// begin() (it opens a file) and finish() (it waits for the disk and the pipeline) belong into a job: on any
// thread, one after the other. All others return at once and may be called from any thread meanwhile.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "devices/live/published.h"
#include "devices/live/stream_feed.h"
#include "devices/live/stream_past.h"
#include "devices/live/stream_request.h"

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
    std::optional<Error> trouble;  ///< why the last stream ended unasked or none began, or no box answers
    std::string last_message;      ///< for the operator: of the box, or why the link was lost
    std::vector<uint16_t> board_flags;  ///< link::kBoardConnected ...
    int64_t reconnections = 0;
};

/// What a suit's part of a take lacks at its end.
struct MissingEnd {
    int64_t until = 0;      ///< a sample of the take
    std::string who{};      ///< begins a sentence; empty: the only suit
    bool is_lost = true;    ///< else it came late
    bool broke_off = true;  ///< its link was stalled or lost
    bool others_went_on = false;

    std::string inWords(double from_s, double missing_s) const;
};

class LiveSession {
public:
    static constexpr double kLongestPreRoll_s = 10;
    /// Less sound that is missing at the end is no loss: boxes start some milliseconds apart, and the rest of
    /// a take comes in blocks.
    static constexpr double kWorthMarking_s = 0.25;

    explicit LiveSession(std::unique_ptr<Device> device);
    LiveSession(const LiveSession&) = delete;
    LiveSession& operator=(const LiveSession&) = delete;
    /// Closes the device; an open take ends where it is.
    ~LiveSession();

    /// Once, and before the rest.
    void connect();
    /// In kReady: makes the take, then starts the device; its first sample is the take's. While a stream
    /// without a take runs: the take begins in its midst, `pre_roll_s` before now, and the looking goes on.
    /// A pipeline that cannot work does not hinder the recording; processingTrouble() says why. `into`: what
    /// the take is written into, instead of a new file.
    Status begin(const StreamRequest& request, std::unique_ptr<TakeSink> into = nullptr);
    /// Asks the box to stop; the stream is open until all that it holds has come.
    void stop();
    /// Ends what began last, here and now: completes the take and, if asked for, writes the results into it.
    /// After a take that began in the midst of a stream the looking goes on; otherwise the device is stopped
    /// unless it was before. `patience_s`: processes what waits for so long at most; all of it if not given.
    StreamResult finish(std::optional<double> patience_s = {});

    /// Lights a board's lamp. A box that cannot says so in status().
    void identify(const link::Identify& identify) { device_->identify(identify); }
    /// Before begin(): holds from the next stream on.
    void set(const link::Settings& settings) { device_->set(settings); }

    /// Into the take that began last, at its newest sample or at one that has come already.
    void addMarker(const std::string& kind, const std::string& label, std::optional<int64_t> sample = {});
    void addNote(const std::string& text);

    /// Of the take that began last: where rows of others go, such as a robot's. Once the take has ended, what
    /// is pushed there is thrown away.
    struct TakeInput {
        std::shared_ptr<Recorder> recorder;
        int64_t origin_ns = 0;  ///< the stream's time at which the take's time is 0
    };
    std::optional<TakeInput> takeInput() const;

    /// Whether what began last is a take in the midst of a stream that goes on without it.
    bool isInMidst() const {
        const std::lock_guard lock(mutex_);
        return take_ != nullptr;
    }
    std::shared_ptr<const SessionStatus> status() const { return status_.get(); }
    /// Null without processing. A take that begins in the midst of a processed stream leaves undisturbed what
    /// is shown: the frames stay those of the stream, on its clock.
    std::shared_ptr<const LiveFrame> latest() const;
    /// Why nothing is processed, or nothing any more, although that was asked for.
    std::optional<Error> processingTrouble() const;
    /// Absent without a take.
    std::optional<RecorderState> recording() const;
    /// Of what began last, on its clock.
    int64_t reachedSample() const;
    /// Of what began last, on its clock: where its sound should have ended, when it broke off and did not
    /// come back before stop() or now.
    std::optional<int64_t> brokenOffUntil() const;
    /// A gap of the take, which finish() tells; finish() marks what broke off where nobody did before.
    void markMissing(const MissingEnd& end);
    link::LinkStatistics linkStatistics() const { return device_->statistics(); }

private:
    struct Stream {
        StreamRequest request;
        std::shared_ptr<Recorder> recorder;
        std::shared_ptr<LiveProcessor> processor;
        std::shared_ptr<StreamFeed> feed;
        std::optional<Error> not_processed;  ///< although it was asked for
        std::vector<std::string> warnings;
        std::string missing_end;    ///< in words; empty: the take's end is there
        std::optional<Error> lost;  ///< its sound broke off

        std::optional<Error> processingTrouble() const;
    };
    using StreamPointer = std::shared_ptr<Stream>;

    void onEvent(DeviceEvent event);
    void feed(DeviceEvent&& event);
    template <class Change>
    void change(Change change) {
        const std::lock_guard lock(mutex_);
        change(state_);
        status_.set(state_);
    }
    void follow(const link::StudioEvent& event);
    void markStarted();
    int64_t dueSample() const;
    void markMissing(Stream& stream, const MissingEnd& end);
    void showFlow(LinkState link);
    void endStream(const std::optional<Error>& why, LinkState link);
    LinkState linkWithoutStream() const;
    /// Of what began last; null when nothing is open.
    StreamPointer newest() const;

    using Sink = std::unique_ptr<TakeSink>;  ///< null: a new file is made
    Status beginWithDevice(const StreamRequest& request, const link::Hello& hello, Sink into);
    Status beginInMidst(const StreamRequest& request, const link::Hello& hello, Sink into);
    Result<StreamPointer> makeStream(const StreamRequest& request, const link::Hello& hello,
                                     int64_t pre_roll_samples, Sink into);
    Result<std::shared_ptr<Recorder>> makeRecorder(const StreamRequest& request, const link::Hello& hello,
                                                   const Suit& suit, int64_t pre_roll_samples, Sink into);
    void startProcessor(Stream& stream, const link::Hello& hello, const Suit& suit, int64_t pre_roll_samples);
    Error notReady() const;
    StreamPointer detachNewest();
    void stopAfterLast();
    StreamResult finishNewest(std::optional<double> patience_s);
    void keepResults(Stream& stream, StreamResult& result);

    std::mutex control_;  ///< of begin() and finish()
    std::mutex order_;    ///< of the following: data come to all that are fed in one order
    std::vector<std::shared_ptr<StreamFeed>> feeds_;
    std::optional<StreamPast> past_;  ///< of a stream that is only looked at
    bool started_ = false;            ///< its first data have come, its last have not
    int board_count_ = 0;             ///< of its blocks

    std::atomic<int64_t> newest_sound_ns_{0};
    std::atomic<bool> is_silent_{false};  ///< stalled or lost, and no sound has come since

    mutable std::mutex mutex_;  ///< of the following, held for moments
    SessionStatus state_;
    std::optional<int64_t> due_sample_;  ///< dueSample() when the stream was told to stop
    StreamPointer stream_, take_;        ///< the device's, and the take that began in its midst
    Published<SessionStatus> status_;
    std::unique_ptr<Device> device_;  ///< last: it goes first, and its events with it
};

}  // namespace noctule
