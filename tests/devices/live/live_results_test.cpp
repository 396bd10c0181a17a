// SPDX-License-Identifier: Apache-2.0
// A take recorded live and the same take processed from its file: identical derived tables.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <future>
#include <mutex>

#include "devices/live/record_take.h"
#include "tests/devices/live/fake_device.h"
#include "tests/support/same_results.h"

namespace noctule {
namespace {

using test::expectSameResults;
using test::FakeDevice;
using test::Folder;
using test::processedFromFile;
using test::rowsOf;

StreamRequest requestOfTinyTake(const Folder& folder) {
    const Take tiny = std::move(Take::open(test::kTinyTake).value());
    StreamRequest request;
    request.take = RecordingRequest{};
    request.take->folder = folder.path();
    request.take->name = "live";
    request.take->reserve_bytes = 1'000'000;
    request.calibration = tiny.calibrationInForce()->value;
    request.actor = tiny.actorInForce()->value;
    request.rest_s = 0.5;
    request.keep_results = true;
    request.software = "test";
    request.created_utc = "2026-01-01T00:00:00Z";
    return request;
}

std::vector<int16_t> soundOf(const std::string& path, int64_t from_sample) {
    const Take take = std::move(Take::open(path).value());
    const auto boards = take.suit().value().boards.size();
    std::vector<int16_t> sound;
    EXPECT_TRUE(take.forEachBlock(1, [&](const AdcBlock& block) {
        sound.insert(sound.end(), block.values.begin(), block.values.end());
        return true;
    }));
    sound.erase(sound.begin(), sound.begin() + from_sample * static_cast<int64_t>(boards));
    return sound;
}

class LiveResults : public testing::TestWithParam<int> {};

TEST_P(LiveResults, AreThoseOfTheFile) {
    const Folder folder;
    auto recorded = recordTake(std::make_unique<FakeDevice>(test::tinyTakeScript(GetParam())),
                               requestOfTinyTake(folder), std::nullopt, {});
    ASSERT_TRUE(recorded) << recorded.error().text();
    ASSERT_TRUE(recorded->stream.recording);
    EXPECT_FALSE(recorded->stream.recording->trouble);
    EXPECT_EQ(recorded->stream.recording->lost_samples, 0);
    for (const std::string& warning : recorded->stream.warnings)
        ADD_FAILURE() << warning;
    ASSERT_TRUE(recorded->stream.results);
    EXPECT_GT(recorded->stream.results->poses, 200);
    EXPECT_GT(recorded->stream.results->ranges.heard, 100);
    const std::string live = folder.file("live_001.noctule");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"live_001.noctule"});
    expectSameResults(live, processedFromFile(folder, live));
}

TEST_P(LiveResults, AlsoWithHolesAndAnUnpluggedBoard) {
    const Folder folder;
    FakeDevice::Script script = test::tinyTakeScript(GetParam());
    std::vector<link::StudioEvent> holed;
    for (link::StudioEvent& event : script.events) {
        auto* block = std::get_if<link::SoundBlock>(&event);
        if (block && block->first_sample >= 120000 && block->first_sample < 126000) {
            holed.push_back(link::Gap{block->first_sample, block->sampleCount(), link::GapReason::kLink});
            continue;
        }
        if (block && block->first_sample >= 180000 && block->first_sample < 210000)
            for (size_t i = 1; i < block->values.size(); i += 2)
                block->values[i] = 0;
        holed.push_back(std::move(event));
    }
    script.events = std::move(holed);
    auto recorded = recordTake(std::make_unique<FakeDevice>(std::move(script)), requestOfTinyTake(folder),
                               std::nullopt, {});
    ASSERT_TRUE(recorded) << recorded.error().text();
    ASSERT_TRUE(recorded->stream.results);
    const std::string live = folder.file("live_001.noctule");
    const auto boards = rowsOf(live, "SELECT sum(sample_count) FROM gap WHERE reason='board' AND board=1");
    EXPECT_NEAR(std::stod(boards.at(0)), 30000, GetParam());
    EXPECT_GE(recorded->stream.recording->lost_samples, 6000 - GetParam());
    expectSameResults(live, processedFromFile(folder, live));
}

INSTANTIATE_TEST_SUITE_P(OfBlocks, LiveResults, testing::Values(600, 4096, 757));

void waitFor(const std::function<bool()>& condition) {
    for (int i = 0; i < 12'000 && !condition(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_TRUE(condition());
}

/// A take that began in the midst of the tiny take, with a pre-roll of half a second.
StreamResult recordedInTheMidst(const Folder& folder, const PoseListener& listener = {}) {
    FakeDevice::Script script = test::tinyTakeScript(600);
    script.speed = 1;
    LiveSession session(std::make_unique<FakeDevice>(std::move(script)));
    session.connect();
    waitFor([&] { return session.status()->link == LinkState::kReady; });
    StreamRequest look = requestOfTinyTake(folder);
    look.take.reset();
    look.pose_listener = listener;
    EXPECT_TRUE(session.begin(look));
    waitFor([&] { return session.reachedSample() > 90'000; });
    StreamRequest request = requestOfTinyTake(folder);
    request.pose_listener = listener;
    request.take->pre_roll_s = 0.5;
    request.rest_s = 0.1;
    EXPECT_TRUE(session.begin(request));
    waitFor([&] { return !session.status()->stream_is_open; });
    waitFor([&] { return session.latest()->sample > 300'000; });  // the look went on to the end
    return session.finish();
}

TEST(LiveResultsOf, ATakeThatBeganInTheMidstAreThoseOfTheFile) {
    const Folder folder;
    const StreamResult recorded = recordedInTheMidst(folder);
    ASSERT_TRUE(recorded.recording);
    for (const std::string& warning : recorded.warnings)
        ADD_FAILURE() << warning;
    ASSERT_TRUE(recorded.results);
    EXPECT_GT(recorded.results->poses, 100);
    EXPECT_GT(recorded.results->ranges.heard, 50);
    const std::string live = folder.file("live_001.noctule");
    const int64_t origin = 302'500 - recorded.recording->samples;
    EXPECT_EQ(origin % 600, 0) << "it begins with a block";
    const std::string shift = std::to_string(origin);
    EXPECT_EQ(rowsOf(live, "SELECT sample FROM pulse ORDER BY sample"),
              rowsOf(test::kTinyTake,
                     "SELECT sample-" + shift + " FROM pulse WHERE sample>=" + shift + " ORDER BY sample"));
    EXPECT_EQ(soundOf(live, 0), soundOf(test::kTinyTake, origin));
    expectSameResults(live, processedFromFile(folder, live));
}

/// A robot follows them: poses of the take's own pipeline between those of the stream would shake it.
TEST(LiveResultsOf, ATakeThatBeginsInTheMidstAddsNoPosesOfItsOwn) {
    const Folder folder;
    std::mutex mutex;
    std::vector<int64_t> times;
    const StreamResult recorded = recordedInTheMidst(folder, [&](const TimedPose& pose, int64_t) {
        const std::lock_guard lock(mutex);
        times.push_back(pose.time_ns);
    });
    ASSERT_TRUE(recorded.results);
    const std::lock_guard lock(mutex);
    EXPECT_GT(times.size(), 200u);
    EXPECT_TRUE(std::ranges::is_sorted(times, std::ranges::less_equal())) << "one stream, each pose once";
}

TEST(LiveResultsOf, ASuitWithoutCalibrationAreNotKeptAndThatIsSaid) {
    const Folder folder;
    StreamRequest request = requestOfTinyTake(folder);
    request.calibration.reset();
    request.rest_s = 0;
    auto recorded =
        recordTake(std::make_unique<FakeDevice>(test::tinyTakeScript(600)), request, std::nullopt, {});
    ASSERT_TRUE(recorded) << recorded.error().text();
    EXPECT_EQ(recorded->stream.recording->lost_samples, 0);
    EXPECT_FALSE(recorded->stream.results);
    ASSERT_EQ(recorded->stream.warnings.size(), 1U);
    EXPECT_NE(recorded->stream.warnings[0].find("not calibrated"), std::string::npos);
}

/// The poses are made more slowly than the sound comes, as in a flood of pulses, and nobody waits for the
/// rest.
TEST(LiveResultsOf, ATakeWhosePosesWereGivenUpAreNotKeptAndItsSoundIs) {
    const Folder folder;
    std::promise<void> go_on;
    StreamRequest request = requestOfTinyTake(folder);
    request.pose_listener = [held = go_on.get_future().share()](const TimedPose&, int64_t) { held.wait(); };
    LiveSession session(std::make_unique<FakeDevice>(test::tinyTakeScript(600)));
    session.connect();
    waitFor([&] { return session.status()->link == LinkState::kReady; });
    ASSERT_TRUE(session.begin(request));
    const std::vector<int16_t> all = soundOf(test::kTinyTake, 0);
    const int64_t end = std::ssize(all) / session.status()->hello->boardCount();
    waitFor([&] { return session.reachedSample() >= end; });
    session.stop();
    waitFor([&] { return !session.status()->stream_is_open; });
    const auto released = std::async(std::launch::async, [&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        go_on.set_value();
    });
    const StreamResult recorded = session.finish(0);
    EXPECT_TRUE(recorded.lacks_poses);
    EXPECT_GT(recorded.frame->queue.dropped_samples, 30'000) << "what waited, not only what overflowed";
    EXPECT_FALSE(recorded.results);
    EXPECT_EQ(recorded.recording->lost_samples, 0);
    EXPECT_EQ(soundOf(folder.file("live_001.noctule"), 0), all);
}

TEST(LiveResultsOf, ATakeWithMissingSoundAreNotKept) {
    const Folder folder;
    StreamRequest request = requestOfTinyTake(folder);
    FakeDevice::Script script = test::tinyTakeScript(600);
    request.take->reserve_bytes = INT64_MAX / 2;  // the disk is "full" at once
    auto recorded = recordTake(std::make_unique<FakeDevice>(std::move(script)), request, std::nullopt, {});
    ASSERT_TRUE(recorded) << recorded.error().text();
    EXPECT_TRUE(recorded->stream.recording->trouble);
    EXPECT_FALSE(recorded->stream.results);
    EXPECT_TRUE(recorded->stream.lacks_poses);
}

}  // namespace
}  // namespace noctule
