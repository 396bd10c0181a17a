// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/pty_port.h"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/inotify.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace noctule::virtual_suit {
namespace {

constexpr size_t kMostAtOnce_bytes = 64 * 1024;

Error noTerminal() {
    return {ErrorKind::kDevice, std::string("no pseudo-terminal: ") + std::strerror(errno),
            "Check that /dev/pts is mounted, or use --tcp instead of --pty"};
}

/// Raw; and somebody had it open, for only then does the system tell that nobody has.
bool prepareOtherEnd(const char* path) {
    const int other = ::open(path, O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (other < 0)
        return false;
    termios settings{};
    const bool known = tcgetattr(other, &settings) == 0;
    cfmakeraw(&settings);
    const bool set = known && tcsetattr(other, TCSANOW, &settings) == 0;
    ::close(other);
    return set;
}

}  // namespace

Result<std::unique_ptr<PtyPort>> PtyPort::open(PortOwner& owner) {
    const int descriptor = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0)
        return noTerminal();
    std::array<char, 128> path{};
    if (grantpt(descriptor) != 0 || unlockpt(descriptor) != 0 ||
        ptsname_r(descriptor, path.data(), path.size()) != 0 || !prepareOtherEnd(path.data())) {
        const Error error = noTerminal();
        ::close(descriptor);
        return error;
    }
    return std::unique_ptr<PtyPort>(new PtyPort(descriptor, path.data(), owner));
}

PtyPort::PtyPort(int descriptor, const std::string& path, PortOwner& owner)
    : descriptor_(descriptor),
      closings_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)),
      path_(path),
      owner_(owner),
      readable_(descriptor, QSocketNotifier::Read),
      writable_(descriptor, QSocketNotifier::Write) {
    readable_.setEnabled(false);
    writable_.setEnabled(false);
    inotify_add_watch(closings_, path_.c_str(), IN_CLOSE);
    QObject::connect(&readable_, &QSocketNotifier::activated, &readable_, [this] { read(); });
    QObject::connect(&writable_, &QSocketNotifier::activated, &writable_, [this] { writeOn(); });
}

PtyPort::~PtyPort() {
    readable_.setEnabled(false);
    writable_.setEnabled(false);
    ::close(closings_);
    ::close(descriptor_);
}

bool PtyPort::otherEndWasClosed() {
    std::array<char, 4096> events;
    bool any = false;
    while (::read(closings_, events.data(), events.size()) > 0)
        any = true;
    return any;
}

bool PtyPort::otherEndIsOpen() const {
    pollfd state{descriptor_, POLLIN, 0};
    return ::poll(&state, 1, 0) >= 0 && !(state.revents & POLLHUP);
}

void PtyPort::poll() {
    const bool is_another = otherEndWasClosed(), is_open = otherEndIsOpen();
    if (open_ && (is_another || !is_open))
        otherEndClosed();
    if (open_ || !is_open)
        return;
    open_ = true;
    readable_.setEnabled(true);
    has_client_ = reachable_ && owner_.clientCame(*this);
}

void PtyPort::otherEndClosed() {
    open_ = false;
    readable_.setEnabled(false);
    const bool had_client = has_client_;
    closeClient();
    if (had_client)
        owner_.clientLeft(*this);
}

void PtyPort::read() {
    poll();
    if (!open_)
        return;
    std::array<uint8_t, 4096> bytes;
    const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno == EIO)
        return otherEndClosed();
    if (count <= 0 || !reachable_)
        return;
    // Someone who was turned away or cut off, and calls again.
    if (!has_client_)
        has_client_ = owner_.clientCame(*this);
    if (has_client_)
        owner_.bytesCame(*this, {bytes.data(), static_cast<size_t>(count)});
}

size_t PtyPort::room() const {
    return has_client_ && unsent_.empty() ? kMostAtOnce_bytes : 0;
}

void PtyPort::write(const link::Bytes& bytes) {
    if (!has_client_)
        return;
    unsent_.insert(unsent_.end(), bytes.begin(), bytes.end());
    const ssize_t count = ::write(descriptor_, unsent_.data(), unsent_.size());
    if (count > 0)
        unsent_.erase(unsent_.begin(), unsent_.begin() + count);
    writable_.setEnabled(!unsent_.empty());
}

void PtyPort::writeOn() {
    write({});
    if (unsent_.empty())
        owner_.roomCame(*this);
}

void PtyPort::closeClient() {
    has_client_ = false;
    unsent_.clear();
    writable_.setEnabled(false);
    tcflush(descriptor_, TCIOFLUSH);  // or the next client would find the rest of a frame
}

void PtyPort::drain() {
    pollfd state{descriptor_, POLLOUT, 0};
    while (has_client_ && !unsent_.empty() && ::poll(&state, 1, kDrain_ms) > 0 && !(state.revents & POLLHUP))
        write({});
}

}  // namespace noctule::virtual_suit
