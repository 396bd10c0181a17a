// SPDX-License-Identifier: Apache-2.0
// noctule-virtual-suit: signals, the event loop's owner, and off.
#include <QCoreApplication>
#include <clocale>
#include <csignal>
#include <string>
#include <vector>

#include "app/virtual_suit/program.h"

namespace {

noctule::CancelFlag suit_cancel_flag;

void onSuitSignal(int) {
    suit_cancel_flag.cancel();
}

}  // namespace

int main(int argc, char** argv) {
    struct sigaction action {};
    action.sa_handler = onSuitSignal;
    action.sa_flags = SA_RESTART;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        sigaction(signal, &action, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
    QCoreApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");  // Qt takes the user's; numbers are the same everywhere
    return noctule::virtual_suit::runVirtualSuit({argv + 1, argv + argc}, suit_cancel_flag);
}
