// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/low_pass.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace noctule::simulation {
namespace {

struct Biquad {
    double b0, b1, b2, a1, a2;

    /// Starts settled on the first value.
    void run(std::vector<double>& x) const {
        double x1 = x.front(), x2 = x1, y1 = x1, y2 = x1;
        for (double& value : x) {
            const double y = b0 * value + b1 * x1 + b2 * x2 - a1 * y1 - a2 * y2;
            x2 = x1;
            x1 = value;
            y2 = y1;
            y1 = value = y;
        }
    }
};

Biquad butterworth(double rate_hz, double cutoff_hz) {
    const double warped = std::tan(std::numbers::pi * cutoff_hz / rate_hz);
    const double scale = 1 / (1 + std::numbers::sqrt2 * warped + warped * warped);
    const double b = warped * warped * scale;
    return {b, 2 * b, b, 2 * (warped * warped - 1) * scale,
            (1 - std::numbers::sqrt2 * warped + warped * warped) * scale};
}

}  // namespace

void lowPassZeroPhase(std::vector<std::vector<double>>& rows, double rate_hz, double cutoff_hz) {
    const double edge_hz = cutoff_hz / std::pow(std::numbers::sqrt2 - 1, 0.25);
    if (rows.size() < 2 || edge_hz >= 0.45 * rate_hz)
        return;
    const Biquad filter = butterworth(rate_hz, edge_hz);
    const size_t n = rows.size(), pad = std::min(n - 1, static_cast<size_t>(2 * rate_hz / cutoff_hz));
    std::vector<double> column(n + 2 * pad);
    for (size_t c = 0; c < rows[0].size(); ++c) {
        for (size_t i = 0; i < n; ++i)
            column[pad + i] = rows[i][c];
        for (size_t i = 1; i <= pad; ++i) {
            column[pad - i] = 2 * rows[0][c] - rows[i][c];
            column[pad + n - 1 + i] = 2 * rows[n - 1][c] - rows[n - 1 - i][c];
        }
        filter.run(column);
        std::reverse(column.begin(), column.end());
        filter.run(column);
        std::reverse(column.begin(), column.end());
        for (size_t i = 0; i < n; ++i)
            rows[i][c] = column[pad + i];
    }
}

}  // namespace noctule::simulation
