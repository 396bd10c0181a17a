// SPDX-License-Identifier: Apache-2.0
// The wire of a box in tests: one client at a time over TCP on a port of the system's choice, or over a
// pseudo-terminal with a name that stays when the terminal changes. Not for several threads at once.
#pragma once

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <string>

#include "devices/driver_box/wire.h"
#include "tests/support/files.h"

namespace noctule::test {

class BoxStream {
public:
    virtual ~BoxStream() = default;
    virtual std::string address() const = 0;
    /// Waits for something to happen, takes a client if there is one.
    virtual void wait(int milliseconds) = 0;
    /// What has come; closes when the client is gone.
    virtual link::Bytes read() = 0;
    /// How many bytes the wire took.
    virtual size_t write(link::ByteView bytes) = 0;
    virtual bool hasClient() const = 0;
    /// The client notices.
    virtual void cut() = 0;
};

/// Reading and writing both kinds of descriptor.
class DescriptorStream : public BoxStream {
public:
    link::Bytes read() override {
        link::Bytes bytes(1 << 16);
        const ssize_t count = client_ < 0 ? 0 : ::read(client_, bytes.data(), bytes.size());
        if (client_ >= 0 && (count == 0 || (count < 0 && errno != EAGAIN)))
            ended();
        bytes.resize(count > 0 ? static_cast<size_t>(count) : 0);
        return bytes;
    }
    size_t write(link::ByteView bytes) override {
        const ssize_t count = client_ < 0 ? 0 : ::write(client_, bytes.data(), bytes.size());
        return count > 0 ? static_cast<size_t>(count) : 0;
    }
    bool hasClient() const override { return client_ >= 0; }

protected:
    virtual void ended() = 0;
    static void poll(int descriptor, int milliseconds) {
        pollfd entry{descriptor, POLLIN, 0};
        ::poll(&entry, 1, milliseconds);
    }
    int client_ = -1;
};

class TcpBoxStream : public DescriptorStream {
public:
    TcpBoxStream() {
        listener_ = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
        sockaddr_in here{};
        here.sin_family = AF_INET;
        here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(bind(listener_, reinterpret_cast<sockaddr*>(&here), sizeof here), 0);
        EXPECT_EQ(listen(listener_, 4), 0);
        socklen_t length = sizeof here;
        getsockname(listener_, reinterpret_cast<sockaddr*>(&here), &length);
        port_ = ntohs(here.sin_port);
    }
    ~TcpBoxStream() override {
        cut();
        close(listener_);
    }
    std::string address() const override { return "tcp://127.0.0.1:" + std::to_string(port_); }
    void wait(int milliseconds) override {
        poll(client_ < 0 ? listener_ : client_, milliseconds);
        const int next = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK);
        if (next >= 0 && client_ >= 0)
            close(next);
        else if (next >= 0)
            client_ = next;
    }
    void cut() override {
        if (client_ >= 0)
            close(client_);
        client_ = -1;
    }

private:
    void ended() override { cut(); }

    int listener_ = -1;
    uint16_t port_ = 0;
};

class PtyBoxStream : public DescriptorStream {
public:
    PtyBoxStream() { plugIn(); }
    ~PtyBoxStream() override { unplug(); }
    std::string address() const override { return "serial://" + folder_.file("box"); }
    void wait(int milliseconds) override {
        poll(terminal_, milliseconds);
        pollfd entry{terminal_, POLLIN, 0};
        ::poll(&entry, 1, 0);
        if ((entry.revents & POLLIN) && client_ < 0)
            client_ = terminal_;
        else if ((entry.revents & POLLHUP) && client_ < 0)
            usleep(1000);  // closed by the last client: poll does not wait any more
    }
    void cut() override {
        unplug();
        plugIn();
    }

private:
    void ended() override { client_ = -1; }
    void plugIn() {
        terminal_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
        EXPECT_TRUE(grantpt(terminal_) == 0 && unlockpt(terminal_) == 0);
        termios raw{};
        tcgetattr(terminal_, &raw);
        cfmakeraw(&raw);
        tcsetattr(terminal_, TCSANOW, &raw);
        std::filesystem::create_symlink(ptsname(terminal_), folder_.file("box"));
    }
    void unplug() {
        std::filesystem::remove(folder_.file("box"));
        close(terminal_);
        client_ = -1;
    }

    Folder folder_;
    int terminal_ = -1;
};

}  // namespace noctule::test
