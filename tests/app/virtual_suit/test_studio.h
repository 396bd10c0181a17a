// SPDX-License-Identifier: Apache-2.0
// The virtual suit as a running program, and a studio beside it: the studio's side of the conversation over a
// plain descriptor, a socket's or a terminal's.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <termios.h>

#include <chrono>
#include <functional>
#include <thread>

#include "devices/driver_box/studio_conversation.h"
#include "tests/support/program_run.h"

namespace noctule::test {

inline int64_t nowNs() {
    return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

/// -1 when nobody listens.
inline int connectTo(int port, int type = SOCK_STREAM) {
    const int descriptor = socket(AF_INET, type | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (connect(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0)
        return descriptor;
    close(descriptor);
    return -1;
}

inline int openTerminal(const std::string& path) {
    const int descriptor = open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    termios settings{};
    EXPECT_EQ(tcgetattr(descriptor, &settings), 0) << path;
    cfmakeraw(&settings);
    tcsetattr(descriptor, TCSANOW, &settings);
    return descriptor;
}

/// What comes within the time; empty when nothing does or the other side has closed.
inline std::string readSome(int descriptor, int wait_ms, bool* closed = nullptr) {
    pollfd state{descriptor, POLLIN, 0};
    std::string bytes(1 << 16, '\0');
    if (poll(&state, 1, wait_ms) <= 0)
        return "";
    const ssize_t count = read(descriptor, bytes.data(), bytes.size());
    if (closed)
        *closed = count <= 0;
    bytes.resize(static_cast<size_t>(std::max<ssize_t>(0, count)));
    return bytes;
}

class RunningSuit {
public:
    explicit RunningSuit(std::vector<std::string> arguments) : program_(withPorts(std::move(arguments))) {
        for (int i = 0; i < 1000 && lineAfter("control: ").empty(); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        control_ = connectTo(portAfter("control: "));
        EXPECT_GE(control_, 0) << program_.out();
    }
    ~RunningSuit() {
        close(control_);
        if (!ended_)
            end(SIGTERM);
    }
    RunningSuit(const RunningSuit&) = delete;
    RunningSuit& operator=(const RunningSuit&) = delete;

    int tcpPort() const { return portAfter("studio: tcp://"); }
    int announcePort() const { return std::stoi(lineAfter("announce: udp ")); }
    std::string terminal() const { return lineAfter("studio: serial://"); }

    /// Its answer, without the end of the line.
    std::string tell(const std::string& command) const {
        const std::string line = command + "\n";
        EXPECT_EQ(write(control_, line.data(), line.size()), static_cast<ssize_t>(line.size()));
        std::string answer;
        for (int i = 0; i < 50 && !answer.ends_with('\n'); ++i)
            answer += readSome(control_, 200);
        EXPECT_TRUE(answer.ends_with('\n')) << command;
        return answer.substr(0, answer.find('\n'));
    }
    Ran end(int signal) {
        program_.send(signal);
        return wait();
    }
    Ran wait() {
        ended_ = true;
        return program_.wait();
    }

private:
    static std::vector<std::string> withPorts(std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--tcp", "127.0.0.1:0", "--control", "127.0.0.1:0"});
        return arguments;
    }
    std::string lineAfter(const std::string& start) const {
        const std::string out = program_.out();
        const size_t at = out.find(start);
        const size_t end = at == std::string::npos ? at : out.find('\n', at);
        return end == std::string::npos ? "" : out.substr(at + start.size(), end - at - start.size());
    }
    int portAfter(const std::string& start) const {
        const std::string line = lineAfter(start);
        const size_t colon = line.rfind(':');
        return colon == std::string::npos ? 0 : std::stoi(line.substr(colon + 1));
    }

    Started program_;
    int control_ = -1;
    bool ended_ = false;
};

/// Connects again by itself, as a studio does.
class TestStudio {
public:
    using Open = std::function<int()>;

    explicit TestStudio(Open open) : open_(std::move(open)) { connectNow(); }
    ~TestStudio() { hangUp(); }

    std::vector<link::StudioEvent> events;
    link::StudioConversation conversation{"the test's link"};
    bool reads = true;

    /// False: it has not come about in time.
    bool runUntil(const std::function<bool()>& done, double seconds = 20) {
        const int64_t end_ns = nowNs() + static_cast<int64_t>(seconds * 1e9);
        while (!done() && nowNs() < end_ns)
            step();
        return done();
    }
    void run(double seconds) {
        runUntil([] { return false; }, seconds);
    }
    bool greet() {
        return runUntil([&] { return count<link::Greeted>() > 0; });
    }
    bool start() {
        if (!greet())
            return false;
        conversation.start(nowNs());
        return runUntil([&] { return count<link::Started>() > 0; });
    }
    bool stop() {
        conversation.stop(nowNs());
        return runUntil([&] { return count<link::Stopped>() > 0; });
    }
    void hangUp() {
        if (descriptor_ >= 0)
            close(std::exchange(descriptor_, -1));
    }

    template <class Event>
    std::vector<Event> all() const {
        std::vector<Event> found;
        for (const link::StudioEvent& event : events)
            if (const auto* one = std::get_if<Event>(&event))
                found.push_back(*one);
        return found;
    }
    template <class Event>
    size_t count() const {
        return all<Event>().size();
    }
    bool heard(link::Code code) const {
        const auto errors = all<link::BoxError>();
        return std::any_of(errors.begin(), errors.end(), [&](const auto& one) { return one.code == code; });
    }
    int64_t samples() const {
        int64_t samples = 0;
        for (const link::StudioEvent& event : events)
            if (const auto* block = std::get_if<link::SoundBlock>(&event))
                samples = block->first_sample + block->sampleCount();
        return samples;
    }
    std::vector<link::EmittedPulse> pulses() const {
        std::vector<link::EmittedPulse> pulses;
        for (const link::Pulses& some : all<link::Pulses>())
            pulses.insert(pulses.end(), some.begin(), some.end());
        return pulses;
    }

private:
    void connectNow() {
        descriptor_ = open_();
        descriptor_ >= 0 ? conversation.opened(nowNs()) : conversation.closed(nowNs());
    }
    void step() {
        bool closed = false;
        std::string bytes;
        if (descriptor_ >= 0 && reads)
            bytes = readSome(descriptor_, 5, &closed);
        else
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        if (!bytes.empty())
            conversation.receive({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()}, nowNs());
        if (closed) {
            hangUp();
            conversation.closed(nowNs());
        }
        conversation.tick(nowNs());
        const link::Bytes out = conversation.takeBytes();
        if (descriptor_ >= 0 && !out.empty()) {
            EXPECT_EQ(send(out), static_cast<ssize_t>(out.size()));
        }
        for (link::StudioEvent& event : conversation.takeEvents()) {
            if (std::holds_alternative<link::LinkLost>(event) || std::holds_alternative<link::Refused>(event))
                hangUp();
            const bool connect_wanted = std::holds_alternative<link::ConnectWanted>(event);
            events.push_back(std::move(event));
            if (connect_wanted)
                connectNow();
        }
    }
    ssize_t send(const link::Bytes& bytes) const {
        const ssize_t sent = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        return sent < 0 && errno == ENOTSOCK ? write(descriptor_, bytes.data(), bytes.size())
               : sent < 0                    ? static_cast<ssize_t>(bytes.size())  // noticed when reading
                                             : sent;
    }

    Open open_;
    int descriptor_ = -1;
};

}  // namespace noctule::test
