// SPDX-License-Identifier: Apache-2.0
// noctule-virtual-robot: signals, the event loop's owner, and off.
#include <QCoreApplication>
#include <clocale>

#include "app/batch/signals.h"
#include "app/virtual_robot/program.h"

int main(int argc, char** argv) {
    const noctule::CancelFlag& cancel = noctule::batch::cancelOnSignals();
    QCoreApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");  // Qt takes the user's; numbers are the same everywhere
    return noctule::virtual_robot::runVirtualRobot({argv + 1, argv + argc}, cancel);
}
