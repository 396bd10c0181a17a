// SPDX-License-Identifier: Apache-2.0
// One magnetometer while it is turned through all directions in one place: which directions it has seen, how
// even its field is, and whether it may be calibrated from that. Readings in microtesla of the nominal scale.
#pragma once

#include <cmath>
#include <vector>

#include "core/sensor_calibration/field_sphere.h"
#include "core/sensor_calibration/magnetometer_fit.h"

namespace noctule {

struct FieldTurnLimits {
    static constexpr double kEnoughShare = 0.9;       ///< of the directions
    static constexpr double kMostUneven_percent = 4;  ///< standard deviation of the calibrated strength
    static constexpr double kIronOverOthers = 2.5;    ///< times the median of the other sensors
    static constexpr double kMostClipped = 0.05;      ///< share of the readings
    static constexpr double kFullScale_ut = 100;      ///< of the boards' magnetometers
    static constexpr double kLeastField_ut = 5;       ///< less is no field
    static constexpr double kLeastEarth_ut = 22, kMostEarth_ut = 67;  ///< of the Earth's field
    static constexpr double kGoodZero_ut = 0.5;                       ///< standard deviation of the zero
};

/// Of one magnetometer, as it was sent.
struct FieldReading {
    double sample = 0;  ///< on the suit's clock
    Vector3d counts = Vector3d::Zero();

    /// In microtesla of the nominal scale.
    Vector3d field_ut() const {
        constexpr double kMiddle = 2048;
        return (counts.array() - kMiddle) * (FieldTurnLimits::kFullScale_ut / kMiddle);
    }
};

enum class FieldTurnState {
    kGoing,
    kDone,     ///< enough directions, and its fit is usable
    kUneven,   ///< enough directions, but the strength changes with them
    kClipped,  ///< the field with the sensor's own iron is beyond its range
    kNoField,  ///< it reads nothing, or always the same
};

class FieldTurn {
public:
    /// NaN is left out. An axis at the end of the range counts as clipped.
    void add(const Vector3d& reading_ut);
    void clear() { *this = {}; }
    const std::vector<Vector3d>& readings() const { return readings_; }

    /// Fits what has come; costs about a millisecond. What follows is as of then. `strength_ut` of the field;
    /// none: as the readings have it.
    void judge(std::optional<double> strength_ut = std::nullopt);
    FieldTurnState state() const { return state_; }
    const FieldSphere& sphere() const { return sphere_; }
    const MagnetometerFit& fit() const { return fit_; }
    /// Of the calibrated field, standard deviation; none before a fit is determined.
    std::optional<double> uneven_percent() const { return uneven_percent_; }
    /// Standard error of the zero, as a share of the field.
    std::optional<double> zero_sigma_percent() const;
    /// Of the latest reading, zero removed as far as it is known.
    Vector3d direction() const;

private:
    Vector3d asCalibrated(const Vector3d& reading_ut) const;
    FieldTurnState stateNow() const;

    std::vector<Vector3d> readings_;
    size_t clipped_ = 0, missing_ = 0;
    MagnetometerFit fit_;
    bool is_fitted_ = false;  ///< else directions are seen from the middle of the readings
    Vector3d middle_ = Vector3d::Zero();
    FieldSphere sphere_;
    std::optional<double> uneven_percent_;
    FieldTurnState state_ = FieldTurnState::kGoing;
};

/// Sensors whose strength changes much more than that of the others: iron lies beside them.
/// `uneven_percent` per sensor; none: not known. One sensor alone cannot tell iron from a bent field.
std::vector<bool> carriesIron(const std::vector<std::optional<double>>& uneven_percent);

/// The field of a spot, from sensors that are carried about a little without being turned much.
struct SpotField {
    double strength_ut = 0, strength_sigma_ut = 0;
    std::optional<double> dip_deg;  ///< below the horizon
    double uneven_percent = 0;      ///< largest change that the sensors share
    int moments = 0;
    /// How much stronger it is near the floor; none: it was not looked at.
    std::optional<double> floor_percent = {};

    static constexpr double kMostUneven_percent = 5;
    bool isEven() const { return moments > 0 && uneven_percent <= kMostUneven_percent; }
    bool isBentAtFloor() const { return std::abs(floor_percent.value_or(0)) > kMostUneven_percent; }
};

/// One moment: a reading of every sensor in microtesla, and what its accelerometer says is up.
struct SpotMoment {
    std::vector<std::optional<Vector3d>> field_ut, up;
};

/// The change at a moment is the median over the sensors, so that one sensor's own iron does not count.
SpotField spotField(const std::vector<SpotMoment>& moments);
/// How much stronger the field is in the later moments: median over sensors that were not turned meanwhile,
/// in percent. None: nothing was read.
std::optional<double> strongerBy_percent(const std::vector<SpotMoment>& earlier,
                                         const std::vector<SpotMoment>& later);

}  // namespace noctule
