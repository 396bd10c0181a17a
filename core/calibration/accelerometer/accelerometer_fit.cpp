// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/accelerometer/accelerometer_fit.h"

#include <cmath>

#include "core/math/linear_solvers.h"

namespace noctule {
namespace {

constexpr double kSigmaOpenAxes_rad = radians(2.0), kSigmaOpenScale = 0.05, kSigmaOpenZero_m_per_s2 = 10;
constexpr int kMostFitSteps = 50;
constexpr double kSmallFitStep = 1e-10;
constexpr double kLeastSigma_m_per_s2 = 5e-4;  ///< for noiseless readings

/// Zero in m/s^2 from the start's, then the rows of E: value = slopes (1 + E) (counts - zero).
using AccelUnknowns = Eigen::Matrix<double, 12, 1>;
using AccelInformation = Eigen::Matrix<double, 12, 12>;
using AccelRow = Eigen::Matrix<double, 1, 12>;

class AccelerometerProblem {
public:
    AccelerometerProblem(const std::vector<StillPosition>& positions, const AxisCalibration& start)
        : positions_(positions), start_(start), slopes_(start.matrix.diagonal()) {}

    AxisCalibration axes(const AccelUnknowns& x) const {
        AxisCalibration axes = start_;
        axes.zero_counts += x.head<3>().cwiseQuotient(slopes_);
        axes.matrix = (Matrix3d::Identity() + errors(x)) * slopes_.asDiagonal();
        return axes;
    }
    /// Of all residuals over their sigmas, and of what the start says.
    void gather(const AccelUnknowns& x, AccelInformation& information, AccelUnknowns& gradient) const {
        information.setZero();
        gradient.setZero();
        const auto add = [&](const AccelRow& row, double residual, double sigma) {
            information += row.transpose() * row / (sigma * sigma);
            gradient += row.transpose() * residual / (sigma * sigma);
        };
        for (int i = 0; i < 12; ++i)
            add(AccelRow::Unit(i), x[i], sigmaOpen(i));
        for (const StillPosition& position : positions_)
            addPosition(position, x, add);
    }

private:
    static Matrix3d errors(const AccelUnknowns& x) { return x.tail<9>().reshaped<Eigen::RowMajor>(3, 3); }
    static double sigmaOpen(int unknown) {
        if (unknown < 3)
            return kSigmaOpenZero_m_per_s2;
        return (unknown - 3) % 4 == 0 ? kSigmaOpenScale : kSigmaOpenAxes_rad;
    }

    template <class Add>
    void addPosition(const StillPosition& position, const AccelUnknowns& x, const Add& add) const {
        const Matrix3d turned = Matrix3d::Identity() + errors(x);
        const Vector3d scaled = slopes_.cwiseProduct(position.mean.counts - start_.zero_counts) - x.head<3>();
        const Vector3d value = turned * scaled;
        Eigen::Matrix<double, 3, 12> J_value_x = Eigen::Matrix<double, 3, 12>::Zero();
        J_value_x.leftCols<3>() = -turned;
        for (int axis = 0; axis < 3; ++axis)
            J_value_x.block<1, 3>(axis, 3 + 3 * axis) = scaled.transpose();
        const double sigma =
            std::max(kLeastSigma_m_per_s2, slopes_.cwiseProduct(position.mean.sigma).cwiseAbs().maxCoeff());
        add(value.normalized().transpose() * J_value_x, value.norm() - position.g_m_per_s2, sigma);
        if (position.level)
            for (int axis = 0; axis < 3; ++axis)
                if (axis != position.level->axis)
                    add(J_value_x.row(axis), value[axis],
                        std::hypot(sigma, position.g_m_per_s2 * position.sigma_level_rad));
    }

    const std::vector<StillPosition>& positions_;
    const AxisCalibration& start_;
    Vector3d slopes_;
};

}  // namespace

double AccelerometerFit::residual_m_per_s2(const StillPosition& position) const {
    return value(position).norm() - position.g_m_per_s2;
}

double AccelerometerFit::angle_rad(const StillPosition& position, BoardSide side) const {
    const Vector3d reading = value(position);
    return std::atan2(reading.cross(side.up()).norm(), reading.dot(side.up()));
}

AccelerometerFit fitAccelerometer(const std::vector<StillPosition>& positions, const AxisCalibration& start) {
    const AccelerometerProblem problem(positions, start);
    AccelUnknowns x = AccelUnknowns::Zero(), gradient;
    AccelInformation information;
    AccelerometerFit fit;
    while (!fit.converged && fit.iterations < kMostFitSteps) {
        problem.gather(x, information, gradient);
        const AccelUnknowns step = -solveSymmetric(information, gradient);
        x += step;
        ++fit.iterations;
        fit.converged = step.norm() < kSmallFitStep;
    }
    problem.gather(x, information, gradient);
    const AccelUnknowns sigma = inverseOf(information).diagonal().cwiseSqrt();
    const Vector3d slopes = start.matrix.diagonal();
    fit.axes = problem.axes(x);
    fit.axes.sigma_zero_counts = sigma.head<3>().cwiseQuotient(slopes);
    fit.sigma_matrix = sigma.tail<9>().reshaped<Eigen::RowMajor>(3, 3) * slopes.asDiagonal();
    return fit;
}

}  // namespace noctule
