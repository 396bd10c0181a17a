// SPDX-License-Identifier: Apache-2.0
// Takes that were made to do harm: what they hold in place of tables, of numbers and of texts.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/job/job.h"
#include "core/job/limits.h"
#include "core/job/outside_text.h"
#include "core/math/json.h"
#include "core/recording/recover_take.h"
#include "core/recording/take_copy.h"
#include "core/recording/take_edit.h"
#include "core/recording/take_writer.h"
#include "tests/support/fuzzing.h"
#include "tests/support/take_files.h"

namespace noctule::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEndless = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i+1 FROM n) ";

std::string hostileTake(const Folder& folder, const std::string& sql) {
    const std::string path = tinyTake(folder);
    runSql(path, sql);
    return path;
}

/// The words on a table's skipped rows; empty: none were.
std::string skippedOf(const Take& take, const std::string& table) {
    for (const SkippedRows& skipped : take.skippedRows())
        if (skipped.table == table)
            return std::to_string(skipped.count) + " " + skipped.first;
    return "";
}

TEST(HostileTake, ViewInPlaceOfATableIsNoTake) {
    for (const char* name : {"marker", "MARKER"}) {
        const Folder folder;
        const auto take = Take::open(hostileTake(
            folder, "ALTER TABLE marker RENAME TO old; CREATE VIEW " + std::string(name) +
                        "(id,suit,sample,kind,label) AS " + kEndless + "SELECT i,1,i,'user','x' FROM n"));
        ASSERT_FALSE(take);
        EXPECT_EQ(take.error().kind, ErrorKind::kUnreadable);
        EXPECT_NE(take.error().message.find(name), std::string::npos) << take.error().text();
    }
}

TEST(HostileTake, EndlessWalkEndsWhenCancelled) {
    const Folder folder;
    CancelFlag cancel;
    const auto database = Database::open(tinyTake(folder), Access::kRead, {&cancel});
    ASSERT_TRUE(database);
    ASSERT_TRUE(database->queryInteger("SELECT 1"));
    cancel.cancel();
    const auto endless = database->queryInteger(std::string(kEndless) + "SELECT count(*) FROM n");
    ASSERT_FALSE(endless);
    EXPECT_EQ(endless.error().kind, ErrorKind::kCancelled);
}

TEST(HostileTake, LockIsNamedAsALockAndTheWaitHeedsCancel) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    const auto other = Database::open(path, Access::kReadWrite);
    ASSERT_TRUE(other);
    ASSERT_TRUE(other->execute("BEGIN EXCLUSIVE"));
    const auto locked = Take::open(path, Access::kReadWrite, {nullptr, 0.05});
    ASSERT_FALSE(locked);
    EXPECT_NE(locked.error().text().find("lock"), std::string::npos) << locked.error().text();
    CancelFlag cancel;
    cancel.cancel();
    const auto cancelled = Take::open(path, Access::kReadWrite, {&cancel, 3600});
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().kind, ErrorKind::kCancelled);
}

TEST(HostileTake, NumbersBeyondTheirLimitsAreNamed) {
    const Folder folder;
    const auto take = Take::open(hostileTake(folder,
                                             "UPDATE meta SET value='1' WHERE key='sample_rate_hz'; INSERT "
                                             "OR REPLACE INTO meta VALUES('pulse_cycles','1e300')"));
    ASSERT_TRUE(take) << take.error().text();
    EXPECT_FALSE(take->sampleRate_hz());
    const std::string skipped = skippedOf(*take, "meta");
    EXPECT_EQ(skipped.substr(0, 2), "2 ") << skipped;
    EXPECT_NE(skipped.find("sample_rate_hz"), std::string::npos) << skipped;
}

TEST(HostileTake, PulsesCannotFloodAndTextsAreCut) {
    const Folder folder;
    const auto take = Take::open(hostileTake(
        folder,
        "DELETE FROM pulse; INSERT INTO pulse(sample,source) WITH RECURSIVE n(i) AS (SELECT 0 UNION ALL "
        "SELECT i+1 FROM n LIMIT 1500) SELECT i,0 FROM n;"
        "INSERT INTO marker(sample,kind,label) "
        "VALUES(1,'user',replace(hex(zeroblob(100000)),'0','m'))"));
    ASSERT_TRUE(take) << take.error().text();
    const double ms = 1500.0 / (static_cast<double>(take->sampleRate_hz().value()) / 1000);
    const auto pulses = take->pulses();
    EXPECT_NEAR(static_cast<double>(pulses->size()), 4 * ms, 4);
    EXPECT_FALSE(skippedOf(*take, "pulse").empty());
    size_t longest = 0;
    for (const auto markers = take->markers(); const MarkerRow& marker : *markers)
        longest = std::max(longest, marker.label.size());
    EXPECT_EQ(longest, limits::kName);
}

/// Names of 5000 letters would break every table and report.
TEST(HostileTake, NamesOfSuitsAndSubjectsAreCut) {
    const Folder folder;
    const std::string name(5000, 'n');
    const auto take =
        Take::open(hostileTake(folder, "UPDATE suit SET json=json_set(json,'$.name','" + name +
                                           "','$.boards[0].id','" + name + "','$.sources[0].id','" + name +
                                           "');"
                                           "UPDATE calibration SET json=json_set(json,'$.boards[0].id','" +
                                           name +
                                           "');"
                                           "UPDATE actor SET json=json_set(json,'$.name','" +
                                           name +
                                           "');"
                                           "INSERT INTO meta VALUES('subjects','[{\"name\":\"" +
                                           name + "\",\"suits\":[1]}]')"));
    ASSERT_TRUE(take) << take.error().text();
    const auto suit = take->suit();
    ASSERT_TRUE(suit) << suit.error().text();
    const auto subjects = take->subjects();
    ASSERT_TRUE(subjects) << subjects.error().text();
    for (const std::string& cut : {suit->name, suit->boards[0].id, suit->sources[0].id,
                                   subjects->front().name, take->actorInForce()->value.name}) {
        EXPECT_LE(cut.size(), limits::kName);
        EXPECT_TRUE(cut.ends_with("…")) << "what is cut shows it: " << cut;
    }
    EXPECT_NE(take->calibrationInForce()->value.findBoard(suit->boards[0].id), nullptr)
        << "both are cut alike, so that they are found by each other";
}

/// They may be JSON, which is nothing when it is cut.
TEST(HostileTake, EntriesOfOtherProgramsAreKeptWholeAndNamesAreCut) {
    const Folder folder;
    const std::string spot = R"({"moments":[)" + std::string(287, '1') + "]}";
    const auto take = Take::open(hostileTake(
        folder, "INSERT INTO meta VALUES('x_field_spot','" + spot + "');" +
                    "INSERT INTO meta VALUES('x_endless',replace(hex(zeroblob(100000)),'0','m'));" +
                    "INSERT OR REPLACE INTO meta VALUES('performer','" + std::string(300, 'n') + "')"));
    ASSERT_TRUE(take) << take.error().text();
    EXPECT_EQ(take->meta().at("x_field_spot"), spot);
    EXPECT_EQ(take->meta().at("x_endless").size(), limits::kMetaValue);
    EXPECT_LE(take->meta().at("performer").size(), limits::kName);
}

TEST(HostileTake, RowsBeyondTheTablesLimitAreCountedNotHeld) {
    const Folder folder;
    const auto take = Take::open(hostileTake(folder,
                                             "INSERT INTO note(created_utc,text) WITH RECURSIVE n(i) AS "
                                             "(SELECT 0 UNION ALL SELECT i+1 FROM n LIMIT "
                                             "30000) SELECT 'x',i FROM n"));
    ASSERT_TRUE(take);
    EXPECT_EQ(static_cast<int64_t>(take->notes()->size()), limits::rowsOf("note"));
    EXPECT_FALSE(skippedOf(*take, "note").empty());
}

TEST(HostileTake, TakeThatIsBeingRecordedIsLeftAlone) {
    const Folder folder;
    TakeHeader header;
    header.sample_rate_hz = 1000;
    header.board_count = 1;
    const std::string path = folder.file("now.noctule");
    auto recording = TakeWriter::create(path, header, {false, TakeWriter::Journal::kWal});
    ASSERT_TRUE(recording && recording->commit());
    EXPECT_TRUE(Take::open(path)) << "looking at it is allowed";
    const auto written = Take::open(path, Access::kReadWrite);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(written.error().text().find("being recorded"), std::string::npos);
    EXPECT_FALSE(TakeCopy::make(path, folder.file("copy.noctule"), {}));
    ASSERT_TRUE(recording->finish());
    EXPECT_TRUE(Take::open(path, Access::kReadWrite));
}

TEST(HostileTake, CopyIsAsPrivateAsTheOriginal) {
    const Folder folder;
    const std::string path = tinyTake(folder), copied = folder.file("copy.noctule");
    fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
    auto copy = TakeCopy::make(path, copied, {});
    ASSERT_TRUE(copy && copy->publish(false));
    EXPECT_EQ(fs::status(copied).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(HostileTake, DeepJsonIsRefused) {
    const std::string deep = "{\"x\":" + std::string(200'000, '[') + std::string(200'000, ']') + "}";
    EXPECT_TRUE(json::parse(deep).is_discarded());
    EXPECT_FALSE(json::parse(R"({"x":["[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[\"[[[[["]})").is_discarded());
}

TEST(OutsideText, ShowsWhatATerminalWouldObey) {
    EXPECT_EQ(visibleText("a\nb\x1b[31m\r\t"), "a\\nb\\x1b[31m\\r\\t");
    EXPECT_EQ(visibleText("a\nb", Lines::kMany), "a\nb");
    EXPECT_EQ(visibleText("\u202egnp \u009b \xff\xc0\xaf \U0001f987 °"),
              "\\u202egnp \\x9b \\xff\\xc0\\xaf \U0001f987 °");
    EXPECT_EQ(visibleJson("\"\x7f\u009b\u202e\"\n"), "\"\\u007f\\u009b\\u202e\"\n");
}

TEST(OutsideText, CutsBetweenCharacters) {
    EXPECT_EQ(shortText("abc", 3), "abc");
    EXPECT_EQ(shortText("abcdef", 5), "ab…");
    EXPECT_EQ(shortText("°°°°", 6), "°…");
}

constexpr int kRowsAtOnce = 20;

/// Into any table, with any of the values in each column.
std::string rowOf(const std::vector<std::string>& values, std::mt19937_64& random) {
    const auto& tables = takeTables();
    const TableDefinition& table = tables[random() % tables.size()];
    std::string columns, list;
    for (const ColumnDefinition& column : table.columns) {
        columns += (columns.empty() ? "" : ",") + column.name;
        list += (list.empty() ? "" : ",") + values[random() % values.size()];
    }
    return "INSERT OR REPLACE INTO " + table.name + "(" + columns + ") VALUES(" + list + ");";
}

TEST(FuzzRows, DamagedValues) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    const std::vector<std::string> values = {"NULL",
                                             "-1",
                                             "0",
                                             "9223372036854775807",
                                             "-9223372036854775808",
                                             "1e300",
                                             "9e999",
                                             "-9e999",
                                             "4294967296",
                                             "'text'",
                                             "x'00ff'",
                                             "zeroblob(70000)",
                                             "CAST(x'fffe1b' AS TEXT)",
                                             "hex(zeroblob(20000))",
                                             "0.5"};
    int64_t rows = 0;
    const int64_t count = countFromEnvironment("NOCTULE_FUZZ_INPUTS", 200);
    for (int64_t i = 0; i < count; i += kRowsAtOnce) {
        std::mt19937_64 random(static_cast<uint64_t>(i) + 1);
        if (i % 500 == 0)
            (void)tinyTake(folder);  // small again
        sqlite3* handle = nullptr;
        ASSERT_EQ(sqlite3_open(path.c_str(), &handle), SQLITE_OK);
        sqlite3_exec(handle, "PRAGMA synchronous=OFF; BEGIN", nullptr, nullptr, nullptr);
        std::string sql;
        for (int row = 0; row < kRowsAtOnce; ++row) {
            const std::string one = rowOf(values, random);
            rows += sqlite3_exec(handle, one.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK;
            sql += one;
        }
        sqlite3_exec(handle, "COMMIT", nullptr, nullptr, nullptr);
        sqlite3_close(handle);
        const auto take = Take::open(path);
        ASSERT_TRUE(take) << sql << ": " << take.error().text();
        for (const auto sent = take->pulses(); const Pulse& pulse : *sent)
            ASSERT_TRUE(pulse.sample >= 0 && pulse.sample <= take->lastSample()) << sql;
        for (const auto roots = take->externalRoot(); const ExternalRootRow& root : *roots)
            ASSERT_LE(root.p_world_root.cwiseAbs().maxCoeff(), limits::kFarthest_m) << sql;
        for (const auto states = take->statusRows(); const StatusRow& status : *states)
            ASSERT_LE(std::abs(status.temperature_c.value_or(0)), limits::kHottest_c) << sql;
        (void)take->markers();
        (void)take->gaps();
        (void)take->derivedRuns();
        (void)take->poses(1);
        (void)take->reference();
        (void)take->contacts(1);
    }
    std::printf("%lld damaged inputs, %lld rows taken by the database\n", static_cast<long long>(count),
                static_cast<long long>(rows));
    EXPECT_GT(rows, 0);
}

}  // namespace
}  // namespace noctule::test
