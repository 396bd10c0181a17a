// SPDX-License-Identifier: Apache-2.0
// Lines in, `ok` or `error ...` out, for anyone who connects. For whoever plays accidents; no studio uses it.
#pragma once

#include <QTcpServer>
#include <functional>
#include <memory>

#include "app/virtual_suit/address.h"

namespace noctule::virtual_suit {

class ControlPort {
public:
    /// Does what a line says.
    using Obey = std::function<Status(const std::string& line)>;

    /// kDevice when nothing can be listened on there.
    static Result<std::unique_ptr<ControlPort>> open(const Address& address, Obey obey);
    const Address& where() const { return where_; }

private:
    static constexpr int kLongestLine = 1000;

    explicit ControlPort(Obey obey);
    void welcome();
    void read(QTcpSocket& client);

    Obey obey_;
    Address where_;
    QTcpServer server_;
};

}  // namespace noctule::virtual_suit
