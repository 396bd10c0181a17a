// SPDX-License-Identifier: Apache-2.0
#include "core/sensor_calibration/hand_calibration.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/linear_solvers.h"
#include "core/math/rotation.h"

namespace noctule {

namespace {

constexpr double kWindow_s = 1;
constexpr size_t kFewestPositions = 12;
constexpr int kFewestGravityDirections = 9;  ///< of 26
constexpr double kFewestTurns_deg = 180;     ///< about each axis
constexpr double kSamePosition_rad = 0.087;  ///< nearer ones add nothing to the accelerometer's fit
constexpr double kLongestTurn_s = 60;
constexpr double kMostHandCondition = 1e4;
constexpr double kMostZeroSigma_m_per_s2 = 0.05, kMostAccelResidual_m_per_s2 = 0.1;
constexpr double kMostTurnResidual_deg = 2;

/// Variance of the acceleration in a window about each row, missing rows left out; infinite without enough.
std::vector<double> windowVariances(const ImuSamples& samples, size_t width) {
    const size_t rows = samples.size();
    std::vector<Vector3d> sums(rows + 1, Vector3d::Zero()), squares(rows + 1, Vector3d::Zero());
    std::vector<size_t> counts(rows + 1, 0);
    for (size_t i = 0; i < rows; ++i) {
        const Vector3d& a = samples.accel_m_per_s2[i];
        const bool read = a.allFinite() && samples.gyro_rad_per_s[i].allFinite();
        sums[i + 1] = sums[i] + (read ? a : Vector3d::Zero());
        squares[i + 1] = squares[i] + (read ? Vector3d(a.cwiseAbs2()) : Vector3d::Zero());
        counts[i + 1] = counts[i] + read;
    }
    std::vector<double> variances(rows, std::numeric_limits<double>::infinity());
    for (size_t begin = 0; begin + width <= rows; ++begin) {
        const size_t count = counts[begin + width] - counts[begin];
        if (count < width / 2 + 1)
            continue;
        const Vector3d mean = (sums[begin + width] - sums[begin]) / double(count);
        const Vector3d square = (squares[begin + width] - squares[begin]) / double(count);
        variances[begin + width / 2] = (square - mean.cwiseAbs2()).cwiseMax(0).sum();
    }
    return variances;
}

StillRows meansOf(const ImuSamples& samples, size_t begin, size_t end) {
    StillRows rows{begin, end, Vector3d::Zero(), Vector3d::Zero()};
    double count = 0;
    for (size_t i = begin; i < end; ++i)
        if (samples.accel_m_per_s2[i].allFinite() && samples.gyro_rad_per_s[i].allFinite()) {
            rows.accel += samples.accel_m_per_s2[i];
            rows.gyro += samples.gyro_rad_per_s[i];
            ++count;
        }
    rows.accel /= std::max(count, 1.0);
    rows.gyro /= std::max(count, 1.0);
    return rows;
}

double angleBetweenVectors(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// One for each direction of gravity.
std::vector<Vector3d> distinctPositions(const std::vector<StillRows>& still) {
    std::vector<Vector3d> positions;
    for (const StillRows& rows : still)
        if (std::none_of(positions.begin(), positions.end(), [&](const Vector3d& known) {
                return angleBetweenVectors(known, rows.accel) < kSamePosition_rad;
            }))
            positions.push_back(rows.accel);
    return positions;
}

/// Rates of one turn between two positions, and gravity before and after.
struct HandTurn {
    std::vector<Vector3d> rates;
    Vector3d up_before, up_after;
};

using GyroUnknowns = Eigen::Matrix<double, 9, 1>;
using GyroNormal = Eigen::Matrix<double, 9, 9>;

class GyroscopeFit {
public:
    GyroscopeFit(std::vector<HandTurn> turns, double rate_hz) : turns_(std::move(turns)), rate_hz_(rate_hz) {}

    GyroscopeHandFit solve() const {
        GyroscopeHandFit fit;
        fit.turns = int(turns_.size());
        GyroUnknowns x;
        x << 1, 0, 0, 0, 1, 0, 0, 0, 1;
        Eigen::VectorXd residuals = residualsOf(x);
        const double before = rms(residuals);
        double damping = 1e-4;
        Eigen::MatrixXd J;
        for (int step = 0; step < 30; ++step) {
            J = derivatives(x, residuals);
            GyroNormal N = J.transpose() * J;
            N.diagonal() *= 1 + damping;
            const GyroUnknowns change = -solveSymmetric(N, J.transpose() * residuals);
            const Eigen::VectorXd tried = residualsOf(x + change);
            if (!change.allFinite() || tried.squaredNorm() > residuals.squaredNorm()) {
                damping *= 10;
                if (damping > 1e6)
                    break;
                continue;
            }
            x += change;
            residuals = tried;
            damping = std::max(damping / 10, 1e-12);
            fit.converged = change.norm() < 1e-8;
            if (fit.converged)
                break;
        }
        J = derivatives(x, residuals);
        const Eigen::VectorXd values = eigenvaluesOf(J.transpose() * J);
        fit.condition = values[8] / std::max(values[0], 1e-300);
        fit.matrix = matrixOfGyro(x);
        fit.residual_deg = degrees(rms(residuals));
        fit.before_deg = degrees(before);
        for (const HandTurn& turn : turns_)
            for (const Vector3d& rate : turn.rates)
                fit.turned_deg += degrees(1) * rate.cwiseAbs() / rate_hz_;
        return fit;
    }

private:
    static Matrix3d matrixOfGyro(const GyroUnknowns& x) {
        return (Matrix3d() << x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8]).finished();
    }
    double rms(const Eigen::VectorXd& residuals) const {
        return std::sqrt(residuals.squaredNorm() / std::max<double>(1, double(turns_.size())));
    }

    Eigen::VectorXd residualsOf(const GyroUnknowns& x) const {
        const Matrix3d G = matrixOfGyro(x);
        Eigen::VectorXd residuals(3 * turns_.size());
        for (size_t t = 0; t < turns_.size(); ++t) {
            Quaterniond q = Quaterniond::Identity();
            for (const Vector3d& rate : turns_[t].rates)
                q = q * expQuaternion(Vector3d(G * rate / rate_hz_));
            residuals.segment<3>(3 * Eigen::Index(t)) =
                q.normalized().conjugate() * turns_[t].up_before - turns_[t].up_after;
        }
        return residuals;
    }

    Eigen::MatrixXd derivatives(const GyroUnknowns& x, const Eigen::VectorXd& at) const {
        constexpr double kStep = 1e-6;
        Eigen::MatrixXd J(at.size(), 9);
        for (int k = 0; k < 9; ++k) {
            GyroUnknowns moved = x;
            moved[k] += kStep;
            J.col(k) = (residualsOf(moved) - at) / kStep;
        }
        return J;
    }

    std::vector<HandTurn> turns_;
    double rate_hz_;
};

std::vector<HandTurn> turnsBetween(const ImuSamples& samples, const std::vector<StillRows>& still,
                                   const EllipsoidFit& accel, const Vector3d& gyro_zero) {
    std::vector<HandTurn> turns;
    for (size_t s = 1; s < still.size(); ++s) {
        const size_t begin = (still[s - 1].begin + still[s - 1].end) / 2,
                     end = (still[s].begin + still[s].end) / 2;
        HandTurn turn;
        bool whole = double(end - begin) < kLongestTurn_s * samples.rate_hz;
        for (size_t i = begin; i < end && whole; ++i) {
            whole = samples.gyro_rad_per_s[i].allFinite();
            turn.rates.push_back(samples.gyro_rad_per_s[i] - gyro_zero);
        }
        if (!whole)
            continue;
        turn.up_before = (accel.matrix * (still[s - 1].accel - accel.zero)).normalized();
        turn.up_after = (accel.matrix * (still[s].accel - accel.zero)).normalized();
        turns.push_back(std::move(turn));
    }
    return turns;
}

void zeroOfGyro(const std::vector<StillRows>& still, GyroscopeHandFit& fit) {
    Vector3d sum = Vector3d::Zero(), squares = Vector3d::Zero();
    for (const StillRows& rows : still) {
        sum += rows.gyro;
        squares += rows.gyro.cwiseAbs2();
    }
    const double n = double(still.size());
    fit.zero = sum / n;
    fit.sigma_zero = ((squares / n - fit.zero.cwiseAbs2()).cwiseMax(0) / std::max(n - 1, 1.0)).cwiseSqrt();
}

void judgeHand(HandFit& fit) {
    const EllipsoidFit& accel = fit.accel;
    std::string missing;
    for (size_t i = 0; i < std::min<size_t>(fit.coverage.missing.size(), 6); ++i)
        missing += (missing.empty() ? "" : ", ") + fit.coverage.missing[i];
    if (fit.positions < kFewestPositions || fit.coverage.covered < kFewestGravityDirections) {
        fit.problem = "it lay still in " + std::to_string(fit.positions) + " different positions";
        fit.remedy =
            "Lay it down for two seconds each in 12 positions or more, also with " + missing + " upward";
    } else if (!accel.converged || !(accel.condition < kMostHandCondition) ||
               !(accel.sigma_zero.maxCoeff() < kMostZeroSigma_m_per_s2)) {
        fit.problem = "the positions do not determine the accelerometer";
        fit.remedy = "Lay it down with " + missing + " upward too";
    } else if (accel.residual > kMostAccelResidual_m_per_s2) {
        fit.problem =
            "gravity differs between positions by " + std::to_string(accel.residual) + " m/s^2 after the fit";
        fit.remedy = "Lay it on something firm and let go of it";
    } else if (fit.gyro.turned_deg.minCoeff() < kFewestTurns_deg) {
        Eigen::Index axis = 0;
        fit.gyro.turned_deg.minCoeff(&axis);
        fit.problem = std::string("it was turned too little about ") + "xyz"[axis];
        fit.remedy = "Turn it by half a turn and more about each axis between positions";
    } else if (!(fit.gyro.condition < kMostHandCondition * 100) ||
               fit.gyro.residual_deg > kMostTurnResidual_deg) {
        fit.problem =
            "the turns do not fit the positions: " + std::to_string(fit.gyro.residual_deg) + " deg remain";
        fit.remedy = "Turn it more slowly, below its full scale, and about all axes";
    }
}

}  // namespace

std::vector<StillRows> findStillRows(const ImuSamples& samples, double factor) {
    const auto width = std::max<size_t>(4, size_t(kWindow_s * samples.rate_hz));
    const std::vector<double> variances = windowVariances(samples, width);
    if (variances.empty())
        return {};
    const double least = *std::min_element(variances.begin(), variances.end());
    const double limit = factor * factor * std::max(least, 1e-10);
    std::vector<StillRows> still;
    for (size_t i = 0; i < variances.size();) {
        if (!(variances[i] <= limit)) {
            ++i;
            continue;
        }
        const size_t begin = i;
        while (i < variances.size() && variances[i] <= limit)
            ++i;
        if (i - begin >= width / 4)
            still.push_back(meansOf(samples, begin, i));
    }
    return still;
}

HandFit calibrateByHand(const ImuSamples& samples, double g_m_per_s2) {
    // As in the paper, the threshold of stillness is that with which the accelerometer fits best.
    HandFit fit;
    double best = std::numeric_limits<double>::infinity();
    std::vector<StillRows> still;
    for (const double factor : {2., 3., 4., 6., 8.}) {
        const auto found = findStillRows(samples, factor);
        const auto positions = distinctPositions(found);
        if (positions.size() > fit.positions && !std::isfinite(best)) {
            fit.positions = positions.size();
            fit.coverage = coverageOf(positions);
        }
        if (positions.size() < kFewestPositions)
            continue;
        const EllipsoidFit accel = fitEllipsoid(positions, g_m_per_s2, EllipsoidForm::kUpperTriangular);
        const double score = accel.residual / std::sqrt(double(positions.size()));
        if (score >= best)
            continue;
        best = score;
        fit.accel = accel;
        fit.positions = positions.size();
        fit.coverage = coverageOf(positions);
        still = found;
        double squares = 0;
        for (const Vector3d& position : positions)
            squares += std::pow(position.norm() - g_m_per_s2, 2) / double(positions.size());
        fit.before_m_per_s2 = std::sqrt(squares);
    }
    if (!still.empty()) {
        GyroscopeHandFit zero;
        zeroOfGyro(still, zero);
        fit.gyro = GyroscopeFit(turnsBetween(samples, still, fit.accel, zero.zero), samples.rate_hz).solve();
        fit.gyro.zero = zero.zero;
        fit.gyro.sigma_zero = zero.sigma_zero;
    }
    judgeHand(fit);
    return fit;
}

}  // namespace noctule
