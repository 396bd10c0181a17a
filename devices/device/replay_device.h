// SPDX-License-Identifier: Apache-2.0
// A take that is played again: the events that a box would have caused, when it would have caused them
// (`speed` 1), faster, or as fast as they are taken (0). At its end comes Stopped, as if the operator had
// stopped it; start() then plays it from the beginning. It has no lights and no settings.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "devices/device/device.h"
#include "devices/device/take_player.h"

namespace noctule {

class ReplayDevice : public Device {
public:
    /// `speed` finite, 0 or more.
    ReplayDevice(std::string address, std::string path, double speed);
    ~ReplayDevice() override;

    const std::string& address() const override { return address_; }
    void open(Listener listener) override;
    void start() override { post({Wish::Kind::kStart, {}}); }
    void stop() override { post({Wish::Kind::kStop, {}}); }
    void identify(const link::Identify&) override { post({Wish::Kind::kRefuse, link::Type::kIdentify}); }
    void set(const link::Settings&) override { post({Wish::Kind::kRefuse, link::Type::kSet}); }
    link::LinkStatistics statistics() const override;

private:
    using Time = std::chrono::steady_clock::time_point;
    struct Wish {
        enum class Kind { kStart, kStop, kRefuse } kind;
        link::Type refused = {};
    };

    void post(const Wish& wish);
    // On the thread:
    void run();
    void serve(const TakePlayer& player);
    void play(const TakePlayer& player);
    std::optional<Wish> nextWish(Time until);
    /// Serves wishes until then; false when the play shall end.
    bool waitWhilePlaying(Time until);
    void refuse(link::Type type, const std::string& why, const std::string& remedy);
    void refuseAsTake(link::Type type);
    void tell(link::StudioEvent event);
    bool closing() const;

    const std::string address_, path_;
    const double speed_;
    Listener listener_;

    mutable std::mutex mutex_;  ///< of the following
    std::condition_variable news_;
    std::deque<Wish> wishes_;
    bool closing_ = false;
    int64_t lost_samples_ = 0;

    std::thread thread_;
};

}  // namespace noctule
