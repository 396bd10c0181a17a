// SPDX-License-Identifier: Apache-2.0
// One datagram a command, one a state; nothing is sent twice, and what comes too late is thrown away.
#pragma once

#include <QHostAddress>
#include <QHostInfo>
#include <QTimer>
#include <QUdpSocket>

#include "devices/device/loop_thread.h"
#include "devices/robot/datagram.h"
#include "devices/robot/link_book.h"

namespace noctule::robot_link {

class UdpInterface : public RobotInterface {
public:
    /// A robot that is silent is asked for its state so often.
    static constexpr int kAskEvery_ms = 100;

    /// `host`: numbers, or a name that is looked up once open() is called.
    UdpInterface(std::string address, QString host, uint16_t port, const LinkOptions& options);
    ~UdpInterface() override { thread_.reset(); }

    const std::string& address() const override { return address_; }
    void open() override;
    void send(const RobotCommand& command) override;
    LinkStatus status() const override { return book_.status(); }

private:
    // On the thread:
    void begin();
    void look();
    void found(const QHostInfo& info);
    void bind();
    void ask();
    void write();
    bool writeBytes(const Datagram& datagram);
    void read();
    void handle(const QByteArray& bytes);

    const std::string address_;
    const QString name_;
    QHostAddress host_;  ///< null until the name is known
    const uint16_t port_;
    const size_t joints_;
    const uint64_t joints_hash_;
    LinkBook book_;
    std::unique_ptr<QUdpSocket> socket_;  ///< lives on the thread
    std::unique_ptr<QTimer> timer_;
    std::unique_ptr<QObject> lookup_;  ///< gone: what the network still says is not heard
    uint64_t newest_state_ = 0;
    int64_t heard_ns_ = 0;
    std::unique_ptr<LoopThread> thread_;  ///< last: it uses the others
};

}  // namespace noctule::robot_link
