// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_robot/robot_ports.h"
#include "devices/machine/clock.h"

namespace noctule::virtual_robot {

using robot_link::Datagram;
using robot_link::DatagramKind;

Result<std::unique_ptr<UdpPort>> UdpPort::open(const virtual_suit::Address& address, RobotBody& body) {
    std::unique_ptr<UdpPort> port(new UdpPort(body));
    if (!port->socket_.bind(address.host, address.port, QAbstractSocket::DontShareAddress))
        return Error{ErrorKind::kDevice,
                     virtual_suit::toText(address) +
                         ": cannot be listened on: " + port->socket_.errorString().toStdString(),
                     "Give --udp another port (0: any free one)"};
    port->where_ = {address.host, port->socket_.localPort()};
    QObject::connect(&port->socket_, &QUdpSocket::readyRead, &port->socket_,
                     [self = port.get()] { self->read(); });
    return port;
}

void UdpPort::read() {
    while (socket_.hasPendingDatagrams()) {
        const QNetworkDatagram datagram = socket_.receiveDatagram(robot_link::kMostDatagramBytes + 1);
        if (!reachable_)
            continue;
        studio_ = datagram.senderAddress();
        studio_port_ = static_cast<quint16>(datagram.senderPort());
        handle(datagram.data());
    }
}

/// What cannot be read is ignored, as a robot's controller would; the studio sees no state that obeys it.
void UdpPort::handle(const QByteArray& bytes) {
    const auto read = robot_link::decode(
        {reinterpret_cast<const uint8_t*>(bytes.constData()), static_cast<size_t>(bytes.size())});
    if (read && read->kind == DatagramKind::kCommand && read->joints_hash == joints_hash_ &&
        read->q.size() == body_.joints().size())
        body_.command(steadyNow_ns(), read->sequence, read->q);
}

void UdpPort::tellState() {
    if (!reachable_ || studio_port_ == 0)
        return;
    Datagram state;
    state.kind = DatagramKind::kState;
    state.sequence = ++sequence_;
    state.time_ns = steadyNow_ns();
    state.joints_hash = joints_hash_;
    state.obeyed_sequence = body_.obeyedSequence();
    state.flags = body_.refuses() ? robot_link::kRefuses : 0u;
    state.q = body_.q();
    state.v = body_.v();
    const std::vector<uint8_t> bytes = encode(state);
    socket_.writeDatagram(reinterpret_cast<const char*>(bytes.data()), static_cast<qint64>(bytes.size()),
                          studio_, studio_port_);
}

}  // namespace noctule::virtual_robot
