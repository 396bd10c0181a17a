// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/limb_ranging.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/math/linear_solvers.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr size_t kLeastSilentReadings = 24;
constexpr int kSteps = 10;
constexpr double kUnheld_rad = 1.5;  ///< prior of the error: where no distance tells, the limb stays
constexpr double kCauchy = 3;        ///< normalised residual whose weight is a half

/// Those of a cube: no attitude is farther than 63 degrees from one.
std::vector<Quaterniond> startingPoints() {
    std::vector<Quaterniond> points;
    const std::array<Vector3d, 4> diagonals = {Vector3d(1, 1, 1), Vector3d(-1, 1, 1), Vector3d(1, -1, 1),
                                               Vector3d(1, 1, -1)};
    points.push_back(Quaterniond::Identity());
    for (int axis = 0; axis < 3; ++axis)
        for (int quarter = 1; quarter < 4; ++quarter)
            points.push_back(axisAngle(Vector3d::Unit(axis), quarter * std::numbers::pi / 2));
    for (const Vector3d& diagonal : diagonals)
        for (const double turn : {1.0, 2.0})
            points.push_back(axisAngle(diagonal.normalized(), turn * 2 * std::numbers::pi / 3));
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            const Vector3d edge = Vector3d::Unit((axis + 1) % 3) + sign * Vector3d::Unit((axis + 2) % 3);
            points.push_back(axisAngle(edge.normalized(), std::numbers::pi));
        }
    return points;
}

}  // namespace

/// About one error D of the limb's attitude; derivatives by right perturbations.
struct LimbRanging::Fit {
    Quaterniond error = Quaterniond::Identity();
    double cost = 0;         ///< of all terms
    double mean_square = 0;  ///< normalised residuals of distances, robust
    Matrix3d information = Matrix3d::Zero();
    Vector3d slope = Vector3d::Zero();
};

void LimbRanging::turnSeen(double time_s) {
    const bool is_gap = last_s_ && time_s - *last_s_ > parameters_.longest_s;
    if (is_gap)
        breakOff(time_s);
    if (!broken_s_)
        broken_s_ = time_s - parameters_.suspected_s;
    last_s_ = time_s;
}

void LimbRanging::breakOff(double time_s) {
    readings_.clear();
    last_s_ = broken_s_ = time_s;
}

void LimbRanging::add(const Reading& reading, double flesh_share) {
    readings_.push_back(reading);
    const double flesh_m = flesh_share * parameters_.flesh_m;
    readings_.back().variance_m2 += parameters_.error_m * parameters_.error_m + flesh_m * flesh_m;
    const auto is_old = [&](const Reading& other) {
        return other.time_s < reading.time_s - parameters_.memory_s;
    };
    readings_.erase(readings_.begin(), std::ranges::find_if_not(readings_, is_old));
}

LimbRanging::Fit LimbRanging::evaluate(const Quaterniond& error, const std::vector<Held>& held) const {
    const Matrix3d D = error.toRotationMatrix();
    Fit fit{error};
    const double share = 1 / parameters_.alike;
    for (const Reading& reading : readings_) {
        const Vector3d between =
            reading.p_carried_m + reading.R_world_limb * (D * reading.p_limb_m) - reading.p_source_m;
        const double expected = std::max(between.norm(), 1e-6);
        const double residual = reading.distance_m - expected;
        const double square = residual * residual / reading.variance_m2;
        const Vector3d along_limb = D.transpose() * (reading.R_world_limb.transpose() * between) / expected;
        const Vector3d slope = reading.p_limb_m.cross(along_limb);  // of the expected distance
        const double weight = share / ((1 + square / (kCauchy * kCauchy)) * reading.variance_m2);
        const double robust = kCauchy * kCauchy * std::log1p(square / (kCauchy * kCauchy));
        fit.cost += share * robust;
        fit.mean_square += robust;
        fit.information += weight * slope * slope.transpose();
        fit.slope += weight * residual * slope;
    }
    fit.mean_square /= std::max<double>(1, static_cast<double>(readings_.size()));
    const double of_held = 1 / (parameters_.held_rad * parameters_.held_rad);
    for (const Held& joint : held) {
        const Vector3d a = D.transpose() * joint.a, slope = joint.b.cross(a);
        const double residual = joint.c - a.dot(joint.b);
        fit.cost += of_held * residual * residual;
        fit.information += of_held * slope * slope.transpose();
        fit.slope += of_held * residual * slope;
    }
    constexpr double kHold = 1 / (kUnheld_rad * kUnheld_rad);
    const Vector3d turned = logQuaternion(error);
    fit.cost += kHold * turned.squaredNorm();
    fit.information += kHold * Matrix3d::Identity();
    fit.slope -= kHold * turned;
    return fit;
}

/// Levenberg and Marquardt's steps.
LimbRanging::Fit LimbRanging::fitFrom(const Quaterniond& start, const std::vector<Held>& held) const {
    Fit best = evaluate(start, held);
    double damping = 0.01;
    for (int step = 0; step < kSteps; ++step) {
        Matrix3d damped = best.information;
        damped.diagonal() *= 1 + damping;
        const Vector3d turn = solveSymmetric(damped, best.slope);
        const Fit next = evaluate((best.error * expQuaternion(turn)).normalized(), held);
        if (next.cost >= best.cost) {
            damping *= 10;
            continue;
        }
        best = next;
        damping *= 0.3;
        if (turn.norm() < 1e-3)
            break;
    }
    return best;
}

std::optional<LimbRanging::Found> LimbRanging::contradict(const std::vector<Held>& held) const {
    if (readings_.size() < kLeastSilentReadings ||
        readings_.back().time_s - readings_.front().time_s < 0.5 * parameters_.memory_s)
        return std::nullopt;
    const Fit believed = evaluate(Quaterniond::Identity(), held);
    if (believed.mean_square < parameters_.contradicted)
        return std::nullopt;
    static const std::vector<Quaterniond> kStarts = startingPoints();
    Fit best = believed;
    std::vector<Fit> ends;
    for (const Quaterniond& start : kStarts) {
        ends.push_back(fitFrom(start, held));
        if (ends.back().cost < best.cost)
            best = ends.back();
    }
    const double scale = std::max(best.mean_square, 1.0);
    const auto rivals = [&](const Fit& other) {
        return other.cost - best.cost < scale * parameters_.lost_sigma * parameters_.lost_sigma &&
               logQuaternion(best.error.conjugate() * other.error).norm() > parameters_.lost_rad;
    };
    if (std::ranges::any_of(ends, rivals))
        return std::nullopt;  // a mirror image fits as well: the limb's movement has yet to tell
    if (best.mean_square > parameters_.explained ||
        believed.cost - best.cost < scale * parameters_.lost_sigma * parameters_.lost_sigma ||
        logQuaternion(best.error).norm() < parameters_.lost_rad)
        return std::nullopt;
    const Eigensystem principal = eigensystemOf(best.information);
    Matrix3d axes = principal.vectors;
    if (axes.determinant() < 0)
        axes.col(0) *= -1;
    return Found{best.error, Quaterniond(axes), scale * principal.values.cwiseInverse()};
}

}  // namespace noctule
