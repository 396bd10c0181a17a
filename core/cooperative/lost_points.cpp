// SPDX-License-Identifier: Apache-2.0
#include "core/cooperative/lost_points.h"

#include <algorithm>
#include <cmath>

#include "core/math/linear_solvers.h"

namespace noctule::cooperative {
namespace {

constexpr double kFarthest_m = 1;   ///< of a point from where it was known
constexpr double kGateMemory = 20;  ///< ranges

double worstSigma_m(const FreePoints& points, int point) {
    const Matrix3d P = points.cov_pp.block<3, 3>(3 * point, 3 * point);
    return std::sqrt(std::max(0.0, eigenvaluesOf(P)[2]));
}

}  // namespace

void hangPoint(FreePoints& points, int point, int from, const Vector3d& offset_m, double sigma_m,
               double sigma_m_per_s) {
    const int i = 3 * point, j = 3 * from;
    points.p_m.segment<3>(i) = points.place(from) + offset_m;
    points.v_m_per_s.segment<3>(i) = points.v_m_per_s.segment<3>(j).eval();
    for (Eigen::MatrixXd* const P : {&points.cov_pp, &points.cov_pv, &points.cov_vv}) {
        P->middleRows<3>(i) = P->middleRows<3>(j).eval();
        P->middleCols<3>(i) = P->middleCols<3>(j).eval();
    }
    points.cov_pp.diagonal().segment<3>(i).array() += sigma_m * sigma_m;
    points.cov_vv.diagonal().segment<3>(i).array() += sigma_m_per_s * sigma_m_per_s;
}

void putPoint(FreePoints& points, int point, const PointBelief& belief) {
    const int i = 3 * point;
    points.p_m.segment<3>(i) = belief.p_m;
    points.v_m_per_s.segment<3>(i) = belief.v_m_per_s;
    for (Eigen::MatrixXd* const P : {&points.cov_pp, &points.cov_pv, &points.cov_vv}) {
        P->middleRows<3>(i).setZero();
        P->middleCols<3>(i).setZero();
    }
    points.cov_pp.block<3, 3>(i, i) = belief.covariance.topLeftCorner<3, 3>();
    points.cov_pv.block<3, 3>(i, i) = belief.covariance.topRightCorner<3, 3>();
    points.cov_vv.block<3, 3>(i, i) = belief.covariance.bottomRightCorner<3, 3>();
}

LostPoints::LostPoints(const std::vector<Vector3d>& rest_m, std::vector<int> user_of_point,
                       std::vector<std::vector<Reach>> reaches, const LostPointSettings& settings)
    : settings_(settings),
      user_of_point_(std::move(user_of_point)),
      reaches_(std::move(reaches)),
      points_(rest_m.size()) {
    lowest_m_ = -settings_.reach_m;
    for (const Vector3d& p : rest_m)
        lowest_m_ = std::min(lowest_m_, p.y() - settings_.reach_m);
    for (size_t i = 0; i < rest_m.size(); ++i)
        for (const Vector3d& other : rest_m)
            points_[i].offsets_m.push_back(rest_m[i] - other);
}

void LostPoints::judged(int point, bool gated) {
    double& share = points_[static_cast<size_t>(point)].gated_share;
    share += ((gated ? 1.0 : 0.0) - share) / kGateMemory;
}

void LostPoints::look(FreePoints& points, double time_s) {
    if (time_s < next_look_s_)
        return;
    next_look_s_ = time_s + settings_.interval_s;
    loseUnsure(points);
    loseOutOfReach(points);
    remember(points, time_s);
    for (int i = 0; i < points.count(); ++i)
        if (isLost(i))
            seek(points, i, time_s);
}

void LostPoints::lose(int point) {
    Watched& lost = points_[static_cast<size_t>(point)];
    lost.is_lost = true;
    lost.ranges.clear();
    ++losses_;
}

void LostPoints::loseUnsure(const FreePoints& points) {
    for (int i = 0; i < points.count(); ++i)
        if (!isLost(i) && (worstSigma_m(points, i) > settings_.lost_m ||
                           points_[static_cast<size_t>(i)].gated_share > settings_.gated_share))
            lose(i);
}

/// Of two points too far from or too near to each other, the one that contradicts more of its wearer's.
void LostPoints::loseOutOfReach(const FreePoints& points) {
    while (true) {
        int worst = -1, most = 0;
        for (int i = 0; i < points.count(); ++i) {
            int contradicted = !isLost(i) && points.place(i).y() < lowest_m_ - settings_.out_of_reach_m;
            for (int k = 0; k < points.count() && !isLost(i); ++k) {
                const Reach& reach = reaches_[static_cast<size_t>(i)][static_cast<size_t>(k)];
                const double apart_m = (points.place(i) - points.place(k)).norm();
                if (k != i && !isLost(k) &&
                    (apart_m > reach.most_m + settings_.out_of_reach_m ||
                     apart_m < reach.least_m - settings_.out_of_reach_m))
                    ++contradicted;
            }
            if (contradicted > most ||
                (contradicted == most && most > 0 && worstSigma_m(points, i) > worstSigma_m(points, worst)))
                worst = i, most = contradicted;
        }
        if (worst < 0)
            return;
        lose(worst);
    }
}

void LostPoints::remember(const FreePoints& points, double time_s) {
    std::vector<char> known(points_.size());
    for (size_t i = 0; i < points_.size(); ++i)
        known[i] = !points_[i].is_lost && points_[i].gated_share < 0.5 * settings_.gated_share &&
                   worstSigma_m(points, static_cast<int>(i)) < settings_.well_known_m;
    for (size_t i = 0; i < points_.size(); ++i) {
        if (!known[i])
            continue;
        points_[i].known_s = time_s;
        for (size_t k = 0; k < points_.size(); ++k)
            if (known[k])
                points_[i].offsets_m[k] =
                    points.place(static_cast<int>(i)) - points.place(static_cast<int>(k));
    }
}

int LostPoints::neighbourOf(int point) const {
    const std::vector<Reach>& reaches = reaches_[static_cast<size_t>(point)];
    int nearest = -1;
    for (int k = 0; k < static_cast<int>(points_.size()); ++k)
        if (!isLost(k) &&
            user_of_point_[static_cast<size_t>(k)] == user_of_point_[static_cast<size_t>(point)] &&
            (nearest < 0 ||
             reaches[static_cast<size_t>(k)].most_m < reaches[static_cast<size_t>(nearest)].most_m))
            nearest = k;
    return nearest;
}

void LostPoints::seek(FreePoints& points, int point, double time_s) {
    Watched& lost = points_[static_cast<size_t>(point)];
    while (!lost.ranges.empty() && lost.ranges.front().time_s < time_s - settings_.memory_s)
        lost.ranges.pop_front();
    const int neighbour = neighbourOf(point);
    if (neighbour < 0)
        return;
    const auto n = static_cast<size_t>(neighbour);
    const double reach_m =
        std::clamp(reaches_[static_cast<size_t>(point)][n].most_m, settings_.least_reach_m, kFarthest_m);
    const double sigma_m =
        std::min(reach_m, settings_.well_known_m + settings_.speed_m_per_s * (time_s - lost.known_s));
    hangPoint(points, point, neighbour, lost.offsets_m[n], sigma_m, settings_.speed_m_per_s);
    const int i = 3 * point;
    PointBelief prior{points.place(point), points.v_m_per_s.segment<3>(i),
                      decltype(PointBelief::covariance)::Zero()};
    prior.covariance << points.cov_pp.block<3, 3>(i, i), points.cov_pv.block<3, 3>(i, i),
        points.cov_pv.block<3, 3>(i, i).transpose(), points.cov_vv.block<3, 3>(i, i);
    PointBounds bounds{{}, lowest_m_};
    for (size_t k = 0; k < points_.size(); ++k)
        if (!points_[k].is_lost && user_of_point_[k] == user_of_point_[static_cast<size_t>(point)])
            bounds.body.push_back(
                {points.place(static_cast<int>(k)), reaches_[static_cast<size_t>(point)][k]});
    const PointFit found = fitPoint(lost.ranges, time_s, prior, bounds, settings_);
    putPoint(points, point, found.belief);
    if (!found.is_certain)
        return;
    lost.is_lost = false;
    lost.gated_share = 0;
    lost.known_s = time_s;
}

}  // namespace noctule::cooperative
