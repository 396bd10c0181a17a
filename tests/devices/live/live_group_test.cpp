// SPDX-License-Identifier: Apache-2.0
// Several suits into one take: what it holds, who is refused, and what a box that fails costs the others.
#include "devices/live/live_group.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "core/recording/database.h"
#include "devices/live/record_take.h"
#include "tests/devices/live/fake_device.h"

namespace noctule {
namespace {

using namespace std::chrono_literals;
using test::FakeDevice;
using test::Folder;
using test::kMadeRate_hz;

constexpr int kOfFirst = 2, kOfSecond = 3;  // boards

FakeDevice::Script groupScript(int number, int boards, double seconds, double speed = 10) {
    FakeDevice::Script script;
    script.hello = test::madeHello(boards);
    script.hello.serial = "NB-00000" + std::to_string(number);
    script.hello.drive_hz = 40000 + 8000 * (number - 1);
    script.hello.pulse_interval_samples = 1200 + 30 * (number - 1);
    script.events = test::madeEvents(0, static_cast<int64_t>(seconds * kMadeRate_hz), boards);
    script.speed = speed;
    script.address = "fake://box" + std::to_string(number);
    return script;
}

std::vector<FakeDevice::Script> twoScripts(double seconds = 3) {
    return {groupScript(1, kOfFirst, seconds), groupScript(2, kOfSecond, seconds)};
}

std::vector<std::unique_ptr<Device>> devicesOf(std::vector<FakeDevice::Script> scripts) {
    std::vector<std::unique_ptr<Device>> devices;
    for (FakeDevice::Script& script : scripts)
        devices.push_back(std::make_unique<FakeDevice>(std::move(script)));
    return devices;
}

GroupRequest groupInto(const Folder& folder, size_t suits = 2) {
    GroupRequest request;
    request.all.take.emplace();
    request.all.take->folder = folder.path();
    request.all.take->name = "duo";
    request.all.take->reserve_bytes = 1'000'000;
    request.all.software = "test";
    request.all.created_utc = "2026-01-01T00:00:00Z";
    request.suits.resize(suits);
    for (GroupSuit& suit : request.suits)
        suit.process = false;
    return request;
}

Result<GroupReport> recordedTogether(std::vector<FakeDevice::Script> scripts, const GroupRequest& request,
                                     std::optional<double> seconds = 1.0, const JobContext& job = {}) {
    return recordTogether(devicesOf(std::move(scripts)), request, seconds, job);
}

/// Blocks of a suit, every value of them checked against what was sent.
struct HeardOfSuit {
    int64_t samples = 0, holes = 0, wrong_values = 0;
};
HeardOfSuit heardOf(const Take& take, int suit, int boards) {
    HeardOfSuit heard;
    int64_t end = 0;
    EXPECT_TRUE(take.forEachBlock(suit, [&](const AdcBlock& block) {
        heard.holes += block.first_sample - end;
        for (size_t i = 0; i < block.values.size(); ++i)
            heard.wrong_values +=
                block.values[i] != test::madeValue(block.first_sample + static_cast<int64_t>(i) / boards,
                                                   static_cast<int>(i % static_cast<size_t>(boards)));
        end = block.first_sample + static_cast<int64_t>(block.values.size()) / boards;
        heard.samples = end;
        return true;
    }));
    return heard;
}

/// The limit only ends waits for what never comes.
template <class Condition>
bool groupComesTo(Condition condition) {
    for (const auto end = std::chrono::steady_clock::now() + 60s; std::chrono::steady_clock::now() < end;) {
        if (condition())
            return true;
        std::this_thread::sleep_for(2ms);
    }
    return condition();
}

TEST(LiveGroup, TwoSuitsBecomeOneTake) {
    const Folder folder;
    GroupRequest request = groupInto(folder);
    request.suits[0].subject = "Ann";
    request.suits[1].subject = "Bob";
    const auto report = recordedTogether(twoScripts(), request);
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_TRUE(report->warnings.empty());
    ASSERT_EQ(report->suits.size(), 2u);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"duo_001.noctule"});
    const Result<Take> take = Take::open(report->suits[0].stream.recording->path);
    ASSERT_TRUE(take) << take.error().text();
    EXPECT_EQ(take->suitIds(), (std::vector<int>{1, 2}));
    EXPECT_EQ(take->meta().at("state"), "complete");
    for (const int suit : {1, 2}) {
        const RecorderState& recording = *report->suits[static_cast<size_t>(suit - 1)].stream.recording;
        const HeardOfSuit heard = heardOf(*take, suit, suit == 1 ? kOfFirst : kOfSecond);
        EXPECT_GE(heard.samples, kMadeRate_hz) << "suit " << suit;
        EXPECT_EQ(heard.samples, recording.samples);
        EXPECT_EQ(heard.samples, take->sampleCount(suit).value());
        EXPECT_EQ(heard.holes, 0);
        EXPECT_EQ(heard.wrong_values, 0);
        const auto pulses = take->pulses(suit);
        ASSERT_TRUE(pulses);
        ASSERT_GE(pulses->size(), 125u);
        EXPECT_EQ(pulses->at(3).sample, 3600);
    }
    EXPECT_EQ(take->suit(2)->carrier_hz, 48000);
    EXPECT_EQ(take->suit(2)->pulse_interval_samples, 1230);
    EXPECT_FALSE(take->suit(1)->carrier_hz) << "meta says it";
    EXPECT_EQ(take->header().drive_hz, 40000);
    EXPECT_EQ(take->meta().at("box_serial"), "NB-000001");
    EXPECT_EQ(take->meta().at("x_box_serial_2"), "NB-000002");
    EXPECT_EQ(take->actors()->size(), 2u) << "the default one each";
    const auto subjects = take->subjects();
    ASSERT_TRUE(subjects) << subjects.error().text();
    ASSERT_EQ(subjects->size(), 2u);
    EXPECT_EQ(subjects->at(1).name, "Bob");
    auto database = Database::open(take->path(), Access::kRead);
    EXPECT_EQ(database->queryInteger("PRAGMA user_version").value(), 1001);
}

TEST(LiveGroup, AnchorsAreASuitThatNobodyWears) {
    const Folder folder;
    auto scripts = twoScripts();
    for (Board& board : scripts[1].hello.suit.boards)
        board.segment.clear();
    for (Source& source : scripts[1].hello.suit.sources)
        source.segment.clear();
    GroupRequest request = groupInto(folder);
    request.suits[0].subject = "Ann";
    request.suits[1].actor = defaultActor();
    const auto refused = recordedTogether(scripts, request);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
    EXPECT_NE(refused.error().message.find("fake://box2"), std::string::npos) << refused.error().message;
    EXPECT_TRUE(folder.names().empty());

    request.suits[1].actor.reset();
    const auto report = recordedTogether(scripts, request);
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_TRUE(report->suits[1].is_room);
    const Result<Take> take = Take::open(report->suits[0].stream.recording->path);
    ASSERT_TRUE(take);
    EXPECT_EQ(take->actors()->size(), 1u);
    const auto subjects = take->subjects();
    ASSERT_TRUE(subjects) << subjects.error().text();
    EXPECT_TRUE(subjects->at(1).room);
    EXPECT_EQ(subjects->at(1).suit(), 2);
}

TEST(LiveGroup, BoxesThatCannotBeToldApartAreRefused) {
    const Folder folder;
    const auto refused = [&](const std::vector<FakeDevice::Script>& scripts, const std::string& named) {
        const auto report = recordedTogether(scripts, groupInto(folder));
        ASSERT_FALSE(report);
        EXPECT_EQ(report.error().kind, ErrorKind::kDevice);
        for (const std::string& word : {std::string("fake://box1"), std::string("fake://box2"), named})
            EXPECT_NE(report.error().text().find(word), std::string::npos) << report.error().text();
        EXPECT_TRUE(folder.names().empty());
    };
    auto scripts = twoScripts();
    scripts[1].hello.drive_hz = 40000;
    refused(scripts, "40 kHz");
    scripts[1].hello.drive_hz = 44000;
    refused(scripts, "40 kHz and 44 kHz");
    scripts = twoScripts();
    scripts[1].hello.serial = scripts[0].hello.serial;
    refused(scripts, "NB-000001");
}

TEST(LiveGroup, SessionsThatAreConnectedAlreadyRecordTogetherUnderNames) {
    const Folder folder;
    std::vector<LiveGroup::Connected> members;
    for (auto& device : devicesOf(twoScripts(6)))
        members.push_back(
            {members.empty() ? "Ann" : "Bob", std::make_shared<LiveSession>(std::move(device))});
    for (const LiveGroup::Connected& member : members) {
        member.session->connect();
        ASSERT_TRUE(groupComesTo([&] { return member.session->status()->link == LinkState::kReady; }));
    }
    GroupRequest request = groupInto(folder);
    request.suits[1].rest_s = 0.5;
    {
        LiveGroup group(members);
        const auto begun = beginTogether(group, request, {});
        ASSERT_TRUE(begun) << begun.error().text();
        EXPECT_TRUE(groupComesTo([&] { return group.reachedOf_s(0) > 1 && group.reachedOf_s(1) > 1; }));
        const GroupReport report = endTogether(group, {});
        ASSERT_EQ(report.suits.size(), 2u);
        EXPECT_EQ(report.suits[1].address, "Bob");
        const Result<Take> take = Take::open(report.suits[0].stream.recording->path);
        ASSERT_TRUE(take) << take.error().text();
        EXPECT_EQ(take->suitIds(), (std::vector<int>{1, 2}));
    }
    for (const LiveGroup::Connected& member : members)
        EXPECT_EQ(member.session->status()->link, LinkState::kReady) << "they outlive the group";
}

TEST(LiveGroup, EqualIntervalsAreSaidAndRecorded) {
    const Folder folder;
    auto scripts = twoScripts();
    scripts[1].hello.pulse_interval_samples = scripts[0].hello.pulse_interval_samples;
    const auto report = recordedTogether(scripts, groupInto(folder));
    ASSERT_TRUE(report) << report.error().text();
    ASSERT_EQ(report->warnings.size(), 1u);
    EXPECT_NE(report->warnings[0].find("1230"), std::string::npos) << "a remedy: " << report->warnings[0];
}

TEST(LiveGroup, ABoxThatDoesNotAnswerOrStartLeavesNothing) {
    const Folder folder;
    auto scripts = twoScripts();
    scripts[1].greets = false;
    const auto silent = recordedTogether(scripts, groupInto(folder));
    ASSERT_FALSE(silent);
    EXPECT_NE(silent.error().message.find("fake://box2"), std::string::npos) << silent.error().message;
    EXPECT_TRUE(folder.names().empty());

    scripts = twoScripts();
    scripts[1].events = {link::RequestFailed{
        link::Type::kStart, {ErrorKind::kDevice, "fake://box2: hardware fault", "Have it repaired"}}};
    scripts[1].ends_by_itself = true;
    const auto failed = recordedTogether(scripts, groupInto(folder));
    ASSERT_FALSE(failed);
    EXPECT_NE(failed.error().message.find("hardware fault"), std::string::npos) << failed.error().message;
    EXPECT_TRUE(folder.names().empty());
}

TEST(LiveGroup, ABoxThatIsLostLeavesAGapAndTheOthersGoOn) {
    const Folder folder;
    auto scripts = twoScripts();
    scripts[1].events = test::madeEvents(0, 60000, kOfSecond);
    scripts[1].events.push_back(
        link::TakeEnded{{ErrorKind::kDevice, "fake://box2: it was switched off", "Look at it"}});
    scripts[1].ends_by_itself = true;
    const auto report = recordedTogether(scripts, groupInto(folder), 2.0);
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_FALSE(report->suits[0].stream.trouble);
    ASSERT_TRUE(report->suits[1].stream.trouble);
    ASSERT_FALSE(report->suits[1].stream.warnings.empty());
    EXPECT_NE(report->suits[1].stream.warnings[0].find("Suit 2 (fake://box2)"), std::string::npos)
        << report->suits[1].stream.warnings[0];
    const Result<Take> take = Take::open(report->suits[0].stream.recording->path);
    ASSERT_TRUE(take);
    EXPECT_GE(heardOf(*take, 1, kOfFirst).samples, 2 * kMadeRate_hz);
    EXPECT_EQ(heardOf(*take, 2, kOfSecond).samples, 60000);
    const auto gaps = take->gaps(2);
    ASSERT_TRUE(gaps);
    ASSERT_EQ(gaps->size(), 1u);
    EXPECT_EQ(gaps->at(0).first_sample, 60000);
    EXPECT_EQ(gaps->at(0).first_sample + gaps->at(0).sample_count, take->sampleCount(1).value());
    EXPECT_EQ(gaps->at(0).reason, "box");
    EXPECT_TRUE(take->gaps(1)->empty());
}

TEST(LiveGroup, WhenAllBoxesAreLostEachHasAGapToTheEndThatWasAskedFor) {
    const Folder folder;
    auto scripts = twoScripts(0.4);
    for (FakeDevice::Script& script : scripts)
        script.events.push_back(link::LinkLost{{ErrorKind::kDevice, script.address + ": cut", "Look"}});
    const auto report = recordedTogether(scripts, groupInto(folder), 1.0);
    ASSERT_TRUE(report) << report.error().text();
    const Result<Take> take = Take::open(report->suits[0].stream.recording->path);
    for (const int suit : {1, 2}) {
        const StreamResult& result = report->suits[static_cast<size_t>(suit - 1)].stream;
        ASSERT_TRUE(result.trouble && result.warnings.size() == 1) << "suit " << suit;
        EXPECT_TRUE(result.warnings[0].ends_with("missing and marked as a gap.")) << result.warnings[0];
        const auto gaps = take->gaps(suit);
        ASSERT_EQ(gaps->size(), 1u);
        EXPECT_EQ(std::pair(gaps->at(0).first_sample, gaps->at(0).sample_count), std::pair(60000L, 90000L));
    }
}

TEST(LiveGroup, ABoxWhoseDataComeLateIsNotCalledLost) {
    const Folder folder;
    const auto report = recordedTogether({groupScript(1, kOfFirst, 30, 10), groupScript(2, kOfSecond, 30, 4)},
                                         groupInto(folder), 1.0);
    ASSERT_TRUE(report) << report.error().text();
    ASSERT_EQ(report->suits[1].stream.warnings.size(), 1u);
    const std::string& said = report->suits[1].stream.warnings[0];
    EXPECT_NE(said.find("Suit 2 (fake://box2) came late"), std::string::npos) << said;
    EXPECT_EQ(said.find("lost"), std::string::npos) << said;
    EXPECT_TRUE(report->suits[0].stream.warnings.empty());
}

/// Cancels once the recording goes on.
class CancelAtProgress : public ProgressSink {
public:
    void progress(double, const std::string& stage) override {
        if (stage.find("Recording 2 suits") != std::string::npos)
            flag.cancel();
    }
    CancelFlag flag;
};

TEST(LiveGroup, CancelledTheTakeIsComplete) {
    const Folder folder;
    CancelAtProgress cancel;
    const auto report =
        recordedTogether(twoScripts(), groupInto(folder), std::nullopt, {&cancel, &cancel.flag});
    ASSERT_TRUE(report) << report.error().text();
    const Result<Take> take = Take::open(report->suits[0].stream.recording->path);
    ASSERT_TRUE(take);
    EXPECT_EQ(take->meta().at("state"), "complete");
    EXPECT_GT(take->sampleCount(2).value(), 0);
    EXPECT_EQ(folder.names().size(), 1u) << "no log beside it";
}

TEST(LiveGroup, AFullDiskEndsAllSuitsIntact) {
    const Folder folder;
    GroupRequest request = groupInto(folder);
    request.all.take->reserve_bytes = INT64_MAX / 2;
    const auto report = recordedTogether(twoScripts(), request, std::nullopt);
    ASSERT_TRUE(report) << report.error().text();
    for (const SuitReport& suit : report->suits) {
        ASSERT_TRUE(suit.stream.recording->trouble);
        EXPECT_EQ(suit.stream.recording->trouble->kind, ErrorKind::kDisk);
    }
    const Result<Take> take = Take::open(report->suits[0].stream.recording->path);
    ASSERT_TRUE(take);
    EXPECT_EQ(take->meta().at("state"), "complete");
}

// The file alone.

std::vector<std::unique_ptr<TakeSink>> twoSinks(const Folder& folder) {
    auto sinks =
        makeTakeFiles({test::madePlan(folder.path(), kOfFirst), test::madePlan(folder.path(), kOfSecond)});
    EXPECT_TRUE(sinks) << sinks.error().text();
    return std::move(*sinks);
}

ArrivedBlock arrivedAt(int64_t first, int64_t count, int boards, double arrived_s) {
    ArrivedBlock block = test::madeBlock(first, count, boards);
    block.arrived_ns = std::llround(arrived_s * 1e9);
    return block;
}

/// Suit 2 began 7 ms after suit 1. Blocks are late by 1 ms at least; the first ones by much more.
TEST(GroupFile, ClocksAreGuessedFromArrivals) {
    const Folder folder;
    auto sinks = twoSinks(folder);
    constexpr double kFirst_s = 100, kSecond_s = 100.007;
    for (int k = 0; k < 200; ++k) {
        const double late_s = k < 20 ? 0.05 : 0.001 + 0.002 * (k % 3), end_s = 0.004 * (k + 1);
        ASSERT_TRUE(sinks[0]->write(arrivedAt(600 * k, 600, kOfFirst, kFirst_s + end_s + 0.001)));
        ASSERT_TRUE(sinks[1]->write(arrivedAt(600 * k, 600, kOfSecond, kSecond_s + end_s + late_s)));
        if (k == 2) {
            ASSERT_TRUE(sinks[0]->commit());
            EXPECT_NEAR(Take::open(sinks[0]->path())->suitClock(2).offset_ns, 56e6, 10)
                << "what is known stands in the file at once";
        }
    }
    for (auto& sink : sinks)
        ASSERT_TRUE(sink->finish());
    const Result<Take> take = Take::open(sinks[0]->path());
    ASSERT_TRUE(take);
    EXPECT_NEAR(take->suitClock(2).offset_ns, 7e6, 10);
    EXPECT_EQ(take->suitClock(2).rate, 1);
    EXPECT_TRUE(take->suitClock(1).isTakeTime());
}

TEST(GroupFile, WhatFailsForOneHasFailedForAllAndTheTakeIsIntact) {
    const Folder folder;
    auto sinks = twoSinks(folder);
    ASSERT_TRUE(sinks[0]->write(test::madeBlock(0, 600, kOfFirst)));
    ASSERT_TRUE(sinks[1]->write(test::madeBlock(0, 600, kOfSecond)));
    ASSERT_TRUE(sinks[0]->commit());
    ASSERT_TRUE(sinks[1]->write(test::madeBlock(600, 600, kOfSecond)));
    const Status twice = sinks[0]->write(test::madeBlock(0, 600, kOfFirst));
    ASSERT_FALSE(twice) << "a block stands there already";
    EXPECT_TRUE(sinks[0]->rollBack());
    EXPECT_TRUE(sinks[0]->finish());
    EXPECT_FALSE(sinks[1]->ready());
    EXPECT_EQ(sinks[1]->write(test::madeBlock(1200, 600, kOfSecond)).error().message, twice.error().message);
    EXPECT_FALSE(sinks[1]->commit());
    EXPECT_TRUE(sinks[1]->rollBack());
    EXPECT_TRUE(sinks[1]->finish());
    const Result<Take> take = Take::open(sinks[0]->path());
    ASSERT_TRUE(take);
    EXPECT_EQ(take->meta().at("state"), "complete");
    EXPECT_EQ(heardOf(*take, 1, kOfFirst).samples, 600);
    EXPECT_EQ(heardOf(*take, 2, kOfSecond).samples, 600) << "what was committed";
}

/// Two threads, one file, and a third program that keeps taking it.
TEST(GroupFile, TwoRecordersBesideAProgramThatKeepsWritingLoseNothing) {
    const Folder folder;
    auto sinks = twoSinks(folder);
    const std::string path = sinks[0]->path();
    RecorderSettings settings;
    settings.reserve_bytes = 1'000'000;
    std::vector<std::unique_ptr<Recorder>> recorders;
    for (auto& sink : sinks)
        recorders.push_back(std::make_unique<Recorder>(std::move(sink), settings));
    std::atomic<bool> ended{false};
    std::thread other([&] {
        auto database = Database::open(path, Access::kReadWrite);
        ASSERT_TRUE(database);
        database->setPatience_s(0);
        while (!ended) {
            if (database->execute("BEGIN IMMEDIATE")) {
                std::this_thread::sleep_for(300ms);
                EXPECT_TRUE(database->execute("ROLLBACK"));
            }
            std::this_thread::sleep_for(1ms);
        }
    });
    constexpr int64_t kSamples = 3 * kMadeRate_hz;
    const auto begin = std::chrono::steady_clock::now();
    for (int64_t at = 0; at < kSamples; at += 600) {
        recorders[0]->push(test::madeBlock(at, 600, kOfFirst));
        recorders[1]->push(test::madeBlock(at, 600, kOfSecond));
        std::this_thread::sleep_until(begin + std::chrono::nanoseconds(at * 1'000'000 / 150));
    }
    ended = true;
    other.join();
    for (auto& recorder : recorders) {
        const RecorderState state = recorder->finish();
        EXPECT_FALSE(state.trouble) << state.trouble->text();
        EXPECT_EQ(state.lost_samples, 0);
    }
    const Result<Take> take = Take::open(path);
    ASSERT_TRUE(take);
    for (const int suit : {1, 2}) {
        const HeardOfSuit heard = heardOf(*take, suit, suit == 1 ? kOfFirst : kOfSecond);
        EXPECT_EQ(heard.samples, kSamples);
        EXPECT_EQ(heard.holes, 0);
        EXPECT_EQ(heard.wrong_values, 0);
    }
}

}  // namespace
}  // namespace noctule
