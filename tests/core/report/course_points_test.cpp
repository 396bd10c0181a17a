// SPDX-License-Identifier: Apache-2.0
#include "core/report/course_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/report/svg_plot.h"

namespace noctule {
namespace {

constexpr Interval kColumns{0, 932}, kRows{0, 100};

TEST(CoursePoints, AShortCourseIsDrawnFrameByFrame) {
    Course course, sigma;
    std::vector<double> time_s, values;
    for (int i = 0; i < 2000; ++i) {
        time_s.push_back(0.01 * i), values.push_back(std::sin(0.05 * i));
        course.add(time_s.back(), values.back());
        sigma.add(time_s.back(), 0.5);
    }
    const CoursePoints points = pointsOf(course, sigma);
    EXPECT_EQ(points.time_s, time_s);
    EXPECT_EQ(points.values, values);
    EXPECT_EQ(points.half_width, std::vector<double>(2000, 1));
    EXPECT_EQ(withinHalfTurn(points).values, values);
}

TEST(CoursePoints, AnHourIsDrawnWithItsPeakAndItsHole) {
    Course course;
    for (int i = 0; i < 3600 * 120; ++i)
        if (i < 240'000 || i > 242'400)  // 20 s without a frame
            course.add(i / 120.0, i == 77'777 ? 10 : 0.1 * std::sin(0.001 * i));
    const CoursePoints points = pointsOf(course);
    EXPECT_LE(points.values.size(), 2 * Course::kMost);
    const std::string path =
        decimatedPath(points.time_s, points.values, {0, 3600}, {-10, 10}, kColumns, kRows);
    EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 2) << "broken at the hole alone";
    EXPECT_NE(path.find(" 0 "), std::string::npos) << "the peak of one frame reaches the top";
}

TEST(CoursePoints, ALineThatPassesHalfATurnGoesOnAtTheOtherEdge) {
    Course course;
    for (const auto& [time_s, angle_deg] : {std::pair{0.0, 170.0}, {0.1, 190.0}, {0.2, 150.0}})
        course.add(time_s, angle_deg);
    const CoursePoints within = withinHalfTurn(pointsOf(course));
    const std::vector<double> values = {170, 180, NAN, -180, -170, -180, NAN, 180, 150};
    const std::vector<double> time_s = {0, 0.05, 0.05, 0.05, 0.1, 0.125, 0.125, 0.125, 0.2};
    ASSERT_EQ(within.values.size(), values.size());
    for (size_t i = 0; i < values.size(); ++i) {
        EXPECT_NEAR(within.time_s[i], time_s[i], 1e-9) << i;
        if (std::isnan(values[i]))
            EXPECT_TRUE(std::isnan(within.values[i])) << i;
        else
            EXPECT_NEAR(within.values[i], values[i], 1e-9) << i;
    }
}

TEST(CoursePoints, AnAngleOfAnHourIsBrokenWhereItGoesRound) {
    Course course;
    for (int i = 0; i < 3600 * 120; ++i)
        course.add(i / 120.0, i / 120.0 - 100);  // to 3500 degrees: ten times past half a turn
    const CoursePoints within = withinHalfTurn(pointsOf(course));
    for (const double value : within.values)
        ASSERT_FALSE(std::abs(value) > 180);
    EXPECT_EQ(std::ranges::count_if(within.values, [](double value) { return std::isnan(value); }), 10);
    for (size_t i = 1; i < within.values.size(); ++i)
        ASSERT_FALSE(std::abs(within.values[i] - within.values[i - 1]) > 10) << "no stroke across the plot";
}

}  // namespace
}  // namespace noctule
