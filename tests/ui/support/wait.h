// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTest>
#include <functional>

namespace noctule::ui {

/// Lets the event loop run until `done`, on a busy machine for half a minute at most; whether it came to
/// that.
inline bool waitFor(const std::function<bool()>& done) {
    return QTest::qWaitFor(done, 30'000);
}

}  // namespace noctule::ui
