// SPDX-License-Identifier: Apache-2.0
#include "devices/live/live_session.h"

#include <gtest/gtest.h>

#include "devices/live/record_take.h"
#include "tests/devices/live/fake_device.h"

namespace noctule {
namespace {

using namespace std::chrono_literals;
using test::FakeDevice;
using test::Folder;

constexpr int kTwoBoards = 2;

StreamRequest recordingInto(const Folder& folder) {
    StreamRequest request;
    request.take = RecordingRequest{};
    request.take->folder = folder.path();
    request.take->name = "walk";
    request.take->reserve_bytes = 1'000'000;
    request.take->meta = {{"performer", "Ann"}};
    request.process = false;
    request.software = "test";
    request.created_utc = "2026-01-01T00:00:00Z";
    return request;
}

FakeDevice::Script scriptOf(std::vector<link::StudioEvent> events, double speed = 0) {
    FakeDevice::Script script;
    script.hello = test::madeHello(kTwoBoards);
    script.events = std::move(events);
    script.speed = speed;
    return script;
}

template <class... Parts>
std::vector<link::StudioEvent> joined(Parts... parts) {
    std::vector<link::StudioEvent> all;
    (std::ranges::move(parts, std::back_inserter(all)), ...);
    return all;
}

std::vector<link::StudioEvent> one(link::StudioEvent event) {
    return {std::move(event)};
}

Error why(const std::string& what) {
    return {ErrorKind::kDevice, what, "Look at the box"};
}

template <class Condition>
bool soon(Condition condition) {
    for (int i = 0; i < 1000 && !condition(); ++i)
        std::this_thread::sleep_for(5ms);
    return condition();
}

TEST(LiveSession, RecordsSoManySeconds) {
    const Folder folder;
    auto report =
        recordTake(std::make_unique<FakeDevice>(scriptOf(test::madeEvents(0, 5 * 150000, kTwoBoards), 10)),
                   recordingInto(folder), 1.0, {});
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_FALSE(report->interrupted);
    EXPECT_FALSE(report->stream.trouble);
    const RecorderState& recording = *report->stream.recording;
    EXPECT_GE(recording.samples, 150000);
    EXPECT_LT(recording.samples, 4 * 150000);
    const Result<Take> take = Take::open(recording.path);
    ASSERT_TRUE(take);
    EXPECT_EQ(take->meta().at("performer"), "Ann");
    EXPECT_EQ(take->meta().at("box_serial"), "NB-000777");
    const auto found = test::readMadeSound(*take, kTwoBoards);
    EXPECT_EQ(found.samples, recording.samples);
    EXPECT_EQ(found.wrong_values, 0);
}

TEST(LiveSession, ALinkThatBreaksLeavesAGapAndTimeDoesNotShift) {
    const Folder folder;
    auto events = joined(
        test::madeEvents(0, 60000, kTwoBoards), one(link::LinkLost{why("cut")}), one(link::ConnectWanted{1}),
        one(link::Greeted{test::madeHello(kTwoBoards)}), one(link::Resumed{}),
        one(link::Gap{60000, 30000, link::GapReason::kLink}), test::madeEvents(90000, 120000, kTwoBoards),
        one(link::BoxError{link::Code::kBoardLost, 100000, "l_forearm"}),
        one(link::Gap{120000, 600, link::GapReason::kBox}), test::madeEvents(120600, 130200, kTwoBoards));
    FakeDevice::Script script = scriptOf(std::move(events));
    script.waits_for_stop = false;
    auto report = recordTake(std::make_unique<FakeDevice>(std::move(script)), recordingInto(folder), {}, {});
    ASSERT_TRUE(report) << report.error().text();
    const Result<Take> take = Take::open(report->stream.recording->path);
    const auto found = test::readMadeSound(*take, kTwoBoards);
    EXPECT_EQ(found.wrong_values, 0) << "every sample is in its place";
    EXPECT_EQ(found.end, 130200);
    EXPECT_EQ(found.holes, 30600);
    EXPECT_EQ(report->stream.recording->lost_samples, 30600);
    const auto gaps = take->gaps();
    ASSERT_EQ(gaps->size(), 2u);
    EXPECT_EQ(gaps->at(0).reason, "link");
    EXPECT_EQ(gaps->at(1).reason, "box");
    EXPECT_NE(take->notes()->at(0).text.find("l_forearm"), std::string::npos);
    ASSERT_FALSE(report->stream.warnings.empty());
    EXPECT_EQ(report->stream.warnings[0], "The driver box said at 0:00.6: board lost, l_forearm.");
}

TEST(LiveSession, ABoxThatIsGoneLeavesAGapToTheEndOfTheTimeThatWasAskedFor) {
    const Folder folder;
    auto report = recordTake(std::make_unique<FakeDevice>(scriptOf(joined(
                                 test::madeEvents(0, 60000, kTwoBoards), one(link::LinkLost{why("cut")})))),
                             recordingInto(folder), 1.0, {});
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->stream.recording->samples, 60000);
    EXPECT_EQ(report->stream.recording->lost_samples, 90000);
    ASSERT_TRUE(report->stream.trouble);
    EXPECT_EQ(report->stream.trouble->kind, ErrorKind::kDevice);
    ASSERT_EQ(report->stream.warnings.size(), 1u);
    EXPECT_NE(report->stream.warnings[0].find("lost after 0.4 s"), std::string::npos)
        << report->stream.warnings[0];
    EXPECT_NE(report->stream.warnings[0].find("the last 0.6 s"), std::string::npos)
        << report->stream.warnings[0];
    const Result<Take> take = Take::open(report->stream.recording->path);
    ASSERT_TRUE(take) << take.error().text();
    EXPECT_EQ(take->meta().at("state"), "complete");
    const auto gaps = take->gaps();
    ASSERT_EQ(gaps->size(), 1u);
    EXPECT_EQ(gaps->at(0).first_sample, 60000);
    EXPECT_EQ(gaps->at(0).sample_count, 90000);
    EXPECT_FALSE(gaps->at(0).board);
    EXPECT_EQ(gaps->at(0).reason, "link");
}

TEST(LiveSession, ABoxThatRestartsEndsTheTakeIntact) {
    const Folder folder;
    FakeDevice::Script script = scriptOf(joined(test::madeEvents(0, 60000, kTwoBoards),
                                                one(link::TakeEnded{why("the driver box restarted")})));
    script.ends_by_itself = true;
    auto report = recordTake(std::make_unique<FakeDevice>(std::move(script)), recordingInto(folder), {}, {});
    ASSERT_TRUE(report) << report.error().text();
    ASSERT_TRUE(report->stream.trouble);
    EXPECT_NE(report->stream.trouble->message.find("restarted"), std::string::npos);
    EXPECT_FALSE(report->stream.recording->trouble);
    const Result<Take> take = Take::open(report->stream.recording->path);
    EXPECT_EQ(take->meta().at("state"), "complete");
    EXPECT_EQ(test::readMadeSound(*take, kTwoBoards).samples, 60000);
}

TEST(LiveSession, NobodyThereLeavesNoFile) {
    const Folder folder;
    FakeDevice::Script script = scriptOf({});
    script.greets = false;
    const auto report =
        recordTake(std::make_unique<FakeDevice>(std::move(script)), recordingInto(folder), {}, {});
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().kind, ErrorKind::kDevice);
    EXPECT_TRUE(folder.names().empty());
}

TEST(LiveSession, CancellingKeepsTheTake) {
    const Folder folder;
    struct : ProgressSink {
        void progress(double fraction, const std::string&) override {
            if (fraction > 0)
                cancel.cancel();
        }
        CancelFlag cancel;
    } first_samples;
    auto report =
        recordTake(std::make_unique<FakeDevice>(scriptOf(test::madeEvents(0, 20 * 150000, kTwoBoards), 1)),
                   recordingInto(folder), 20.0, {&first_samples, &first_samples.cancel});
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_TRUE(report->interrupted);
    EXPECT_EQ(Take::open(report->stream.recording->path)->meta().at("state"), "complete");
    EXPECT_GT(report->stream.recording->samples, 0);
}

TEST(LiveSession, ShowsPosesAndHealthWithoutATakeAndTakesAfterwards) {
    const Folder folder;
    const Take tiny = std::move(Take::open(test::kTinyTake).value());
    FakeDevice::Script script = test::tinyTakeScript(600);
    script.speed = 2;
    LiveSession session(std::make_unique<FakeDevice>(std::move(script)));
    EXPECT_FALSE(session.begin({})) << "not connected yet";
    session.connect();
    ASSERT_TRUE(soon([&] { return session.status()->link == LinkState::kReady; }));
    StreamRequest look;
    look.calibration = tiny.calibrationInForce()->value;
    look.actor = tiny.actorInForce()->value;
    look.rest_s = 0.5;
    ASSERT_TRUE(session.begin(look));
    EXPECT_FALSE(session.begin(look)) << "one stream at a time";
    ASSERT_TRUE(soon([&] { return !session.status()->stream_is_open; }));
    const StreamResult result = session.finish();
    EXPECT_FALSE(result.recording);
    ASSERT_TRUE(result.frame);
    EXPECT_EQ(result.frame->sample, 302500);
    EXPECT_TRUE(result.frame->pose);
    EXPECT_GT(result.frame->poses, 200);
    const HealthReport& health = result.frame->health;
    EXPECT_NEAR(health.boards.at(0).frames_per_s, 140, 5);
    EXPECT_GT(health.boards.at(0).ranges_per_s, 5);
    EXPECT_FALSE(health.boards.at(0).silent);
    EXPECT_TRUE(health.pair(0, 0).age_s);
    EXPECT_NEAR(*health.suit.temperature_c, 22.71, 0.01);
    EXPECT_GT(result.frame->latency_median_s, 0);
}

TEST(LiveSession, ASlowReaderMissesFramesAndKeepsNobodyWaiting) {
    Published<std::vector<int>> numbers;
    const auto first = numbers.get();
    for (int i = 0; i < 1000; ++i)
        numbers.set({i});
    EXPECT_TRUE(first->empty());
    EXPECT_EQ(numbers.get()->at(0), 999);
}

TEST(LiveSession, WithoutACalibrationThatFitsItRecordsAllTheSame) {
    const Folder folder;
    StreamRequest request = recordingInto(folder);
    request.process = true;
    Actor stranger = defaultActor();
    stranger.skeleton = Take::open(test::kTinyTake)->actorInForce()->value.skeleton;
    request.actor = stranger;
    FakeDevice::Script script = scriptOf(test::madeEvents(0, 60000, kTwoBoards));
    script.hello.suit.boards[0].segment = "Tail";
    script.waits_for_stop = false;
    auto report = recordTake(std::make_unique<FakeDevice>(std::move(script)), request, {}, {});
    ASSERT_TRUE(report) << report.error().text();
    ASSERT_FALSE(report->stream.warnings.empty());
    EXPECT_NE(report->stream.warnings[0].find("Nothing is processed live"), std::string::npos);
    EXPECT_EQ(report->stream.recording->samples, 60000);
}

TEST(LiveSession, SaysAtOnceThatNothingIsProcessedAndWhy) {
    FakeDevice::Script script = scriptOf(test::madeEvents(0, 60000, kTwoBoards));
    script.hello.suit.boards[0].segment = "Tail";
    LiveSession session(std::make_unique<FakeDevice>(std::move(script)));
    session.connect();
    ASSERT_TRUE(soon([&] { return session.status()->link == LinkState::kReady; }));
    EXPECT_FALSE(session.processingTrouble());
    ASSERT_TRUE(session.begin({}));
    ASSERT_TRUE(session.processingTrouble());
    EXPECT_NE(session.processingTrouble()->text().find("Tail"), std::string::npos)
        << session.processingTrouble()->text();
    session.finish();
    EXPECT_FALSE(session.processingTrouble());
}

}  // namespace
}  // namespace noctule
