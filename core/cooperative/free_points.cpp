// SPDX-License-Identifier: Apache-2.0
#include "core/cooperative/free_points.h"

#include "core/job/contract.h"
#include "core/math/linear_solvers.h"

namespace noctule::cooperative {
namespace {

/// Directions shorter than this are rounding.
constexpr double kSamePoint_m = 1e-9;

void makeSymmetric(Eigen::MatrixXd& m) {
    m = (0.5 * (m + m.transpose())).eval();
}

/// L and g of correct().
struct Information {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd vector;
};

Information informationOf(const std::vector<RangeRow>& rows, Eigen::Index size) {
    Information sum{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
    for (const RangeRow& row : rows) {
        const Matrix3d block = row.direction * row.direction.transpose() / row.variance_m2;
        const Vector3d pull = row.direction * (row.innovation_m / row.variance_m2);
        const int i = 3 * row.point, j = 3 * row.other;
        sum.matrix.block<3, 3>(i, i) += block;
        sum.vector.segment<3>(i) += pull;
        if (row.other < 0)
            continue;
        sum.matrix.block<3, 3>(j, j) += block;
        sum.matrix.block<3, 3>(i, j) -= block;
        sum.matrix.block<3, 3>(j, i) -= block;
        sum.vector.segment<3>(j) -= pull;
    }
    return sum;
}

}  // namespace

Eigen::MatrixXd FreePoints::covariance() const {
    const Eigen::Index n = p_m.size();
    Eigen::MatrixXd all(2 * n, 2 * n);
    all << cov_pp, cov_pv, cov_pv.transpose(), cov_vv;
    return all;
}

FreePoints startPoints(const std::vector<Vector3d>& places_m, double sigma_m, double sigma_m_per_s) {
    const auto n = static_cast<Eigen::Index>(3 * places_m.size());
    FreePoints points;
    points.p_m.resize(n);
    for (size_t i = 0; i < places_m.size(); ++i)
        points.p_m.segment<3>(static_cast<Eigen::Index>(3 * i)) = places_m[i];
    points.v_m_per_s = Eigen::VectorXd::Zero(n);
    points.cov_pp = Eigen::MatrixXd::Identity(n, n) * (sigma_m * sigma_m);
    points.cov_pv = Eigen::MatrixXd::Zero(n, n);
    points.cov_vv = Eigen::MatrixXd::Identity(n, n) * (sigma_m_per_s * sigma_m_per_s);
    return points;
}

void predict(FreePoints& points, double dt_s, double q_m2_per_s3) {
    points.p_m += dt_s * points.v_m_per_s;  // equation 4 with equation 6
    points.cov_pp +=
        dt_s * (points.cov_pv + points.cov_pv.transpose()) + dt_s * dt_s * points.cov_vv;  // equation 5
    points.cov_pv += dt_s * points.cov_vv;
    points.cov_pp.diagonal().array() += q_m2_per_s3 * dt_s * dt_s * dt_s / 3;  // equation 7
    points.cov_pv.diagonal().array() += q_m2_per_s3 * dt_s * dt_s / 2;         // equation 8
    points.cov_vv.diagonal().array() += q_m2_per_s3 * dt_s;                    // equation 9
}

std::vector<RangeRow> linearise(const FreePoints& points, const std::vector<Vector3d>& anchors_m,
                                const std::vector<PointRange>& ranges) {
    std::vector<RangeRow> rows;
    rows.reserve(ranges.size());
    for (const PointRange& range : ranges) {
        require(range.variance_m2 > 0, "linearise: a range without variance");
        const Vector3d other =
            range.other < 0 ? anchors_m.at(static_cast<size_t>(-1 - range.other)) : points.place(range.other);
        const Vector3d between = points.place(range.point) - other;
        const double expected_m = between.norm();  // equation 12
        if (expected_m < kSamePoint_m)
            continue;
        rows.push_back({range.point, range.other, between / expected_m, range.distance_m - expected_m,
                        range.variance_m2});
    }
    return rows;
}

void correct(FreePoints& points, const std::vector<RangeRow>& rows) {
    if (rows.empty())
        return;
    const Eigen::Index n = points.p_m.size();
    const Information sum = informationOf(rows, n);
    Eigen::MatrixXd inverse_of_M = sum.matrix * points.cov_pp;
    inverse_of_M.diagonal().array() += 1;
    const Eigen::MatrixXd M = inverseOf(inverse_of_M);
    const Eigen::MatrixXd M_L_cov_pv = M * (sum.matrix * points.cov_pv);
    points.cov_vv -= points.cov_pv.transpose() * M_L_cov_pv;
    points.cov_pp = points.cov_pp * M;
    points.cov_pv = M.transpose() * points.cov_pv;
    makeSymmetric(points.cov_pp);
    makeSymmetric(points.cov_vv);
    points.p_m += points.cov_pp * sum.vector;
    points.v_m_per_s += points.cov_pv.transpose() * sum.vector;
}

void correctByGain(FreePoints& points, const std::vector<RangeRow>& rows) {
    const Eigen::Index n = points.p_m.size(), m = static_cast<Eigen::Index>(rows.size());
    if (m == 0)
        return;
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(m, 2 * n);
    Eigen::VectorXd innovation(m), variance(m);
    for (Eigen::Index k = 0; k < m; ++k) {
        const RangeRow& row = rows[static_cast<size_t>(k)];
        H.block<1, 3>(k, 3 * row.point) = row.direction.transpose();
        if (row.other >= 0)
            H.block<1, 3>(k, 3 * row.other) = -row.direction.transpose();
        innovation[k] = row.innovation_m;
        variance[k] = row.variance_m2;
    }
    const Eigen::MatrixXd P = points.covariance();
    Eigen::MatrixXd S = H * P * H.transpose();
    S.diagonal() += variance;
    const Eigen::MatrixXd K = solveSymmetric(S, H * P).transpose();  // equation 1.11 of WB95
    const Eigen::VectorXd correction = K * innovation;               // equation 1.12
    points.p_m += correction.head(n);
    points.v_m_per_s += correction.tail(n);
    Eigen::MatrixXd after = P - K * (H * P);  // equation 1.13
    makeSymmetric(after);
    points.cov_pp = after.topLeftCorner(n, n);
    points.cov_pv = after.topRightCorner(n, n);
    points.cov_vv = after.bottomRightCorner(n, n);
}

double relativeVariance(const FreePoints& points, int a, int b) {
    const auto block = [&](int i, int j) { return points.cov_pp.block<3, 3>(3 * i, 3 * j).trace(); };
    return block(a, a) + block(b, b) - 2 * block(a, b);
}

}  // namespace noctule::cooperative
