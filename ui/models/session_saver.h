// SPDX-License-Identifier: Apache-2.0
// Brings a session to the disk within a second after it changed, on a thread of its own job, and tells once
// when that fails. A save that was started earlier never replaces a later one.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "core/session/session.h"
#include "ui/jobs/jobs.h"

namespace noctule::ui {

class SessionSaver : public QObject {
    Q_OBJECT
public:
    explicit SessionSaver(Jobs& jobs, QObject* parent = nullptr);

    /// `session` is copied when the time has come; it must live until flush() or forget().
    void schedule(const Session& session);
    /// Saves now what is waiting; back when it is on disk, or after failed().
    void flush();
    void forget();

signals:
    void failed(const noctule::Error& error);
    /// After failed().
    void savedAgain();

private:
    struct Order;
    void start();
    void report(const Status& status);

    Jobs& jobs_;
    const Session* waiting_ = nullptr;
    QTimer timer_;
    uint64_t version_ = 0;
    std::shared_ptr<Order> order_;
    bool told_ = false;
};

}  // namespace noctule::ui
