// SPDX-License-Identifier: Apache-2.0
#include "core/cooperative/point_fit.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/math/linear_solvers.h"

namespace noctule::cooperative {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr int kFitSteps = 12;
constexpr double kCauchyWidth = 3;     ///< normalised residual whose weight is a half
constexpr double kSamePlace_m = 0.05;  ///< fits nearer than this are one
constexpr double kAround_m = 0.5;      ///< of starting points about the prior
constexpr size_t kLeastRanges = 8;
constexpr int kLeastEnds = 5;          ///< known places that ranges come from, twice each
constexpr double kUnlikely = 18;       ///< cost beyond that of the best fit at which a fit is left out
constexpr double kRivalWeight = 0.01;  ///< of all fits

struct Fit {
    Vector6 x;  ///< place, velocity
    double cost = 0, mean_square = 0;
    Matrix6 information = Matrix6::Zero();
    Vector6 slope = Vector6::Zero();
};

class PlaceSearch {
public:
    PlaceSearch(const std::deque<LostRange>& ranges, double time_s, const PointBelief& prior,
                const PointBounds& bounds, const LostPointSettings& settings)
        : ranges_(ranges),
          time_s_(time_s),
          bounds_(bounds),
          reach_m_(settings.reach_m),
          detour_m2_(settings.detour_m * settings.detour_m) {
        for (const LostRange& range : ranges)
            ++count_of_end_[range.known];
        prior_mean_ << prior.p_m, prior.v_m_per_s;
        prior_information_ = inverseOf(prior.covariance);
    }

    /// The different ones, best first.
    std::vector<Fit> minima() const {
        std::vector<Fit> all;
        for (const Vector3d& start : starts())
            all.push_back(fitFrom(start));
        std::ranges::sort(all, {}, &Fit::cost);
        std::vector<Fit> different;
        for (const Fit& fit : all)
            if (fit.cost - all.front().cost < kUnlikely &&
                std::ranges::none_of(different, [&](const Fit& other) {
                    return (other.x - fit.x).head<3>().norm() < kSamePlace_m;
                }))
                different.push_back(fit);
        return different;
    }

private:
    Fit evaluate(const Vector6& x) const {
        Fit fit{x};
        for (const LostRange& range : ranges_) {
            const double dt_s = range.time_s - time_s_;
            const Vector3d between = x.head<3>() + dt_s * x.tail<3>() - range.known_m;
            const double expected_m = std::max(between.norm(), 1e-6);
            const double residual = range.distance_m - expected_m;
            const double variance_m2 = range.variance_m2 + detour_m2_,
                         share = 1.0 / count_of_end_.at(range.known);
            const double square = residual * residual / variance_m2;
            Vector6 row;
            row << between / expected_m, dt_s * between / expected_m;
            const double relative = square / (kCauchyWidth * kCauchyWidth);
            const double robust = kCauchyWidth * kCauchyWidth * std::log1p(relative);
            const double weight = share / ((1 + relative) * variance_m2);
            fit.cost += share * robust;
            fit.mean_square += robust / static_cast<double>(ranges_.size());
            fit.information += weight * row * row.transpose();
            fit.slope += weight * residual * row;
        }
        addReach(fit);
        const Vector6 off = prior_mean_ - x;
        fit.cost += off.dot(prior_information_ * off);
        fit.information += prior_information_;
        fit.slope += prior_information_ * off;
        return fit;
    }

    /// Nothing within the bones' reach, squares beyond.
    void addReach(Fit& fit) const {
        const double weight = 1 / (reach_m_ * reach_m_);
        if (const double below_m = bounds_.lowest_m - fit.x[1]; below_m > 0) {
            fit.cost += weight * below_m * below_m;
            fit.information(1, 1) += weight;
            fit.slope[1] += weight * below_m;
        }
        for (const PointOfBody& other : bounds_.body) {
            const Vector3d between = fit.x.head<3>() - other.p_m;
            const double apart_m = std::max(between.norm(), 1e-6);
            const double residual = std::clamp(apart_m, other.reach.least_m, other.reach.most_m) - apart_m;
            if (residual == 0)
                continue;
            const Vector3d row = between / apart_m;
            fit.cost += weight * residual * residual;
            fit.information.topLeftCorner<3, 3>() += weight * row * row.transpose();
            fit.slope.head<3>() += weight * residual * row;
        }
    }

    /// Levenberg and Marquardt's steps.
    Fit fitFrom(const Vector3d& start) const {
        Vector6 x = prior_mean_;
        x.head<3>() = start;
        Fit best = evaluate(x);
        double damping = 0.01;
        for (int step = 0; step < kFitSteps; ++step) {
            Matrix6 damped = best.information;
            damped.diagonal() *= 1 + damping;
            const Vector6 change = solveSymmetric(damped, best.slope);
            Fit next = evaluate(best.x + change);
            if (next.cost >= best.cost) {
                damping *= 10;
                continue;
            }
            best = std::move(next);
            damping *= 0.3;
            if (change.head<3>().norm() < 1e-4)
                break;
        }
        return best;
    }

    /// The prior's place, some around it, and the mirror images of all in the plane of the known places.
    std::vector<Vector3d> starts() const {
        Vector3d middle = Vector3d::Zero();
        for (const LostRange& range : ranges_)
            middle += range.known_m / static_cast<double>(ranges_.size());
        Matrix3d spread = Matrix3d::Zero();
        for (const LostRange& range : ranges_)
            spread += (range.known_m - middle) * (range.known_m - middle).transpose();
        const Vector3d normal = eigensystemOf(spread).vectors.col(0);
        std::vector<Vector3d> starts{prior_mean_.head<3>()};
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {1.0, -1.0})
                starts.push_back(starts.front() + sign * kAround_m * Vector3d::Unit(axis));
        for (size_t i = 0, count = starts.size(); i < count; ++i)
            starts.push_back(starts[i] - 2 * normal.dot(starts[i] - middle) * normal);
        return starts;
    }

    const std::deque<LostRange>& ranges_;
    double time_s_;
    const PointBounds& bounds_;
    double reach_m_, detour_m2_;
    std::map<int, int> count_of_end_;
    Vector6 prior_mean_;
    Matrix6 prior_information_;
};

}  // namespace

PointFit fitPoint(const std::deque<LostRange>& ranges, double time_s, const PointBelief& prior,
                  const PointBounds& bounds, const LostPointSettings& settings) {
    const std::vector<Fit> minima = PlaceSearch(ranges, time_s, prior, bounds, settings).minima();
    const Fit& best = minima.front();
    std::vector<double> weights;
    double sum = 0;
    for (const Fit& fit : minima)
        sum += weights.emplace_back(std::exp(-0.5 * (fit.cost - best.cost)));
    Vector6 mean = Vector6::Zero();
    for (size_t k = 0; k < minima.size(); ++k)
        mean += weights[k] / sum * minima[k].x;
    const double scale = std::max(1.0, best.mean_square);
    Matrix6 covariance = Matrix6::Zero();
    for (size_t k = 0; k < minima.size(); ++k)
        covariance += weights[k] / sum *
                      (scale * inverseOf(minima[k].information) +
                       (minima[k].x - mean) * (minima[k].x - mean).transpose());
    PointFit found{{mean.head<3>(), mean.tail<3>(), covariance}, false};
    std::map<int, int> heard;
    for (const LostRange& range : ranges)
        ++heard[range.known];
    const auto ends = std::ranges::count_if(heard, [](const auto& end) { return end.second > 1; });
    found.is_certain =
        ranges.size() >= kLeastRanges && ends >= kLeastEnds && best.mean_square < settings.explained &&
        weights.front() / sum > 1 - kRivalWeight &&
        eigenvaluesOf(covariance.topLeftCorner<3, 3>())[2] < settings.found_m * settings.found_m;
    return found;
}

}  // namespace noctule::cooperative
