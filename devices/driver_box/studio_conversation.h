// SPDX-License-Identifier: Apache-2.0
// The studio's side of the link (README.md, section 4) as a value: bytes and the time go in, bytes to send
// and events come out; it opens nothing, waits for nothing and reads no clock. Its owner moves bytes between
// it and a stream, calls tick() about every 50 ms, and after each call sends takeBytes() and handles
// takeEvents(). Times are nanoseconds of any clock that does not go back.
#pragma once

#include "devices/driver_box/frame.h"
#include "devices/driver_box/request_book.h"
#include "devices/driver_box/studio_event.h"

namespace noctule::link {

struct LinkStatistics {
    FrameStatistics frames;
    int64_t bad_content = 0;       ///< good frames whose payload cannot be
    int64_t unknown_types = 0;     ///< ignored
    int64_t duplicate_blocks = 0;  ///< wholly old ADC blocks
    int64_t lost_samples = 0;      ///< of the last take, as gaps
    int64_t reconnections = 0;
    std::optional<int64_t> round_trip_ns;  ///< of the last PING
};

class StudioConversation {
public:
    static constexpr int64_t kMillisecond_ns = 1'000'000;
    static constexpr int64_t kQueryEvery_ns = 500 * kMillisecond_ns,
                             kGiveUpGreeting_ns = 3000 * kMillisecond_ns;
    static constexpr int64_t kFirstSound_ns = 1000 * kMillisecond_ns;
    static constexpr int64_t kStalled_ns = 500 * kMillisecond_ns, kLost_ns = 3000 * kMillisecond_ns;
    static constexpr int64_t kPingEvery_ns = 2000 * kMillisecond_ns;

    enum class State {
        kClosed,    ///< before opened(), after Refused and hangUp()
        kPausing,   ///< until the next attempt to connect
        kOpening,   ///< ConnectWanted was given
        kGreeting,  ///< QUERY was sent
        kIdle,
        kClearing,  ///< a box that streams for nobody is stopped before START
        kStarting,
        kStreaming,
        kStopping,
    };

    /// `where` names the link in errors: "tcp://10.0.0.7:41941".
    explicit StudioConversation(std::string where) : where_(std::move(where)) {}

    /// The stream is open, for the first time or after ConnectWanted.
    void opened(int64_t now_ns);
    /// It ended by itself or could not be opened. Not to be called when the owner closed it.
    void closed(int64_t now_ns);
    void receive(ByteView bytes, int64_t now_ns);
    void tick(int64_t now_ns);

    /// Wishes; the answer is an event. start() wants kIdle.
    void start(int64_t now_ns);
    void stop(int64_t now_ns);
    void identify(const Identify& identify, int64_t now_ns);
    void set(const Settings& settings, int64_t now_ns);
    /// Ends the conversation for good; an open take ends. stop() first, and wait for Stopped, to lose
    /// nothing.
    void hangUp();

    Bytes takeBytes() { return std::exchange(outgoing_, {}); }
    std::vector<StudioEvent> takeEvents() { return std::exchange(events_, {}); }

    State state() const { return state_; }
    bool takeIsOpen() const { return take_.has_value(); }
    LinkStatistics statistics() const;

private:
    /// What must be the same after a reconnection.
    struct OpenTake {
        std::string serial;
        int board_count = 0;
        int sample_rate_hz = 0;
    };

    void handle(const LinkFrame& frame, int64_t now_ns);
    void handleHello(ByteView payload, int64_t now_ns);
    void greet(Hello hello, int64_t now_ns);
    void handleAck(const Ack& ack, int64_t now_ns);
    void handleAdc(ByteView payload, int64_t now_ns);
    void handlePulses(ByteView payload, int64_t now_ns);
    void handleStatus(ByteView payload);
    void handleError(ByteView payload);
    void handlePong(ByteView payload, int64_t now_ns);
    void soundCame(int64_t now_ns);

    void tickGreeting(int64_t now_ns);
    void tickSound(int64_t now_ns);
    void ping(int64_t now_ns);
    void expireRequests(int64_t now_ns);
    void requestFailed(Type type, const Error& why);
    void sendStart(int64_t now_ns);
    void request(Type type, Bytes payload, int64_t now_ns);
    uint32_t send(Type type, ByteView payload);
    void loseLink(const std::string& why, int64_t now_ns);
    void pause(int64_t now_ns);
    void endTake(const std::string& why);
    void finishTake();
    void refuse(const Error& why);

    bool isOpen() const { return state_ >= State::kGreeting; }
    bool takesSound() const {
        return state_ == State::kStarting || state_ == State::kStreaming || state_ == State::kStopping;
    }
    int64_t losses() const { return reader_.statistics().losses() + statistics_.bad_content; }
    Error trouble(const std::string& what, const std::string& remedy) const;

    std::string where_;
    State state_ = State::kClosed;
    FrameReader reader_;
    RequestBook requests_;
    uint32_t next_sequence_ = 0;
    Bytes outgoing_;
    std::vector<StudioEvent> events_;
    LinkStatistics statistics_;

    std::optional<Hello> hello_;
    Bytes hello_payload_;
    std::optional<Error> greeting_error_;  ///< of a HELLO that could not be read
    bool box_streams_for_nobody_ = false;
    bool start_wanted_ = false;  ///< of kClearing: START follows
    std::optional<OpenTake> take_;
    std::optional<SampleSequence> sequence_;
    int64_t losses_at_last_block_ = 0, unknown_versions_when_opened_ = 0;
    bool stalled_ = false;
    int attempt_ = 0;

    int64_t opened_ns_ = 0, queried_ns_ = 0, pinged_ns_ = 0, pause_until_ns_ = 0;
    int64_t last_frame_ns_ = 0, last_sound_ns_ = 0;
    std::optional<int64_t> start_acknowledged_ns_;
};

}  // namespace noctule::link
