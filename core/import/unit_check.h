// SPDX-License-Identifier: Apache-2.0
// Finds readings in other units than SI by what they show, converts them and says so. Nothing is converted
// silently.
#pragma once

#include "core/import/recording.h"

namespace noctule {

/// What a gyroscope's numbers are, told by gravity: between two instants at which the sensor hardly
/// accelerates, its turn must take gravity's direction at the first to that at the second.
enum class RateReading { kUnknown, kRadians, kDegrees, kMirrored, kConvertedTwice };
/// kUnknown when the sensor turned by 20 degrees between quiet instants less than three times, or nothing
/// fits. kMirrored: axes of another handedness than the accelerometer's. kConvertedTwice: rad/s that were
/// taken for deg/s. Accelerations in m/s^2.
RateReading rateReading(const ImuSamples& samples);

/// Accelerations whose median is near 1 are g, near 981 cm/s^2; rates by rateReading; fields as strong as the
/// Earth's in tesla or nanotesla become microtesla. Converts and adds one warning for each sensor and
/// quantity; a field of zeros and readings that fit no unit are warned of.
void convertToSi(ImportedRecording& recording);

/// What looks odd in readings of SI, as warnings: missing and impossible readings (which become missing),
/// readings that stand still, sensors of different lengths.
void checkReadings(ImportedRecording& recording);
/// Whether any sensor has one rate, acceleration, field or attitude, or the file its own result.
bool holdsReadings(const ImportedRecording& recording);

}  // namespace noctule
