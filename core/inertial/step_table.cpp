// SPDX-License-Identifier: Apache-2.0
#include "core/inertial/step_table.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/job/contract.h"

namespace noctule {
namespace {

std::array<int, 64> sortedSteps() {
    std::array<int, 64> steps = kSteps;
    std::sort(steps.begin(), steps.end());
    return steps;
}

}  // namespace

int stepped(int reconstruction, int code) {
    return std::clamp(reconstruction + kSteps[code], 0, 4095);
}

int nearestCode(int reconstruction, int target) {
    int best = 0, best_distance = std::abs(reconstruction - target);
    for (int code = 1; code < 64; ++code) {
        const int distance = std::abs(stepped(reconstruction, code) - target);
        if (distance < best_distance ||
            (distance == best_distance && std::abs(kSteps[code]) < std::abs(kSteps[best]))) {
            best = code;
            best_distance = distance;
        }
    }
    return best;
}

double codecRoundingSigmaCounts(double step_counts) {
    require(std::isfinite(step_counts), "codecRoundingSigmaCounts: step is not finite");
    static const std::array<int, 64> steps = sortedSteps();
    const auto above = std::lower_bound(steps.begin(), steps.end(), step_counts);
    size_t i = std::min<size_t>(above - steps.begin(), steps.size() - 1);
    if (i > 0 && step_counts - steps[i - 1] < steps[i] - step_counts)
        --i;
    // The outermost entries have one neighbour; its gap serves for both sides.
    const int gap_below = i > 0 ? steps[i] - steps[i - 1] : steps[1] - steps[0];
    const int gap_above = i + 1 < steps.size() ? steps[i + 1] - steps[i] : gap_below;
    const double a = gap_below / 2.0, b = gap_above / 2.0;
    return std::sqrt((a * a * a + b * b * b) / (3 * (a + b)));
}

}  // namespace noctule
