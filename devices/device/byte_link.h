// SPDX-License-Identifier: Apache-2.0
// Bytes to and from a box, over whatever wire: TCP or a serial line. All of it, also the listener's
// functions, runs on one thread with an event loop; nothing blocks. A link may be opened again after it has
// ended.
#pragma once

#include <functional>
#include <string>

#include "devices/driver_box/wire.h"

namespace noctule {

class ByteLink {
public:
    struct Listener {
        std::function<void()> opened;
        std::function<void(link::ByteView)> received;
        /// It ended by itself or could not be opened; why, and what to do about it.
        std::function<void(const std::string& why, const std::string& remedy)> closed;
    };

    ByteLink() = default;
    ByteLink(const ByteLink&) = delete;
    ByteLink& operator=(const ByteLink&) = delete;
    virtual ~ByteLink() = default;

    /// Its outcome, opened() or closed(), may be told before this returns. Called once, before open().
    void listen(Listener listener) { listener_ = std::move(listener); }
    virtual void open() = 0;
    /// Ignored unless it is open.
    virtual void write(link::ByteView bytes) = 0;
    /// The listener hears nothing more until it is opened again. What was written is still tried to be sent.
    virtual void close() = 0;

protected:
    const Listener& listener() const { return listener_; }

private:
    Listener listener_;
};

}  // namespace noctule
