// SPDX-License-Identifier: Apache-2.0
// What turning magnetometers through all directions found, board by board, for people and for machines.
#pragma once

#include <nlohmann/json.hpp>

#include "core/report/calibration_document.h"
#include "core/sensor_calibration/field_sphere.h"
#include "core/sensor_calibration/magnetometer_fit.h"

namespace noctule {

struct TurnedMagnetometer {
    std::string board;  ///< id
    MagnetometerFit fit;
    double sigma_zero_ut = 0;
    FieldSphere seen;
    /// In each direction seen, how far the field's strength is off its mean, in percent: as the board was
    /// calibrated before, and as it is now.
    std::vector<double> before_percent, after_percent;
    /// The same measure as fit.after_percent, with the calibration before.
    double spread_before_percent = 0;
    bool used = false;
    bool in_microtesla = true;  ///< else in a unit that nobody has stated
};

struct MagnetometerReport {
    std::vector<TurnedMagnetometer> boards;
    std::vector<Finding> findings;
};

/// Without date and takes.
CalibrationDocument documentOf(const MagnetometerReport& report);
/// Members of this procedure alone; `sphere`: of each of the 100 directions, the readings of the board that
/// has fewest.
nlohmann::json toJson(const MagnetometerReport& report);

}  // namespace noctule
