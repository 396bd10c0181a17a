// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/control_port.h"

#include <QTcpSocket>

namespace noctule::virtual_suit {

Result<std::unique_ptr<ControlPort>> ControlPort::open(const Address& address, Obey obey) {
    std::unique_ptr<ControlPort> port(new ControlPort(std::move(obey)));
    if (!port->server_.listen(address.host, address.port))
        return Error{ErrorKind::kDevice,
                     toText(address) +
                         ": cannot be listened on for control: " + port->server_.errorString().toStdString(),
                     "Give --control another port (0: any free one)"};
    port->where_ = {address.host, port->server_.serverPort()};
    return port;
}

ControlPort::ControlPort(Obey obey) : obey_(std::move(obey)) {
    QObject::connect(&server_, &QTcpServer::newConnection, &server_, [this] { welcome(); });
}

void ControlPort::welcome() {
    while (QTcpSocket* client = server_.nextPendingConnection()) {
        QObject::connect(client, &QTcpSocket::disconnected, client, &QObject::deleteLater);
        QObject::connect(client, &QTcpSocket::readyRead, client, [this, client] { read(*client); });
        read(*client);
    }
}

void ControlPort::read(QTcpSocket& client) {
    while (client.canReadLine()) {
        const Status done = obey_(client.readLine().trimmed().toStdString());
        client.write(done ? "ok\n" : ("error " + done.error().text() + "\n").c_str());
        client.flush();
    }
    if (client.bytesAvailable() > kLongestLine) {
        client.write("error a line that is too long. Write one command a line\n");
        client.disconnectFromHost();
    }
}

}  // namespace noctule::virtual_suit
