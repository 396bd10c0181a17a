// SPDX-License-Identifier: Apache-2.0
// A thread with Qt's event loop, so that sockets and timers can live on it. What is posted, from any thread,
// runs there in order; what still waits when it stops is dropped.
#pragma once

#include <QObject>
#include <QThread>
#include <functional>

namespace noctule {

class LoopThread {
public:
    /// Starts at once. `at_end` runs on the thread, last of all: what lives there has to be destroyed there.
    LoopThread(const char* name, std::function<void()> at_end);
    ~LoopThread() { stop(); }

    void post(std::function<void()> work);
    /// Returns when the thread has ended. Not to be called on it.
    void stop();

private:
    QThread thread_;
    QObject place_;  ///< lives on the thread
};

}  // namespace noctule
