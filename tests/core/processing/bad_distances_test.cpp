// SPDX-License-Identifier: Apache-2.0
// Distances that cannot be, as writers of other programs may leave them: below 0, or in millimetres.
#include "core/processing/evaluate_take.h"
#include "core/report/take_verdict.h"
#include "core/report/verdict.h"
#include "tests/core/processing/made_take.h"
#include "tests/support/take_files.h"

namespace noctule {
namespace {

class BadDistances : public test::MadeTake {
protected:
    /// One distance of board 0 for each pulse.
    void setDistances(const std::string& sql) {
        test::runSql(
            path(),
            "CREATE TABLE IF NOT EXISTS range(run INTEGER, pulse INTEGER, suit INTEGER NOT NULL "
            "DEFAULT 1, board INTEGER, detector TEXT, arrival_sample REAL, distance_m REAL, w_s REAL, "
            "w_t REAL, w_a REAL, sigma_m REAL);"
            "DELETE FROM range WHERE run=0; INSERT INTO "
            "range(run,pulse,board,detector,arrival_sample,distance_m,w_s,w_t,w_a,sigma_m) "
            "SELECT 0,id,0,'inflection',sample+200," +
                sql + ",1,1,1,0.003 FROM pulse");
    }
    /// How many are read; why others are not.
    std::pair<int, std::string> read() const {
        const Take take = Take::open(path()).value();
        auto ranges = take.ranges(kPrimaryRun).value();
        int count = 0;
        for (auto range = ranges.next(); range && *range; range = ranges.next())
            ++count;
        const auto skipped = take.skippedRows();
        return {count, skipped.empty() ? "" : std::to_string(skipped[0].count) + ", " + skipped[0].first};
    }
};

TEST_F(BadDistances, AreSkippedCountedAndNamed) {
    setDistances("0.5");
    EXPECT_EQ(read(), std::pair(test::kPulses, std::string()));
    setDistances("CASE WHEN id%4=0 THEN -0.5 ELSE 0.5 END");
    EXPECT_EQ(read().first, test::kPulses * 3 / 4);
    EXPECT_NE(read().second.find("the distance is below 0"), std::string::npos) << read().second;
    setDistances("CASE WHEN id%4=0 THEN 21 ELSE 19 END");
    EXPECT_EQ(read().first, test::kPulses * 3 / 4);
    EXPECT_NE(read().second.find("beyond 20 m"), std::string::npos) << read().second;
    EXPECT_EQ(read().second.find("millimetres"), std::string::npos) << "most are good: " << read().second;
}

TEST_F(BadDistances, MillimetresAreGuessed) {
    setDistances("500");
    EXPECT_EQ(read().first, 0);
    EXPECT_EQ(read().second.find("240, row "), 0u) << read().second;
    EXPECT_NE(read().second.find("they look like millimetres"), std::string::npos) << read().second;
}

TEST_F(BadDistances, ATakeOfThemIsNeverGood) {
    addRuns("mine");
    addReference(0);
    const auto evaluate = [&] {
        EvaluateRequest request;
        request.take_path = path();
        return evaluateTake(request, {}).value();
    };
    const auto isNamed = [](const ReportData& data) {
        return std::ranges::count(judgeTake(data).reasons, VerdictReason::kDistances) > 0;
    };
    setDistances("0.5");
    EXPECT_FALSE(isNamed(evaluate()));
    setDistances("-1");
    const ReportData data = evaluate();
    EXPECT_EQ(data.distances_given, test::kPulses);
    EXPECT_EQ(data.distances_refused, test::kPulses);
    EXPECT_TRUE(isNamed(data));
    EXPECT_NE(judge(data).grade, Grade::kGood);
    const auto said = judge(data).reasons;
    EXPECT_TRUE(std::ranges::any_of(said, [](const std::string& reason) {
        return reason.find("of the take's distances cannot be") != std::string::npos;
    }));
}

}  // namespace
}  // namespace noctule
