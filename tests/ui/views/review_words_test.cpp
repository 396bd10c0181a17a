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

TEST(ReviewWords, AResultOfSeveralSaysWhoWasProcessedAndHow) {
    ReviewRun run;
    EXPECT_EQ(peopleInWords(run), "") << "one performer";
    run.run.settings_json = R"({"subjects":[{"name":"Ada","suit":1},{"name":"Ben","suit":2}]})";
    EXPECT_EQ(peopleInWords(run), "Ada, Ben: each alone, without ranges between them");
    run.settings.between = true;
    EXPECT_EQ(peopleInWords(run), "Ada, Ben: together, with ranges between them");
    run.settings.unjoined = {2};
    EXPECT_EQ(peopleInWords(run), "Ada, Ben: together, with ranges between them; could not be joined: Ben");
    run.settings = {};
    run.settings.uses_room = true;
    EXPECT_EQ(peopleInWords(run), "Ada, Ben: together, with ranges to the room");
    run.settings.root_given = true;
    EXPECT_EQ(peopleInWords(run), "Ada, Ben: each alone, placed by another system");
}

}  // namespace
}  // namespace noctule::ui
