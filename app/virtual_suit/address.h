// SPDX-License-Identifier: Apache-2.0
// Where a socket listens, as people write it.
#pragma once

#include <QHostAddress>
#include <string>

#include "core/job/result.h"

namespace noctule::virtual_suit {

struct Address {
    QHostAddress host;
    quint16 port = 0;  ///< 0: the system chooses
};

/// "127.0.0.1:41941", "localhost:0", "[::1]:41941"; `option` names the mistake.
Result<Address> parseAddress(const std::string& text, const std::string& option);

std::string toText(const Address& address);

}  // namespace noctule::virtual_suit
