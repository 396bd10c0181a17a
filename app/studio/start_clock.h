// SPDX-License-Identifier: Apache-2.0
// How long the program takes to be there, from the start of its process: one line in the logging category
// noctule.startup, which QT_LOGGING_RULES="noctule.startup=true" switches on. `packaging/acceptance.sh
// studio` reads it.
#pragma once

#include <QWidget>

namespace noctule::studio {

/// Logs once, when the first frame of the window has been painted and the event loop has come back to take
/// events. The window is shown already, and the event loop has not run since.
void logFirstFrame(QWidget& window);

/// Since the start of the process; the kernel keeps that in steps of 10 ms. Negative: unknown.
double msSinceProcessStart();

}  // namespace noctule::studio
