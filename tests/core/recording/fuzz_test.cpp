// SPDX-License-Identifier: Apache-2.0
// Takes and JSON files under damage: a reader may refuse them or leave rows out, but never crashes, throws or
// grows.
#include "core/body/actor.h"
#include "core/recording/take.h"
#include "core/recording/take_writer.h"
#include "core/suit/calibration.h"
#include "core/suit/default_suit.h"
#include "tests/support/files.h"
#include "tests/support/fuzzing.h"

namespace noctule::test {
namespace {

constexpr const char* kFuzzCreated = "2026-03-01T10:00:00Z";
constexpr int64_t kMostTakeGrowth_kb = 96 * 1024;  ///< the longest value that a reader accepts is 64 MiB
constexpr int64_t kMostJsonGrowth_kb = 32 * 1024;

/// Every table has rows, all of them together are small.
std::string smallTake(const Folder& folder) {
    const std::string path = folder.file("small.noctule");
    TakeHeader header;
    header.created_utc = kFuzzCreated;
    header.sample_rate_hz = 1000;
    Suit suit = defaultSuit();
    suit.boards.resize(2);
    suit.sources.resize(2);
    header.board_count = header.source_count = 2;
    auto take = TakeWriter::create(path, header, {});
    EXPECT_TRUE(take);
    EXPECT_TRUE(take->addSuit(suit));
    EXPECT_TRUE(take->addCalibration(Calibration{}));
    EXPECT_TRUE(take->addActor(defaultActor(), kFuzzCreated));
    const std::vector<int16_t> values(2 * 40, 7);
    for (int64_t i = 0; i < 4; ++i) {
        EXPECT_TRUE(take->addBlock({i * 40, values}, 2, 1, i % 2 == 1));
        EXPECT_TRUE(take->addPulse(i * 40, static_cast<int>(i % 2)));
        StatusRow status;
        status.sample = i * 40;
        status.temperature_c = 21;
        EXPECT_TRUE(take->addStatus(status));
        InertialReading reading;
        reading.board = static_cast<int>(i % 2);
        reading.frame = i / 2;
        reading.sample = static_cast<double>(i) * 7;
        reading.counts = {2048, 2048, 2048, 2048, 2048, 2048};
        EXPECT_TRUE(take->addInertial(kPrimaryRun, reading));
        RangeMeasurement range;
        range.pulse = i + 1;
        range.board = 1;
        range.distance_m = 0.5;
        EXPECT_TRUE(take->addRange(kPrimaryRun, range, "inflection"));
        EXPECT_TRUE(take->addReference({i * 1'000'000, defaultActor().skeleton.zeroPose(), {}}));
    }
    EXPECT_TRUE(take->addMarker({0, "rest", "begin"}));
    EXPECT_TRUE(take->addGap({160, 10, std::nullopt, "link"}));
    EXPECT_TRUE(take->addNote({kFuzzCreated, "a note"}));
    EXPECT_TRUE(take->finish());
    return path;
}

/// Everything that a take may be asked; what is refused is a good answer.
void readEverything(const Take& take) {
    int64_t end = 0;
    (void)take.missingParts();
    (void)take.duration_s();
    for (const int suit : {1, 2}) {
        (void)take.suit(suit);
        (void)take.forEachBlock(suit, [&](const AdcBlock& block) {
            EXPECT_GE(block.first_sample, end) << "blocks rise and do not overlap";
            EXPECT_LE(block.first_sample, kLastSample);
            end = block.first_sample + 1;
            return true;
        });
        end = 0;
        (void)take.pulses(suit);
        (void)take.statusRows(suit);
        (void)take.gaps(suit);
        (void)take.markers(suit);
        (void)take.reference(suit);
        (void)take.externalRoot(suit);
        (void)take.restInterval(suit);
        (void)take.calibrationInForce(suit);
        (void)take.actorInForce(suit);
        (void)take.poses(1, suit);
        if (auto readings = take.readings(kPrimaryRun, suit))
            for (auto row = readings->next(); row && *row; row = readings->next()) {
            }
        if (auto ranges = take.ranges(kPrimaryRun, suit))
            for (auto row = ranges->next(); row && *row; row = ranges->next()) {
            }
    }
    (void)take.notes();
    (void)take.derivedRuns();
    (void)take.skippedRows();
}

TEST(FuzzTake, DamagedFiles) {
    const Folder folder;
    const std::string path = smallTake(folder), damaged = folder.file("damaged.noctule");
    const std::vector<std::string> examples{readBytes(path)};
    EXPECT_LT(examples[0].size(), 400'000u) << "small, so that a wound hits something";
    int64_t opened = 0;
    feedDamaged(examples, 400, kMostTakeGrowth_kb, [&](const std::string& bytes, int64_t) {
        writeBytes(damaged, bytes);
        const Result<Take> take = Take::open(damaged);
        if (!take)
            return;
        ++opened;
        readEverything(*take);
    });
    std::printf("%lld of them could be opened\n", static_cast<long long>(opened));
    EXPECT_GT(opened, 0);
}

TEST(FuzzJson, DamagedDocuments) {
    const Suit suit = defaultSuit();
    Calibration calibration;
    for (const Board& board : suit.boards)
        calibration.boards.emplace_back().id = board.id;
    for (const Source& source : suit.sources) {
        calibration.sources.emplace_back().id = source.id;
        calibration.sources.back().offsets_s = {{"inflection", 1e-4}};
    }
    const Actor actor = defaultActor();
    const std::vector<std::string> examples{toJson(suit).dump(), toJson(calibration).dump(),
                                            toJson(actor).dump()};
    int64_t parsed = 0;
    feedDamaged(examples, 3000, kMostJsonGrowth_kb, [&](const std::string& text, int64_t) {
        const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
        if (json.is_discarded())
            return;
        ++parsed;
        (void)suitFromJson(json, "fuzz");
        (void)calibrationFromJson(json, "fuzz");
        (void)actorFromJson(json, "fuzz");
    });
    EXPECT_GT(parsed, 0);
}

}  // namespace
}  // namespace noctule::test
