// SPDX-License-Identifier: Apache-2.0
#include "core/recording/derived_cursor.h"

#include <gtest/gtest.h>

#include "tests/support/files.h"

namespace noctule {
namespace {

/// What SQLite says that it does, a line for each step.
std::string planOf(const Database& database, const std::string& query) {
    auto rows = database.prepare("EXPLAIN QUERY PLAN " + query);
    if (!rows)
        return rows.error().text();
    std::string plan;
    for (auto row = rows->step(); row && *row; row = rows->step())
        plan += rows->text(3).value_or("") + "\n";
    return plan;
}

TEST(RangeCursor, NothingIsSortedAndNothingIsSearchedThrough) {
    const test::Folder folder;
    const auto database = Database::create(folder.file("take.noctule"));
    ASSERT_TRUE(database) << database.error().text();
    auto schema = TakeSchema::read(*database);
    ASSERT_TRUE(schema && schema->complete(*database, "pulse") && schema->complete(*database, "range"));
    SkipLog log;
    RunOfTake run{&*database, &*schema, &log, 1, 1, 18, 8};
    for (const bool some : {false, true}) {
        if (some)
            run.pulses = std::pair(int64_t{3}, int64_t{9});
        const std::string plan = planOf(*database, RangeCursor::query(run));
        EXPECT_NE(plan.find("SEARCH range USING INDEX"), std::string::npos) << plan;
        EXPECT_NE(plan.find("SEARCH pulse USING INTEGER PRIMARY KEY"), std::string::npos) << plan;
        EXPECT_EQ(plan.find("TEMP B-TREE"), std::string::npos) << plan;
    }
}

}  // namespace
}  // namespace noctule
