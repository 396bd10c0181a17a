// SPDX-License-Identifier: Apache-2.0
#include "app/batch/devices/operator_keys.h"

#include <poll.h>
#include <unistd.h>

#include <array>

namespace noctule::batch {
namespace {

constexpr size_t kLongestKeyLine = 200;

}  // namespace

void OperatorKeys::obey(const std::string& line) {
    if (line == "engage") {
        holds_ = true;
    } else if (line == "release") {
        holds_ = false;
    } else if (line == "accept") {
        pressed_.accept = true;
    } else if (line == "stop") {
        pressed_.stop = true;
        holds_ = false;
    } else if (line == "reset") {
        pressed_.reset = true;
    } else if (!line.empty()) {
        complaint_ = "'" + line.substr(0, 40) + "' is no key; write engage, accept, release, stop or reset";
    }
}

void OperatorKeys::read() {
    pollfd wanted{descriptor_, POLLIN, 0};
    if (!is_open_ || ::poll(&wanted, 1, 0) <= 0)
        return;
    std::array<char, 256> bytes{};
    const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
    if (count <= 0) {
        is_open_ = false;
        if (!accepts_always_)
            holds_ = false;  // nobody is there any more who could let go
        return;
    }
    for (const char letter : std::string_view(bytes.data(), static_cast<size_t>(count))) {
        if (letter == '\n' || unfinished_.size() >= kLongestKeyLine)
            obey(std::exchange(unfinished_, {}));
        else if (letter != '\r')
            unfinished_ += letter;
    }
}

robot::TeleopKeys OperatorKeys::next() {
    if (!std::exchange(has_begun_, true))
        accepts_always_ = holds_;
    read();
    robot::TeleopKeys keys = std::exchange(pressed_, {});
    keys.dead_man = keys.clutch = holds_;
    keys.accept |= accepts_always_;
    return keys;
}

}  // namespace noctule::batch
