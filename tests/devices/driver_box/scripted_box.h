// SPDX-License-Identifier: Apache-2.0
// A studio's side of the link and the bytes that a test writes to it by hand, to the millisecond.
#pragma once

#include "tests/devices/driver_box/link_simulation.h"

namespace noctule::link {

/// A box that says only what a test lets it say.
struct Scripted {
    StudioConversation studio{"here"};
    FrameReader reader;
    std::vector<StudioEvent> events;
    std::vector<std::pair<Type, uint32_t>> sent;
    int64_t now_ns = kSecond_ns;
    uint32_t sequence = 0;

    void collect() {
        for (StudioEvent& event : studio.takeEvents())
            events.push_back(std::move(event));
        const Bytes bytes = studio.takeBytes();
        reader.push(bytes, now_ns, [&](const LinkFrame& frame) {
            sent.emplace_back(static_cast<Type>(frame.header.type), frame.header.sequence);
        });
    }
    void say(Type type, const Bytes& payload) {
        studio.receive(encodeFrame(static_cast<uint8_t>(type), sequence++, payload), now_ns);
        collect();
    }
    void wait_ms(int64_t duration_ms) {
        for (int64_t i = 0; i < duration_ms; ++i) {
            now_ns += kMillisecond_ns;
            studio.tick(now_ns);
            collect();
        }
    }
    /// Keeps an idle link alive.
    void waitWithStatus_ms(int64_t duration_ms) {
        for (; duration_ms > 0; duration_ms -= 1000) {
            say(Type::kStatus, status());
            wait_ms(std::min<int64_t>(duration_ms, 1000));
        }
    }
    static Bytes status(int64_t sample = 0) {
        BoxStatus status;
        status.sample = sample;
        status.board_flags = {1, 1};
        return toPayload(status);
    }
    void hello(bool streaming = false, const std::string& serial = "NB-000777") {
        Hello hello = testHello(serial);
        hello.streaming = streaming;
        say(Type::kHello, toPayload(hello));
    }
    void open() {
        sequence = 0;
        reader.restart();
        studio.opened(now_ns);
        collect();
    }
    void ack(uint32_t request, Code code = Code::kOk) { say(Type::kAck, toPayload(Ack{request, code, ""})); }
    void adc(int64_t first_sample, int samples = 600) {
        say(Type::kAdc, toPayload(soundBlock(first_sample, samples, 2)));
    }
    void startTake() {
        open();
        hello();
        studio.start(now_ns);
        collect();
        ack(sent.back().second);
        adc(0);
    }
    size_t sentOf(Type type) const {
        return static_cast<size_t>(
            std::count_if(sent.begin(), sent.end(), [&](const auto& one) { return one.first == type; }));
    }
};

}  // namespace noctule::link
