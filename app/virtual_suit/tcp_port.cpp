// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/tcp_port.h"

namespace noctule::virtual_suit {
namespace {

/// Of ours and of the system's each: together a tenth of a second of 18 boards. More would hide from the box
/// that its client does not read.
constexpr qint64 kMostUnsent_bytes = 256 * 1024;

}  // namespace

Result<std::unique_ptr<TcpPort>> TcpPort::open(const Address& address, PortOwner& owner) {
    std::unique_ptr<TcpPort> port(new TcpPort(address, owner));
    if (port->listen())
        return port;
    return Error{
        ErrorKind::kDevice,
        "tcp://" + toText(address) + ": cannot be listened on: " + port->server_.errorString().toStdString(),
        "Another box may run there; end it, or give --tcp another port (0: any free one)"};
}

TcpPort::TcpPort(const Address& address, PortOwner& owner) : where_(address), owner_(owner) {
    QObject::connect(&server_, &QTcpServer::newConnection, &server_, [this] { welcome(); });
}

TcpPort::~TcpPort() {
    closeClient();
}

bool TcpPort::listen() {
    if (!server_.listen(where_.host, where_.port))
        return false;
    where_.port = server_.serverPort();
    return true;
}

void TcpPort::welcome() {
    while (QTcpSocket* socket = server_.nextPendingConnection()) {
        QObject::connect(socket, &QTcpSocket::disconnected, socket, &QObject::deleteLater);
        if (client_ || !owner_.clientCame(*this)) {
            socket->disconnectFromHost();
            continue;
        }
        client_ = socket;
        socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
        socket->setSocketOption(QAbstractSocket::SendBufferSizeSocketOption, int{kMostUnsent_bytes});
        QObject::connect(socket, &QTcpSocket::readyRead, &server_, [this] { read(); });
        QObject::connect(socket, &QTcpSocket::bytesWritten, &server_, [this] { owner_.roomCame(*this); });
        QObject::connect(socket, &QTcpSocket::disconnected, &server_, [this] {
            client_ = nullptr;
            owner_.clientLeft(*this);
        });
        read();
    }
}

void TcpPort::read() {
    if (!client_)
        return;
    const QByteArray bytes = client_->readAll();
    if (!bytes.isEmpty())
        owner_.bytesCame(*this, {reinterpret_cast<const uint8_t*>(bytes.data()), size_t(bytes.size())});
}

size_t TcpPort::room() const {
    return client_ ? static_cast<size_t>(std::max<qint64>(0, kMostUnsent_bytes - client_->bytesToWrite()))
                   : 0;
}

void TcpPort::write(const link::Bytes& bytes) {
    if (!client_)
        return;
    client_->write(reinterpret_cast<const char*>(bytes.data()), static_cast<qint64>(bytes.size()));
    client_->flush();
}

void TcpPort::closeClient() {
    QTcpSocket* socket = std::exchange(client_, nullptr);
    if (!socket)
        return;
    QObject::disconnect(socket, nullptr, &server_, nullptr);
    socket->abort();
}

void TcpPort::setReachable(bool reachable) {
    reachable_ = reachable;
    if (!reachable)
        server_.close();
    else
        poll();
}

/// The port may be taken for a moment after it was closed.
void TcpPort::poll() {
    if (reachable_ && !server_.isListening())
        listen();
}

void TcpPort::drain() {
    if (client_ && client_->bytesToWrite() > 0)
        client_->waitForBytesWritten(kDrain_ms);
}

}  // namespace noctule::virtual_suit
