// SPDX-License-Identifier: Apache-2.0
#include "core/motion/course.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace noctule {
namespace {

TEST(Course, HoldsEveryFrameOfAShortTake) {
    Course course;
    for (size_t i = 0; i < Course::kMost; ++i)
        course.add(0.01 * static_cast<double>(i), std::sin(static_cast<double>(i)));
    ASSERT_EQ(course.stretches().size(), Course::kMost);
    for (size_t i = 0; i < Course::kMost; ++i) {
        ASSERT_EQ(course.stretches()[i].time_s, 0.01 * static_cast<double>(i));
        ASSERT_EQ(course.stretches()[i].first, std::sin(static_cast<double>(i)));
        ASSERT_EQ(course.stretches()[i].second, course.stretches()[i].first);
    }
}

TEST(Course, AnHourIsBoundedAndKeepsPeaksInTheirOrderAndPlace) {
    Course course;
    constexpr int kFrames = 3600 * 120, kHigh = 200'001, kLow = 200'002;
    for (int i = 0; i < kFrames; ++i)
        course.add(i / 120.0, i == kHigh ? 50 : i == kLow ? -70 : std::sin(0.01 * i));
    const auto& stretches = course.stretches();
    EXPECT_LE(stretches.size(), Course::kMost);
    EXPECT_GE(stretches.size(), Course::kMost / 2 - 1);
    EXPECT_EQ(stretches.front().time_s, 0);
    for (size_t i = 1; i < stretches.size(); ++i)
        ASSERT_LE(stretches[i].time_s - stretches[i - 1].time_s, 3600.0 / 1000) << "less than a pixel";
    const auto peak = std::find_if(stretches.begin(), stretches.end(),
                                   [](const Course::Stretch& stretch) { return stretch.first == 50; });
    ASSERT_NE(peak, stretches.end());
    EXPECT_EQ(peak->second, -70);
    EXPECT_NEAR(peak->time_s, kHigh / 120.0, 3.6);
}

TEST(Course, EqualTimesMakeEqualStretchesWhateverTheValues) {
    Course one, other;
    for (int i = 0; i < 30'000; ++i) {
        const double time_s = i / 120.0 + (i > 12'345 ? 100 : 0);
        one.add(time_s, std::cos(0.3 * i));
        other.add(time_s, i % 7);
    }
    ASSERT_EQ(one.stretches().size(), other.stretches().size());
    for (size_t i = 0; i < one.stretches().size(); ++i)
        ASSERT_EQ(one.stretches()[i].time_s, other.stretches()[i].time_s);
}

}  // namespace
}  // namespace noctule
