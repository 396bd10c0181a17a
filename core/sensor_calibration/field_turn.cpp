// SPDX-License-Identifier: Apache-2.0
#include "core/sensor_calibration/field_turn.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/math/order_statistics.h"

namespace noctule {
namespace {

constexpr size_t kFewestReadings = 20;
constexpr double kClip_ut = FieldTurnLimits::kFullScale_ut * 2046 / 2048;

bool isField(const std::optional<Vector3d>& field) {
    return field && field->allFinite() && field->norm() > FieldTurnLimits::kLeastField_ut;
}

/// Median length of one sensor's readings; 0 without any.
double usualLength(const std::vector<SpotMoment>& moments, size_t sensor) {
    std::vector<double> lengths;
    for (const SpotMoment& moment : moments)
        if (isField(moment.field_ut[sensor]))
            lengths.push_back(moment.field_ut[sensor]->norm());
    return middleValue(lengths);
}

double dipOf_deg(const Vector3d& field, const Vector3d& up) {
    return degrees(std::asin(std::clamp(-field.normalized().dot(up.normalized()), -1.0, 1.0)));
}

}  // namespace

void FieldTurn::add(const Vector3d& reading_ut) {
    if (!reading_ut.allFinite())
        ++missing_;
    else if (reading_ut.cwiseAbs().maxCoeff() >= kClip_ut)
        ++clipped_;
    else
        readings_.push_back(reading_ut);
}

Vector3d FieldTurn::asCalibrated(const Vector3d& reading_ut) const {
    return is_fitted_ ? Vector3d(fit_.ellipsoid.matrix * (reading_ut - fit_.ellipsoid.zero))
                      : Vector3d(reading_ut - middle_);
}

Vector3d FieldTurn::direction() const {
    return readings_.empty() ? Vector3d::Zero() : asCalibrated(readings_.back());
}

std::optional<double> FieldTurn::zero_sigma_percent() const {
    if (!is_fitted_ || !(fit_.strength_ut > 0))
        return std::nullopt;
    return 100 * (fit_.ellipsoid.matrix * fit_.ellipsoid.sigma_zero).norm() / fit_.strength_ut;
}

void FieldTurn::judge(std::optional<double> strength_ut) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& reading : readings_)
        box.extend(reading);
    middle_ = readings_.empty() ? Vector3d(Vector3d::Zero()) : Vector3d(box.center());
    fit_ = fitMagnetometer(readings_, strength_ut);
    // A fit from a part of the sphere may lie far off; the middle of the box is safer until it is determined.
    constexpr double kMostZeroSigma = 0.03, kMostCondition = 1e4;
    is_fitted_ = fit_.strength_ut > FieldTurnLimits::kLeastField_ut && fit_.ellipsoid.converged &&
                 fit_.ellipsoid.condition < kMostCondition &&
                 (fit_.ellipsoid.matrix * fit_.ellipsoid.sigma_zero).cwiseAbs().maxCoeff() <
                     kMostZeroSigma * fit_.strength_ut;
    sphere_ = {};
    for (const Vector3d& reading : readings_)
        if (const Vector3d field = asCalibrated(reading); field.norm() > FieldTurnLimits::kLeastField_ut)
            sphere_.add(field);
    uneven_percent_.reset();
    if (is_fitted_)
        uneven_percent_ = fit_.after_percent;
    state_ = stateNow();
}

FieldTurnState FieldTurn::stateNow() const {
    using Limits = FieldTurnLimits;
    const size_t all = readings_.size() + clipped_;
    if (all < kFewestReadings)
        return FieldTurnState::kGoing;
    if (static_cast<double>(clipped_) > Limits::kMostClipped * static_cast<double>(all))
        return FieldTurnState::kClipped;
    std::vector<double> lengths;
    for (const Vector3d& reading : readings_)
        lengths.push_back(reading.norm());
    if (middleValue(lengths) < Limits::kLeastField_ut)
        return FieldTurnState::kNoField;
    if (sphere_.share() < Limits::kEnoughShare || !is_fitted_)
        return FieldTurnState::kGoing;
    return fit_.problem.empty() && *uneven_percent_ <= Limits::kMostUneven_percent ? FieldTurnState::kDone
                                                                                   : FieldTurnState::kUneven;
}

std::vector<bool> carriesIron(const std::vector<std::optional<double>>& uneven_percent) {
    std::vector<bool> iron(uneven_percent.size());
    for (size_t sensor = 0; sensor < uneven_percent.size(); ++sensor) {
        if (!uneven_percent[sensor])
            continue;
        std::vector<double> others;
        for (size_t other = 0; other < uneven_percent.size(); ++other)
            if (other != sensor && uneven_percent[other])
                others.push_back(*uneven_percent[other]);
        iron[sensor] = !others.empty() && *uneven_percent[sensor] > FieldTurnLimits::kMostUneven_percent &&
                       *uneven_percent[sensor] > FieldTurnLimits::kIronOverOthers * middleValue(others);
    }
    return iron;
}

SpotField spotField(const std::vector<SpotMoment>& moments) {
    SpotField spot;
    const size_t sensors = moments.empty() ? 0 : moments.front().field_ut.size();
    std::vector<double> usual(sensors), dips;
    for (size_t sensor = 0; sensor < sensors; ++sensor) {
        usual[sensor] = usualLength(moments, sensor);
        for (const SpotMoment& moment : moments) {
            const std::optional<Vector3d>&field = moment.field_ut[sensor], &up = moment.up[sensor];
            if (isField(field) && up && up->allFinite() && !up->isZero())
                dips.push_back(dipOf_deg(*field, *up));
        }
    }
    std::vector<double> strengths;
    std::ranges::copy_if(usual, std::back_inserter(strengths), [](double length) { return length > 0; });
    spot.strength_ut = middleValue(strengths);
    if (!dips.empty())
        spot.dip_deg = middleValue(dips);
    double squares = 0;
    for (const SpotMoment& moment : moments) {
        std::vector<double> changes;
        for (size_t sensor = 0; sensor < sensors; ++sensor)
            if (usual[sensor] > 0 && moment.field_ut[sensor] && moment.field_ut[sensor]->allFinite())
                changes.push_back(moment.field_ut[sensor]->norm() / usual[sensor] - 1);
        if (changes.empty())
            continue;
        const double change = middleValue(changes);
        ++spot.moments;
        squares += change * change;
        spot.uneven_percent = std::max(spot.uneven_percent, 100 * std::abs(change));
    }
    if (spot.moments > 0)
        spot.strength_sigma_ut = spot.strength_ut * std::sqrt(squares / spot.moments);
    return spot;
}

std::optional<double> strongerBy_percent(const std::vector<SpotMoment>& earlier,
                                         const std::vector<SpotMoment>& later) {
    std::vector<double> changes;
    for (size_t sensor = 0; !earlier.empty() && !later.empty() && sensor < earlier.front().field_ut.size();
         ++sensor) {
        const double before = usualLength(earlier, sensor), after = usualLength(later, sensor);
        if (before > 0 && after > 0)
            changes.push_back(100 * (after / before - 1));
    }
    return changes.empty() ? std::nullopt : std::optional(middleValue(changes));
}

}  // namespace noctule
