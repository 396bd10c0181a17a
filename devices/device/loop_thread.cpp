// SPDX-License-Identifier: Apache-2.0
#include "devices/device/loop_thread.h"

#include <QMetaObject>

#include "core/job/contract.h"

namespace noctule {

LoopThread::LoopThread(const char* name, std::function<void()> at_end) {
    thread_.setObjectName(name);
    place_.moveToThread(&thread_);
    QObject::connect(
        &thread_, &QThread::finished, &thread_, [at_end = std::move(at_end)] { at_end(); },
        Qt::DirectConnection);
    thread_.start();
}

void LoopThread::post(std::function<void()> work) {
    QMetaObject::invokeMethod(&place_, std::move(work), Qt::QueuedConnection);
}

void LoopThread::stop() {
    require(QThread::currentThread() != &thread_, "LoopThread: stopped by itself");
    thread_.quit();
    thread_.wait();
}

}  // namespace noctule
