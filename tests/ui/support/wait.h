// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTest>
#include <functional>

namespace noctule::ui {

/// Runs the event loop until `done`. The limit of four minutes only ends waits for what never comes.
inline bool waitFor(const std::function<bool()>& done) {
    return QTest::qWaitFor(done, 240'000);
}

}  // namespace noctule::ui
