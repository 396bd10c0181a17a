// SPDX-License-Identifier: Apache-2.0
#include "app/batch/devices/drive_poses.h"

#include <chrono>
#include <thread>

namespace noctule::batch {
namespace {

constexpr std::chrono::milliseconds kLookAtDevice{20};
constexpr std::chrono::seconds kDeviceGreets{10}, kDeviceStops{6};
constexpr double kPatience_s = 2;  // for the last poses of a recording

/// A take's poses at the times at which they were made.
class TakePoses : public LivePoses {
public:
    TakePoses(TimedMotion motion, robot_link::PoseFeed& feed, bool repeats)
        : poses_(std::move(motion), feed,
                 repeats ? robot_link::MotionPoses::AtEnd::kRepeats : robot_link::MotionPoses::AtEnd::kEnds,
                 true) {}
    bool ended() const override { return poses_.ended(); }

private:
    robot_link::MotionPoses poses_;
};

/// A suit that is worn right now.
class SuitPoses : public LivePoses {
public:
    explicit SuitPoses(std::unique_ptr<Device> device) : session_(std::move(device)) {}
    ~SuitPoses() override {
        session_.stop();
        session_.finish();
    }

    Status begin(const StreamRequest& request, const std::string& address, const JobContext& job) {
        session_.connect();
        const auto until = std::chrono::steady_clock::now() + kDeviceGreets;
        while (session_.status()->link != LinkState::kReady &&
               session_.status()->link != LinkState::kRefused && std::chrono::steady_clock::now() < until &&
               !job.cancelled())
            std::this_thread::sleep_for(kLookAtDevice);
        if (job.cancelled())
            return JobContext::cancelledError();
        const auto status = session_.status();
        if (status->link != LinkState::kReady)
            return status->trouble.value_or(
                Error{ErrorKind::kDevice, address + ": no driver box answers",
                      "Check that it is switched on and that the address is right"});
        if (Status begun = session_.begin(request); !begun)
            return begun;
        const auto trouble = session_.processingTrouble();
        return trouble ? Status(*trouble) : Status(Done{});
    }
    bool ended() const override { return !session_.status()->stream_is_open; }
    std::optional<Error> trouble() const override {
        const auto processing = session_.processingTrouble();
        return processing ? processing : session_.status()->trouble;
    }
    void tell(nlohmann::json& json) const override {
        if (const auto frame = session_.latest())
            json["poses"] = {{"count", frame->poses},
                             {"latency_median_ms", 1e3 * frame->latency_median_s},
                             {"latency_p999_ms", 1e3 * frame->latency_p999_s}};
    }

    std::optional<LiveSession::TakeInput> takeInput() const override { return session_.takeInput(); }
    std::optional<StreamResult> endTake() override {
        session_.stop();
        const auto until = std::chrono::steady_clock::now() + kDeviceStops;
        while (session_.status()->stream_is_open && std::chrono::steady_clock::now() < until)
            std::this_thread::sleep_for(kLookAtDevice);
        return session_.finish(kPatience_s);
    }

private:
    mutable LiveSession session_;
};

}  // namespace

std::unique_ptr<LivePoses> posesOfTake(TimedMotion motion, robot_link::PoseFeed& feed, bool repeats) {
    return std::make_unique<TakePoses>(std::move(motion), feed, repeats);
}

Result<std::unique_ptr<LivePoses>> posesOfSuit(const StreamRequest& request, const std::string& address,
                                               const JobContext& job) {
    auto device = makeDevice(address);
    if (!device)
        return device.error();
    auto poses = std::make_unique<SuitPoses>(std::move(*device));
    if (Status begun = poses->begin(request, address, job); !begun)
        return begun.error();
    return std::unique_ptr<LivePoses>(std::move(poses));
}

}  // namespace noctule::batch
