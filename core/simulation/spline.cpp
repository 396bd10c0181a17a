// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/spline.h"

#include <algorithm>
#include <type_traits>

#include "core/job/contract.h"

namespace noctule::simulation {

Spline::Spline(Eigen::MatrixXd rows, double step_s) : rows_(std::move(rows)), step_s_(step_s) {
    const Eigen::Index n = rows_.rows();
    require(n >= 2 && step_s > 0, "a spline needs two rows and a step");
    curvature_.setZero(n, rows_.cols());  // second derivatives; zero at both ends
    // (m[i-1] + 4 m[i] + m[i+1]) h^2 / 6 = y[i-1] - 2 y[i] + y[i+1], solved by elimination down and up.
    std::vector<double> factor(static_cast<size_t>(n), 0.0);
    for (Eigen::Index i = 1; i + 1 < n; ++i) {
        const double pivot = 4 - factor[i - 1];
        factor[i] = 1 / pivot;
        curvature_.row(i) =
            (6 / (step_s * step_s) * (rows_.row(i - 1) - 2 * rows_.row(i) + rows_.row(i + 1)) -
             curvature_.row(i - 1)) /
            pivot;
    }
    for (Eigen::Index i = n - 2; i >= 1; --i)
        curvature_.row(i) -= factor[i] * curvature_.row(i + 1);
}

template <class T>
void Spline::at(double t_s, std::vector<T>& coordinates) const {
    const double place = std::clamp(t_s / step_s_, 0.0, static_cast<double>(rows_.rows() - 1));
    const Eigen::Index i = std::min(static_cast<Eigen::Index>(place), rows_.rows() - 2);
    const double b = place - static_cast<double>(i), a = 1 - b, h = step_s_;
    coordinates.resize(static_cast<size_t>(rows_.cols()));
    for (Eigen::Index c = 0; c < rows_.cols(); ++c) {
        const double y0 = rows_(i, c), y1 = rows_(i + 1, c), m0 = curvature_(i, c), m1 = curvature_(i + 1, c);
        const double value = a * y0 + b * y1 + h * h / 6 * ((a * a * a - a) * m0 + (b * b * b - b) * m1);
        if constexpr (std::is_same_v<T, double>)
            coordinates[c] = value;
        else
            coordinates[c] = Jet(value, (y1 - y0) / h + h / 6 * ((1 - 3 * a * a) * m0 + (3 * b * b - 1) * m1),
                                 a * m0 + b * m1);
    }
}

template void Spline::at<double>(double, std::vector<double>&) const;
template void Spline::at<Jet>(double, std::vector<Jet>&) const;

}  // namespace noctule::simulation
