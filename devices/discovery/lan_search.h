// SPDX-License-Identifier: Apache-2.0
// Asks the network for boxes (README.md of the link, section 5) and hears their answers; lives on a thread
// with an event loop. Three datagrams 300 ms apart, then one a second, so that a box that is switched on
// later appears too and one lost datagram makes nobody vanish.
#pragma once

#include <QTimer>
#include <QUdpSocket>
#include <functional>
#include <string>

#include "devices/driver_box/hello.h"

namespace noctule {

class LanSearch {
public:
    static constexpr int kThenEvery_ms = 1000;

    /// `host`: the sender's address.
    using Listener = std::function<void(const link::Announcement&, const std::string& host)>;

    /// `port`: where boxes listen.
    LanSearch(uint16_t port, Listener listener);

private:
    void ask();
    void ask(const QHostAddress& address);
    void hear();

    uint16_t port_;
    Listener listener_;
    QUdpSocket socket_;
    QTimer timer_;
    int asked_ = 0;
};

}  // namespace noctule
