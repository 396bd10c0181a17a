// SPDX-License-Identifier: Apache-2.0
#include "ui/models/end_signals.h"

#include <fcntl.h>
#include <unistd.h>

#include <QSocketNotifier>
#include <array>
#include <csignal>
#include <utility>

namespace noctule::ui {
namespace {

constexpr std::array kEnding{SIGTERM, SIGINT, SIGHUP};
std::array<int, 2> signal_pipe{-1, -1};

void setHandlers(void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    for (const int signal : kEnding)
        sigaction(signal, &action, nullptr);
}

/// Only what is safe in a handler. The next signal finds the system's own answer.
void onEndSignal(int) {
    const char byte = 1;
    [[maybe_unused]] const ssize_t written = write(signal_pipe[1], &byte, 1);
    setHandlers(SIG_DFL);
}

}  // namespace

EndSignals::EndSignals(QObject* parent) : QObject(parent) {
    if (pipe2(signal_pipe.data(), O_CLOEXEC | O_NONBLOCK) != 0)
        return;  // without a pipe the system's own answer stays
    notifier_ = std::make_unique<QSocketNotifier>(signal_pipe[0], QSocketNotifier::Read);
    connect(notifier_.get(), &QSocketNotifier::activated, this, [this] {
        char byte = 0;
        while (read(signal_pipe[0], &byte, 1) == 1) {
        }
        emit endWanted();
    });
    setHandlers(onEndSignal);
}

EndSignals::~EndSignals() {
    setHandlers(SIG_DFL);
    notifier_.reset();
    for (int& end : signal_pipe)
        if (const int open = std::exchange(end, -1); open >= 0)
            close(open);
}

}  // namespace noctule::ui
