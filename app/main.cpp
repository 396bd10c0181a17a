// SPDX-License-Identifier: Apache-2.0
// Wires the parts: without `--batch` the studio opens, with it a job runs without a display.
#include <QCoreApplication>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <string>
#include <vector>

#include "app/batch/help.h"
#include "app/batch/program.h"
#include "app/studio/studio_main.h"

namespace {

noctule::CancelFlag cancel_flag;

void onSignal(int) {
    cancel_flag.cancel();
}

/// Ctrl-C and a polite kill end the job tidily; a reader that goes away is an error of writing.
void handleSignals() {
    struct sigaction action {};
    action.sa_handler = onSignal;
    action.sa_flags = SA_RESTART;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        sigaction(signal, &action, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
}

int runBatch(int argc, char** argv, const std::vector<std::string>& words) {
    handleSignals();
    QCoreApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");  // Qt takes the user's; files and JSON are the same everywhere
    return noctule::batch::runBatch({words.begin() + 1, words.end()}, cancel_flag);
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    const std::string first = words.empty() ? "" : words.front();
    if (first == "--batch")
        return runBatch(argc, argv, words);
    if (first == "--help" || first == "-h") {
        std::fputs(noctule::batch::programHelp().c_str(), stdout);
        return 0;
    }
    if (first == "--version") {
        std::puts(noctule::batch::softwareName().c_str());
        return 0;
    }
    return noctule::studio::runStudio(argc, argv);
}
