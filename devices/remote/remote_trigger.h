// SPDX-License-Identifier: Apache-2.0
// Hears on a UDP port when another program begins and ends a recording, and tells each message once: such
// programs send it several times, and it may come on several ways.
#pragma once

#include <QUdpSocket>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>

#include "core/job/result.h"
#include "devices/device/loop_thread.h"
#include "devices/remote/capture_message.h"

namespace noctule {

struct RemoteTriggerOptions {
    uint16_t port = 0;      ///< 0: any that is free
    std::string only_from;  ///< an address, "10.0.0.5"; empty: from anybody
};

class RemoteTrigger {
public:
    /// A message with the packet id and name of one heard so long before is its repetition.
    static constexpr int64_t kRepeated_ns = 5'000'000'000;

    /// Called on a thread of its own, one message after the other.
    using Listener = std::function<void(const CaptureMessage&)>;
    /// kUsage for an address that is none, kDevice for a port that cannot be had.
    static Result<std::unique_ptr<RemoteTrigger>> listen(const RemoteTriggerOptions& options,
                                                         Listener listener);
    RemoteTrigger(const RemoteTrigger&) = delete;
    RemoteTrigger& operator=(const RemoteTrigger&) = delete;
    /// No message comes any more when it returns.
    ~RemoteTrigger() { thread_.reset(); }

    uint16_t port() const { return port_; }

    struct Counts {
        int64_t told = 0, repeated = 0, malformed = 0, from_others = 0;
    };
    Counts counts() const;

private:
    struct Heard {
        CaptureMessage message;
        int64_t heard_ns = 0;
    };
    RemoteTrigger(QHostAddress only_from, Listener listener);
    Status open(uint16_t port);
    // On the thread:
    void read();
    void handle(const QByteArray& datagram);
    bool isRepeated(const CaptureMessage& message);

    const QHostAddress only_from_;
    const Listener listener_;
    uint16_t port_ = 0;
    std::unique_ptr<QUdpSocket> socket_;  ///< lives on the thread
    std::deque<Heard> heard_;
    mutable std::mutex counts_mutex_;
    Counts counts_;
    std::unique_ptr<LoopThread> thread_;  ///< last: it uses the others
};

}  // namespace noctule
