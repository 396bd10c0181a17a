// SPDX-License-Identifier: Apache-2.0
#include "core/report/evaluation_json.h"

#include <gtest/gtest.h>

#include "core/report/verdict.h"
#include "tests/core/report/made_report.h"

namespace noctule {
namespace {

using namespace test;

TEST(EvaluationJson, HasTheDocumentedMembers) {
    const ReportData& data = shortReport();
    const nlohmann::json json = evaluationJson(data, *data.shownRun());
    EXPECT_EQ(json.at("take"), "boxer_001");
    EXPECT_EQ(json.at("run"), "AGD-manifold");
    EXPECT_EQ(json.at("sensors"), "AGD");
    EXPECT_EQ(json.at("joints").size(), 17u);
    const Comparison& c = *data.shownRun()->comparison;
    EXPECT_EQ(json.at("joints")[0].at("name"), c.joints[0].name);
    for (const char* member : {"mean_deg", "std_deg", "rms_deg"})
        EXPECT_TRUE(json.at("joints")[0].at(member).is_number()) << member;
    EXPECT_DOUBLE_EQ(json.at("mean_deg"), c.mean_deg);
    for (const char* member : {"end_effector_mm", "nees", "duration_s"})
        EXPECT_TRUE(json.at(member).is_number()) << member;
    for (const char* member : {"yaw_deg", "tilt_deg", "position_m"})
        EXPECT_TRUE(json.at("root").at(member).is_number()) << member;
    EXPECT_EQ(json.at("verdict"), "Usable") << "a board lost frames";
    EXPECT_NO_THROW((void)json.dump());
}

TEST(EvaluationJson, UnknownIsNullAndNeverNan) {
    ReportData data = madeReport(5);
    data.runs.back().comparison->nees.reset();
    data.runs.back().comparison->joints[0].angle.mean_deg = NAN;
    const nlohmann::json json = evaluationJson(data, data.runs.back());
    EXPECT_TRUE(json.at("nees").is_null());
    EXPECT_TRUE(json.at("joints")[0].at("mean_deg").is_null());
    data.runs.back().comparison.reset();
    const nlohmann::json without = evaluationJson(data, data.runs.back());
    EXPECT_TRUE(without.at("mean_deg").is_null());
    EXPECT_TRUE(without.at("root").at("yaw_deg").is_null());
    EXPECT_TRUE(without.at("joints").empty());
}

TEST(Verdict, FollowsTheError) {
    ReportData data = madeReport(5);
    for (size_t i = 0; i < data.boards.size(); ++i)
        data.boards[i].frames_lost = data.boards[i].clipped_accel = 0;
    data.boards[14].readings_present = data.boards[14].readings_expected;
    const auto gradeAt = [&](double mean_deg) {
        data.runs.back().comparison->mean_deg = mean_deg;
        return judge(data).grade;
    };
    EXPECT_EQ(gradeAt(1), Grade::kGood);
    EXPECT_EQ(gradeAt(5), Grade::kUsable);
    EXPECT_EQ(gradeAt(12), Grade::kNotUsable);
    EXPECT_EQ(gradeAt(NAN), Grade::kNotUsable);
    EXPECT_EQ(gradeAt(1), Grade::kGood);
    data.runs.back().comparison->joints[3].angle.mean_deg = 20;
    EXPECT_EQ(judge(data).grade, Grade::kUsable);
    data.boards[2].readings_present = 0;
    EXPECT_TRUE(has(judge(data).reasons.back(), "Chest (board 3) delivered 0 %"));
    data.take.reference_kind = "optical";
    EXPECT_TRUE(has(judge(data).headline, "against the optical reference"));
}

}  // namespace
}  // namespace noctule
