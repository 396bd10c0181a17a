// SPDX-License-Identifier: Apache-2.0
// Finds readings in other units than SI by what they show, converts them and says so. Nothing is converted
// silently.
#pragma once

#include "core/import/recording.h"

namespace noctule {

/// How fast gravity turns in the sensor's frame over how fast the gyroscope says it does, in slow movement: 1
/// in rad/s, 0.017 in deg/s. Not finite when the sensor hardly moves.
double gyroscopeSlope(const ImuSamples& samples);

/// Accelerations whose median is near 1 are g, near 981 cm/s^2; rates by gyroscopeSlope. Converts to SI and
/// adds one warning for each sensor and quantity; a field of zeros and readings that fit no unit are warned
/// of.
void convertToSi(ImportedRecording& recording);

}  // namespace noctule
