// SPDX-License-Identifier: Apache-2.0
// Points of a plot's line that draw a course.
#pragma once

#include <vector>

#include "core/motion/course.h"

namespace noctule {

/// All equally long.
struct CoursePoints {
    std::vector<double> time_s, values;
    std::vector<double> half_width;  ///< of a band about the values; 0 without sigmas
};

/// `sigma`: of the same instants, or empty; the band is two of them wide to each side.
CoursePoints pointsOf(const Course& course, const Course& sigma = {});

/// The same angles within (-180, 180] degrees. A line that passes half a turn ends at the one edge, and
/// begins anew, after a value that is NaN, at the other.
CoursePoints withinHalfTurn(const CoursePoints& angles_deg);

}  // namespace noctule
