// SPDX-License-Identifier: Apache-2.0
#include "devices/device/replay_device.h"

#include <chrono>
#include <cmath>

#include "core/job/contract.h"
#include "devices/machine/clock.h"

namespace noctule {

namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr std::chrono::seconds kIdleStatusEvery{1};

}  // namespace

ReplayDevice::ReplayDevice(std::string address, std::string path, double speed)
    : address_(std::move(address)), path_(std::move(path)), speed_(speed) {
    require(std::isfinite(speed) && speed >= 0, "ReplayDevice: the speed is 0 or more");
}

ReplayDevice::~ReplayDevice() {
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
    }
    news_.notify_all();
    if (thread_.joinable())
        thread_.join();
}

void ReplayDevice::open(Listener listener) {
    require(!thread_.joinable() && listener, "ReplayDevice::open: once, and with a listener");
    listener_ = std::move(listener);
    thread_ = std::thread([this] { run(); });
}

void ReplayDevice::post(const Wish& wish) {
    require(thread_.joinable(), "ReplayDevice: a wish before open()");
    {
        const std::lock_guard lock(mutex_);
        wishes_.push_back(wish);
    }
    news_.notify_all();
}

link::LinkStatistics ReplayDevice::statistics() const {
    link::LinkStatistics statistics;
    const std::lock_guard lock(mutex_);
    statistics.lost_samples = lost_samples_;
    return statistics;
}

bool ReplayDevice::closing() const {
    const std::lock_guard lock(mutex_);
    return closing_;
}

void ReplayDevice::tell(link::StudioEvent event) {
    if (!closing())
        listener_({std::move(event), steadyNow_ns()});
}

void ReplayDevice::refuse(link::Type type, const std::string& why, const std::string& remedy) {
    tell(link::RequestFailed{type, {ErrorKind::kDevice, address_ + ": " + why, remedy}});
}

void ReplayDevice::refuseAsTake(link::Type type) {
    refuse(type, "a take that is played again can neither be set nor light up",
           "Connect a driver box for that");
}

void ReplayDevice::run() {
    const Result<TakePlayer> player = TakePlayer::open(path_);
    if (!player)
        tell(link::Refused{player.error()});
    else
        tell(link::Greeted{player->hello()});
    if (player)
        serve(*player);
    while (const auto wish = nextWish(Time::max()))
        if (wish->kind != Wish::Kind::kStop)
            refuse(wish->kind == Wish::Kind::kStart ? link::Type::kStart : wish->refused, "no take is open",
                   "Choose a take of sound");
}

/// Nothing when the time has come or the device closes.
std::optional<ReplayDevice::Wish> ReplayDevice::nextWish(Time until) {
    std::unique_lock lock(mutex_);
    const auto woken = [&] { return closing_ || !wishes_.empty(); };
    if (until == Time::max())
        news_.wait(lock, woken);
    else
        news_.wait_until(lock, until, woken);
    if (closing_ || wishes_.empty())
        return std::nullopt;
    const Wish wish = wishes_.front();
    wishes_.pop_front();
    return wish;
}

void ReplayDevice::serve(const TakePlayer& player) {
    Time next_status = SteadyClock::now();
    while (!closing()) {
        const auto wish = nextWish(next_status);
        if (!wish) {
            if (auto status = player.idleStatus())
                tell(std::move(*status));
            next_status = SteadyClock::now() + kIdleStatusEvery;
        } else if (wish->kind == Wish::Kind::kStart) {
            play(player);
        } else if (wish->kind == Wish::Kind::kRefuse) {
            refuseAsTake(wish->refused);
        }
    }
}

void ReplayDevice::play(const TakePlayer& player) {
    const Time begin = SteadyClock::now();
    bool started = false;
    const auto sink = [&](link::StudioEvent event, int64_t due_sample) {
        const double due_s =
            speed_ > 0 ? static_cast<double>(due_sample) / (player.hello().sample_rate_hz * speed_) : 0;
        const auto due =
            std::chrono::duration_cast<SteadyClock::duration>(std::chrono::duration<double>(due_s));
        if (!waitWhilePlaying(begin + due))
            return false;
        if (!std::exchange(started, true))
            tell(link::Started{});
        if (const auto* gap = std::get_if<link::Gap>(&event)) {
            const std::lock_guard lock(mutex_);
            lost_samples_ += gap->sample_count;
        }
        tell(std::move(event));
        return true;
    };
    {
        const std::lock_guard lock(mutex_);
        lost_samples_ = 0;
    }
    const Status played = player.play(sink);
    if (played)
        tell(link::Stopped{});
    else
        tell(link::TakeEnded{played.error()});
}

bool ReplayDevice::waitWhilePlaying(Time until) {
    while (const auto wish = nextWish(until)) {
        if (wish->kind == Wish::Kind::kStop)
            return false;
        if (wish->kind == Wish::Kind::kStart)
            refuse(link::Type::kStart, "the take is being played already", "Stop it first");
        else
            refuseAsTake(wish->refused);
    }
    return !closing();
}

}  // namespace noctule
