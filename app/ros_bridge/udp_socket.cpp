// SPDX-License-Identifier: Apache-2.0
#include "app/ros_bridge/udp_socket.h"

#include <arpa/inet.h>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>

#include "devices/robot/datagram.h"

namespace noctule::ros_bridge {
namespace {

Result<sockaddr_in> addressOf(const std::string& text) {
    const size_t colon = text.rfind(':');
    const std::string port = colon == std::string::npos ? "" : text.substr(colon + 1);
    const bool is_number = !port.empty() && port.size() <= 5 &&
                           port.find_first_not_of("0123456789") == std::string::npos &&
                           std::stoi(port) <= 65535;
    addrinfo wanted{}, *found = nullptr;
    wanted.ai_family = AF_INET;
    wanted.ai_socktype = SOCK_DGRAM;
    if (colon == 0 || !is_number ||
        ::getaddrinfo(text.substr(0, colon).c_str(), port.c_str(), &wanted, &found) != 0)
        return Error{ErrorKind::kUsage, "--udp " + text + ": is no address of this computer",
                     "Write HOST:PORT, such as 127.0.0.1:41950"};
    const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> owner(found, &::freeaddrinfo);
    sockaddr_in address{};
    std::memcpy(&address, found->ai_addr, sizeof address);
    return address;
}

}  // namespace

Result<UdpSocket> UdpSocket::listen(const std::string& address) {
    const auto where = addressOf(address);
    if (!where)
        return where.error();
    UdpSocket made(::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (made.handle_ < 0 ||
        ::bind(made.handle_, reinterpret_cast<const sockaddr*>(&*where), sizeof *where) != 0)
        return Error{ErrorKind::kDevice, address + ": cannot be listened on: " + std::strerror(errno),
                     "Give --udp another port (0: any free one)"};
    return made;
}

UdpSocket::UdpSocket(UdpSocket&& other) noexcept
    : handle_(std::exchange(other.handle_, -1)), sender_(other.sender_), peer_(other.peer_) {}

UdpSocket::~UdpSocket() {
    if (handle_ >= 0)
        ::close(handle_);
}

std::string UdpSocket::address() const {
    sockaddr_in own{};
    socklen_t size = sizeof own;
    ::getsockname(handle_, reinterpret_cast<sockaddr*>(&own), &size);
    char host[INET_ADDRSTRLEN] = "";
    ::inet_ntop(AF_INET, &own.sin_addr, host, sizeof host);
    return std::string(host) + ":" + std::to_string(ntohs(own.sin_port));
}

std::optional<std::vector<uint8_t>> UdpSocket::receive() {
    std::vector<uint8_t> bytes(robot_link::kMostDatagramBytes + 1);
    socklen_t size = sizeof sender_;
    const ssize_t count =
        ::recvfrom(handle_, bytes.data(), bytes.size(), 0, reinterpret_cast<sockaddr*>(&sender_), &size);
    if (count < 0)
        return std::nullopt;
    bytes.resize(static_cast<size_t>(count));
    return bytes;
}

void UdpSocket::send(const std::vector<uint8_t>& bytes) const {
    if (peer_)
        (void)::sendto(handle_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&*peer_),
                       sizeof *peer_);
}

}  // namespace noctule::ros_bridge
