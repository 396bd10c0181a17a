// SPDX-License-Identifier: Apache-2.0
#include "devices/device/serial_link.h"

#include <utility>

#include "devices/driver_box/discovery.h"

namespace noctule {

namespace {

std::string serialRemedy(QSerialPort::SerialPortError error) {
    switch (error) {
        case QSerialPort::DeviceNotFoundError:
            return "Plug the box in, or see with 'noctule --batch devices' which ports there are";
        case QSerialPort::PermissionError:
            return "Close the program that uses it, or have your account added to the group dialout";
        default:
            return "Check the cable and that the box is switched on";
    }
}

}  // namespace

void SerialLink::open() {
    close();
    port_ = new QSerialPort(QString::fromStdString(path_));
    port_->setBaudRate(link::kSerialBaud);
    if (!port_->open(QIODevice::ReadWrite))
        return ended(port_->error());
    port_->setDataTerminalReady(true);  // a pseudo-terminal has none
    port_->clearError();
    port_->clear(QSerialPort::Input);  // what came before belongs to nobody
    QObject::connect(port_, &QSerialPort::readyRead, port_, [this] { read(); });
    QObject::connect(port_, &QSerialPort::errorOccurred, port_, [this](QSerialPort::SerialPortError error) {
        if (error != QSerialPort::NoError)
            ended(error);
    });
    listener().opened();
}

void SerialLink::read() {
    const QByteArray bytes = port_->readAll();
    if (!bytes.isEmpty())
        listener().received(
            {reinterpret_cast<const uint8_t*>(bytes.constData()), static_cast<size_t>(bytes.size())});
}

/// The last bytes come before the end; hearing them may already close this link.
void SerialLink::ended(QSerialPort::SerialPortError error) {
    if (!port_)
        return;
    const std::string why = port_->errorString().toStdString();
    const QSerialPort* const before = port_;
    if (port_->isOpen())
        read();
    if (port_ != before)
        return;
    close();
    listener().closed(why, serialRemedy(error));
}

void SerialLink::write(link::ByteView bytes) {
    if (port_ && port_->isOpen())
        port_->write(reinterpret_cast<const char*>(bytes.data()), static_cast<qint64>(bytes.size()));
}

void SerialLink::close() {
    QSerialPort* const port = std::exchange(port_, nullptr);
    if (!port)
        return;
    port->disconnect();
    if (port->isOpen()) {
        port->flush();
        port->close();
    }
    port->deleteLater();
}

}  // namespace noctule
