// SPDX-License-Identifier: Apache-2.0
// Takes that begin and end in the midst of a stream that somebody looks at.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "tests/devices/live/hand_device.h"

namespace noctule {
namespace {

using test::Folder;
using test::LookedAt;

constexpr int kWorn = LookedAt::kBoards;

StreamRequest takeInto(const Folder& folder, double pre_roll_s) {
    StreamRequest request;
    request.take = RecordingRequest{};
    request.take->folder = folder.path();
    request.take->name = "walk";
    request.take->reserve_bytes = 1'000'000;
    request.take->pre_roll_s = pre_roll_s;
    request.process = false;
    request.created_utc = "2026-01-01T00:00:00Z";
    return request;
}

/// Sound and status come when a test says so.
struct Worn : LookedAt {
    void sayBattery(int64_t sample, float percent) {
        link::BoxStatus status;
        status.sample = sample;
        status.battery_percent = percent;
        status.board_flags = {1, 1};
        hand->tell(status);
    }
};

/// Sound, pulses and their numbers are those of the stream from `origin` on.
void expectStreamFrom(const Take& take, int64_t origin, int64_t end) {
    int64_t next = 0, wrong = 0;
    EXPECT_TRUE(take.forEachBlock(1, [&](const AdcBlock& block) {
        EXPECT_EQ(block.first_sample, next);
        for (size_t i = 0; i < block.values.size(); ++i)
            wrong += block.values[i] != test::madeValue(origin + next + static_cast<int64_t>(i) / kWorn,
                                                        static_cast<int>(i) % kWorn);
        next += std::ssize(block.values) / kWorn;
        return true;
    }));
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(next, end - origin);
    EXPECT_EQ(take.meta().at("sample_count"), std::to_string(next));
    const auto pulses = take.pulses();
    int64_t sample = (origin + 1199) / 1200 * 1200, id = 1;
    EXPECT_EQ(std::ssize(*pulses), (end - sample + 1199) / 1200);
    for (const Pulse& pulse : *pulses) {
        EXPECT_EQ(pulse.id, id++);
        EXPECT_EQ(pulse.sample + origin, sample);
        EXPECT_EQ(pulse.source, sample / 1200 % 8);
        sample += 1200;
    }
}

TEST(PreRoll, ATakeHoldsTheSecondBeforeItWasAskedFor) {
    const Folder folder;
    Worn worn;
    worn.sayBattery(0, 90);
    worn.hear(0, 60'000);
    worn.sayBattery(60'000, 80);
    worn.hear(60'000, 240'000);
    ASSERT_TRUE(worn.session.begin(takeInto(folder, 1)));
    EXPECT_EQ(worn.session.reachedSample(), 150'000) << "on the clock of the take";
    worn.session.addMarker("user", "jump");
    worn.sayBattery(240'000, 70);
    worn.hear(240'000, 300'000);
    const StreamResult result = worn.session.finish();
    ASSERT_TRUE(result.recording);
    EXPECT_EQ(result.recording->lost_samples, 0);
    EXPECT_EQ(worn.hand->stops, 0) << "the looking goes on";

    const Result<Take> take = Take::open(result.recording->path);
    ASSERT_TRUE(take) << take.error().text();
    expectStreamFrom(*take, 90'000, 300'000);
    const auto statuses = take->statusRows();
    ASSERT_EQ(statuses->size(), 2u);
    EXPECT_EQ(statuses->at(0).sample, 0);
    EXPECT_EQ(statuses->at(0).battery_percent, 80) << "what the box had said last";
    EXPECT_EQ(statuses->at(1).sample, 150'000);
    const auto markers = take->markers();
    ASSERT_EQ(markers->size(), 2u);
    EXPECT_EQ(markers->at(0).kind, "start");
    EXPECT_EQ(markers->at(0).sample, 150'000);
    EXPECT_EQ(markers->at(1).label, "jump");
    EXPECT_EQ(markers->at(1).sample, 150'000);
}

/// A machine that is slow sees things late, and the take of what it saw begins no later for that.
TEST(PreRoll, ATakeOfWhatWasSeenBeginsBeforeThat) {
    const Folder folder;
    Worn worn;
    worn.hear(0, 12 * 150'000);
    StreamRequest request = takeInto(folder, 10);
    request.take->seen_sample = 10 * 150'000 + 90'000;
    ASSERT_TRUE(worn.session.begin(request));
    EXPECT_EQ(worn.session.reachedSample(), 12 * 150'000 - 90'000);
    const StreamResult result = worn.session.finish();
    ASSERT_TRUE(result.recording);
    const Result<Take> take = Take::open(result.recording->path);
    ASSERT_TRUE(take) << take.error().text();
    expectStreamFrom(*take, 90'000, 12 * 150'000);
}

TEST(PreRoll, TakesFollowOneAnotherWhileTheSuitStreams) {
    const Folder folder;
    Worn worn;
    int64_t heard = 0;
    for (const double pre_roll_s : {0.0, 0.5, 99.0}) {
        worn.hear(heard, heard + 90'000);
        const int64_t asked = heard + 90'000;
        ASSERT_TRUE(worn.session.begin(takeInto(folder, pre_roll_s)));
        EXPECT_FALSE(worn.session.begin(takeInto(folder, 0))) << "one at a time";
        worn.hear(asked, asked + 30'000);
        const StreamResult result = worn.session.finish();
        heard = asked + 30'000;
        worn.hear(heard, heard + 6'000);  // belongs to nobody
        heard += 6'000;
        const Result<Take> take = Take::open(result.recording->path);
        expectStreamFrom(*take,
                         std::max<int64_t>(0, asked - std::llround(std::min(pre_roll_s, 10.0) * 150'000)),
                         asked + 30'000);
        EXPECT_EQ(take->markers()->size(), pre_roll_s > 0 ? 1u : 0u);
        EXPECT_FALSE(worn.session.recording());
        EXPECT_EQ(worn.session.status()->link, LinkState::kStreaming);
        EXPECT_TRUE(worn.session.status()->stream_is_open);
    }
    EXPECT_EQ(worn.hand->starts, 1);
    EXPECT_EQ(worn.hand->stops, 0);
    EXPECT_EQ(folder.names().size(), 3u);
}

TEST(PreRoll, TheRestPoseIsHeldFromTheMomentOnAtWhichItWasAskedFor) {
    const Folder folder;
    Worn worn;
    worn.hear(0, 90'000);
    StreamRequest request = takeInto(folder, 0.2);
    request.rest_s = 0.1;
    ASSERT_TRUE(worn.session.begin(request));
    worn.hear(90'000, 120'000);
    const Result<Take> take = Take::open(worn.session.finish().recording->path);
    const auto markers = take->markers();
    ASSERT_EQ(markers->size(), 3u);
    EXPECT_EQ(markers->at(1).kind, "rest");
    EXPECT_EQ(markers->at(1).sample, 30'000);
    EXPECT_EQ(markers->at(2).sample, 44'999);
}

TEST(PreRoll, AHoleInTheStreamIsAHoleInTheTake) {
    const Folder folder;
    Worn worn;
    worn.hear(0, 60'000);
    worn.hand->tell(link::Gap{60'000, 6'000, link::GapReason::kLink});
    worn.hear(66'000, 90'000);
    worn.hand->tell(link::Gap{90'000, 1'200, link::GapReason::kBox});
    worn.hear(91'200, 120'000);
    ASSERT_TRUE(worn.session.begin(takeInto(folder, 58'000 / 150'000.0)));  // in the first hole
    worn.hear(120'000, 126'000);
    const Result<Take> take = Take::open(worn.session.finish().recording->path);
    const auto gaps = take->gaps();
    ASSERT_EQ(gaps->size(), 1u) << "what was missing before it began is not missing in it";
    EXPECT_EQ(gaps->at(0).first_sample, 24'000);
    EXPECT_EQ(gaps->at(0).sample_count, 1'200);
    EXPECT_EQ(gaps->at(0).reason, "box");
    EXPECT_EQ(take->meta().at("sample_count"), "60000");
}

TEST(PreRoll, AStreamThatEndsEndsTheTakeInItsMidst) {
    const Folder folder;
    Worn worn;
    worn.hear(0, 90'000);
    ASSERT_TRUE(worn.session.begin(takeInto(folder, 0.2)));
    worn.hear(90'000, 120'000);
    worn.hand->tell(link::TakeEnded{{ErrorKind::kDevice, "the box has restarted", "Start a new take"}});
    EXPECT_EQ(worn.session.status()->link, LinkState::kReady);
    const StreamResult result = worn.session.finish();
    ASSERT_TRUE(result.trouble);
    expectStreamFrom(*Take::open(result.recording->path), 60'000, 120'000);
    worn.session.finish();
    EXPECT_EQ(worn.hand->stops, 0) << "it had stopped by itself";
    EXPECT_TRUE(worn.session.begin(takeInto(folder, 1))) << "as before: with the device";
    EXPECT_EQ(worn.hand->starts, 2);
}

TEST(PreRoll, FinishingTheLookStopsTheDevice) {
    Worn worn;
    worn.hear(0, 6'000);
    worn.session.finish();
    EXPECT_EQ(worn.hand->stops, 1);
    EXPECT_EQ(worn.session.status()->link, LinkState::kStopping);
    EXPECT_FALSE(worn.session.begin({})) << "the box still sends";
    worn.hear(6'000, 12'000);
    worn.hand->tell(link::Stopped{});
    EXPECT_EQ(worn.session.status()->link, LinkState::kReady);
}

TEST(PreRoll, ATakeInTheMidstNeedsSoundThatComes) {
    const Folder folder;
    Worn worn;
    worn.hear(0, 6'000);
    worn.hand->tell(link::LinkLost{{ErrorKind::kDevice, "cut", "Look"}});
    EXPECT_FALSE(worn.session.begin(takeInto(folder, 1)));
    EXPECT_TRUE(folder.names().empty());
}

/// For the thread sanitizer, too: everybody does at once what anybody may do.
TEST(PreRoll, ScreensAndJobsMayAskAtAnyMoment) {
    const Folder folder;
    Worn worn;
    worn.hear(0, 30'000);
    std::atomic<bool> ends{false};
    std::thread device([&] {
        for (int64_t at = 30'000; !ends; at += 6'000) {
            worn.hear(at, at + 6'000);
            std::this_thread::sleep_for(std::chrono::milliseconds(4));
        }
    });
    std::thread screen([&] {
        while (!ends) {
            (void)worn.session.status();
            (void)worn.session.latest();
            (void)worn.session.recording();
            (void)worn.session.processingTrouble();
            worn.session.addMarker("user", "M");
            worn.session.identify({0, 100});
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    });
    for (int take = 0; take < 3; ++take) {
        ASSERT_TRUE(worn.session.begin(takeInto(folder, 0.1)));
        std::this_thread::sleep_for(std::chrono::milliseconds(40));
        const StreamResult result = worn.session.finish();
        EXPECT_FALSE(result.recording->trouble);
        EXPECT_EQ(result.recording->lost_samples, 0);
        EXPECT_EQ(std::to_string(result.recording->samples),
                  Take::open(result.recording->path)->meta().at("sample_count"));
    }
    ends = true;
    device.join();
    screen.join();
    EXPECT_FALSE(worn.hand->identified.empty());
}

TEST(PreRoll, SoundThatBrokeOffIsAGapToWhereTheTakeEnded) {
    const Folder folder;
    LookedAt worn;
    worn.hear(0, 60000);
    ASSERT_TRUE(worn.session.begin(takeInto(folder, 0)));
    const int64_t heard_ns = steadyNow_ns();
    worn.hear(60000, 120000);
    worn.hand->tell(link::Stalled{});
    while (!worn.session.brokenOffUntil())
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const StreamResult result = worn.session.finish();
    const auto most = static_cast<int64_t>(static_cast<double>(steadyNow_ns() - heard_ns) * 1e-9 * 150'000);
    ASSERT_TRUE(result.trouble);
    ASSERT_EQ(result.warnings.size(), 1u);
    EXPECT_NE(result.warnings[0].find("marked as a gap"), std::string::npos) << result.warnings[0];
    const auto gaps = Take::open(result.recording->path)->gaps();
    ASSERT_EQ(gaps->size(), 1u);
    EXPECT_EQ(gaps->at(0).first_sample, 60000) << "on the take's clock";
    EXPECT_GE(gaps->at(0).sample_count, LiveSession::kWorthMarking_s * 150'000);
    EXPECT_LE(gaps->at(0).sample_count, most + 1);
}

TEST(PreRoll, SoundThatCameBackLeavesNoGapAtTheEnd) {
    const Folder folder;
    LookedAt worn;
    worn.hear(0, 60000);
    ASSERT_TRUE(worn.session.begin(takeInto(folder, 0)));
    worn.hear(60000, 120000);
    worn.hand->tell(link::Stalled{});
    while (!worn.session.brokenOffUntil())
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    worn.hand->tell(link::Flowing{});
    worn.hear(120000, 150000);
    const StreamResult result = worn.session.finish();
    EXPECT_FALSE(result.trouble);
    EXPECT_TRUE(result.warnings.empty());
    EXPECT_TRUE(Take::open(result.recording->path)->gaps()->empty());
}

}  // namespace
}  // namespace noctule
