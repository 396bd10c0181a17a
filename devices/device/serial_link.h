// SPDX-License-Identifier: Apache-2.0
// A box at the other end of a serial line: USB, or a pseudo-terminal, which QSerialPort takes as well. 8N1,
// raw, DTR on, 3 000 000 baud (README.md of the link, section 5); USB and pseudo-terminals ignore the rate.
#pragma once

#include <QSerialPort>

#include "devices/device/byte_link.h"

namespace noctule {

class SerialLink : public ByteLink {
public:
    /// A path: "/dev/ttyACM0".
    explicit SerialLink(std::string path) : path_(std::move(path)) {}
    ~SerialLink() override { close(); }

    void open() override;
    void write(link::ByteView bytes) override;
    void close() override;

private:
    void read();
    void ended(QSerialPort::SerialPortError error);

    std::string path_;
    QSerialPort* port_ = nullptr;  ///< as TcpLink's socket
};

}  // namespace noctule
