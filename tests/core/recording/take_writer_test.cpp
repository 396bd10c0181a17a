// SPDX-License-Identifier: Apache-2.0
#include "core/recording/take_writer.h"

#include <gtest/gtest.h>

#include <random>

#include "core/suit/default_suit.h"
#include "tests/core/recording/collect.h"

namespace noctule {
namespace {

using test::Folder;

TakeHeader smallHeader() {
    TakeHeader header;
    header.uuid = "1";
    header.name = "small";
    header.created_utc = "2026-01-01T00:00:00Z";
    header.software = "test";
    header.sample_rate_hz = 150000;
    header.board_count = 18;
    header.source_count = 8;
    header.pulse_cycles = 9.5;
    header.take_kind = "jig";
    return header;
}

std::vector<int16_t> noise(size_t count) {
    std::mt19937 random(7);
    std::vector<int16_t> values(count);
    for (int16_t& value : values)
        value = static_cast<int16_t>(random() % 1000);
    return values;
}

TEST(TakeWriter, EverythingIsReadBack) {
    const Folder folder;
    const std::string path = folder.file("t.noctule");
    const std::vector<int16_t> values = noise(18 * 600);
    const Actor actor = defaultActor();
    const TimedPose seen{7142857, actor.restPose(), {}};
    {
        Result<TakeWriter> writer = TakeWriter::create(path, smallHeader());
        ASSERT_TRUE(writer) << writer.error().text();
        EXPECT_FALSE(std::filesystem::exists(path)) << "written aside";
        EXPECT_EQ(*writer->addSuit(defaultSuit(), {12.5, 1.000001}), 1);
        ASSERT_TRUE(writer->addCalibration(nominalCalibration(defaultSuit())));
        ASSERT_TRUE(writer->addActor(actor, "2026-01-01T00:00:00Z"));
        ASSERT_TRUE(writer->addBlock({600, values}, 18, 1, true));
        ASSERT_TRUE(writer->addBlock({0, values}, 18, 1));
        EXPECT_EQ(*writer->addPulse(1200, 7), 1);
        ASSERT_TRUE(writer->addStatus({150000, 21.5, {}, 3.9, 55}));
        ASSERT_TRUE(writer->addGap({700, 10, 3, "board"}));
        ASSERT_TRUE(writer->addGap({600, 1, {}, "link"}));
        ASSERT_TRUE(writer->addMarker({5, "placement", "J\xc3\xb6rg's table"}));
        ASSERT_TRUE(writer->addNote({"2026-01-01T00:00:00Z", "strap slipped"}));
        ASSERT_TRUE(writer->addReference({0, {}, {}}));
        ASSERT_TRUE(writer->addReference(seen));
        ASSERT_TRUE(writer->addExternalRoot({3, {1, 2, 3}, {0.5, 0.5, 0.5, -0.5}, 0.001, 0.002}));
        ASSERT_TRUE(writer->addInertial(kPrimaryRun, {17, 2, 1000.5, {1.5, 2, 3, 4, 5, 6}, {7, 8, {}}, 1}));
        ASSERT_TRUE(writer->addRange(kPrimaryRun, {1, 1200, 7, 17, 1400, 0.4, 1, 1, 1, 0.002}, "matched"));
        ASSERT_TRUE(writer->finish());
    }
    EXPECT_EQ(folder.names().size(), 1u);

    const Result<Take> take = Take::open(path);
    ASSERT_TRUE(take) << take.error().text();
    EXPECT_EQ(take->header().pulse_cycles, 9.5);
    EXPECT_EQ(take->header().take_kind, "jig");
    EXPECT_EQ(take->meta().at("state"), "complete");
    EXPECT_EQ(take->meta().at("sample_count"), "1200");
    EXPECT_EQ(toJson(*take->suit()), toJson(defaultSuit()));
    EXPECT_EQ(take->suitClock().offset_ns, 12.5);
    EXPECT_EQ(take->suitClock().rate, 1.000001);
    EXPECT_EQ(toJson(take->calibrationInForce()->value), toJson(nominalCalibration(defaultSuit())));
    EXPECT_EQ(toJson(take->actorInForce()->value), toJson(actor));
    std::vector<int64_t> starts;
    ASSERT_TRUE(take->forEachBlock(1, [&](const AdcBlock& block) {
        starts.push_back(block.first_sample);
        EXPECT_TRUE(std::equal(block.values.begin(), block.values.end(), values.begin(), values.end()));
        return true;
    }));
    EXPECT_EQ(starts, (std::vector<int64_t>{0, 600}));
    EXPECT_EQ(take->pulses()->at(0).source, 7);
    EXPECT_FALSE(take->statusRows()->at(0).humidity_percent);
    EXPECT_EQ(take->statusRows()->at(0).battery_percent, 55);
    const auto gaps = take->gaps();
    EXPECT_FALSE(gaps->at(0).board);
    EXPECT_EQ(gaps->at(1).board, 3);
    EXPECT_EQ(gaps->at(1).reason, "board");
    EXPECT_EQ(take->markers()->at(0).label, "J\xc3\xb6rg's table");
    EXPECT_EQ(take->notes()->at(0).text, "strap slipped");
    const auto reference = take->reference();
    ASSERT_TRUE(reference) << reference.error().text();
    EXPECT_FALSE(reference->frames.at(0).pose);
    for (size_t joint = 0; joint < seen.pose->q_parent_joint.size(); ++joint)
        EXPECT_EQ(reference->frames.at(1).pose->q_parent_joint[joint].coeffs(),
                  seen.pose->q_parent_joint[joint].coeffs());
    EXPECT_EQ(take->externalRoot()->at(0).q_world_root.z(), -0.5);
    auto readings = take->readings(kPrimaryRun);
    const auto all = test::collect(*readings);
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].board, 17);
    EXPECT_EQ(all[0].counts[0], 1.5);
    EXPECT_EQ(all[0].magnetometer_counts[1], 8);
    EXPECT_FALSE(all[0].magnetometer_counts[2]);
    auto ranges = take->ranges(kPrimaryRun);
    EXPECT_EQ(test::collect(*ranges).at(0).arrival_sample, 1400);
    EXPECT_TRUE(take->skippedRows().empty());
}

TEST(TakeWriter, LeavesNoHalfFile) {
    const Folder folder;
    const std::string path = folder.file("t.noctule");
    {
        Result<TakeWriter> forgotten = TakeWriter::create(path, smallHeader());
        ASSERT_TRUE(forgotten->addBlock({0, noise(18 * 5000)}, 18, 1));
        Result<TakeWriter> abandoned = TakeWriter::create(path, smallHeader());
        abandoned->abandon();
        EXPECT_EQ(folder.names().size(), 1u);
    }
    EXPECT_EQ(folder.names().size(), 0u);
}

TEST(TakeWriter, NeverOverwritesUnasked) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    const auto refused = TakeWriter::create(path, smallHeader());
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
    EXPECT_FALSE(TakeWriter::create(path, smallHeader(), {true, TakeWriter::Journal::kWal}));
    EXPECT_EQ(test::readBytes(path), test::readBytes(test::kTinyTake));
    {
        Result<TakeWriter> unfinished = TakeWriter::create(path, smallHeader(), {true});
        ASSERT_TRUE(unfinished);
    }
    EXPECT_EQ(test::readBytes(path), test::readBytes(test::kTinyTake));
    Result<TakeWriter> asked = TakeWriter::create(path, smallHeader(), {true});
    ASSERT_TRUE(asked->finish());
    EXPECT_EQ(Take::open(path)->header().name, "small");
    EXPECT_EQ(folder.names().size(), 1u);
    test::writeBytes(path + "-wal", "frames");
    EXPECT_EQ(TakeWriter::create(path, smallHeader(), {true}).error().kind, ErrorKind::kUsage);
}

TEST(TakeWriter, FolderThatIsNotThere) {
    const Folder folder;
    const auto writer = TakeWriter::create(folder.file("none/t.noctule"), smallHeader());
    ASSERT_FALSE(writer);
    EXPECT_EQ(writer.error().kind, ErrorKind::kDisk);
}

TEST(TakeWriter, ARecordingShowsWhatWasCommitted) {
    const Folder folder;
    const std::string path = folder.file("t.noctule");
    const std::vector<int16_t> values = noise(18 * 100);
    Result<TakeWriter> writer = TakeWriter::create(path, smallHeader(), {false, TakeWriter::Journal::kWal});
    ASSERT_TRUE(writer) << writer.error().text();
    ASSERT_TRUE(writer->addSuit(defaultSuit()));
    ASSERT_TRUE(writer->addBlock({0, values}, 18, 1));
    ASSERT_TRUE(writer->commit());
    ASSERT_TRUE(writer->addBlock({100, values}, 18, 1));

    // As after a crash: both files as they are now.
    const std::string crashed = folder.file("crashed.noctule");
    std::filesystem::copy_file(path, crashed);
    std::filesystem::copy_file(path + "-wal", crashed + "-wal");
    for (const std::string& name : {path, crashed}) {
        const Result<Take> take = Take::open(name);
        ASSERT_TRUE(take) << take.error().text();
        EXPECT_EQ(take->meta().at("state"), "recording");
        EXPECT_EQ(*take->sampleCount(), 100);
    }
    ASSERT_TRUE(writer->finish());
    EXPECT_FALSE(std::filesystem::exists(path + "-wal"));
    EXPECT_EQ(*Take::open(path)->sampleCount(), 200);
}

TEST(TakeWriter, TheSameBlockTwiceIsAnError) {
    const Folder folder;
    Result<TakeWriter> writer = TakeWriter::create(folder.file("t.noctule"), smallHeader());
    ASSERT_TRUE(writer->addSuit(defaultSuit()));
    ASSERT_TRUE(writer->addBlock({0, noise(18)}, 18, 1));
    EXPECT_FALSE(writer->addBlock({0, noise(18)}, 18, 1));
    EXPECT_TRUE(writer->addBlock({1, noise(18)}, 18, 1));
    ASSERT_TRUE(writer->finish());
    EXPECT_EQ(*Take::open(folder.file("t.noctule"))->sampleCount(), 2);
}

}  // namespace
}  // namespace noctule
