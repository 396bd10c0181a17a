// SPDX-License-Identifier: Apache-2.0
// What happened during a take, a line each, with times of the take: notes of the operator and of the driver
// box, and boards that fell silent.
#pragma once

#include <QStringList>

#include "core/review/take_review.h"

namespace noctule::ui {

/// "0:07.8 right hand (board 15) fell silent; back at 0:13.0". In order of time; what carries none is last.
QStringList takeNoteLines(const TakeOverview& take);

}  // namespace noctule::ui
