// SPDX-License-Identifier: Apache-2.0
// Natural cubic spline through equally spaced rows of numbers: continuous up to the second derivative.
#pragma once

#include <vector>

#include "core/simulation/jet.h"

namespace noctule::simulation {

class Spline {
public:
    Spline() = default;
    /// rows: at least two, one column per coordinate; row i is met exactly at time i * step_s.
    Spline(Eigen::MatrixXd rows, double step_s);

    int columns() const { return static_cast<int>(rows_.cols()); }
    double duration_s() const { return step_s_ * static_cast<double>(rows_.rows() - 1); }

    /// All coordinates at t, which is held at the ends; T is double or Jet (derivatives in time).
    template <class T>
    void at(double t_s, std::vector<T>& coordinates) const;

private:
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows_, curvature_;
    double step_s_ = 1;
};

extern template void Spline::at<double>(double, std::vector<double>&) const;
extern template void Spline::at<Jet>(double, std::vector<Jet>&) const;

}  // namespace noctule::simulation
