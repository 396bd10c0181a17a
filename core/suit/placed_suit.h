// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/suit/calibration.h"

namespace noctule {

/// The suit with boards and sources where the calibration has found them; others stay as described. Where an
/// anchor of the room has been turned, the source in its housing faces elsewhere too.
Suit placedSuit(Suit suit, const Calibration& calibration);

}  // namespace noctule
