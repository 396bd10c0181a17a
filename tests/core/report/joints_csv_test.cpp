// SPDX-License-Identifier: Apache-2.0
#include "core/report/joints_csv.h"

#include <gtest/gtest.h>

#include <sstream>

namespace noctule {
namespace {

TEST(JointsCsv, HasARowPerJointAndRunAndQuotesNames) {
    ReportData data;
    data.take.name = "walk, \"fast\"";
    ReportRun run;
    run.name = "AG";
    run.sensors = "AG";
    run.estimator = "manifold";
    run.comparison.emplace();
    JointComparison elbow{"LeftForeArm", "LeftArm", false, {}, 12.5, std::nullopt};
    elbow.angle.mean_deg = 1.25;
    elbow.angle.p95_deg = NAN;
    run.comparison->joints = {elbow, elbow};
    data.runs = {run, ReportRun{}};

    std::istringstream csv(jointsCsv({{"Anna", data}, {"Ben", data}}));
    std::string header, row;
    std::getline(csv, header);
    std::getline(csv, row);
    EXPECT_EQ(std::ranges::count(header, ','), 16);
    EXPECT_EQ(row,
              "\"walk, "
              "\"\"fast\"\"\",Anna,AG,AG,manifold,none,LeftForeArm,LeftArm,1.25,0.0,0.0,0.0,,0.0,0.0,12.5,");
    EXPECT_TRUE(std::getline(csv, row)) << "the second joint";
    EXPECT_TRUE(std::getline(csv, row) && row.find(",Ben,") != std::string::npos) << row;
    EXPECT_TRUE(std::getline(csv, row));
    EXPECT_FALSE(std::getline(csv, row)) << "a run that was not compared has none";
}

}  // namespace
}  // namespace noctule
