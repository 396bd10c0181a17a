// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/models/review_context.h"

namespace noctule::ui {

/// Index into the session of the take that is open for review; -1 when none is or it lies outside.
int openTakeIndex(ReviewContext& review);
/// Name of the open take without folder and extension; empty when none is.
QString openTakeName(ReviewContext& review);

}  // namespace noctule::ui
