// SPDX-License-Identifier: Apache-2.0
// The box's side of the link (README.md, sections 4 and 7) as a value, for `noctule-virtual-suit` and for
// tests: its owner tells it about clients, bytes and time, offers pulses and sound while streaming() and
// writes what read() gives as fast as the stream takes it. It samples nothing and reads no clock. Times are
// nanoseconds of any clock that does not go back; with --speed they run as fast as the client's.
#pragma once

#include "devices/driver_box/box_event.h"
#include "devices/driver_box/box_queue.h"
#include "devices/driver_box/frame.h"

namespace noctule::link {

struct BoxOptions {
    AdcFormat adc_format = AdcFormat::kPlain;  ///< kZstd wants "zstd" among HELLO's features
    double buffer_s = 1.0;             ///< of sound kept when the stream does not take it; at least 0.25
    bool drops_silent_clients = true;  ///< over TCP; a serial line may be silent
    bool sets_pulses = true;           ///< SET of pulse_interval_samples and pulse_cycles; else code 4
    bool sets_sources = true;          ///< SET of enabled_sources; else code 4
};

class BoxConversation {
public:
    static constexpr int64_t kSecond_ns = 1'000'000'000;
    static constexpr int64_t kStatusEvery_ns = kSecond_ns, kSilence_ns = 10 * kSecond_ns;
    static constexpr int64_t kAloneAtMost_ns = 120 * kSecond_ns;
    static constexpr double kLeastBuffer_s = 0.25;
    /// A client that lets more than this pile up of what is never dropped reads no more.
    static constexpr size_t kMostSmallBytes = 4 << 20;

    /// `hello.streaming` is filled in. No boards, or a serial number that is empty, are broken promises.
    explicit BoxConversation(Hello hello, BoxOptions options = {});

    /// A second client must be turned away by the owner; the first has to be gone before.
    void connected(int64_t now_ns);
    void disconnected(int64_t now_ns);
    void receive(ByteView bytes, int64_t now_ns);
    void tick(int64_t now_ns);

    /// Pulses before the block that contains them; blocks of up to kMaxBlockSamples in rising order, all
    /// boards. Ignored unless streaming().
    void offer(const std::vector<EmittedPulse>& pulses);
    void offer(SoundBlock block);
    /// For the next STATUS; `sample` and `dropped_samples` are filled in.
    void setConditions(const BoxStatus& conditions) { conditions_ = conditions; }
    void report(const BoxError& error);

    /// At most that many bytes; they count as written. Call it when the stream has room.
    Bytes read(size_t most_bytes);
    std::vector<BoxEvent> takeEvents() { return std::exchange(events_, {}); }

    const Hello& hello() const { return hello_; }
    bool hasClient() const { return has_client_; }
    bool streaming() const { return streaming_; }
    int64_t nextSample() const { return next_sample_; }
    const FrameStatistics& statistics() const { return reader_.statistics(); }

private:
    void handle(const LinkFrame& frame);
    Code handleRequest(const LinkFrame& frame);
    Code start(ByteView payload);
    Code identify(ByteView payload);
    Code set(ByteView payload);
    void sayHello();
    void stop(uint32_t request);
    void answer(uint32_t request, Code code);
    void answerStops();
    void sendStatus();
    void stopStreaming();
    void dropClient(const std::string& why, int64_t now_ns);

    Hello hello_;
    BoxOptions options_;
    BoxQueue queue_;
    FrameReader reader_;
    std::vector<BoxEvent> events_;
    BoxStatus conditions_;

    bool has_client_ = false;
    bool streaming_ = false;
    bool started_by_this_client_ = false;
    std::vector<uint32_t> stops_;  ///< to be answered when all is sent
    int64_t next_sample_ = 0;
    int64_t dropped_samples_ = 0;
    int64_t heard_ns_ = 0, status_ns_ = 0, alone_since_ns_ = 0;
};

}  // namespace noctule::link
