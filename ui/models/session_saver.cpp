// SPDX-License-Identifier: Apache-2.0
#include "ui/models/session_saver.h"

#include <QPointer>
#include <mutex>

namespace noctule::ui {
namespace {

constexpr int kDelay_ms = 400;

}  // namespace

/// One save at a time, the newest wins.
struct SessionSaver::Order {
    std::mutex mutex;
    uint64_t saved = 0;

    Status save(const Session& session, uint64_t version) {
        const std::lock_guard lock(mutex);
        if (version <= saved)
            return Done{};
        Status status = saveSession(session);
        if (status)
            saved = version;
        return status;
    }
};

SessionSaver::SessionSaver(Jobs& jobs, QObject* parent)
    : QObject(parent), jobs_(jobs), order_(std::make_shared<Order>()) {
    timer_.setSingleShot(true);
    timer_.setInterval(kDelay_ms);
    connect(&timer_, &QTimer::timeout, this, &SessionSaver::start);
}

void SessionSaver::schedule(const Session& session) {
    waiting_ = &session;
    ++version_;
    if (!timer_.isActive())  // the first change counts: dragging must not put it off for ever
        timer_.start();
}

void SessionSaver::start() {
    if (!waiting_)
        return;
    jobs_.start<Done>(
        tr("Saving the session"),
        [order = order_, session = *waiting_, version = version_](const JobContext&) {
            return order->save(session, version);
        },
        [saver = QPointer(this)](const Status& status) -> QString {
            if (saver)
                saver->report(status);
            return {};
        },
        Jobs::Loudness::kQuiet);
}

void SessionSaver::flush() {
    timer_.stop();
    if (waiting_)
        report(order_->save(*waiting_, version_));
}

void SessionSaver::forget() {
    timer_.stop();
    waiting_ = nullptr;
    told_ = false;
}

void SessionSaver::report(const Status& status) {
    if (!status && !std::exchange(told_, true))
        emit failed(status.error());
    else if (status && std::exchange(told_, false))
        emit savedAgain();
}

}  // namespace noctule::ui
