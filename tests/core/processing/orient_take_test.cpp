// SPDX-License-Identifier: Apache-2.0
#include "core/processing/orient_take.h"

#include "tests/core/processing/made_take.h"
#include "tests/support/take_files.h"

namespace noctule {
namespace {

class OrientTake : public test::MadeTake {
protected:
    std::string refusal() const {
        OrientRequest request;
        request.take_path = path();
        request.run_name = "mine";
        request.estimator = findOrientationEstimator("noctule");
        const auto summary = orientTake(request, {});
        return summary ? "" : summary.error().text();
    }
};

TEST_F(OrientTake, SaysWhichTakeItNeedsWhatThisOneIsAndWhatGivesAMotion) {
    const std::string command = "noctule --batch process " + path();
    test::runSql(path(), "DELETE FROM inertial");
    EXPECT_NE(refusal().find("no board has readings"), std::string::npos) << refusal();

    auto take = Take::open(path(), Access::kReadWrite);
    ASSERT_TRUE(take);
    auto edit = TakeEdit::begin(*take);
    ASSERT_TRUE(edit);
    ASSERT_TRUE(edit->beginRun({0, "orientation", "theirs", "", "", "{}", {}, {}}));
    ASSERT_TRUE(edit->commit());
    EXPECT_NE(refusal().find("holds attitudes that came with it"), std::string::npos) << refusal();
    EXPECT_NE(refusal().find(command + " --estimator orientation"), std::string::npos) << refusal();

    test::runSql(path(), "UPDATE meta SET value='signal' WHERE key='level'");
    EXPECT_NE(refusal().find("holds the sound of a driver box"), std::string::npos) << refusal();
    EXPECT_NE(refusal().find("needs a take of inertial sensors"), std::string::npos) << refusal();
    EXPECT_NE(refusal().find(command + "`"), std::string::npos) << refusal();
}

}  // namespace
}  // namespace noctule
