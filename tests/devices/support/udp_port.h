// SPDX-License-Identifier: Apache-2.0
// A port for a test to listen on.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <QUdpSocket>

namespace noctule::test {

/// Free, and below those that the system gives to who asks for any (32768 and up): nothing beside this test
/// takes it before the test does.
inline uint16_t freeUdpPort() {
    constexpr int kFirst = 20000, kCount = 12000;
    for (int attempt = 0; attempt < 100; ++attempt) {
        const auto port = static_cast<uint16_t>(kFirst + (::getpid() + 97 * attempt) % kCount);
        QUdpSocket probe;
        if (probe.bind(QHostAddress::AnyIPv4, port, QAbstractSocket::DontShareAddress))
            return port;
    }
    ADD_FAILURE() << "no UDP port is free";
    return 0;
}

}  // namespace noctule::test
