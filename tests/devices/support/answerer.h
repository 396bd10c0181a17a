// SPDX-License-Identifier: Apache-2.0
// A box's side of discovery on loopback, at a port of the system's choice, with some noise between its
// answers.
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>

#include "devices/driver_box/frame.h"
#include "devices/driver_box/hello.h"
#include "devices/driver_box/messages.h"

namespace noctule::test {

inline link::Announcement testAnnouncement(const std::string& serial = "NB-000777") {
    return {serial, "Blue suit", "test box", 50123, 150000, 18, 8, false};
}

class Answerer {
public:
    explicit Answerer(const link::Announcement& announcement) : announcement_(announcement) {
        socket_ = socket(AF_INET, SOCK_DGRAM, 0);
        sockaddr_in here{};
        here.sin_family = AF_INET;
        here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(bind(socket_, reinterpret_cast<sockaddr*>(&here), sizeof here), 0);
        socklen_t length = sizeof here;
        getsockname(socket_, reinterpret_cast<sockaddr*>(&here), &length);
        port_ = ntohs(here.sin_port);
        const timeval patience{0, 20'000};
        setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
        thread_ = std::thread([this] { run(); });
    }
    ~Answerer() {
        ends_ = true;
        thread_.join();
        close(socket_);
    }

    uint16_t port() const { return port_; }
    int questions() const { return questions_; }
    void answers(bool answers) { answers_ = answers; }
    void announce(const link::Announcement& announcement) {
        const std::lock_guard lock(mutex_);
        announcement_ = announcement;
    }

private:
    void run() {
        while (!ends_) {
            char bytes[64];
            sockaddr_in from{};
            socklen_t length = sizeof from;
            const auto count =
                recvfrom(socket_, bytes, sizeof bytes, 0, reinterpret_cast<sockaddr*>(&from), &length);
            if (count <= 0)
                continue;
            EXPECT_EQ(std::string(bytes, static_cast<size_t>(count)), "NOCTULE-DISCOVER");
            ++questions_;
            if (answers_)
                answer(from);
        }
    }
    void answer(const sockaddr_in& to) {
        const std::lock_guard lock(mutex_);
        const auto payload = link::toPayload(announcement_);
        auto frame = link::encodeFrame(static_cast<uint8_t>(link::Type::kAnnounce), 0, payload);
        auto broken = frame;
        broken[30] ^= 1;
        const std::string words = "{\"serial\":\"NB-666\"}";
        send(to, {broken.begin(), broken.end()});
        send(to, words);
        send(to, {frame.begin(), frame.begin() + 21});
        send(to, "");
        send(to, {frame.begin(), frame.end()});
    }
    void send(const sockaddr_in& to, const std::string& bytes) const {
        sendto(socket_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
    }

    int socket_ = -1;
    uint16_t port_ = 0;
    std::mutex mutex_;
    link::Announcement announcement_;
    std::atomic<bool> ends_ = false, answers_ = true;
    std::atomic<int> questions_ = 0;
    std::thread thread_;
};

}  // namespace noctule::test
