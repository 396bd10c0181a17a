// SPDX-License-Identifier: Apache-2.0
#include "devices/robot/udp_interface.h"

#include <QNetworkDatagram>
#include <algorithm>

#include "devices/machine/clock.h"

namespace noctule::robot_link {
namespace {

/// After so long without a state, one with a smaller number is a robot that has started again.
constexpr int64_t kForgetsOrder_ns = 500'000'000;

}  // namespace

UdpInterface::UdpInterface(std::string address, QString host, uint16_t port, const LinkOptions& options)
    : address_(std::move(address)),
      name_(std::move(host)),
      host_(name_),
      port_(port),
      joints_(options.joints.size()),
      joints_hash_(hashOf(options.joints)) {
    thread_ = std::make_unique<LoopThread>("robot", [this] {
        lookup_.reset();
        timer_.reset();
        socket_.reset();
    });
}

void UdpInterface::open() {
    thread_->post([this] { begin(); });
}

void UdpInterface::begin() {
    if (host_.isNull())
        look();
    else
        bind();
}

/// The network may take seconds to answer, or never do; nobody waits for it.
void UdpInterface::look() {
    lookup_ = std::make_unique<QObject>();
    QHostInfo::lookupHost(name_, lookup_.get(), [this](const QHostInfo& info) { found(info); });
}

void UdpInterface::found(const QHostInfo& info) {
    const QList<QHostAddress> addresses = info.addresses();
    if (addresses.isEmpty())
        return book_.hopeless(unknownName(address_));
    const auto is_v4 = [](const QHostAddress& one) {
        return one.protocol() == QAbstractSocket::IPv4Protocol;
    };
    const auto v4 = std::ranges::find_if(addresses, is_v4);
    host_ = v4 == addresses.end() ? addresses.first() : *v4;
    bind();
}

void UdpInterface::bind() {
    socket_ = std::make_unique<QUdpSocket>();
    QObject::connect(socket_.get(), &QUdpSocket::readyRead, socket_.get(), [this] { read(); });
    if (!socket_->bind(host_.protocol() == QAbstractSocket::IPv6Protocol ? QHostAddress::AnyIPv6
                                                                         : QHostAddress::AnyIPv4))
        book_.lost({ErrorKind::kDevice,
                    address_ + ": no UDP port can be had: " + socket_->errorString().toStdString(),
                    "Close programs that hold many ports"});
    timer_ = std::make_unique<QTimer>();
    QObject::connect(timer_.get(), &QTimer::timeout, timer_.get(), [this] { ask(); });
    timer_->start(kAskEvery_ms);
    ask();
}

/// A robot tells its state to who asked or commanded last.
void UdpInterface::ask() {
    if (steadyNow_ns() - heard_ns_ < int64_t{kAskEvery_ms} * 1'000'000)
        return;
    Datagram query;
    query.kind = DatagramKind::kQuery;
    query.time_ns = steadyNow_ns();
    query.joints_hash = joints_hash_;
    writeBytes(query);
}

bool UdpInterface::writeBytes(const Datagram& datagram) {
    const std::vector<uint8_t> bytes = encode(datagram);
    const auto size = static_cast<qint64>(bytes.size());
    if (socket_ &&
        socket_->writeDatagram(reinterpret_cast<const char*>(bytes.data()), size, host_, port_) == size)
        return true;
    book_.lost({ErrorKind::kDevice,
                address_ + ": cannot be written to" +
                    (socket_ ? ": " + socket_->errorString().toStdString() : std::string()),
                "Check the network and the robot's address"});
    return false;
}

void UdpInterface::send(const RobotCommand& command) {
    require(areSound(command.q, command.v, joints_), "a command has a finite value for every joint");
    if (book_.put(command))
        thread_->post([this] { write(); });
}

void UdpInterface::write() {
    const auto command = book_.takeCommand();
    if (!command)
        return;
    if (host_.isNull())
        return book_.dropped();  // its name is not known yet
    Datagram datagram;
    datagram.sequence = command->sequence;
    datagram.time_ns = command->time_ns;
    datagram.joints_hash = joints_hash_;
    datagram.flags = command->flags;
    datagram.q = command->q;
    datagram.v = command->v;
    if (writeBytes(datagram))
        book_.sent(*command, steadyNow_ns());
    else
        book_.dropped();
}

void UdpInterface::read() {
    while (socket_->hasPendingDatagrams()) {
        const QNetworkDatagram datagram = socket_->receiveDatagram(kMostDatagramBytes + 1);
        if (datagram.senderAddress().isEqual(host_, QHostAddress::ConvertV4MappedToIPv4) &&
            datagram.senderPort() == port_)
            handle(datagram.data());
    }
}

void UdpInterface::handle(const QByteArray& bytes) {
    auto read =
        decode({reinterpret_cast<const uint8_t*>(bytes.constData()), static_cast<size_t>(bytes.size())});
    if (!read)
        return book_.refused(
            {read.error().kind, address_ + ": " + read.error().message, read.error().remedy});
    if (read->kind != DatagramKind::kState)
        return book_.refused({ErrorKind::kUnusable, address_ + ": sends commands instead of states",
                              "Check that this is the robot's address, not a studio's"});
    if (read->joints_hash != joints_hash_ || read->q.size() != joints_)
        return book_.refused({ErrorKind::kUnusable,
                              address_ + ": the robot's joints are others than those that are driven",
                              "Give the robot the same joint names in the same order"});
    const int64_t now_ns = steadyNow_ns();
    if (read->sequence <= newest_state_ && now_ns - heard_ns_ < kForgetsOrder_ns)
        return;
    newest_state_ = read->sequence;
    heard_ns_ = now_ns;
    book_.received({read->sequence, read->time_ns, read->obeyed_sequence, read->flags, std::move(read->q),
                    std::move(read->v)},
                   now_ns);
}

}  // namespace noctule::robot_link
