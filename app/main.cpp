// SPDX-License-Identifier: Apache-2.0
// Wires the parts: without `--batch` the studio opens, with it a job runs without a display.
#include <QCoreApplication>
#include <clocale>
#include <cstdio>
#include <string>
#include <vector>

#include "app/batch/help.h"
#include "app/batch/program.h"
#include "app/batch/signals.h"
#include "app/studio/studio_main.h"

namespace {

int runBatch(int argc, char** argv, const std::vector<std::string>& words) {
    const noctule::CancelFlag& cancel = noctule::batch::cancelOnSignals();
    QCoreApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");  // Qt takes the user's; files and JSON are the same everywhere
    return noctule::batch::runBatch({words.begin() + 1, words.end()}, cancel);
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
