// SPDX-License-Identifier: Apache-2.0
// The box's serial port as a pseudo-terminal: raw, eight bits, any rate. A client is there while someone has
// the other end open, as with DTR. While it cannot be reached (`cut`) the cable is out: the terminal stays,
// bytes of both directions vanish.
#pragma once

#include <QSocketNotifier>
#include <memory>

#include "app/virtual_suit/port.h"
#include "core/job/result.h"

namespace noctule::virtual_suit {

class PtyPort : public Port {
public:
    /// kDevice when the system has no pseudo-terminal.
    static Result<std::unique_ptr<PtyPort>> open(PortOwner& owner);
    ~PtyPort() override;

    std::string address() const override { return "serial://" + path_; }
    size_t room() const override;
    void write(const link::Bytes& bytes) override;
    void closeClient() override;
    void setReachable(bool reachable) override { reachable_ = reachable; }
    void drain() override;
    void poll() override;

private:
    PtyPort(int descriptor, const std::string& path, PortOwner& owner);
    bool otherEndIsOpen() const;
    bool otherEndWasClosed();
    void read();
    void writeOn();
    void otherEndClosed();

    int descriptor_;
    int closings_;  ///< tells of them even when another opening has followed at once
    std::string path_;
    PortOwner& owner_;
    QSocketNotifier readable_, writable_;
    bool open_ = false;  ///< the other end
    bool has_client_ = false;
    bool reachable_ = true;
    link::Bytes unsent_;
};

}  // namespace noctule::virtual_suit
