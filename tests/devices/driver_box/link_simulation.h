// SPDX-License-Identifier: Apache-2.0
// Studio and box with a wire between them that a test can cut, damage and slow down, in steps of 4 ms of its
// own time. The sound tells which sample and board it is from, so that a shift of time shows.
#pragma once

#include <memory>

#include "devices/driver_box/box_conversation.h"
#include "devices/driver_box/studio_conversation.h"
#include "tests/devices/driver_box/link_data.h"

namespace noctule::link {

inline constexpr int64_t kMillisecond_ns = 1'000'000, kSecond_ns = 1'000'000'000;

inline int16_t soundAt(int64_t sample, int board) {
    return static_cast<int16_t>((sample * 31 + board * 1000) % 30000);
}

inline SoundBlock soundBlock(int64_t first_sample, int samples, int boards) {
    SoundBlock block{first_sample, boards, {}};
    for (int i = 0; i < samples; ++i)
        for (int board = 0; board < boards; ++board)
            block.values.push_back(soundAt(first_sample + i, board));
    return block;
}

/// Two boards, one source.
inline Hello testHello(const std::string& serial = "NB-000777") {
    Hello hello = readHello(goldenFrame(Type::kHello).payload(), "golden").value();
    hello.serial = serial;
    return hello;
}

template <class Event>
std::vector<Event> eventsOf(const std::vector<StudioEvent>& events) {
    std::vector<Event> found;
    for (const StudioEvent& event : events)
        if (const auto* one = std::get_if<Event>(&event))
            found.push_back(*one);
    return found;
}

template <class Event>
size_t countOf(const std::vector<StudioEvent>& events) {
    return eventsOf<Event>(events).size();
}

class LinkSimulation {
public:
    explicit LinkSimulation(uint32_t seed = 1) : random(seed) {}

    StudioConversation studio{"test link"};
    std::unique_ptr<BoxConversation> box = std::make_unique<BoxConversation>(testHello());
    std::vector<StudioEvent> events;
    std::vector<BoxEvent> box_events;
    std::mt19937 random;
    int64_t now_ns = 5 * kSecond_ns;
    bool cable = true;
    bool swallow = false;        ///< bytes of the box vanish, the stream stays open
    double damage_per_byte = 0;  ///< flipped, lost or doubled
    size_t bytes_per_step = 1'000'000;

    void connect() {
        connected_ = true;
        box->connected(now_ns);
        studio.opened(now_ns);
    }
    /// Pulls the cable: both ends notice.
    void cut() {
        cable = false;
        if (std::exchange(connected_, false)) {
            box->disconnected(now_ns);
            studio.closed(now_ns);
        }
    }
    /// Power off and on; the stream ends, as the port of a box does.
    void restartBox(const std::string& serial = "NB-000777") {
        cut();
        cable = true;
        box = std::make_unique<BoxConversation>(testHello(serial));
    }
    /// The same without the stream noticing, as behind a serial adapter.
    void restartBoxSilently() {
        box = std::make_unique<BoxConversation>(testHello());
        box->connected(now_ns);
    }
    void run(double seconds) {
        for (const int64_t end_ns = now_ns + static_cast<int64_t>(seconds * 1e9); now_ns < end_ns;)
            step();
    }
    void step() {
        now_ns += 4 * kMillisecond_ns;
        room_ = bytes_per_step;
        produce();
        move();
        box->tick(now_ns);
        studio.tick(now_ns);
        move();
        handleEvents();
    }

    /// Every sample since START came once, or lies in a gap; values fit their samples. Gives the end.
    int64_t expectWholeTake() const {
        int64_t next = 0;
        for (const StudioEvent& event : events)
            if (const auto* gap = std::get_if<Gap>(&event)) {
                EXPECT_EQ(gap->first_sample, next);
                EXPECT_GT(gap->sample_count, 0);
                next += gap->sample_count;
            } else if (const auto* block = std::get_if<SoundBlock>(&event)) {
                EXPECT_EQ(block->first_sample, next);
                EXPECT_EQ(*block, soundBlock(next, static_cast<int>(block->sampleCount()), 2));
                next += block->sampleCount();
            }
        return next;
    }
    /// Rising, each once, at its place.
    size_t expectPulses() const {
        int64_t last = -1;
        size_t count = 0;
        for (const Pulses& pulses : eventsOf<Pulses>(events))
            for (const EmittedPulse& pulse : pulses) {
                EXPECT_GT(pulse.sample, last);
                EXPECT_EQ(pulse.sample % 1200, 0);
                last = pulse.sample;
                ++count;
            }
        return count;
    }

private:
    void produce() {
        if (!box->streaming())
            return;
        const int64_t first = box->nextSample();
        if (first % 1200 == 0)
            box->offer(std::vector<EmittedPulse>{{first, 0}});
        box->offer(soundBlock(first, 600, 2));
    }
    void move() {
        if (!connected_)
            return;
        const Bytes up = studio.takeBytes();
        box->receive(damaged(up), now_ns);
        const Bytes read = box->read(room_);
        room_ -= read.size();
        const Bytes down = damaged(read);
        if (!swallow && !down.empty())
            studio.receive(down, now_ns);
    }
    Bytes damaged(const Bytes& bytes) {
        if (damage_per_byte == 0)
            return bytes;
        std::geometric_distribution<size_t> distance(damage_per_byte);
        Bytes worse;
        size_t next = distance(random);
        for (size_t i = 0; i < bytes.size(); ++i) {
            worse.push_back(bytes[i]);
            if (i != next)
                continue;
            next += 1 + distance(random);
            if (random() % 3 == 0)
                worse.pop_back();
            else if (random() % 2 == 0)
                worse.push_back(bytes[i]);
            else
                worse.back() ^= static_cast<uint8_t>(1 << (random() % 8));
        }
        return worse;
    }
    void handleEvents() {
        for (BoxEvent& event : box->takeEvents()) {
            if (std::holds_alternative<ClientDropped>(event) && std::exchange(connected_, false))
                studio.closed(now_ns);
            box_events.push_back(std::move(event));
        }
        for (StudioEvent& event : studio.takeEvents()) {
            if ((std::holds_alternative<LinkLost>(event) || std::holds_alternative<Refused>(event)) &&
                std::exchange(connected_, false))
                box->disconnected(now_ns);
            if (std::holds_alternative<ConnectWanted>(event) && cable)
                connect();
            else if (std::holds_alternative<ConnectWanted>(event))
                studio.closed(now_ns);
            events.push_back(std::move(event));
        }
    }

    bool connected_ = false;
    size_t room_ = 0;  ///< bytes that the wire takes in this step
};

}  // namespace noctule::link
