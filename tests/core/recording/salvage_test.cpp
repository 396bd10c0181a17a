// SPDX-License-Identifier: Apache-2.0
// What is saved of damaged takes, and what is said of the rest.
#include "core/recording/salvage.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "core/recording/recover_take.h"
#include "core/recording/schema.h"
#include "core/recording/table_pages.h"
#include "tests/core/recording/collect.h"

namespace noctule {
namespace {

using test::Folder;

constexpr int64_t kPage_bytes = 4096;  // of the tiny take

void overwrite(const std::string& path, int64_t at, int64_t bytes) {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(at);
    file << std::string(static_cast<size_t>(bytes), '\xff');
}

/// The first page with rows of the table.
int64_t firstPageOf(const std::string& path, const std::string& table) {
    const Result<Database> database = Database::open(path, Access::kRead);
    const auto page = database->queryInteger("SELECT pageno FROM dbstat WHERE name='" + table +
                                             "' AND pagetype='leaf' ORDER BY path LIMIT 1");
    EXPECT_TRUE(page && *page);
    return page ? page->value_or(1) : 1;
}

void damageFirstPageOf(const std::string& path, const std::string& table) {
    overwrite(path, (firstPageOf(path, table) - 1) * kPage_bytes, kPage_bytes);
}

int64_t countRows(const std::string& path, const std::string& table) {
    const Result<Database> database = Database::open(path, Access::kRead);
    const auto rows = database->queryInteger("SELECT count(*) FROM " + table);
    return rows ? rows->value_or(-1) : -1;
}

TEST(DamagedTake, WhatCanBeReadOfHalfAFileIsATake) {
    const Folder folder;
    const std::string whole = test::readBytes(test::kTinyTake);
    const std::string torn = folder.file("torn.noctule"), saved = folder.file("saved.noctule");
    const std::string half = whole.substr(0, whole.size() / 2);
    test::writeBytes(torn, half);
    const auto done = recoverTake(torn, saved, {});
    ASSERT_TRUE(done) << done.error().text();
    ASSERT_TRUE(*done);
    const std::string told = savedText(**done);
    EXPECT_TRUE(told.starts_with("Saved of it: 1.") && told.ends_with("; everything else is complete"))
        << told;
    EXPECT_NE(told.find(" s of 2.02 s of the sound, nothing of the reference motion"), std::string::npos)
        << told;
    EXPECT_EQ(test::readBytes(torn), half);
    const auto take = Take::open(saved), before = Take::open(test::kTinyTake);
    ASSERT_TRUE(take) << take.error().text();
    EXPECT_EQ(take->meta().at("state"), "recovered");
    EXPECT_EQ(take->meta().at("uuid"), before->meta().at("uuid"));
    EXPECT_GT(*take->sampleCount(), *before->sampleCount() / 3);
    EXPECT_LT(*take->sampleCount(), *before->sampleCount());
    EXPECT_FALSE(recoverTake(torn, saved, {})) << "nothing is overwritten";
}

int addFirst(void* sum, int, char** values, char**) {
    *static_cast<int64_t*>(sum) += std::stoll(values[0]);
    return 0;
}

/// A row that ends behind the cut is lost; zeros in place of its end would be made up.
TEST(DamagedTake, RowsThatACutGoesThroughAreNotMadeUp) {
    const std::string whole = test::readBytes(test::kTinyTake);
    for (const size_t cut : {6U, 700U, 1500U, 2500U, 3500U}) {  // of the last page, which external_root has
        SCOPED_TRACE(cut);
        const Folder folder;
        const std::string torn = folder.file("torn.noctule"), saved = folder.file("saved.noctule");
        test::writeBytes(torn, whole.substr(0, whole.size() - cut));
        ASSERT_TRUE(recoverTake(torn, saved, {}));
        int64_t made_up = 0;
        sqlite3* handle = nullptr;
        ASSERT_EQ(sqlite3_open(saved.c_str(), &handle), SQLITE_OK);
        const std::string sql = "ATTACH '" + std::string(test::kTinyTake) +
                                "' AS whole; SELECT count(*) FROM (SELECT * FROM main.external_root EXCEPT "
                                "SELECT * FROM whole.external_root)";
        EXPECT_EQ(sqlite3_exec(handle, sql.c_str(), addFirst, &made_up, nullptr), SQLITE_OK);
        sqlite3_close(handle);
        EXPECT_EQ(made_up, 0);
    }
}

/// Other programs number rows as they like.
TEST(DamagedTake, RowsOfEveryNumberAreSaved) {
    const Folder folder;
    const std::string whole = test::tinyTake(folder), saved = folder.file("saved.noctule");
    test::runSql(whole,
                 "UPDATE pulse SET id=0 WHERE id=(SELECT min(id) FROM pulse);"
                 "UPDATE marker SET id=-id;"
                 "UPDATE adc_block SET id=9223372036854775807 WHERE id=(SELECT max(id) FROM adc_block)");
    const auto done = copyReadableRows(whole, saved, {});
    ASSERT_TRUE(done) << done.error().text();
    EXPECT_TRUE(done->empty()) << savedText(*done);
    const auto take = Take::open(saved), before = Take::open(whole);
    ASSERT_TRUE(take && before);
    EXPECT_EQ(take->pulses()->size(), before->pulses()->size());
    EXPECT_EQ(take->markers()->size(), before->markers()->size());
    EXPECT_EQ(*take->sampleCount(), *before->sampleCount());
    const auto blocks = [](const Take& of) {
        int count = 0;
        EXPECT_TRUE(of.forEachBlock(1, [&count](const auto&) { return ++count > 0; }));
        return count;
    };
    EXPECT_EQ(blocks(*take), blocks(*before));
}

/// SQLite would make the number 12 of the text, and keep the word where a number belongs.
TEST(DamagedTake, RowsOfOtherTypesAreLostAndCounted) {
    const Folder folder;
    const std::string torn = test::tinyTake(folder), saved = folder.file("saved.noctule");
    const int64_t notes = countRows(torn, "note");
    test::runSql(torn,
                 "DROP TABLE marker; CREATE TABLE marker(id INTEGER PRIMARY KEY, suit, sample, kind, label);"
                 "INSERT INTO marker VALUES(1,1,100,'hand','good'),(2,1,'12','hand','text'),"
                 "(3,1,'soon','hand','word'),(4,1,x'00','hand','bytes'),(5,1,NULL,'hand','nothing'),"
                 "(6,1,200,7,'number')");
    const auto done = copyReadableRows(torn, saved, {});
    ASSERT_TRUE(done) << done.error().text();
    ASSERT_EQ(done->tables.size(), 1u) << savedText(*done);
    EXPECT_EQ(done->tables[0].table, "marker");
    EXPECT_EQ(done->tables[0].saved, 2) << "a number may stand for a text";
    EXPECT_EQ(done->tables[0].lost, 4);
    EXPECT_EQ(countRows(saved, "marker"), 2);
    EXPECT_EQ(countRows(saved, "note"), notes);
}

TEST(DamagedTake, BytesThatAreNoTextAreMendedAndCounted) {
    const Folder folder;
    const std::string torn = test::tinyTake(folder), saved = folder.file("saved.noctule");
    test::runSql(torn, "INSERT INTO note(created_utc,text) VALUES('2026-01-01', CAST(x'61ff62' AS TEXT))");
    const auto done = copyReadableRows(torn, saved, {});
    ASSERT_TRUE(done) << done.error().text();
    EXPECT_EQ(done->mended_texts, 1);
    EXPECT_NE(savedText(*done).find("in so many texts: 1"), std::string::npos) << savedText(*done);
    const auto take = Take::open(saved);
    ASSERT_TRUE(take) << take.error().text();
    EXPECT_EQ(take->notes()->back().text,
              "a\xef\xbf\xbd"
              "b");
}

/// It says that fewer pages are free, so that removed rows would seem to be lost ones.
TEST(DamagedTake, AListOfFreePagesThatIsOldBringsNoRowsBack) {
    const Folder folder;
    const std::string torn = test::tinyTake(folder), saved = folder.file("saved.noctule");
    test::runSql(torn, "DELETE FROM reference WHERE rowid > (SELECT max(rowid)/2 FROM reference)");
    const int64_t rows = countRows(torn, "reference");
    overwrite(torn, 36, 4);  // how many they are
    const auto done = recoverTake(torn, saved, {}, Error{ErrorKind::kUnreadable, "torn", "", true});
    ASSERT_TRUE(done) << done.error().text();
    EXPECT_EQ(countRows(saved, "reference"), rows);
}

TEST(DamagedTake, OfATakeWithoutItsFirstPageNothingIsSaved) {
    const Folder folder;
    std::string bytes = test::readBytes(test::kTinyTake);
    bytes.replace(100, 3996, 3996, '\xff');
    const std::string torn = folder.file("torn.noctule"), saved = folder.file("saved.noctule");
    test::writeBytes(torn, bytes);
    const auto take = Take::open(torn);
    ASSERT_FALSE(take);
    EXPECT_TRUE(take.error().is_damage);
    const auto done = recoverTake(torn, saved, {});
    ASSERT_FALSE(done);
    EXPECT_EQ(
        done.error().message,
        torn + ": the beginning of the file is damaged, which says where the rest is; nothing can be read");
    EXPECT_FALSE(std::filesystem::exists(saved));
}

TEST(DamagedTake, ADamagedPageCostsItsOwnRowsOnly) {
    for (const char* number : {"id", "id-25", "id+1000000000000"}) {
        SCOPED_TRACE(number);
        const Folder folder;
        const std::string torn = test::tinyTake(folder), saved = folder.file("saved.noctule");
        test::runSql(torn, std::string("UPDATE adc_block SET id=") + number);
        const int64_t rows = countRows(torn, "adc_block");
        damageFirstPageOf(torn, "adc_block");
        const auto done = recoverTake(torn, saved, {});
        ASSERT_TRUE(done) << done.error().text();
        ASSERT_TRUE(*done && (*done)->tables.size() == 1);
        const TableLoss& loss = (*done)->tables[0];
        EXPECT_EQ(loss.table, "adc_block");
        EXPECT_GE(loss.saved, rows - 2);
        EXPECT_EQ(countRows(saved, "adc_block"), loss.saved);
        ASSERT_TRUE(loss.lost);
        EXPECT_NEAR(static_cast<double>(*loss.lost), static_cast<double>(rows - loss.saved), 1);
    }
}

/// Of all connections that are opened while it lives.
class CopiedStretches {
public:
    CopiedStretches() {
        seen().clear();
        sqlite3_auto_extension(reinterpret_cast<void (*)()>(listen));
    }
    ~CopiedStretches() { sqlite3_cancel_auto_extension(reinterpret_cast<void (*)()>(listen)); }

    static std::multiset<std::string>& seen() {
        static std::multiset<std::string> statements;
        return statements;
    }

private:
    static int listen(sqlite3* handle, const char**, const void*) {
        return sqlite3_trace_v2(handle, SQLITE_TRACE_STMT, note, nullptr);
    }
    static int note(unsigned, void*, void* statement, void*) {
        char* sql = sqlite3_expanded_sql(static_cast<sqlite3_stmt*>(statement));
        if (const std::string text = sql ? sql : ""; text.starts_with("INSERT OR IGNORE"))
            seen().insert(text);
        sqlite3_free(sql);
        return 0;
    }
};

TEST(DamagedTake, NoStretchOfATableIsCopiedTwice) {
    for (const char* table : {"adc_block", "reference", "note", "half of all"}) {
        SCOPED_TRACE(table);
        const Folder folder;
        const std::string torn = test::tinyTake(folder);
        if (std::string(table) == "half of all")
            std::filesystem::resize_file(torn, std::filesystem::file_size(torn) / 2);
        else
            damageFirstPageOf(torn, table);
        const CopiedStretches copied;
        const auto done = copyReadableRows(torn, folder.file("saved.noctule"), {});
        ASSERT_TRUE(done) << done.error().text();
        EXPECT_GE(copied.seen().size(), 10u) << "each table once at least";
        for (const std::string& statement : copied.seen())
            EXPECT_EQ(copied.seen().count(statement), 1u) << statement;
    }
}

TEST(DamagedTake, EveryTableHasAName) {
    for (const TableDefinition& table : takeTables())
        EXPECT_NO_THROW((void)savedText({{{table.name, 0, 1}}, {}})) << table.name;
}

TEST(DamagedTake, OfATableWithoutItsFirstPageNothingIsSaved) {
    const Folder folder;
    const std::string torn = test::tinyTake(folder), saved = folder.file("saved.noctule");
    damageFirstPageOf(torn, "note");  // it is the only one
    const auto done = recoverTake(torn, saved, {});
    ASSERT_TRUE(done) << done.error().text();
    ASSERT_TRUE(*done);
    EXPECT_EQ(savedText(**done), "Saved of it: nothing of the list of notes; everything else is complete");
    EXPECT_FALSE((*done)->tables.at(0).lost) << "how many there were stood on that page";
}

TEST(DamagedTake, WithoutItsDetailsTheLengthOfTheSoundIsAShare) {
    const Folder folder;
    const std::string torn = test::tinyTake(folder), saved = folder.file("saved.noctule");
    test::runSql(torn, "DELETE FROM meta WHERE key='sample_count'");
    damageFirstPageOf(torn, "adc_block");
    const auto done = recoverTake(torn, saved, {});
    ASSERT_TRUE(done) << done.error().text();
    ASSERT_TRUE(*done);
    EXPECT_EQ(savedText(**done), "Saved of it: about 98 % of the sound; everything else is complete");
}

/// The length is that of the readings that were saved, and nobody misses sound.
TEST(DamagedTake, OfATakeOfReadingsNoSoundIsMissed) {
    const Folder folder;
    const std::string torn = test::tinyTake(folder), saved = folder.file("saved.noctule");
    test::runSql(torn, "INSERT INTO meta(key,value) VALUES('level','readings'); DELETE FROM pulse");
    damageFirstPageOf(torn, "adc_block");
    damageFirstPageOf(torn, "note");
    const auto done = recoverTake(torn, saved, {});
    ASSERT_TRUE(done) << done.error().text();
    ASSERT_TRUE(*done);
    EXPECT_EQ(savedText(**done).find("sound"), std::string::npos) << savedText(**done);
    EXPECT_FALSE((*done)->sound_s);
    EXPECT_EQ(countRows(saved, "meta WHERE key='level'"), 1);
    const Take take = Take::open(saved).value();
    EXPECT_EQ(take.meta().count("sample_count"), 0U);
    EXPECT_EQ(take.duration_s().value(), 0) << "nothing that has a time was saved";
}

TEST(DamagedTake, AnotherListOfTablesIsMadeOfWhatRemains) {
    for (const int64_t bytes : {16, 100, 512}) {
        SCOPED_TRACE(bytes);
        const Folder folder;
        const std::string torn = test::tinyTake(folder), saved = folder.file("saved.noctule");
        overwrite(torn, 0, bytes);
        const auto take = Take::open(torn);
        ASSERT_FALSE(take);
        EXPECT_TRUE(take.error().is_damage) << take.error().text();
        const auto done = recoverTake(torn, saved, {});
        ASSERT_TRUE(done) << done.error().text();
        ASSERT_TRUE(*done);
        EXPECT_EQ(savedText(**done),
                  "All that was found could be read. The list of what it had is damaged too, so more may be "
                  "lost");
        for (const char* table : {"meta", "adc_block", "pulse", "reference", "external_root", "note"})
            EXPECT_EQ(countRows(saved, table), countRows(test::kTinyTake, table)) << table;
    }
}

TEST(DamagedTake, ALogBesideItIsRead) {
    const Folder folder;
    const std::string whole = test::tinyTake(folder), torn = folder.file("torn.noctule");
    const std::string saved = folder.file("saved.noctule");
    sqlite3* handle = nullptr;
    ASSERT_EQ(sqlite3_open(whole.c_str(), &handle), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(handle,
                           "PRAGMA journal_mode=WAL;"
                           "INSERT INTO note(created_utc,text) VALUES('2026-01-01T00:00:00Z', 'in the log')",
                           nullptr, nullptr, nullptr),
              SQLITE_OK);
    const std::string bytes = test::readBytes(whole);
    test::writeBytes(torn, bytes.substr(0, bytes.size() / 2));
    std::filesystem::copy_file(whole + "-wal", torn + "-wal");
    sqlite3_close(handle);
    const auto done = recoverTake(torn, saved, {});
    ASSERT_TRUE(done) << done.error().text();
    EXPECT_TRUE(*done);
    EXPECT_EQ(countRows(saved, "note"), countRows(test::kTinyTake, "note") + 1);
    EXPECT_FALSE(std::filesystem::exists(saved + "-wal"));
}

TEST(DamagedTake, PagesOfATableHoldAllItsRows) {
    const Result<Database> database = Database::open(test::kTinyTake, Access::kRead);
    std::ifstream file(test::kTinyTake, std::ios::binary);
    for (const char* table : {"meta", "adc_block", "reference", "external_root"}) {
        SCOPED_TRACE(table);
        const auto root = database->queryInteger(
            std::string("SELECT rootpage FROM sqlite_schema WHERE type='table' AND name='") + table + "'");
        int64_t rows = 0, next = RowPage().first;
        const std::vector<RowPage> pages = rowPages(file, kPage_bytes, root->value());
        for (const RowPage& page : pages) {
            EXPECT_TRUE(page.is_readable);
            EXPECT_EQ(page.first, next);
            next = page.last < RowPage().last ? page.last + 1 : page.last;
            rows += page.rows.value_or(0);
        }
        EXPECT_EQ(next, RowPage().last);
        EXPECT_EQ(rows, countRows(test::kTinyTake, table));
    }
}

TEST(DamagedTake, ATreeThatLeadsInACircleEnds) {
    std::string page(512, '\0');
    page[100] = 5;  // behind the header of the file
    page[111] = 1;  // its only child is itself
    std::istringstream file(page);
    const std::vector<RowPage> pages = rowPages(file, 512, 1);
    EXPECT_EQ(pages.size(), 1u);
}

}  // namespace
}  // namespace noctule
