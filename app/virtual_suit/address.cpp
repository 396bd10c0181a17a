// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/address.h"

namespace noctule::virtual_suit {

Result<Address> parseAddress(const std::string& text, const std::string& option) {
    const size_t colon = text.rfind(':');
    QString host = QString::fromStdString(text.substr(0, colon));
    if (host.startsWith('[') && host.endsWith(']'))
        host = host.mid(1, host.size() - 2);
    bool is_port = false;
    const quint16 port =
        colon == std::string::npos ? 0 : QString::fromStdString(text.substr(colon + 1)).toUShort(&is_port);
    const QHostAddress address =
        host == "localhost" ? QHostAddress(QHostAddress::LocalHost) : QHostAddress(host);
    if (!is_port || address.isNull())
        return Error{ErrorKind::kUsage, option + " cannot be '" + text + "'",
                     "Give an address of this machine and a port, such as 127.0.0.1:41941; 0.0.0.0 is every "
                     "address, port 0 any free one"};
    return Address{address, port};
}

std::string toText(const Address& address) {
    const std::string host = address.host.toString().toStdString();
    const bool bracketed = address.host.protocol() == QAbstractSocket::IPv6Protocol;
    return (bracketed ? "[" + host + "]" : host) + ":" + std::to_string(address.port);
}

}  // namespace noctule::virtual_suit
