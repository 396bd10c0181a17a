// SPDX-License-Identifier: Apache-2.0
// Rauch-Tung-Striebel smoothing of orientation_filter.h: goes back over the steps of the filter, then
// integrates the gyroscope anew between the smoothed attitudes. Holds 3.6 kB a step, 260 MB an hour.
#pragma once

#include <vector>

#include "core/orientation/error_filter.h"

namespace noctule::orientation {

/// What the filter was at the end of a step, after its corrections.
struct FilteredStep {
    Transition transition;  ///< that led here
    ErrorMatrix P;
    ErrorVector error;  ///< the corrections that were added here
    Nominal nominal;
};

class Smoother {
public:
    Smoother(const ImuSamples& samples, const OrientationSettings& settings, size_t per_step)
        : samples_(samples), settings_(settings), per_step_(per_step) {}

    void push(FilteredStep step) { steps_.push_back(std::move(step)); }
    /// Replaces what `out` holds by the smoothed estimate.
    void run(OrientationRun& out);

private:
    void smoothSteps();
    void integrateBetween(size_t step, OrientationRun& out) const;

    const ImuSamples& samples_;
    const OrientationSettings& settings_;
    size_t per_step_;
    std::vector<FilteredStep> steps_;
};

}  // namespace noctule::orientation
