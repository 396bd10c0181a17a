// SPDX-License-Identifier: Apache-2.0
// Answers studios that look for boxes on the network (devices/driver_box/README.md, section 5).
#pragma once

#include <QUdpSocket>
#include <functional>
#include <memory>

#include "core/job/result.h"
#include "devices/driver_box/hello.h"

namespace noctule::virtual_suit {

class Announcer {
public:
    using Announce = std::function<link::Announcement()>;

    /// `only_this_machine`: nobody else could connect, so nobody else is answered. Port 0: the system
    /// chooses. kDevice when the port cannot be had.
    static Result<std::unique_ptr<Announcer>> open(quint16 port, bool only_this_machine, Announce announce);
    quint16 port() const { return socket_.localPort(); }

private:
    Announcer(bool only_this_machine, Announce announce);
    void joinGroup();
    void read();

    QUdpSocket socket_;
    bool only_this_machine_;
    Announce announce_;
};

}  // namespace noctule::virtual_suit
