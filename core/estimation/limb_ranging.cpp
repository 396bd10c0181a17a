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

constexpr size_t kFewestReadings = 24;
constexpr int kSteps = 10;
constexpr double kUnheld_rad = 1.5;  ///< prior of the error: where no distance tells, the limb stays
constexpr double kCauchy = 3;        ///< normalised residual whose weight is a half, a quarter where late

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
    double mean_loss = 0;    ///< of a distance
    double trusted = 0;      ///< number of distances that it explains
    double mean_square = 0;  ///< normalised residuals of these
    Matrix3d information = Matrix3d::Zero();
    Vector3d slope = Vector3d::Zero();
};

void LimbRanging::turnSeen(double time_s, const Vector3d& rate_rad_per_s) {
    const bool is_gap = last_s_ && time_s - *last_s_ > parameters_.longest_s;
    if (is_gap)
        breakOff(time_s);
    else if (last_s_)
        q_first_limb_ =
            (q_first_limb_ * expQuaternion(0.5 * (time_s - *last_s_) * (rate_rad_per_s_ + rate_rad_per_s)))
                .normalized();
    if (!broken_s_)
        broken_s_ = time_s - parameters_.suspected_s;
    last_s_ = time_s;
    rate_rad_per_s_ = rate_rad_per_s;
}

void LimbRanging::breakOff(double time_s) {
    readings_.clear();
    last_s_ = broken_s_ = time_s;
}

void LimbRanging::add(const Reading& reading, double flesh_share) {
    if (!last_s_)
        return;
    if (hasBeenSilent(reading.time_s)) {
        readings_.clear();
        broken_s_ = last_s_;
        return;
    }
    const double flesh_m = flesh_share * parameters_.flesh_m;
    const Quaterniond q_first_limb =
        q_first_limb_ * expQuaternion((reading.time_s - *last_s_) * rate_rad_per_s_);
    readings_.push_back(reading);
    readings_.back().p_limb_m = q_first_limb * reading.p_limb_m;
    readings_.back().variance_m2 += parameters_.error_m * parameters_.error_m + flesh_m * flesh_m;
    const auto is_old = [&](const Reading& other) {
        return other.time_s < reading.time_s - parameters_.memory_s;
    };
    readings_.erase(readings_.begin(), std::ranges::find_if_not(readings_, is_old));
}

/// The limb's error now, by distances from then: what turns with the limb, in its frame of now.
struct LimbRanging::Problem {
    struct Term {
        double distance_m, variance_m2;
        Vector3d p_base_m;  ///< of what turns, from the source
        Vector3d p_limb_m;
    };
    const LimbRangingParameters& parameters;
    const std::vector<Held>& held;
    Matrix3d R_world_limb;
    std::vector<Term> terms;

    Fit evaluate(const Quaterniond& error) const;
    Fit fitFrom(const Quaterniond& start) const;
    /// How far apart two errors put what turns, as a share of its distance from the joint.
    double placesApart(const Quaterniond& one, const Quaterniond& other) const;
};

LimbRanging::Fit LimbRanging::Problem::evaluate(const Quaterniond& error) const {
    constexpr double kCauchy2 = kCauchy * kCauchy;
    const Matrix3d D = error.toRotationMatrix(), R = R_world_limb * D;
    Fit fit{error};
    const double share = 1 / parameters.alike;
    for (const Term& term : terms) {
        const Vector3d between = term.p_base_m + R * term.p_limb_m;
        const double expected = std::max(between.norm(), 1e-6);
        const double residual = term.distance_m - expected;
        const double square = residual * residual / term.variance_m2, excess = 1 + square / kCauchy2;
        const bool is_late = residual > 0;
        const double loss = is_late ? square / excess : kCauchy2 * std::log(excess);
        const double trust = 1 / (is_late ? excess * excess : excess);
        const Vector3d slope =
            term.p_limb_m.cross(R.transpose() * between) / expected;  // of the expected distance
        const double weight = share * trust / term.variance_m2;
        fit.cost += share * loss;
        fit.mean_loss += loss;
        fit.trusted += trust;
        fit.mean_square += trust * square;
        fit.information += weight * slope * slope.transpose();
        fit.slope += weight * residual * slope;
    }
    fit.mean_loss /= std::max<double>(1, static_cast<double>(terms.size()));
    fit.mean_square /= std::max(1.0, fit.trusted);
    const double of_held = 1 / (parameters.held_rad * parameters.held_rad);
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
LimbRanging::Fit LimbRanging::Problem::fitFrom(const Quaterniond& start) const {
    Fit best = evaluate(start);
    double damping = 0.01;
    for (int step = 0; step < kSteps; ++step) {
        Matrix3d damped = best.information;
        damped.diagonal() *= 1 + damping;
        const Vector3d turn = solveSymmetric(damped, best.slope);
        const Fit next = evaluate((best.error * expQuaternion(turn)).normalized());
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

double LimbRanging::Problem::placesApart(const Quaterniond& one, const Quaterniond& other) const {
    const Matrix3d difference = one.toRotationMatrix() - other.toRotationMatrix();
    double apart = 0, length = 1e-12;
    for (const Term& term : terms) {
        apart += (difference * term.p_limb_m).squaredNorm();
        length += term.p_limb_m.squaredNorm();
    }
    return std::sqrt(apart / length);
}

std::optional<LimbRanging::Found> LimbRanging::contradict(double time_s, const Matrix3d& R_world_limb,
                                                          const std::vector<Held>& held) const {
    if (hasBeenSilent(time_s) || readings_.size() < kFewestReadings ||
        readings_.back().time_s - readings_.front().time_s < 0.5 * parameters_.memory_s)
        return std::nullopt;
    Problem problem{parameters_, held, R_world_limb, {}};
    for (const Reading& reading : readings_)
        problem.terms.push_back({reading.distance_m, reading.variance_m2,
                                 reading.p_carried_m - reading.p_source_m,
                                 q_first_limb_.conjugate() * reading.p_limb_m});
    const Fit believed = problem.evaluate(Quaterniond::Identity());
    if (believed.mean_loss < parameters_.contradicted)
        return std::nullopt;
    static const std::vector<Quaterniond> kStarts = startingPoints();
    Fit best = believed;
    std::vector<Fit> ends;
    for (const Quaterniond& start : kStarts) {
        ends.push_back(problem.fitFrom(start));
        if (ends.back().cost < best.cost)
            best = ends.back();
    }
    const double scale = std::max(best.mean_square, 1.0);
    const double significant = scale * parameters_.lost_sigma * parameters_.lost_sigma;
    // Of attitudes that distances cannot tell apart the least turned one is kept: a single microphone does
    // not show the turn about the line to it.
    const double least_cost = best.cost;
    for (const Fit& end : ends) {
        if (end.cost - least_cost > significant)
            continue;
        if (problem.placesApart(best.error, end.error) > parameters_.lost_rad)
            return std::nullopt;  // a mirror image fits as well: the limb's movement has yet to tell
        if (logQuaternion(end.error).norm() < logQuaternion(best.error).norm())
            best = end;
    }
    if (best.mean_square > parameters_.explained || best.trusted < believed.trusted ||
        best.trusted < parameters_.explained_share * static_cast<double>(problem.terms.size()) ||
        believed.cost - best.cost < significant || logQuaternion(best.error).norm() < parameters_.lost_rad)
        return std::nullopt;
    const Eigensystem principal = eigensystemOf(best.information);
    Matrix3d axes = principal.vectors;
    if (axes.determinant() < 0)
        axes.col(0) *= -1;
    return Found{best.error, Quaterniond(axes), scale * principal.values.cwiseInverse()};
}

}  // namespace noctule
