// SPDX-License-Identifier: Apache-2.0
// What Review says of results, without its page.
#include "ui/views/review_words.h"

#include <gtest/gtest.h>

namespace noctule::ui {
namespace {

TEST(ReviewWords, AResultWithoutGyroscopesSaysHowToGetABetterOne) {
    TakeVerdict verdict;
    verdict.grade = Grade::kNotUsable;
    verdict.reasons = {VerdictReason::kNoGyroscopes};
    for (const auto& [sensors, title] :
         {std::pair{"D", "Made of distances only"}, std::pair{"A", "Made of accelerometers only"},
          std::pair{"AD", "Made without gyroscopes"}}) {
        verdict.sensors = sensors;
        EXPECT_FALSE(gradeExplained(verdict).contains("inertia"));
        const auto problems = problemsInWords(verdict, TakeOverview{});
        ASSERT_EQ(problems.size(), 1U);
        EXPECT_EQ(problems[0].title, title);
        EXPECT_TRUE(problems[0].text.startsWith("No gyroscope was used, so the angles are guesses."));
        EXPECT_TRUE(problems[0].processes);
        EXPECT_TRUE(problems[0].with_gyroscopes) << "the last result's sensors are not proposed again";
    }
}

}  // namespace
}  // namespace noctule::ui
