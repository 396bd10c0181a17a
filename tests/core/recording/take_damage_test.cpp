// SPDX-License-Identifier: Apache-2.0
// Takes that other programs wrote differently, and takes that are broken.
#include <gtest/gtest.h>

#include <random>

#include "core/recording/take_edit.h"
#include "tests/core/recording/collect.h"

namespace noctule {
namespace {

using test::Folder;
using test::runSql;

int64_t countSamples(const Take& take) {
    int64_t samples = 0;
    const Status walked = take.forEachBlock(1, [&](const AdcBlock& block) {
        samples += static_cast<int64_t>(block.values.size()) / 2;
        return true;
    });
    EXPECT_TRUE(walked) << walked.error().text();
    return samples;
}

/// Calls everything a reader can; whether it works does not matter, only that it ends.
void readAll(const std::string& path) {
    const Result<Take> take = Take::open(path);
    if (!take) {
        EXPECT_FALSE(take.error().message.empty());
        EXPECT_FALSE(take.error().remedy.empty());
        return;
    }
    int64_t sum = 0;
    (void)take->forEachBlock(1, [&](const AdcBlock& block) {
        for (const int16_t value : block.values)
            sum += value;
        return true;
    });
    (void)take->missingParts();
    (void)take->sampleCount();
    (void)take->pulses();
    (void)take->statusRows();
    (void)take->gaps();
    (void)take->notes();
    (void)take->restInterval();
    (void)take->calibrationInForce();
    (void)take->reference();
    (void)take->externalRoot();
    (void)take->derivedRuns();
    auto readings = take->readings(kPrimaryRun);
    while (readings) {
        const auto next = readings->next();
        if (!next || !*next)
            break;
    }
    auto ranges = take->ranges(kPrimaryRun);
    while (ranges) {
        const auto next = ranges->next();
        if (!next || !*next)
            break;
    }
}

TEST(ForeignTake, OnlySection2AndAnotherPageSize) {
    const Folder folder;
    const std::string path = folder.file("small.noctule");
    runSql(path,
           "PRAGMA page_size=512; PRAGMA application_id=1313817428; PRAGMA user_version=1007;"
           "CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL);"
           "CREATE TABLE suit(id INTEGER PRIMARY KEY, json TEXT NOT NULL);"
           "CREATE TABLE adc_block(id INTEGER PRIMARY KEY, first_sample INTEGER, sample_count INTEGER, data "
           "BLOB);"
           "CREATE TABLE pulse(id INTEGER PRIMARY KEY, sample INTEGER, source INTEGER, shade TEXT);"
           "CREATE TABLE weather(wind REAL);"
           "INSERT INTO meta VALUES('sample_rate_hz', 140000), ('board_count', 2), ('source_count', 1);"
           "INSERT INTO adc_block(first_sample,sample_count,data)"
           " VALUES(3, 1, x'0100FEFF'), (0, 2, x'0000010002000300');"
           "INSERT INTO pulse(sample,source,shade) VALUES(900, 0, 'red'), (100, 0, NULL), (200, 1, NULL);");
    const Result<Take> take = Take::open(path);
    ASSERT_TRUE(take) << take.error().text();
    EXPECT_EQ(*take->sampleRate_hz(), 140000);
    EXPECT_EQ(take->header().pulse_interval_samples, 1200);
    EXPECT_EQ(take->header().drive_hz, 40000);
    std::vector<int> values;
    ASSERT_TRUE(take->forEachBlock(1, [&](const AdcBlock& block) {
        values.insert(values.end(), block.values.begin(), block.values.end());
        return true;
    }));
    EXPECT_EQ(values, (std::vector<int>{0, 1, 2, 3, 1, -2}));
    ASSERT_EQ(take->pulses()->size(), 2u) << "source 1 is not there";
    EXPECT_EQ(take->pulses()->at(0).sample, 100);
    EXPECT_EQ(take->skippedRows().at(0).first, "row 3: source is not in the suit");
    EXPECT_TRUE(take->statusRows()->empty());
    EXPECT_TRUE(take->reference()->frames.empty());
    EXPECT_EQ(take->suit().error().kind, ErrorKind::kUnusable);
    const auto missing = take->missingParts();
    ASSERT_EQ(missing->size(), 3u);
    EXPECT_EQ(missing->at(0), "suit: which boards and sources there are");
    EXPECT_TRUE(take->pulses(2)->empty());
    EXPECT_EQ(*take->sampleCount(), 4);
}

TEST(ForeignTake, IsCompletedByAnEditAndKeepsWhatWeDoNotKnow) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    runSql(path, "CREATE TABLE weather(wind REAL); INSERT INTO weather VALUES(3); DROP TABLE note;");
    Result<Take> take = Take::open(path, Access::kReadWrite);
    Result<TakeEdit> edit = TakeEdit::begin(*take);
    ASSERT_TRUE(edit->addNote({"2026-01-01T00:00:00Z", "new"}));
    ASSERT_TRUE(edit->addMarker({9, "user", "second"}, 2));
    ASSERT_TRUE(edit->commit());
    EXPECT_EQ(take->notes()->size(), 1u);
    EXPECT_EQ(take->markers()->size(), 2u);
    EXPECT_EQ(take->markers(2)->at(0).label, "second");
    const Result<Database> database = Database::open(path, Access::kRead);
    EXPECT_EQ(*database->queryInteger("SELECT wind FROM weather"), 3);
}

TEST(ForeignTake, TwoSuitsTakeTheirCountsFromTheirJson) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    runSql(path,
           "INSERT INTO suit(json,clock_offset_ns,clock_rate) SELECT replace(json, 'l_hand', 'r_hand'), 5e6, "
           "1.5 FROM suit;"
           "INSERT INTO adc_block(suit,first_sample,sample_count,data) VALUES(2, 0, 1, x'01000200');"
           "UPDATE meta SET value='7' WHERE key='board_count'");
    const Result<Take> take = Take::open(path);
    EXPECT_EQ(take->suitIds(), (std::vector<int>{1, 2}));
    EXPECT_EQ(*take->boardCount(2), 2);
    EXPECT_EQ(take->suitClock(2).rate, 1.5);
    EXPECT_EQ(take->suit(2)->boards[1].id, "r_hand");
    EXPECT_EQ(countSamples(*take), 302500);
    int blocks = 0;
    ASSERT_TRUE(take->forEachBlock(2, [&](const AdcBlock& block) {
        EXPECT_EQ(block.values[1], 2);
        return ++blocks > 0;
    }));
    EXPECT_EQ(blocks, 1);
}

struct Refusal {
    const char* sql;
    const char* message;
};

/// How GoogleTest names the case.
void PrintTo(const Refusal& c, std::ostream* out) {
    *out << c.sql;
}

class RefusedTake : public testing::TestWithParam<Refusal> {};

TEST_P(RefusedTake, SaysWhy) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    runSql(path, GetParam().sql);
    const auto take = Take::open(path);
    ASSERT_FALSE(take);
    EXPECT_EQ(take.error().kind, ErrorKind::kUnreadable);
    EXPECT_EQ(take.error().message, path + ": " + GetParam().message);
    EXPECT_FALSE(take.error().remedy.empty());
}

INSTANTIATE_TEST_SUITE_P(
    All, RefusedTake,
    testing::Values(
        Refusal{"PRAGMA application_id=7", "is not a take, it is a database of another kind"},
        Refusal{"PRAGMA user_version=2000", "is a take of format version 2, this program reads version 1"},
        Refusal{"PRAGMA user_version=0", "is a take of format version 0, this program reads version 1"},
        Refusal{"UPDATE meta SET value='gpx' WHERE key='format'", "is not a take, its format is 'gpx'"}));

TEST(RefusedTake, NoFileAndNoDatabase) {
    const Folder folder;
    EXPECT_EQ(Take::open(folder.file("none")).error().kind, ErrorKind::kUnreadable);
    EXPECT_EQ(Take::open(folder.file("")).error().kind, ErrorKind::kUnreadable);
    const std::pair<std::string, const char*> contents[] = {
        {"", "is empty"}, {"BVH", "is not a take"}, {std::string(5000, 'x'), "is not a take"}};
    for (const auto& [content, why] : contents) {
        test::writeBytes(folder.file("text"), content);
        const auto take = Take::open(folder.file("text"));
        ASSERT_FALSE(take);
        EXPECT_EQ(take.error().kind, ErrorKind::kUnreadable);
        EXPECT_NE(take.error().message.find(why), std::string::npos) << take.error().text();
    }
}

TEST(DamagedTake, MissingMetaRefusesOnlyProcessing) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    runSql(path, "DELETE FROM meta WHERE key IN ('sample_rate_hz', 'board_count')");
    const Result<Take> take = Take::open(path);
    ASSERT_TRUE(take);
    EXPECT_EQ(take->sampleRate_hz().error().kind, ErrorKind::kUnusable);
    EXPECT_EQ(take->forEachBlock(1, [](const AdcBlock&) { return true; }).error().kind, ErrorKind::kUnusable);
    EXPECT_EQ(take->notes()->size(), 1u);
    EXPECT_EQ(take->pulses()->size(), 251u);
    EXPECT_EQ(take->missingParts()->size(), 2u);
    runSql(path, "DROP TABLE meta");
    EXPECT_EQ(Take::open(path)->notes()->size(), 1u);
}

TEST(DamagedTake, BoardCountsThatContradict) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    runSql(path, "UPDATE meta SET value='3' WHERE key='board_count'");
    const auto count = Take::open(path)->boardCount();
    ASSERT_FALSE(count);
    EXPECT_EQ(count.error().message, path + ": meta says 3 boards, the suit describes 2");
}

TEST(DamagedTake, BadBlocksAreSkippedCountedAndNamed) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    runSql(path,
           "UPDATE adc_block SET data=x'0102' WHERE id=2; UPDATE adc_block SET sample_count=70000 WHERE id=4;"
           "UPDATE adc_block SET first_sample=-5 WHERE id=6; UPDATE adc_block SET codec=9 WHERE id=8;"
           "UPDATE adc_block SET codec=1 WHERE id=10; UPDATE adc_block SET data='text' WHERE id=12;"
           "UPDATE adc_block SET first_sample=first_sample-1 WHERE id=14;"
           "UPDATE adc_block SET first_sample='soon' WHERE id=16;"
           "UPDATE adc_block SET sample_count=0 WHERE id=18;");
    const Result<Take> take = Take::open(path);
    EXPECT_EQ(countSamples(*take), 302500 - 9 * 6000);
    const auto skipped = take->skippedRows();
    ASSERT_EQ(skipped.size(), 1u);
    EXPECT_EQ(skipped[0].table, "adc_block");
    EXPECT_EQ(skipped[0].count, 9);
    EXPECT_EQ(countSamples(*take), 302500 - 9 * 6000);
    EXPECT_EQ(take->skippedRows()[0].count, 9) << "reading again does not count again";
}

TEST(DamagedTake, BadRowsAreSkipped) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    runSql(path,
           "UPDATE pulse SET source=2 WHERE id=1; UPDATE pulse SET sample=-1 WHERE id=2;"
           "UPDATE status SET sample='x' WHERE id=1; UPDATE status SET temperature_c='warm' WHERE id=2;"
           "INSERT INTO gap(first_sample,sample_count,board) VALUES(0,5,2),(0,5,NULL),(0,-5,1);"
           "UPDATE reference SET q=x'00' WHERE time_ns=0; UPDATE reference SET px=NULL WHERE time_ns=7142857;"
           "UPDATE external_root SET qw=5 WHERE time_ns=0; UPDATE external_root SET sigma_p_m=0 WHERE "
           "time_ns=8333333");
    const Result<Take> take = Take::open(path);
    EXPECT_EQ(take->pulses()->size(), 249u);
    ASSERT_EQ(take->statusRows()->size(), 2u);
    EXPECT_FALSE(take->statusRows()->at(0).temperature_c);
    EXPECT_EQ(take->gaps()->size(), 1u);
    const auto reference = take->reference();
    EXPECT_EQ(reference->frames.size(), 282u);
    EXPECT_FALSE(reference->frames.at(0).pose) << "NULL: not seen";
    EXPECT_EQ(take->externalRoot()->size(), 240u);
    EXPECT_EQ(take->skippedRows().size(), 5u);
}

TEST(DamagedTake, BadReadingsAndRangesAreSkipped) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    runSql(path,
           "CREATE TABLE inertial(run INTEGER, suit INTEGER NOT NULL DEFAULT 1, board INTEGER, frame "
           "INTEGER, sample"
           " REAL, gx, gy, gz, ax, ay, az, corrected, PRIMARY KEY(run,suit,board,frame));"
           "INSERT INTO inertial(run,board,frame,sample,gx,corrected) VALUES(0,0,0,129,5,0),(0,0,1,NULL,5,0),"
           "(0,0,2,2271,'x',0),(0,2,0,129,5,0),(0,-1,0,129,5,0),(0,1,7,8050,NULL,NULL),(1,0,0,1,1,1);"
           "CREATE TABLE range(run, pulse, board, arrival_sample, distance_m, w_s, w_t, w_a, sigma_m);"
           "INSERT INTO range VALUES(0,1,0,1300,0.2,1,1,NULL,0.002),(0,2,1,2500,0.2,1,1,1,NULL),"
           "(0,999,1,2500,0.2,1,1,1,0.1),(0,3,5,2500,0.2,1,1,1,0.1),(0,4,1,2500,0.2,1.5,1,1,0.1),"
           "(0,5,1,NULL,0.2,1,1,1,0.1)");
    const Result<Take> take = Take::open(path);
    auto readings = take->readings(kPrimaryRun);
    ASSERT_TRUE(readings) << readings.error().text();
    const auto all = test::collect(*readings);
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[1].frame, 7);
    EXPECT_FALSE(all[1].corrected_bits);
    auto ranges = take->ranges(kPrimaryRun);
    ASSERT_TRUE(ranges) << ranges.error().text();
    const auto heard = test::collect(*ranges);
    ASSERT_EQ(heard.size(), 2u);
    EXPECT_EQ(heard[0].w_a, 1);
    EXPECT_EQ(heard[0].pulse_sample, 1200);
    EXPECT_FALSE(*ranges->next()) << "the end stays the end";
    for (const SkippedRows& skipped : take->skippedRows())
        EXPECT_EQ(skipped.count, 4) << skipped.table;
}

TEST(DamagedTake, BrokenJsonIsNamed) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    runSql(
        path,
        "UPDATE suit SET json='{\"format\":'; UPDATE calibration SET json='[]'; UPDATE actor SET json=x'00'");
    const Result<Take> take = Take::open(path);
    ASSERT_TRUE(take);
    EXPECT_EQ(take->suit().error().message, path + ": suit 1: is not a JSON object");
    EXPECT_EQ(take->calibrationInForce().error().message, path + ": calibration 1: is not a JSON object");
    EXPECT_FALSE(take->actorInForce());
    EXPECT_EQ(*take->boardCount(), 2) << "meta still tells";
}

#ifdef NOCTULE_SANITIZED
constexpr int kTruncations = 20, kFlips = 50;
#else
constexpr int kTruncations = 200, kFlips = 500;
#endif

TEST(DamagedTake, TruncatedAnywhere) {
    const Folder folder;
    const std::string whole = test::readBytes(test::kTinyTake);
    const std::string path = folder.file("short.noctule");
    std::mt19937 random(1);
    for (int i = 0; i < kTruncations; ++i) {
        test::writeBytes(path, whole.substr(0, random() % whole.size()));
        readAll(path);
    }
    test::writeBytes(path, whole.substr(0, whole.size() / 2));
    const auto take = Take::open(path);
    ASSERT_FALSE(take);
    EXPECT_EQ(take.error().kind, ErrorKind::kUnreadable);
    EXPECT_NE(take.error().remedy.find("noctule --batch recover"), std::string::npos) << take.error().text();
}

TEST(DamagedTake, FlippedBytes) {
    const Folder folder;
    const std::string whole = test::readBytes(test::kTinyTake);
    const std::string path = folder.file("flipped.noctule");
    std::mt19937 random(2);
    for (int i = 0; i < kFlips; ++i) {
        std::string bytes = whole;
        // Half of them where the structure is: the first pages.
        const size_t reach = i % 2 ? bytes.size() : size_t{65536};
        for (unsigned k = 0; k < 1 + random() % 8; ++k)
            bytes[random() % reach] = static_cast<char>(random());
        test::writeBytes(path, bytes);
        readAll(path);
    }
}

}  // namespace
}  // namespace noctule
