// SPDX-License-Identifier: Apache-2.0
#include "core/processing/run_command.h"

#include <gtest/gtest.h>

#include "core/live/estimators.h"

namespace noctule {
namespace {

DerivedRun runWith(const std::string& settings) {
    DerivedRun run;
    run.name = "second try";
    run.settings_json = settings;
    return run;
}

TEST(RunCommand, HoldsEveryOptionOfTheRun) {
    const std::string settings = R"({"sensors":"AG","root":"free","estimator":"manifold","smooth":"full",)"
                                 R"("detector":"matched","ground":"uneven"})";
    EXPECT_EQ(
        commandOfRun(runWith(settings), "/anywhere/jane's walk.noctule"),
        "noctule --batch process 'jane'\\''s walk.noctule' --sensors AG --root free --estimator manifold "
        "--smooth full --detector matched --ground uneven --run-name 'second try'");
}

TEST(RunCommand, NamesOnlyParametersThatWereChanged) {
    const EstimatorEntry& manifold = *findEstimator("manifold");
    const ParameterDescription &first = manifold.parameters[0], &second = manifold.parameters[1];
    const double changed = first.usual + 0.25;
    const nlohmann::json settings{{"estimator", "manifold"},
                                  {"parameters", {{first.name, changed}, {second.name, second.usual}}}};
    const std::string command = commandOfRun(runWith(settings.dump()), "walk.noctule");
    EXPECT_NE(command.find("--param " + first.name + "=" + nlohmann::json(changed).dump()), std::string::npos)
        << command;
    EXPECT_EQ(command.find(second.name + "="), std::string::npos) << command;
}

TEST(RunCommand, ARunThatDoesNotSayHowItWasMadeHasNone) {
    for (const char* settings : {"", "[]", "{}", R"({"estimator":"of tomorrow"})", R"({"estimator":7})"})
        EXPECT_EQ(commandOfRun(runWith(settings), "walk.noctule"), "") << settings;
}

}  // namespace
}  // namespace noctule
