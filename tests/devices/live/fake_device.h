// SPDX-License-Identifier: Apache-2.0
// A device for tests: plays a script of events on a thread of its own, in its own time or as fast as they are
// taken.
#pragma once

#include <atomic>
#include <chrono>
#include <thread>

#include "devices/device/device.h"
#include "tests/devices/live/made_sound.h"
#include "tests/support/take_files.h"

namespace noctule::test {

class FakeDevice : public Device {
public:
    struct Script {
        link::Hello hello;
        std::vector<link::StudioEvent> events;  ///< between Started and Stopped
        double speed = 0;                       ///< 0: as fast as they are taken
        bool greets = true;
        bool ends_by_itself = false;  ///< no Stopped comes: the script says how it ends
        bool waits_for_stop = true;   ///< after the last event, as a box would go on
        std::string address = "fake://box";
    };
    explicit FakeDevice(Script script) : script_(std::move(script)), address_(script_.address) {}
    ~FakeDevice() override {
        closing_ = true;
        if (thread_.joinable())
            thread_.join();
    }

    const std::string& address() const override { return address_; }
    void open(Listener listener) override {
        listener_ = std::move(listener);
        thread_ = std::thread([this] { run(); });
    }
    void start() override { started_ = true; }
    void stop() override { stopped_ = true; }
    void identify(const link::Identify&) override {}
    void set(const link::Settings&) override {}
    link::LinkStatistics statistics() const override { return {}; }

private:
    void tell(link::StudioEvent event) {
        const auto now = std::chrono::steady_clock::now().time_since_epoch();
        listener_({std::move(event), std::chrono::nanoseconds(now).count()});
    }
    bool waitFor(const std::atomic<bool>& flag) const {
        while (!flag && !closing_)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return !closing_;
    }
    void run() {
        if (!script_.greets)
            return tell(link::Refused{{ErrorKind::kDevice, address_ + ": nobody there", "Switch it on"}});
        tell(link::Greeted{script_.hello});
        if (!waitFor(started_))
            return;
        tell(link::Started{});
        play();
        if (script_.ends_by_itself || (script_.waits_for_stop && !waitFor(stopped_)))
            return;
        tell(link::Stopped{});
    }
    void play() {
        const auto begin = std::chrono::steady_clock::now();
        for (const link::StudioEvent& event : script_.events) {
            const auto* block = std::get_if<link::SoundBlock>(&event);
            if (block && script_.speed > 0)
                std::this_thread::sleep_until(
                    begin + std::chrono::nanoseconds(static_cast<int64_t>(
                                static_cast<double>(block->first_sample + block->sampleCount()) /
                                script_.hello.sample_rate_hz / script_.speed * 1e9)));
            if (closing_ || (stopped_ && !script_.ends_by_itself))
                return;
            tell(event);
        }
    }

    Script script_;
    std::string address_;
    Listener listener_;
    std::atomic<bool> started_{false}, stopped_{false}, closing_{false};
    std::thread thread_;
};

inline link::Hello madeHello(int boards) {
    link::Hello hello;
    hello.serial = "NB-000777";
    hello.suit = suitOf(boards);
    return hello;
}

/// Blocks of 600 samples and a pulse every 1200, as a box sends them.
inline std::vector<link::StudioEvent> madeEvents(int64_t first, int64_t end, int boards) {
    std::vector<link::StudioEvent> events;
    for (int64_t at = first; at < end; at += 600) {
        if (at % 1200 == 0)
            events.push_back(link::Pulses{{at, static_cast<int>(at / 1200 % 8)}});
        events.push_back(*madeBlock(at, std::min<int64_t>(600, end - at), boards).sound);
    }
    return events;
}

/// The tiny take as its box would have sent it, split into blocks of the given size.
inline FakeDevice::Script tinyTakeScript(int64_t block_samples) {
    const Take take = std::move(Take::open(kTinyTake).value());
    FakeDevice::Script script;
    script.hello.serial = "NB-000777";
    script.hello.suit = take.suit().value();
    script.hello.sample_rate_hz = static_cast<int>(take.header().sample_rate_hz);
    const int boards = script.hello.boardCount();
    std::vector<int16_t> sound;
    EXPECT_TRUE(take.forEachBlock(1, [&](const AdcBlock& block) {
        sound.insert(sound.end(), block.values.begin(), block.values.end());
        return true;
    }));
    const auto pulses = take.pulses();
    const auto statuses = take.statusRows();
    size_t pulse = 0, status = 0;
    const int64_t count = std::ssize(sound) / boards;
    for (int64_t at = 0; at < count; at += block_samples) {
        const int64_t end = std::min(count, at + block_samples);
        for (; status < statuses->size() && statuses->at(status).sample <= at; ++status) {
            const StatusRow& row = statuses->at(status);
            link::BoxStatus told;
            told.sample = row.sample;
            told.temperature_c = static_cast<float>(*row.temperature_c);
            told.humidity_percent = static_cast<float>(*row.humidity_percent);
            script.events.push_back(told);
        }
        link::Pulses due;
        for (; pulse < pulses->size() && pulses->at(pulse).sample < end; ++pulse)
            due.push_back({pulses->at(pulse).sample, pulses->at(pulse).source});
        if (!due.empty())
            script.events.push_back(due);
        script.events.push_back(
            link::SoundBlock{at, boards, {sound.begin() + at * boards, sound.begin() + end * boards}});
    }
    script.waits_for_stop = false;
    script.speed = 4;  // as fast as possible would be too fast for queues of two seconds
    return script;
}

}  // namespace noctule::test
