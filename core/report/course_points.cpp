// SPDX-License-Identifier: Apache-2.0
#include "core/report/course_points.h"

#include <algorithm>
#include <cmath>

namespace noctule {
namespace {

void append(CoursePoints& points, double time_s, double value, double half_width) {
    points.time_s.push_back(time_s);
    points.values.push_back(value);
    points.half_width.push_back(half_width);
}

double turnOf(double angle_deg) {
    return std::ceil((angle_deg - 180) / 360);
}

}  // namespace

CoursePoints pointsOf(const Course& course, const Course& sigma) {
    CoursePoints points;
    for (size_t i = 0; i < course.stretches().size(); ++i) {
        const auto& [time_s, first, second] = course.stretches()[i];
        double half_width = 0;
        if (i < sigma.stretches().size())
            half_width = 2 * std::max(sigma.stretches()[i].first, sigma.stretches()[i].second);
        append(points, time_s, first, half_width);
        if (second != first)
            append(points, time_s, second, half_width);
    }
    return points;
}

CoursePoints withinHalfTurn(const CoursePoints& angles_deg) {
    CoursePoints within;
    for (size_t i = 0; i < angles_deg.values.size(); ++i) {
        const double time_s = angles_deg.time_s[i], angle_deg = angles_deg.values[i];
        const double half_width = angles_deg.half_width[i], turn = turnOf(angle_deg);
        const double before_deg = i > 0 ? angles_deg.values[i - 1] : angle_deg;
        const double side = angle_deg < before_deg ? -1 : 1;
        for (double passed = turnOf(before_deg); passed * side < turn * side; passed += side) {
            const double edge_deg = 360 * passed + 180 * side;
            const double share = (edge_deg - before_deg) / (angle_deg - before_deg);
            const double edge_s = std::lerp(angles_deg.time_s[i - 1], time_s, share);
            append(within, edge_s, 180 * side, half_width);
            append(within, edge_s, NAN, NAN);
            append(within, edge_s, -180 * side, half_width);
        }
        append(within, time_s, angle_deg - 360 * turn, half_width);
    }
    return within;
}

}  // namespace noctule
