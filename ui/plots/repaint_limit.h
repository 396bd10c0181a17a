// SPDX-License-Identifier: Apache-2.0
// Calls back soon after it was asked to, at most 30 times a second however often it is asked.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <functional>

namespace noctule::ui {

class RepaintLimit {
public:
    static constexpr int kInterval_ms = 33;

    explicit RepaintLimit(std::function<void()> repaint) : repaint_(std::move(repaint)) {
        timer_.setSingleShot(true);
        timer_.setTimerType(Qt::PreciseTimer);
        QObject::connect(&timer_, &QTimer::timeout, [this] {
            since_.start();
            repaint_();
        });
    }

    void ask() {
        if (timer_.isActive())
            return;
        const qint64 passed_ms = since_.isValid() ? since_.elapsed() : kInterval_ms;
        timer_.start(passed_ms >= kInterval_ms ? 0 : static_cast<int>(kInterval_ms - passed_ms));
    }

private:
    std::function<void()> repaint_;
    QTimer timer_;
    QElapsedTimer since_;
};

}  // namespace noctule::ui
