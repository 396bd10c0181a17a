// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/time_keys.h"

namespace noctule::ui {

bool stepTime(TimeCursor& time, const QKeyEvent& event) {
    if (event.modifiers() & Qt::ControlModifier)
        return false;
    const bool seconds = event.modifiers() & Qt::ShiftModifier;
    switch (event.key()) {
        case Qt::Key_Left:
            seconds ? time.stepSeconds(-1) : time.stepFrames(-1);
            return true;
        case Qt::Key_Right:
            seconds ? time.stepSeconds(1) : time.stepFrames(1);
            return true;
        case Qt::Key_Home:
            time.setTime(time.in());
            return true;
        case Qt::Key_End:
            time.setTime(time.out());
            return true;
        default:
            return false;
    }
}

}  // namespace noctule::ui
