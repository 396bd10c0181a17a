// SPDX-License-Identifier: Apache-2.0
#include "devices/device/tcp_link.h"

#include <QNetworkProxy>
#include <utility>

namespace noctule {

void TcpLink::open() {
    close();
    socket_ = new QTcpSocket;
    socket_->setProxy(QNetworkProxy::NoProxy);
    QObject::connect(socket_, &QTcpSocket::connected, socket_, [this] { connected(); });
    QObject::connect(socket_, &QTcpSocket::readyRead, socket_, [this] { read(); });
    QObject::connect(socket_, &QTcpSocket::errorOccurred, socket_,
                     [this] { ended(socket_->errorString().toStdString()); });
    QObject::connect(socket_, &QTcpSocket::disconnected, socket_,
                     [this] { ended("the box has closed the connection"); });
    if (!patience_) {
        patience_ = std::make_unique<QTimer>();
        patience_->setSingleShot(true);
        QObject::connect(patience_.get(), &QTimer::timeout, patience_.get(),
                         [this] { ended("no connection within 3 s"); });
    }
    patience_->start(kConnectTime_ms);
    socket_->connectToHost(QString::fromStdString(host_), port_);
}

void TcpLink::connected() {
    patience_->stop();
    socket_->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    listener().opened();
}

void TcpLink::read() {
    const QByteArray bytes = socket_->readAll();
    if (!bytes.isEmpty())
        listener().received(
            {reinterpret_cast<const uint8_t*>(bytes.constData()), static_cast<size_t>(bytes.size())});
}

/// The last bytes come before the end; hearing them may already close this link.
void TcpLink::ended(const std::string& why) {
    if (!socket_)
        return;
    const QTcpSocket* const before = socket_;
    read();
    if (socket_ != before)
        return;
    close();
    listener().closed(why,
                      "Check that the box is switched on, in the same network, and that this is its "
                      "address and port");
}

void TcpLink::write(link::ByteView bytes) {
    if (socket_ && socket_->state() == QAbstractSocket::ConnectedState)
        socket_->write(reinterpret_cast<const char*>(bytes.data()), static_cast<qint64>(bytes.size()));
}

void TcpLink::close() {
    if (patience_)
        patience_->stop();
    QTcpSocket* const socket = std::exchange(socket_, nullptr);
    if (!socket)
        return;
    socket->disconnect();
    socket->flush();
    socket->abort();
    socket->deleteLater();
}

}  // namespace noctule
