// SPDX-License-Identifier: Apache-2.0
#include "core/review/series_csv.h"

#include <gtest/gtest.h>

#include <limits>

namespace noctule {
namespace {

std::shared_ptr<const SeriesPyramid> pyramid(std::vector<double> t_s, std::vector<float> value) {
    return std::make_shared<SeriesPyramid>(Series{std::move(t_s), std::move(value)});
}

TEST(SeriesCsv, JoinsCurvesOfDifferentTimes) {
    const std::string csv = seriesCsv(
        {{"angle (deg)", pyramid({0, 1, 2}, {1.5f, -2, 3})}, {"distance (m)", pyramid({1, 1.5}, {0.25f, 4})}},
        0, 10);
    EXPECT_EQ(csv,
              "time_s,angle (deg),distance (m)\n"
              "0.000000,1.5,\n"
              "1.000000,-2,0.25\n"
              "1.500000,,4\n"
              "2.000000,3,\n");
}

TEST(SeriesCsv, KeepsToTheTimesAskedFor) {
    EXPECT_EQ(seriesCsv({{"a", pyramid({0, 1, 2, 3}, {1, 2, 3, 4})}}, 1, 2),
              "time_s,a\n1.000000,2\n2.000000,3\n");
}

TEST(SeriesCsv, QuotesNamesAndLeavesMissingValuesEmpty) {
    EXPECT_EQ(seriesCsv({{"knee, \"left\"", pyramid({0}, {std::numeric_limits<float>::quiet_NaN()})}}, 0, 1),
              "time_s,\"knee, \"\"left\"\"\"\n0.000000,\n");
}

TEST(SeriesCsv, WithoutCurvesIsTheHeader) {
    EXPECT_EQ(seriesCsv({}, 0, 1), "time_s\n");
}

}  // namespace
}  // namespace noctule
