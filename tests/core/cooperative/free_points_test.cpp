// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/math/linear_solvers.h"
#include "tests/core/cooperative/cast_scene.h"

namespace noctule::cooperative {
namespace {

/// Two users after some steps: a covariance with all its correlations.
struct Prepared {
    FreePoints points;
    std::vector<RangeRow> rows;
};

Prepared prepared(unsigned seed) {
    const CastScene scene = drawnScene(2, 5, 4, 0.1, seed);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Prepared made{startPoints(scene.places_m.front(), 0.02, 0.3), {}};
    for (int step = 0; step < 3; ++step) {
        predict(made.points, 0.01, 0.1);
        auto ranges = pairsOfTarget(scene.user_of_point, 4, step % 2);
        for (PointRange& range : ranges) {
            const Vector3d other = range.other < 0 ? scene.anchors_m[static_cast<size_t>(-1 - range.other)]
                                                   : made.points.place(range.other);
            range.variance_m2 = 4e-6 * (1 + std::abs(normal(random)));
            range.distance_m = (made.points.place(range.point) - other).norm() + 0.002 * normal(random);
        }
        made.rows = linearise(made.points, scene.anchors_m, ranges);
        if (step < 2)
            correctByGain(made.points, made.rows);
    }
    return made;
}

double relativeDifference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return (a - b).norm() / b.norm();
}

TEST(FreePoints, TheCheapUpdateIsTheTextbooks) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const Prepared before = prepared(seed);
        FreePoints cheap = before.points, dense = before.points;
        correct(cheap, before.rows);
        correctByGain(dense, before.rows);
        EXPECT_LT(relativeDifference(cheap.covariance(), dense.covariance()), 1e-9) << seed;
        EXPECT_LT((cheap.p_m - dense.p_m).norm() / (dense.p_m - before.points.p_m).norm(), 1e-9) << seed;
        EXPECT_LT(
            (cheap.v_m_per_s - dense.v_m_per_s).norm() / (dense.v_m_per_s - before.points.v_m_per_s).norm(),
            1e-9)
            << seed;
    }
}

TEST(FreePoints, TimeUpdateIsEquations4To9) {
    FreePoints points = prepared(7).points;
    const Eigen::MatrixXd P = points.covariance();
    const Eigen::Index n = points.p_m.size();
    constexpr double kDt = 0.02, kQ = 0.3;
    Eigen::MatrixXd F = Eigen::MatrixXd::Identity(2 * n, 2 * n), Q = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    F.topRightCorner(n, n).diagonal().setConstant(kDt);
    Q.topLeftCorner(n, n).diagonal().setConstant(kQ * kDt * kDt * kDt / 3);
    Q.topRightCorner(n, n).diagonal().setConstant(kQ * kDt * kDt / 2);
    Q.bottomLeftCorner(n, n).diagonal().setConstant(kQ * kDt * kDt / 2);
    Q.bottomRightCorner(n, n).diagonal().setConstant(kQ * kDt);
    predict(points, kDt, kQ);
    EXPECT_LT(relativeDifference(points.covariance(), F * P * F.transpose() + Q), 1e-12);
}

TEST(FreePoints, TwoPointsAtOnePlaceGiveNoRow) {
    const FreePoints points = startPoints({Vector3d::Ones(), Vector3d::Ones()}, 1, 1);
    EXPECT_TRUE(linearise(points, {}, {{0, 1, 0.1, 1e-6}}).empty());
}

/// As the greedy choice is defined: each round tries all rows with the whole update.
std::vector<int> greedyByTrial(const Prepared& from, size_t most, bool trace) {
    FreePoints points = from.points;
    std::vector<int> chosen;
    while (chosen.size() < most) {
        int best = -1;
        double best_value = 1e300;
        for (int k = 0; k < static_cast<int>(from.rows.size()); ++k) {
            if (std::find(chosen.begin(), chosen.end(), k) != chosen.end())
                continue;
            FreePoints tried = points;
            correctByGain(tried, {from.rows[static_cast<size_t>(k)]});
            const double value =
                trace ? tried.cov_pp.trace() : eigenvaluesOf(tried.cov_pp).array().log().sum();
            if (value < best_value)
                best_value = value, best = k;
        }
        chosen.push_back(best);
        correctByGain(points, {from.rows[static_cast<size_t>(best)]});
    }
    return chosen;
}

TEST(RangeSelection, GreedyChoicesAreThoseOfTrial) {
    const Prepared from = prepared(3);
    EXPECT_EQ(selectRows(from.points, from.rows, 8, SelectionRule::kTrace), greedyByTrial(from, 8, true));
    EXPECT_EQ(selectRows(from.points, from.rows, 8, SelectionRule::kLogDet), greedyByTrial(from, 8, false));
}

TEST(RangeSelection, RatioIsTheDiagonalOfSOverR) {
    const Prepared from = prepared(4);
    const auto order = selectRows(from.points, from.rows, from.rows.size(), SelectionRule::kRatio);
    double last = 1e300;
    for (const int k : order) {
        const RangeRow& row = from.rows[static_cast<size_t>(k)];
        Eigen::VectorXd h = Eigen::VectorXd::Zero(from.points.p_m.size());
        h.segment<3>(3 * row.point) += row.direction;
        if (row.other >= 0)
            h.segment<3>(3 * row.other) -= row.direction;
        const double ratio = h.dot(from.points.cov_pp * h) / row.variance_m2;
        EXPECT_LE(ratio, last * (1 + 1e-12));
        last = ratio;
    }
}

TEST(RangeSelection, AShareIsRoundedAndNeverNone) {
    EXPECT_EQ(shareOf(377, 2.0 / 3), 251u);
    EXPECT_EQ(shareOf(4, 0), 1u);
    EXPECT_EQ(shareOf(0, 1), 0u);
}

}  // namespace
}  // namespace noctule::cooperative
