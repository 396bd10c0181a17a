// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/models/studio.h"

namespace noctule::ui {

/// Index into the session of the take that is open for review; -1 when none is or it lies outside.
int openTakeIndex(Studio& studio);
/// Name of the open take without folder and extension; empty when none is.
QString openTakeName(Studio& studio);

}  // namespace noctule::ui
