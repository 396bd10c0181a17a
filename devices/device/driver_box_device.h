// SPDX-License-Identifier: Apache-2.0
// A driver box over any link of bytes: a thread of its own keeps the studio's side of the conversation
// (devices/driver_box/studio_conversation.h), connects again when the link was lost, and hands every event on
// at once. When it is closed while a take is open the box is told to stop, without waiting for its answer.
#pragma once

#include <QTimer>
#include <atomic>
#include <mutex>

#include "devices/device/byte_link.h"
#include "devices/device/device.h"
#include "devices/device/loop_thread.h"

namespace noctule {

class DriverBoxDevice : public Device {
public:
    static constexpr int kTickEvery_ms = 20;

    DriverBoxDevice(std::string address, std::unique_ptr<ByteLink> link);
    ~DriverBoxDevice() override;

    const std::string& address() const override { return address_; }
    void open(Listener listener) override;
    void start() override;
    void stop() override;
    void identify(const link::Identify& identify) override;
    void set(const link::Settings& settings) override;
    link::LinkStatistics statistics() const override;

private:
    using Wish = std::function<void(link::StudioConversation&, int64_t now_ns)>;

    void post(Wish wish);
    // On the thread:
    void begin();
    void end();
    void connectionEnded(const std::string& why, const std::string& remedy);
    void tell(const Wish& what);
    void handle(link::StudioEvent event, int64_t now_ns);

    const std::string address_;
    std::unique_ptr<ByteLink> link_;
    Listener listener_;
    link::StudioConversation conversation_;
    std::unique_ptr<QTimer> ticks_;
    bool telling_ = false;
    std::atomic<bool> closing_ = false;

    mutable std::mutex statistics_mutex_;
    link::LinkStatistics statistics_;

    std::unique_ptr<LoopThread> thread_;  ///< last: it uses the others
};

}  // namespace noctule
