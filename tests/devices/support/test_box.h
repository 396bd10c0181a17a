// SPDX-License-Identifier: Apache-2.0
// A driver box for tests: the box's side of the link behind a wire, on a thread of its own, that plays a
// take, the tiny one if no other is named, from its beginning with each START and goes on with silence after
// its end.
#pragma once

#include <atomic>
#include <mutex>
#include <thread>

#include "core/recording/take.h"
#include "devices/driver_box/box_conversation.h"
#include "devices/driver_box/studio_event.h"
#include "devices/machine/clock.h"
#include "tests/devices/support/box_stream.h"
#include "tests/support/take_files.h"

namespace noctule::test {

/// A take as a box would say it.
struct TakeSound {
    link::Hello hello;
    std::vector<int16_t> values;
    link::Pulses pulses;

    int64_t sampleCount() const { return static_cast<int64_t>(values.size()) / hello.boardCount(); }

    static TakeSound of(const std::string& path) {
        TakeSound sound;
        Take take = Take::open(path).value();
        sound.hello.serial = "NB-000777";
        sound.hello.model = "test box";
        sound.hello.suit = take.suit().value();
        EXPECT_TRUE(take.forEachBlock(1,
                                      [&](const AdcBlock& block) {
                                          sound.values.insert(sound.values.end(), block.values.begin(),
                                                              block.values.end());
                                          return true;
                                      })
                        .ok());
        const auto pulses = take.pulses().value();
        for (const Pulse& pulse : pulses)
            sound.pulses.push_back({pulse.sample, pulse.source});
        return sound;
    }
    static const TakeSound& tiny() {
        static const TakeSound kSound = of(kTinyTake);
        return kSound;
    }
    link::SoundBlock block(int64_t first, int64_t samples) const {
        const auto boards = static_cast<size_t>(hello.boardCount());
        link::SoundBlock block{first, hello.boardCount(),
                               std::vector<int16_t>(static_cast<size_t>(samples) * boards)};
        for (size_t i = 0; i < block.values.size(); ++i) {
            const size_t at = static_cast<size_t>(first) * boards + i;
            block.values[i] = at < values.size() ? values[at] : int16_t{0};
        }
        return block;
    }
};

class TestBox {
public:
    struct Options {
        bool pty = false;
        bool answers = true;
        double speed = 1;
        bool loops = false;        ///< the take again and again instead of silence after its end
        link::Bytes garbage = {};  ///< written to every new client first
        std::string take = kTinyTake;
        std::string serial = {};  ///< empty: the usual one
        double drive_hz = 0;      ///< 0: the take's
        bool fixed = false;       ///< all of it hangs in the room
        std::optional<float> temperature_c{};
    };

    explicit TestBox(const Options& options)
        : options_(options),
          other_sound_(options.take == kTinyTake ? TakeSound() : TakeSound::of(options.take)),
          sound_(options.take == kTinyTake ? TakeSound::tiny() : other_sound_),
          serial_(options.serial) {
        if (options.pty)
            stream_ = std::make_unique<PtyBoxStream>();
        else
            stream_ = std::make_unique<TcpBoxStream>();
        address_ = stream_->address();
        box_ = makeBox();
        thread_ = std::thread([this] { run(); });
    }
    ~TestBox() {
        ends_ = true;
        thread_.join();
    }

    const std::string& address() const { return address_; }
    /// Of a box on TCP.
    uint16_t port() const {
        return static_cast<uint16_t>(std::stoi(address_.substr(address_.rfind(':') + 1)));
    }
    void cut() { cut_wanted_ = true; }
    /// Power off and on: it forgets that it was streaming.
    void restart() { restart_wanted_ = true; }
    /// Another box comes to its address.
    void becomes(const std::string& serial) {
        const std::lock_guard lock(mutex_);
        serial_ = serial;
        restart_wanted_ = true;
    }
    /// As if it stood still, its wire open.
    void freeze(bool frozen) { frozen_ = frozen; }
    /// A block each second only: its link stalls again and again and is never lost.
    void stutter(bool stutters) { stutters_ = stutters; }
    bool streaming() const { return streaming_; }
    int64_t sampledSamples() const { return sampled_; }
    std::vector<link::BoxEvent> events() const {
        const std::lock_guard lock(mutex_);
        return events_;
    }

private:
    std::unique_ptr<link::BoxConversation> makeBox() const {
        link::BoxOptions options;
        options.buffer_s = 10;
        options.drops_silent_clients = !options_.pty;
        link::Hello hello = sound_.hello;
        const std::lock_guard lock(mutex_);
        if (!serial_.empty())
            hello.serial = serial_;
        if (options_.drive_hz > 0)
            hello.drive_hz = options_.drive_hz;
        for (Board& board : hello.suit.boards)
            board.segment = options_.fixed ? "" : board.segment;
        for (Source& source : hello.suit.sources)
            source.segment = options_.fixed ? "" : source.segment;
        auto box = std::make_unique<link::BoxConversation>(hello, options);
        link::BoxStatus conditions;
        conditions.temperature_c = options_.temperature_c;
        conditions.board_flags.assign(hello.suit.boards.size(), link::kBoardConnected);
        box->setConditions(conditions);
        return box;
    }

    void run() {
        while (!ends_) {
            stream_->wait(1);
            if (frozen_)
                continue;
            if (restart_wanted_.exchange(false)) {
                box_ = makeBox();
                known_client_ = false;
                stream_->cut();
            }
            if (cut_wanted_.exchange(false))
                stream_->cut();
            noticeClient();
            if (options_.answers)
                serve();
        }
    }
    void noticeClient() {
        const int64_t now_ns = steadyNow_ns();
        if (known_client_ && !stream_->hasClient()) {
            box_->disconnected(now_ns);
        } else if (!known_client_ && stream_->hasClient()) {
            box_->connected(now_ns);
            unwritten_ = options_.garbage;
        }
        known_client_ = stream_->hasClient();
    }
    void serve() {
        const int64_t now_ns = steadyNow_ns();
        const link::Bytes bytes = stream_->read();
        noticeClient();
        if (!bytes.empty())
            box_->receive(bytes, now_ns);
        box_->tick(now_ns);
        for (link::BoxEvent& event : box_->takeEvents()) {
            if (std::holds_alternative<link::StartWanted>(event))
                begun_ns_ = now_ns;
            if (std::holds_alternative<link::ClientDropped>(event))
                stream_->cut();
            const std::lock_guard lock(mutex_);
            events_.push_back(std::move(event));
        }
        produce(now_ns);
        streaming_ = box_->streaming();
        write();
    }
    void produce(int64_t now_ns) {
        constexpr int64_t kStutter_ns = 1'000'000'000;
        if (!box_->streaming() || (stutters_ && now_ns - offered_ns_ < kStutter_ns))
            return;
        const double rate_hz = sound_.hello.sample_rate_hz * options_.speed;
        while (static_cast<double>(box_->nextSample() + link::kUsualBlockSamples) / rate_hz * 1e9 <=
               static_cast<double>(now_ns - begun_ns_)) {
            const int64_t now = box_->nextSample();
            const int64_t first = options_.loops ? now % sound_.sampleCount() : now;
            const int64_t end = first + link::kUsualBlockSamples;
            link::Pulses pulses;
            for (const link::EmittedPulse& pulse : sound_.pulses)
                if (pulse.sample >= first && pulse.sample < end)
                    pulses.push_back({pulse.sample + now - first, pulse.source});
            link::SoundBlock block = sound_.block(first, link::kUsualBlockSamples);
            block.first_sample = now;
            box_->offer(pulses);
            box_->offer(block);
            offered_ns_ = now_ns;
            if (stutters_)
                break;
        }
        sampled_ = box_->nextSample();
    }
    void write() {
        for (int i = 0; i < 64 && stream_->hasClient(); ++i) {
            if (unwritten_.empty())
                unwritten_ = box_->read(1 << 14);
            const size_t written = stream_->write(unwritten_);
            unwritten_.erase(unwritten_.begin(), unwritten_.begin() + static_cast<std::ptrdiff_t>(written));
            if (!unwritten_.empty() || written == 0)
                break;
        }
    }

    const Options options_;
    const TakeSound other_sound_;
    const TakeSound& sound_;
    std::string serial_;
    std::unique_ptr<BoxStream> stream_;
    std::string address_;
    std::unique_ptr<link::BoxConversation> box_;
    link::Bytes unwritten_;
    bool known_client_ = false;
    int64_t begun_ns_ = 0, offered_ns_ = 0;
    std::atomic<bool> ends_ = false, cut_wanted_ = false, restart_wanted_ = false, frozen_ = false,
                      stutters_ = false, streaming_ = false;
    std::atomic<int64_t> sampled_ = 0;
    mutable std::mutex mutex_;
    std::vector<link::BoxEvent> events_;
    std::thread thread_;
};

}  // namespace noctule::test
