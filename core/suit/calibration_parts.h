// SPDX-License-Identifier: Apache-2.0
// The two lives of a calibration: values of sensors and sources belong to the parts, by their serial numbers,
// and last for months; the rest pose belongs to one wearing. And whose a calibration is.
#pragma once

#include "core/suit/calibration.h"

namespace noctule {

/// Offsets of sources and values of sensors; mountings on the body and soft tissue are left out.
Calibration withoutWearing(const Calibration& calibration);

/// Takes those values of sensors and sources that `other` found later, for parts with the same id and no
/// other serial number. False: none is newer, and `base` stays as it was.
bool takeNewerParts(Calibration& base, const Calibration& other);

/// It names a box, a board or a source; files of older programs may name none.
bool namesItsSuit(const Calibration& calibration);

enum class CalibrationOwner { kUnknown, kThisSuit, kAnotherSuit };
/// By the serial numbers of boards and sources, else by that of the box: parts that move to another box keep
/// their values, and one part that was exchanged does not make another suit. `box_serial` may be empty.
CalibrationOwner ownerOf(const Calibration& calibration, const Suit& suit, const std::string& box_serial);

}  // namespace noctule
