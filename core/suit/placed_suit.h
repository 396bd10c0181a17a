// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/suit/calibration.h"

namespace noctule {

/// The suit with boards and sources where the calibration has found them; others stay as described.
Suit placedSuit(Suit suit, const Calibration& calibration);

}  // namespace noctule
