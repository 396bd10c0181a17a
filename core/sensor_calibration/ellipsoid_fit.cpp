// SPDX-License-Identifier: Apache-2.0
#include "core/sensor_calibration/ellipsoid_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/job/contract.h"
#include "core/math/linear_solvers.h"

namespace noctule {

namespace {

using Unknowns = Eigen::Matrix<double, 9, 1>;
using Normal = Eigen::Matrix<double, 9, 9>;

constexpr int kMostSteps = 30, kMostRounds = 40;
constexpr double kTukey = 4.685;  ///< keeps 95 % efficiency on Gaussian residuals
constexpr double kSigmaOfMad = 1.4826;

/// Row and column of each of the six entries of the matrix.
constexpr std::array<std::pair<int, int>, 6> kEntries{{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};

Matrix3d matrixOf(const Unknowns& x, EllipsoidForm form) {
    Matrix3d M = Matrix3d::Zero();
    for (size_t k = 0; k < 6; ++k) {
        const auto [r, c] = kEntries[k];
        M(r, c) = x[3 + Eigen::Index(k)];
        if (form == EllipsoidForm::kSymmetric)
            M(c, r) = M(r, c);
    }
    return M;
}

/// Sphere through the readings: linear in centre and squared radius.
Unknowns sphereStart(const std::vector<Vector3d>& readings) {
    Eigen::MatrixXd A(readings.size(), 4);
    Eigen::VectorXd b(readings.size());
    for (size_t i = 0; i < readings.size(); ++i) {
        A.row(Eigen::Index(i)) << 2 * readings[i].transpose(), 1;
        b[Eigen::Index(i)] = readings[i].squaredNorm();
    }
    const Eigen::Vector4d s = solveLeastSquares(A, b);
    const double radius = std::sqrt(std::max(s[3] + s.head<3>().squaredNorm(), 1e-12));
    Unknowns x = Unknowns::Zero();
    x.head<3>() = s.head<3>();
    x[3] = x[6] = x[8] = 1 / radius;
    return x;
}

/// Residuals |M (p - zero)| - 1 and their derivatives.
class LengthResiduals {
public:
    LengthResiduals(const std::vector<Vector3d>& readings, EllipsoidForm form)
        : readings_(readings), form_(form) {}

    Eigen::VectorXd values(const Unknowns& x) const {
        const Matrix3d M = matrixOf(x, form_);
        Eigen::VectorXd r(readings_.size());
        for (size_t i = 0; i < readings_.size(); ++i)
            r[Eigen::Index(i)] = (M * (readings_[i] - x.head<3>())).norm() - 1;
        return r;
    }

    Unknowns gradient(const Unknowns& x, size_t i) const {
        const Matrix3d M = matrixOf(x, form_);
        const Vector3d p = readings_[i] - x.head<3>(), v = M * p;
        const Vector3d unit = v / std::max(v.norm(), 1e-12);
        Unknowns g;
        g.head<3>() = -M.transpose() * unit;
        for (size_t k = 0; k < 6; ++k) {
            const auto [row, column] = kEntries[k];
            g[3 + Eigen::Index(k)] = unit[row] * p[column];
            if (form_ == EllipsoidForm::kSymmetric && row != column)
                g[3 + Eigen::Index(k)] += unit[column] * p[row];
        }
        return g;
    }

private:
    const std::vector<Vector3d>& readings_;
    EllipsoidForm form_;
};

Eigen::VectorXd tukeyWeights(const Eigen::VectorXd& residuals) {
    std::vector<double> sizes(residuals.data(), residuals.data() + residuals.size());
    for (double& size : sizes)
        size = std::abs(size);
    std::nth_element(sizes.begin(), sizes.begin() + long(sizes.size() / 2), sizes.end());
    const double reach = kTukey * std::max(kSigmaOfMad * sizes[sizes.size() / 2], 1e-9);
    return residuals.unaryExpr([reach](double r) {
        const double u = r / reach;
        return std::abs(u) < 1 ? (1 - u * u) * (1 - u * u) : 0;
    });
}

Normal normalOf(const LengthResiduals& problem, const Unknowns& x, const Eigen::VectorXd& residuals,
                const Eigen::VectorXd& weights, Unknowns& right) {
    Normal N = Normal::Zero();
    right.setZero();
    for (Eigen::Index i = 0; i < residuals.size(); ++i) {
        if (weights[i] == 0)
            continue;
        const Unknowns g = problem.gradient(x, size_t(i));
        N += weights[i] * g * g.transpose();
        right -= weights[i] * residuals[i] * g;
    }
    return N;
}

double costOf(const Eigen::VectorXd& residuals, const Eigen::VectorXd& weights) {
    return residuals.cwiseAbs2().dot(weights);
}

/// Ratio of the eigenvalues once every unknown is scaled to its own sensitivity.
double conditionOf(const Normal& N) {
    const Unknowns scale = N.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const Normal scaled = scale.asDiagonal() * N * scale.asDiagonal();
    const Eigen::VectorXd values = eigenvaluesOf(scaled);
    return values[8] / std::max(values[0], 1e-300);
}

/// Steps until the cost falls no further; how many.
int descend(const LengthResiduals& problem, const Eigen::VectorXd& weights, Unknowns& x,
            Eigen::VectorXd& residuals) {
    double damping = 1e-3;
    Unknowns right;
    for (int steps = 0; steps < kMostSteps; ++steps) {
        Normal N = normalOf(problem, x, residuals, weights, right);
        N.diagonal() *= 1 + damping;
        const Unknowns step = solveSymmetric(N, right);
        const Eigen::VectorXd tried = problem.values(x + step);
        if (!step.allFinite() || !(costOf(tried, weights) < costOf(residuals, weights))) {
            damping *= 10;
            if (damping > 1e3)
                return steps;
            continue;
        }
        x += step;
        residuals = tried;
        damping = std::max(damping / 10, 1e-9);
        if (step.norm() < 1e-9 * x.norm())
            return steps;
    }
    return kMostSteps;
}

}  // namespace

EllipsoidFit fitEllipsoid(const std::vector<Vector3d>& readings, double length, EllipsoidForm form) {
    require(readings.size() >= 10, "an ellipsoid needs ten readings");
    // Unit size and the origin amid the readings, so that every unknown is near 1.
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& reading : readings)
        middle += reading / double(readings.size());
    double size = 0;
    for (const Vector3d& reading : readings)
        size += (reading - middle).squaredNorm() / double(readings.size());
    size = std::max(std::sqrt(size), 1e-12);
    std::vector<Vector3d> scaled;
    for (const Vector3d& reading : readings)
        scaled.push_back((reading - middle) / size);
    const LengthResiduals problem(scaled, form);
    Unknowns x = sphereStart(scaled), right;
    EllipsoidFit fit;
    Eigen::VectorXd residuals = problem.values(x), weights = Eigen::VectorXd::Ones(residuals.size());
    // Nothing is doubted in the first round, before the shape is known.
    for (int round = 0; round < kMostRounds && !fit.converged; ++round) {
        const Unknowns before = x;
        fit.iterations += descend(problem, weights, x, residuals);
        weights = tukeyWeights(residuals);
        fit.converged = round > 1 && (x - before).norm() < 1e-6 * x.norm();
    }
    const Normal N = normalOf(problem, x, residuals, weights, right);
    fit.condition = conditionOf(N);
    fit.used = size_t((weights.array() > 0).count());
    fit.doubted = readings.size() - fit.used;
    const double variance = costOf(residuals, weights) / std::max(weights.sum() - 9, 1.0);
    fit.residual = length * std::sqrt(variance);
    fit.sigma_zero =
        size * (variance * solveSymmetric(N, Normal::Identity()).diagonal().head<3>()).cwiseAbs().cwiseSqrt();
    fit.matrix = length / size * matrixOf(x, form);
    fit.zero = middle + size * x.head<3>();
    return fit;
}

DirectionCoverage coverageOf(const std::vector<Vector3d>& vectors) {
    struct Cell {
        Vector3d direction;
        std::string name;
        bool covered = false;
    };
    std::vector<Cell> cells;
    for (int axes = 1; axes <= 3; ++axes)
        for (int code = 0; code < 27; ++code) {
            const int parts[3] = {code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1};
            std::string name;
            for (int axis = 0; axis < 3; ++axis)
                if (parts[axis] != 0)
                    name += std::string(parts[axis] > 0 ? "+" : "-") + "xyz"[axis];
            if (name.size() == size_t(2 * axes))
                cells.push_back({Vector3d(parts[0], parts[1], parts[2]).normalized(), name});
        }
    for (const Vector3d& vector : vectors)
        if (vector.allFinite() && vector.norm() > 0)
            std::max_element(cells.begin(), cells.end(), [&](const Cell& a, const Cell& b) {
                return a.direction.dot(vector) < b.direction.dot(vector);
            })->covered = true;
    DirectionCoverage coverage;
    for (const Cell& cell : cells) {
        coverage.covered += cell.covered;
        if (!cell.covered)
            coverage.missing.push_back(cell.name);
    }
    return coverage;
}

}  // namespace noctule
