// SPDX-License-Identifier: Apache-2.0
#include "core/review/series.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace noctule {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Series randomSeries(size_t count, double gap_share, std::mt19937& random) {
    std::uniform_real_distribution<double> step_s(1e-4, 0.02);
    std::uniform_real_distribution<float> value(-5, 5);
    std::bernoulli_distribution gap(gap_share), long_gap(0.01 * gap_share);
    Series series;
    double t_s = 0.3;
    size_t silent = 0;
    for (size_t i = 0; i < count; ++i) {
        if (long_gap(random))
            silent = 200;
        series.t_s.push_back(t_s += step_s(random));
        series.value.push_back(silent > 0 || gap(random) ? kNan : value(random));
        silent -= silent > 0;
    }
    return series;
}

/// The definition, value by value.
std::vector<SeriesColumn> bruteColumns(const Series& series, double from_s, double to_s, int count) {
    std::vector<SeriesColumn> columns(static_cast<size_t>(count));
    if (!(to_s > from_s))
        return columns;
    const double width_s = (to_s - from_s) / count;
    for (int c = 0; c < count; ++c) {
        SeriesColumn& column = columns[static_cast<size_t>(c)];
        const double begin_s = from_s + c * width_s,
                     end_s = c + 1 == count ? to_s : from_s + (c + 1) * width_s;
        bool gap_so_far = false;
        for (size_t i = 0; i < series.t_s.size(); ++i) {
            if (series.t_s[i] >= end_s)
                break;
            const float value = series.value[i];
            const bool within = series.t_s[i] >= begin_s;
            if (std::isnan(value)) {
                gap_so_far = true;
                column.breaks = column.breaks || (column.empty && within);
                continue;
            }
            if (within && column.empty) {
                column = {value, value, value, value, false, gap_so_far};
            } else if (within) {
                column.min = std::min(column.min, value), column.max = std::max(column.max, value);
                column.last = value;
                column.breaks = column.breaks || gap_so_far;
            }
            gap_so_far = false;
        }
    }
    return columns;
}

void expectSame(const std::vector<SeriesColumn>& a, const std::vector<SeriesColumn>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); ++i) {
        SCOPED_TRACE(i);
        ASSERT_EQ(a[i].empty, b[i].empty);
        ASSERT_EQ(a[i].breaks, b[i].breaks);
        if (a[i].empty)
            continue;
        ASSERT_EQ(a[i].min, b[i].min);
        ASSERT_EQ(a[i].max, b[i].max);
        ASSERT_EQ(a[i].first, b[i].first);
        ASSERT_EQ(a[i].last, b[i].last);
    }
}

TEST(SeriesPyramid, ColumnsAreThoseOfTheDefinition) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> columns(1, 300);
    for (const size_t count : {0, 1, 2, 7, 8, 9, 63, 64, 65, 511, 513, 3000}) {
        for (const double gaps : {0.0, 0.1, 0.9, 1.0}) {
            const Series series = randomSeries(count, gaps, random);
            const SeriesPyramid pyramid(series);
            const double end_s = count > 0 ? series.t_s.back() + 0.5 : 1;
            std::uniform_real_distribution<double> time(-0.5, end_s);
            for (int round = 0; round < 8; ++round) {
                SCOPED_TRACE(testing::Message() << count << " values, gaps " << gaps << ", round " << round);
                double from_s = time(random), to_s = time(random);
                if (round == 0)
                    from_s = -1, to_s = end_s;
                if (round == 1)
                    to_s = from_s + 1e-3;
                const int n = columns(random);
                expectSame(pyramid.columns(from_s, to_s, n), bruteColumns(series, from_s, to_s, n));
            }
        }
    }
}

TEST(SeriesPyramid, BoundsAreThoseOfTheDefinition) {
    std::mt19937 random(11);
    const Series series = randomSeries(2000, 0.3, random);
    const SeriesPyramid pyramid(series);
    std::uniform_real_distribution<double> time(0, series.t_s.back());
    for (int round = 0; round < 200; ++round) {
        const double from_s = time(random), to_s = from_s + (round % 2 == 0 ? 0.01 : 3);
        float low = std::numeric_limits<float>::infinity(), high = -low;
        for (size_t i = 0; i < series.t_s.size(); ++i)
            if (series.t_s[i] >= from_s && series.t_s[i] <= to_s && !std::isnan(series.value[i]))
                low = std::min(low, series.value[i]), high = std::max(high, series.value[i]);
        EXPECT_EQ(pyramid.bounds(from_s, to_s), std::pair(low, high));
    }
    const auto [low, high] = pyramid.bounds(series.t_s.back() + 1, series.t_s.back() + 2);
    EXPECT_GT(low, high);
}

TEST(SeriesPyramid, BoundsHoldBothEnds) {
    const SeriesPyramid pyramid({{1, 2, 3}, {-1, 0, 1}});
    EXPECT_EQ(pyramid.bounds(1, 3), (std::pair<float, float>(-1, 1)));
    EXPECT_EQ(pyramid.bounds(3, 3), (std::pair<float, float>(1, 1)));
}

TEST(SeriesPyramid, OddWindowsAreEmpty) {
    const SeriesPyramid pyramid({{1, 2, 3}, {1, 2, 3}});
    EXPECT_TRUE(pyramid.columns(0, 4, 0).empty());
    EXPECT_TRUE(pyramid.columns(0, 4, -3).empty());
    for (const auto& [from_s, to_s] :
         {std::pair(2.0, 2.0), std::pair(3.0, 1.0), std::pair(std::nan(""), 2.0), std::pair(5.0, 9.0)})
        for (const SeriesColumn& column : pyramid.columns(from_s, to_s, 4))
            EXPECT_TRUE(column.empty);
    EXPECT_TRUE(SeriesPyramid().empty());
    EXPECT_TRUE(SeriesPyramid().columns(0, 1, 2)[1].empty);
}

TEST(SeriesPyramid, FindsTheValueAtATime) {
    const SeriesPyramid pyramid({{1, 2, 4}, {1, kNan, 3}});
    EXPECT_EQ(pyramid.indexAt(0.9), pyramid.size());
    EXPECT_EQ(pyramid.indexAt(1), 0u);
    EXPECT_EQ(pyramid.indexAt(3.9), 1u);
    EXPECT_EQ(pyramid.indexAt(100), 2u);
    EXPECT_EQ(SeriesPyramid().indexAt(0), 0u);
}

TEST(Series, LeavesOutTimesThatDoNotAdvance) {
    const Series series = makeSeries({0, 1, 1, 0.5, std::nan(""), 2}, {0, 1, 2, 3, 4, 5});
    EXPECT_EQ(series.t_s, (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(series.value, (std::vector<float>{0, 1, 5}));
    EXPECT_THROW((void)makeSeries({0, 1}, {0}), std::logic_error);
}

/// How quick it is, tests/benchmark/review.cpp measures.
TEST(SeriesPyramid, OfTenMillionValuesTheHighestIsSeen) {
    Series series;
    for (size_t i = 0; i < 10'000'000; ++i) {
        series.t_s.push_back(static_cast<double>(i) * 1e-4);
        series.value.push_back(i > 3'000'000 && i < 7'000'000 ? kNan : static_cast<float>(i % 1000));
    }
    const SeriesPyramid pyramid(std::move(series));
    const auto columns = pyramid.columns(0, 1000, 2000);
    EXPECT_EQ(columns[1].max, 999);
    EXPECT_EQ(columns[1].min, 0);
    EXPECT_TRUE(columns[1000].empty) << "in the midst of the gap";
}

}  // namespace
}  // namespace noctule
