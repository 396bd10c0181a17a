// SPDX-License-Identifier: Apache-2.0
#include "core/sensor_calibration/magnetometer_fit.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/math/linear_solvers.h"
#include "core/math/order_statistics.h"

namespace noctule {

namespace {

constexpr size_t kFewestPoints = 60;
constexpr int kFewestDirections = 18;  ///< of 26
constexpr double kMostCondition = 1e4;
constexpr double kMostZeroSigma = 0.03;  ///< of the field's strength
constexpr double kMostSoftIron = 3;      ///< longest over shortest axis
constexpr double kMostResidual = 0.1;    ///< of the strength
constexpr double kCell = 0.12;           ///< of the spread: readings in one cell count once

/// Means of the readings in cells, so that a sensor that lay still counts no more than one that turned.
std::vector<Vector3d> evenPoints(const std::vector<Vector3d>& readings) {
    std::vector<Vector3d> good;
    for (const Vector3d& reading : readings)
        if (reading.allFinite() && !reading.isZero())
            good.push_back(reading);
    if (good.size() < kFewestPoints)
        return {};
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& reading : good)
        middle += reading / double(good.size());
    std::vector<double> distances;
    for (const Vector3d& reading : good)
        distances.push_back((reading - middle).norm());
    const double cell = kCell * middleValue(distances);
    if (!(cell > 0))
        return {};
    std::map<std::array<long, 3>, std::pair<Vector3d, int>> cells;
    for (const Vector3d& reading : good) {
        const Vector3d at = ((reading - middle) / cell).array().floor();
        if (!(at.cwiseAbs().maxCoeff() < 1e6))
            continue;
        auto& [sum, count] =
            cells.try_emplace({long(at.x()), long(at.y()), long(at.z())}, Vector3d::Zero(), 0).first->second;
        sum += reading;
        ++count;
    }
    std::vector<Vector3d> points;
    for (const auto& [at, entry] : cells)
        points.push_back(entry.first / entry.second);
    return points;
}

double spreadPercent(const std::vector<Vector3d>& points, const Vector3d& zero, const Matrix3d& matrix) {
    double sum = 0, squares = 0;
    for (const Vector3d& point : points) {
        const double length = (matrix * (point - zero)).norm();
        sum += length;
        squares += length * length;
    }
    const double mean = sum / double(points.size());
    return 100 * std::sqrt(std::max(squares / double(points.size()) - mean * mean, 0.0)) / mean;
}

std::string wordsOf(const std::vector<std::string>& names, size_t most) {
    std::string list;
    for (size_t i = 0; i < std::min(names.size(), most); ++i)
        list += (list.empty() ? "" : ", ") + names[i];
    return list + (names.size() > most ? " and " + std::to_string(names.size() - most) + " more" : "");
}

bool isDetermined(const MagnetometerFit& fit) {
    const EllipsoidFit& e = fit.ellipsoid;
    return e.converged && e.condition < kMostCondition &&
           (e.matrix * e.sigma_zero).cwiseAbs().maxCoeff() < kMostZeroSigma * fit.strength_ut;
}

/// From the middle of the readings' box: what a fit that is not determined says of directions means nothing.
DirectionCoverage coverageAsRead(const std::vector<Vector3d>& points) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& point : points)
        box.extend(point);
    std::vector<Vector3d> directions;
    for (const Vector3d& point : points)
        directions.push_back(point - box.center());
    return coverageOf(directions);
}

void judge(MagnetometerFit& fit) {
    const EllipsoidFit& e = fit.ellipsoid;
    const Vector3d axes = eigenvaluesOf(e.matrix);
    const std::string turn =
        "Turn the board until its field has pointed along " + wordsOf(fit.coverage.missing, 8);
    if (fit.coverage.covered < kFewestDirections) {
        fit.problem = "the field was seen along " + std::to_string(fit.coverage.covered) + " of " +
                      std::to_string(DirectionCoverage::kDirections) + " main directions, " +
                      std::to_string(kFewestDirections) + " are needed";
        fit.remedy = turn;
    } else if (!isDetermined(fit)) {
        fit.problem = "the turns do not determine the fit";
        fit.remedy =
            fit.coverage.missing.empty() ? "Turn the board about all its axes, slowly, in one place" : turn;
    } else if (!(axes[0] > 0) || axes[2] > kMostSoftIron * axes[0]) {
        fit.problem = "the readings lie on no ellipsoid that soft iron makes";
        fit.remedy = "Stay in one place, away from iron, and turn the board again";
    } else if (e.residual > kMostResidual * fit.strength_ut) {
        fit.problem = "the field changed while the board was turned";
        fit.remedy = "Stay in one place, away from iron, magnets and cables, and turn the board again";
    }
}

}  // namespace

MagnetometerFit fitMagnetometer(const std::vector<Vector3d>& readings, std::optional<double> strength_ut) {
    MagnetometerFit fit;
    const std::vector<Vector3d> points = evenPoints(readings);
    if (points.size() < kFewestPoints) {
        fit.coverage = coverageOf(points);
        fit.problem =
            "the field was read in " + std::to_string(points.size()) + " different directions or fewer";
        fit.remedy = "Record a minute in which the board is turned through all directions";
        return fit;
    }
    fit.ellipsoid = fitEllipsoid(points, 1, EllipsoidForm::kSymmetric);
    Matrix3d& matrix = fit.ellipsoid.matrix;
    const double mean_scale = std::cbrt(std::abs(matrix.determinant()));
    fit.strength_ut = strength_ut.value_or(1 / mean_scale);
    matrix *= fit.strength_ut;
    fit.ellipsoid.residual *= fit.strength_ut;
    std::vector<Vector3d> calibrated;
    for (const Vector3d& point : points)
        calibrated.push_back(matrix * (point - fit.ellipsoid.zero));
    fit.coverage = isDetermined(fit) ? coverageOf(calibrated) : coverageAsRead(points);
    fit.before_percent = spreadPercent(points, Vector3d::Zero(), Matrix3d::Identity());
    fit.after_percent = spreadPercent(points, fit.ellipsoid.zero, matrix);
    judge(fit);
    return fit;
}

double fieldSpread_percent(const std::vector<Vector3d>& readings, const Vector3d& zero,
                           const Matrix3d& matrix) {
    const std::vector<Vector3d> points = evenPoints(readings);
    return points.empty() ? 0 : spreadPercent(points, zero, matrix);
}

namespace {

constexpr double kBlock_s = 0.5;
constexpr double kBentStrength = 0.07, kBentDip_deg = 5;
constexpr double kQuietAccel = 0.05, kQuietRate_rad_per_s = 0.5;
constexpr size_t kMostStretches = 1000;

struct FieldBlock {
    double strength = 0, dip_deg = std::nan("");
    bool read = false;
};

FieldBlock fieldBlock(const ImuSamples& samples, size_t begin, size_t end) {
    FieldBlock block;
    std::vector<double> strengths;
    Vector3d field = Vector3d::Zero(), force = Vector3d::Zero();
    bool quiet = true;
    for (size_t i = begin; i < end; ++i) {
        if (!samples.hasMag(i))
            continue;
        strengths.push_back(samples.mag[i].norm());
        field += samples.mag[i];
        const Vector3d& a = samples.accel_m_per_s2[i];
        force += a;
        quiet = quiet && std::abs(a.norm() / kStandardGravity_m_per_s2 - 1) < kQuietAccel &&
                samples.gyro_rad_per_s[i].norm() < kQuietRate_rad_per_s;
    }
    block.read = !strengths.empty();
    block.strength = middleValue(strengths);
    if (quiet && block.read && force.allFinite())
        block.dip_deg =
            degrees(std::asin(std::clamp(-field.normalized().dot(force.normalized()), -1.0, 1.0)));
    return block;
}

}  // namespace

FieldCheck checkField(const ImuSamples& samples) {
    FieldCheck check;
    const auto size = std::max<size_t>(1, size_t(kBlock_s * samples.rate_hz));
    std::vector<FieldBlock> blocks;
    std::vector<double> strengths, dips;
    for (size_t begin = 0; begin < samples.size(); begin += size) {
        blocks.push_back(fieldBlock(samples, begin, std::min(begin + size, samples.size())));
        if (blocks.back().read)
            strengths.push_back(blocks.back().strength);
        if (std::isfinite(blocks.back().dip_deg))
            dips.push_back(blocks.back().dip_deg);
    }
    check.strength = middleValue(strengths);
    check.has_dip = !dips.empty();
    check.dip_deg = middleValue(dips);
    size_t bent = 0;
    bool going_on = false;
    for (size_t b = 0; b < blocks.size(); ++b) {
        const double off = blocks[b].read ? blocks[b].strength / check.strength - 1 : 0;
        const double dip = std::isfinite(blocks[b].dip_deg) ? blocks[b].dip_deg - check.dip_deg : 0;
        const bool is_bent = std::abs(off) > kBentStrength || std::abs(dip) > kBentDip_deg;
        bent += is_bent;
        if (is_bent && !going_on && check.stretches.size() < kMostStretches)
            check.stretches.push_back({double(b * size) / samples.rate_hz, 0, 0, 0});
        if (is_bent && !check.stretches.empty()) {
            BentField& stretch = check.stretches.back();
            stretch.to_s = double(std::min((b + 1) * size, samples.size())) / samples.rate_hz;
            if (std::abs(100 * off) > std::abs(stretch.strength_off_percent))
                stretch.strength_off_percent = 100 * off;
            if (std::abs(dip) > std::abs(stretch.dip_off_deg))
                stretch.dip_off_deg = dip;
        }
        going_on = is_bent;
    }
    check.bent_percent = strengths.empty() ? 0 : 100 * double(bent) / double(strengths.size());
    return check;
}

}  // namespace noctule
