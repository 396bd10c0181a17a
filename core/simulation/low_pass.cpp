// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/low_pass.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/butterworth.h"

namespace noctule::simulation {
namespace {

/// Starts settled on the first value.
void run(const Biquad& filter, std::vector<double>& x) {
    double x1 = x.front(), x2 = x1, y1 = x1, y2 = x1;
    for (double& value : x) {
        const double y =
            filter.b0 * value + filter.b1 * x1 + filter.b2 * x2 - filter.a1 * y1 - filter.a2 * y2;
        x2 = x1;
        x1 = value;
        y2 = y1;
        y1 = value = y;
    }
}

}  // namespace

void lowPassZeroPhase(std::vector<std::vector<double>>& rows, double rate_hz, double cutoff_hz) {
    const double edge_hz = cutoff_hz / std::pow(std::numbers::sqrt2 - 1, 0.25);
    if (rows.size() < 2 || edge_hz >= 0.45 * rate_hz)
        return;
    const Biquad filter = butterworthLowPass(2, edge_hz, rate_hz).front();
    const size_t n = rows.size(), pad = std::min(n - 1, static_cast<size_t>(2 * rate_hz / cutoff_hz));
    std::vector<double> column(n + 2 * pad);
    for (size_t c = 0; c < rows[0].size(); ++c) {
        for (size_t i = 0; i < n; ++i)
            column[pad + i] = rows[i][c];
        for (size_t i = 1; i <= pad; ++i) {
            column[pad - i] = 2 * rows[0][c] - rows[i][c];
            column[pad + n - 1 + i] = 2 * rows[n - 1][c] - rows[n - 1 - i][c];
        }
        run(filter, column);
        std::reverse(column.begin(), column.end());
        run(filter, column);
        std::reverse(column.begin(), column.end());
        for (size_t i = 0; i < n; ++i)
            rows[i][c] = column[pad + i];
    }
}

}  // namespace noctule::simulation
