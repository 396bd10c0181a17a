// SPDX-License-Identifier: Apache-2.0
// Sound pages below a damaged one are found again.
#include "core/recording/lost_branches.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/recording/recover_take.h"
#include "core/recording/take.h"
#include "tests/support/take_files.h"

namespace noctule {
namespace {

using test::Folder;

/// Of the page that leads to all others of the table.
void damageRootOf(const std::string& path, const std::string& table) {
    int64_t root = 0, page_bytes = 0;
    {
        const Result<Database> database = Database::open(path, Access::kRead);
        root = database
                   ->queryInteger("SELECT rootpage FROM sqlite_schema WHERE type='table' AND name='" + table +
                                  "'")
                   ->value();
        page_bytes = database->queryInteger("PRAGMA page_size")->value();
    }
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp((root - 1) * page_bytes);
    file << std::string(static_cast<size_t>(page_bytes), '\xff');
}

int64_t sumOf(const std::string& path, const std::string& expression, const std::string& table) {
    const Result<Database> database = Database::open(path, Access::kRead);
    const auto sum = database->queryInteger("SELECT " + expression + " FROM " + table);
    EXPECT_TRUE(sum && *sum) << table;
    return sum && *sum ? **sum : -1;
}

TEST(LostBranches, AllRowsBelowADamagedRootAreSaved) {
    const std::pair<const char*, const char*> tables[] = {
        {"adc_block", "sum(id)"}, {"reference", "sum(time_ns)"}, {"external_root", "sum(time_ns)"}};
    for (const auto& [table, sum] : tables) {
        SCOPED_TRACE(table);
        const Folder folder;
        const std::string torn = test::tinyTake(folder), saved = folder.file("saved.noctule");
        damageRootOf(torn, table);
        const auto done = recoverTake(torn, saved, {});
        ASSERT_TRUE(done) << done.error().text();
        ASSERT_TRUE(*done && (*done)->tables.size() == 1) << "that something is missing cannot be excluded";
        EXPECT_EQ((*done)->tables[0].table, table);
        EXPECT_FALSE((*done)->tables[0].lost);
        EXPECT_EQ(sumOf(saved, "count(*)", table), sumOf(test::kTinyTake, "count(*)", table));
        EXPECT_EQ(sumOf(saved, sum, table), sumOf(test::kTinyTake, sum, table));
    }
}

TEST(LostBranches, TablesThatAreDamagedTogetherAreToldApart) {
    const Folder folder;
    const std::string torn = test::tinyTake(folder), saved = folder.file("saved.noctule");
    for (const char* table : {"adc_block", "reference", "external_root"})
        damageRootOf(torn, table);
    const auto done = recoverTake(torn, saved, {});
    ASSERT_TRUE(done) << done.error().text();
    for (const char* table : {"adc_block", "reference", "external_root"})
        EXPECT_EQ(sumOf(saved, "count(*)", table), sumOf(test::kTinyTake, "count(*)", table)) << table;
    EXPECT_EQ(sumOf(saved, "sum(length(data))", "adc_block"),
              sumOf(test::kTinyTake, "sum(length(data))", "adc_block"));
}

TEST(LostBranches, RowsThatWereRemovedDoNotComeBack) {
    const Folder folder;
    const std::string torn = test::tinyTake(folder), saved = folder.file("saved.noctule");
    test::runSql(torn,
                 "DELETE FROM reference WHERE rowid % 3 = 0 OR rowid > (SELECT max(rowid)/2 FROM reference)");
    const int64_t rows = sumOf(torn, "count(*)", "reference");
    damageRootOf(torn, "reference");
    const auto done = recoverTake(torn, saved, {});
    ASSERT_TRUE(done) << done.error().text();
    EXPECT_EQ(sumOf(saved, "count(*)", "reference"), rows);
}

TEST(LostBranches, NothingIsMendedInAWholeTake) {
    const Folder folder;
    const std::string whole = test::tinyTake(folder);
    const std::string before = test::readBytes(whole);
    EXPECT_TRUE(mendBranches(whole, {}).empty());
    EXPECT_EQ(test::readBytes(whole), before);
}

}  // namespace
}  // namespace noctule
