// SPDX-License-Identifier: Apache-2.0
#include "ui/jobs/remaining_time.h"

#include <algorithm>
#include <cmath>

namespace noctule::ui {
namespace {

constexpr double kShortest_s = 1, kSmallestFraction = 0.02, kSmoothing_s = 2;

}  // namespace

void RemainingTime::report(double elapsed_s, double fraction) {
    const double step_s = elapsed_s - now_s_;
    now_s_ = elapsed_s;
    if (fraction < fraction_) {
        began_s_ = elapsed_s;
        left_s_.reset();
    }
    fraction_ = fraction;
    const double spent_s = elapsed_s - began_s_;
    if (spent_s < kShortest_s || fraction < kSmallestFraction)
        return;
    const double estimate_s = spent_s * (1 - fraction) / fraction;
    if (!left_s_) {
        left_s_ = estimate_s;
        return;
    }
    const double expected_s = std::max(0.0, *left_s_ - step_s);
    left_s_ = expected_s + (estimate_s - expected_s) * (1 - std::exp(-step_s / kSmoothing_s));
}

std::optional<int> RemainingTime::seconds() const {
    if (!left_s_)
        return std::nullopt;
    return static_cast<int>(std::ceil(*left_s_));
}

}  // namespace noctule::ui
