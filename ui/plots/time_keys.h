// SPDX-License-Identifier: Apache-2.0
// The keys that move the time cursor wherever time is shown: Left and Right a frame, with Shift a second,
// Home and End to in and out.
#pragma once

#include <QKeyEvent>

#include "ui/models/time_cursor.h"

namespace noctule::ui {

/// True: it was one of them. With Ctrl they mean something else.
bool stepTime(TimeCursor& time, const QKeyEvent& event);

}  // namespace noctule::ui
