// SPDX-License-Identifier: Apache-2.0
#include "app/batch/signals.h"

#include <csignal>

namespace noctule::batch {
namespace {

CancelFlag cancel_flag;

void onSignal(int) {
    cancel_flag.cancel();
}

}  // namespace

const CancelFlag& signalFlag() {
    return cancel_flag;
}

const CancelFlag& cancelOnSignals() {
    struct sigaction action {};
    action.sa_handler = onSignal;
    action.sa_flags = SA_RESTART;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        sigaction(signal, &action, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
    return cancel_flag;
}

}  // namespace noctule::batch
