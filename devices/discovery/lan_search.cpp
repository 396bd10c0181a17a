// SPDX-License-Identifier: Apache-2.0
#include "devices/discovery/lan_search.h"

#include <QNetworkDatagram>
#include <QNetworkInterface>
#include <QNetworkProxy>

#include "devices/driver_box/discovery.h"

namespace noctule {

LanSearch::LanSearch(uint16_t port, Listener listener) : port_(port), listener_(std::move(listener)) {
    socket_.setProxy(QNetworkProxy::NoProxy);
    socket_.bind(QHostAddress(QHostAddress::AnyIPv4));
    socket_.setSocketOption(QAbstractSocket::MulticastTtlOption, link::kDiscoveryTtl);
    QObject::connect(&socket_, &QUdpSocket::readyRead, &socket_, [this] { hear(); });
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { ask(); });
    ask();
}

/// An interface that cannot send (no address, no route) is no error: the box may be at another.
void LanSearch::ask() {
    static const QHostAddress kGroup(QString::fromLatin1(link::kDiscoveryGroup.data()));
    for (const QNetworkInterface& interface : QNetworkInterface::allInterfaces()) {
        if (!interface.flags().testFlag(QNetworkInterface::IsRunning))
            continue;
        if (interface.flags().testFlag(QNetworkInterface::CanMulticast)) {
            socket_.setMulticastInterface(interface);
            ask(kGroup);
        }
        for (const QNetworkAddressEntry& entry : interface.addressEntries())
            if (!entry.broadcast().isNull())
                ask(entry.broadcast());
    }
    ask(QHostAddress::Broadcast);
    ask(QHostAddress::LocalHost);  // a virtual suit on this computer, with or without a network
    timer_.start(++asked_ < link::kDiscoveryQuestions ? link::kDiscoveryEvery_ms : kThenEvery_ms);
}

void LanSearch::ask(const QHostAddress& address) {
    socket_.writeDatagram(link::kDiscoveryQuestion.data(),
                          static_cast<qint64>(link::kDiscoveryQuestion.size()), address, port_);
}

void LanSearch::hear() {
    while (socket_.hasPendingDatagrams()) {
        const QNetworkDatagram datagram = socket_.receiveDatagram();
        const QByteArray bytes = datagram.data();
        const std::string host = datagram.senderAddress().toString().toStdString();
        const auto announcement = link::readAnnouncementDatagram(
            {reinterpret_cast<const uint8_t*>(bytes.constData()), static_cast<size_t>(bytes.size())}, host);
        if (announcement)
            listener_(*announcement, host);
    }
}

}  // namespace noctule
