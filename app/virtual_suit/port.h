// SPDX-License-Identifier: Apache-2.0
// One way to the studio: TCP or a pseudo-terminal. It carries bytes of at most one client and never waits.
// Lives in the thread of the event loop.
#pragma once

#include <string>

#include "devices/driver_box/wire.h"

namespace noctule::virtual_suit {

class Port;

/// Who has the ports. Must outlive them.
class PortOwner {
public:
    virtual ~PortOwner() = default;
    /// False: it is turned away.
    virtual bool clientCame(Port& port) = 0;
    virtual void clientLeft(Port& port) = 0;
    virtual void bytesCame(Port& port, link::ByteView bytes) = 0;
    virtual void roomCame(Port& port) = 0;
};

class Port {
public:
    static constexpr int kDrain_ms = 500;

    virtual ~Port() = default;

    /// As `record --device` takes it: "tcp://127.0.0.1:41941".
    virtual std::string address() const = 0;
    /// How many bytes may be written now.
    virtual size_t room() const = 0;
    virtual void write(const link::Bytes& bytes) = 0;
    /// At once, whatever is under way; the owner is not told.
    virtual void closeClient() = 0;
    /// No: nobody can come until yes.
    virtual void setReachable(bool reachable) = 0;
    /// Waits a moment until what was written has gone.
    virtual void drain() = 0;
    /// A few hundred times a second.
    virtual void poll() {}
};

}  // namespace noctule::virtual_suit
