// SPDX-License-Identifier: Apache-2.0
// Sound pages below a damaged one are found again.
#include "core/recording/lost_branches.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/recording/page_reader.h"
#include "core/recording/recover_take.h"
#include "core/recording/table_pages.h"
#include "core/recording/take.h"
#include "tests/support/take_files.h"

namespace noctule {
namespace {

using test::Folder;

struct TablePlace {
    int64_t root = 0, page_bytes = 0;
};

TablePlace placeOf(const std::string& path, const std::string& table) {
    const Result<Database> database = Database::open(path, Access::kRead);
    const std::string root = "SELECT rootpage FROM sqlite_schema WHERE type='table' AND name='" + table + "'";
    return {database->queryInteger(root)->value(), database->queryInteger("PRAGMA page_size")->value()};
}

void writeAt(const std::string& path, int64_t at, const std::string& bytes) {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(at);
    file << bytes;
}

/// Of the page that leads to all others of the table.
void damageRootOf(const std::string& path, const std::string& table) {
    const auto [root, page_bytes] = placeOf(path, table);
    writeAt(path, (root - 1) * page_bytes, std::string(static_cast<size_t>(page_bytes), '\xff'));
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

/// The length of one row's header is the greatest number there is.
TEST(LostBranches, APageThatContradictsItselfIsNotLedTo) {
    const Folder folder;
    const std::string torn = test::tinyTake(folder), saved = folder.file("saved.noctule");
    const auto [root, page_bytes] = placeOf(torn, "reference");
    std::ifstream file(torn, std::ios::binary);
    const std::vector<RowPage> pages = rowPages(file, page_bytes, root);
    ASSERT_GT(pages.size(), 3u);
    PageReader page(file, page_bytes);
    ASSERT_TRUE(page.read(pages[1].page));
    int64_t at = page.number(8, 2);  // its first row: length, number, header
    (void)page.varint(at);
    (void)page.varint(at);
    writeAt(torn, (pages[1].page - 1) * page_bytes + at, "\xbf\xff\xff\xff\xff\xff\xff\xff\xff");
    damageRootOf(torn, "reference");
    const auto done = recoverTake(torn, saved, {});
    ASSERT_TRUE(done) << done.error().text();
    EXPECT_EQ(sumOf(saved, "count(*)", "reference"),
              sumOf(test::kTinyTake, "count(*)", "reference") - *pages[1].rows);
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
