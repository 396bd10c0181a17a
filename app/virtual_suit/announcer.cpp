// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/announcer.h"

#include <QNetworkDatagram>
#include <QNetworkInterface>

#include "devices/driver_box/discovery.h"

namespace noctule::virtual_suit {
Result<std::unique_ptr<Announcer>> Announcer::open(quint16 port, bool only_this_machine, Announce announce) {
    std::unique_ptr<Announcer> announcer(new Announcer(only_this_machine, std::move(announce)));
    // Several boxes of one machine answer side by side.
    if (!announcer->socket_.bind(QHostAddress::AnyIPv4, port,
                                 QUdpSocket::ShareAddress | QUdpSocket::ReuseAddressHint))
        return Error{ErrorKind::kDevice,
                     "UDP port " + std::to_string(port) +
                         ": cannot be listened on: " + announcer->socket_.errorString().toStdString(),
                     "Another program has it; leave --announce out and give the studio the address"};
    announcer->joinGroup();
    return announcer;
}

Announcer::Announcer(bool only_this_machine, Announce announce)
    : only_this_machine_(only_this_machine), announce_(std::move(announce)) {
    QObject::connect(&socket_, &QUdpSocket::readyRead, &socket_, [this] { read(); });
}

/// On every interface that can; broadcasts and questions to this address alone come without it.
void Announcer::joinGroup() {
    const QHostAddress group(QString::fromLatin1(link::kDiscoveryGroup.data()));
    for (const QNetworkInterface& one : QNetworkInterface::allInterfaces())
        if (one.flags().testFlag(QNetworkInterface::IsUp))
            socket_.joinMulticastGroup(group, one);
}

void Announcer::read() {
    while (socket_.hasPendingDatagrams()) {
        const QNetworkDatagram question = socket_.receiveDatagram();
        const QByteArray bytes = question.data();
        const link::ByteView words{reinterpret_cast<const uint8_t*>(bytes.constData()),
                                   static_cast<size_t>(bytes.size())};
        if (!link::isDiscoveryQuestion(words) ||
            (only_this_machine_ && !question.senderAddress().isLoopback()))
            continue;
        const link::Bytes answer = link::announcementDatagram(announce_());
        socket_.writeDatagram(reinterpret_cast<const char*>(answer.data()),
                              static_cast<qint64>(answer.size()), question.senderAddress(),
                              static_cast<quint16>(question.senderPort()));
    }
}

}  // namespace noctule::virtual_suit
