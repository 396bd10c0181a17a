// SPDX-License-Identifier: Apache-2.0
// A box at the other end of a TCP connection.
#pragma once

#include <QTcpSocket>
#include <QTimer>
#include <memory>

#include "devices/device/byte_link.h"

namespace noctule {

class TcpLink : public ByteLink {
public:
    /// Until then a connection has to stand.
    static constexpr int kConnectTime_ms = 3000;

    TcpLink(std::string host, uint16_t port) : host_(std::move(host)), port_(port) {}
    ~TcpLink() override { close(); }

    void open() override;
    void write(link::ByteView bytes) override;
    void close() override;

private:
    void connected();
    void read();
    void ended(const std::string& why);

    std::string host_;
    uint16_t port_;
    /// One per connection; deleted by the event loop, because it may be left in one of its own signals.
    QTcpSocket* socket_ = nullptr;
    std::unique_ptr<QTimer> patience_;
};

}  // namespace noctule
