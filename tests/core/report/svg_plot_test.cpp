// SPDX-License-Identifier: Apache-2.0
#include "core/report/svg_plot.h"

#include <gtest/gtest.h>

#include <regex>

#include "tests/core/report/made_report.h"

namespace noctule {
namespace {

using namespace test;

TEST(SvgPlot, DecimationKeepsExtremesAndBreaksAtHoles) {
    std::vector<double> time_s, values;
    for (int i = 0; i < 100000; ++i) {
        time_s.push_back(i * 0.001 + (i > 50000 ? 5 : 0));
        values.push_back(i == 20000 ? 10 : i % 2 ? 1.0 : -1.0);
    }
    values[70000] = NAN;
    const std::string path = decimatedPath(time_s, values, {0, 105}, {-10, 10}, {0, 500}, {0, 100});
    EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 3);
    EXPECT_TRUE(has(path, " 0 ")) << "the single spike reaches the top";
    EXPECT_LT(path.size(), 16000u);
    EXPECT_FALSE(std::regex_search(path, std::regex("[^-M0-9. ]")));
}

TEST(SvgPlot, ABandBreaksWhereItsCurveBreaks) {
    std::vector<double> time_s, middle, half_width(600, 5);
    for (int i = 0; i < 600; ++i) {
        time_s.push_back(0.02 * i + (i < 400 ? 0 : 2));  // a hole of two seconds
        middle.push_back(i < 200 ? 170 : -170);
    }
    middle[200] = NAN;  // it goes round
    LinePlot plot;
    plot.time_s = {0, 14};
    plot.values = {-180, 180};
    plot.bands.push_back({time_s, middle, half_width});
    std::string band = svg(plot);
    band = band.substr(band.find("<path class=\"band\" d=\""));
    band = band.substr(0, band.find("/>"));
    EXPECT_EQ(std::count(band.begin(), band.end(), 'M'), 3);
    EXPECT_EQ(std::count(band.begin(), band.end(), 'Z'), 3);
    half_width[450] = INFINITY;
    EXPECT_EQ(std::ranges::count(svg(plot), 'Z'), 4) << "nothing is known of one instant";
}

TEST(SvgPlot, TicksAreRoundAndFew) {
    const std::vector<double> tens = ticks({-5, 42}, 5);
    EXPECT_EQ(tens, (std::vector<double>{0, 10, 20, 30, 40}));
    for (const double top : {0.03, 0.7, 1.0, 3.3, 17.0, 99.0, 1234.0}) {
        const std::vector<double> values = ticks({0, top}, 5);
        EXPECT_GE(values.size(), 2u) << top;
        EXPECT_LE(values.size(), 6u) << top;
    }
    EXPECT_TRUE(ticks({1, 1}, 5).empty());
    const std::vector<double> nothing = {NAN, INFINITY};
    EXPECT_EQ(niceInterval({nothing}, 2).span(), 2);
    const std::vector<double> some = {-3.2, 14.1};
    EXPECT_LE(niceInterval({some}, 1).min, -3.2);
    EXPECT_GE(niceInterval({some}, 1).max, 14.1);
    EXPECT_LE(timeTicks({0, 307}).size(), 11u);
}

}  // namespace
}  // namespace noctule
