// SPDX-License-Identifier: Apache-2.0
// Wires the parts: without `--batch` the studio will open here, with it a job runs without a display.
#include <QCoreApplication>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <string>
#include <vector>

#include "app/batch/help.h"
#include "app/batch/program.h"

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

int withoutBatch(const std::vector<std::string>& words) {
    const std::string first = words.empty() ? "" : words.front();
    if (first == "--help" || first == "-h") {
        std::fputs(noctule::batch::programHelp().c_str(), stdout);
        return 0;
    }
    if (first == "--version") {
        std::puts(noctule::batch::softwareName().c_str());
        return 0;
    }
    std::fputs(
        "noctule: the studio is not part of this version yet; jobs without a screen are: "
        "`noctule --batch VERB`. `noctule --help` shows the verbs.\n",
        stderr);
    return 2;
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.empty() || words.front() != "--batch")
        return withoutBatch(words);
    handleSignals();
    QCoreApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");  // Qt takes the user's; files and JSON are the same everywhere
    return noctule::batch::runBatch({words.begin() + 1, words.end()}, cancel_flag);
}
