// SPDX-License-Identifier: Apache-2.0
// The box's TCP port.
#pragma once

#include <QTcpServer>
#include <QTcpSocket>
#include <memory>

#include "app/virtual_suit/address.h"
#include "app/virtual_suit/port.h"

namespace noctule::virtual_suit {

class TcpPort : public Port {
public:
    /// kDevice when nothing can be listened on there.
    static Result<std::unique_ptr<TcpPort>> open(const Address& address, PortOwner& owner);
    ~TcpPort() override;

    const Address& where() const { return where_; }
    std::string address() const override { return "tcp://" + toText(where_); }
    size_t room() const override;
    void write(const link::Bytes& bytes) override;
    void closeClient() override;
    void setReachable(bool reachable) override;
    void drain() override;
    void poll() override;

private:
    TcpPort(const Address& address, PortOwner& owner);
    bool listen();
    void welcome();
    void read();

    Address where_;
    PortOwner& owner_;
    QTcpServer server_;
    QTcpSocket* client_ = nullptr;
    bool reachable_ = true;
};

}  // namespace noctule::virtual_suit
