// SPDX-License-Identifier: Apache-2.0
// What only a take that is played again does.
#include "tests/devices/support/event_log.h"

namespace noctule::test {
namespace {

struct Replay {
    explicit Replay(const std::string& path, double speed = 0)
        : device(makeDevice("replay:" + path, {speed}).value()) {
        device->open(log.listener());
    }
    bool playsToTheEnd() {
        device->start();
        return log.waitFor<link::Stopped>();
    }

    EventLog log;
    std::unique_ptr<Device> device;
};

TEST(ReplayDeviceTest, AsFastAsPossibleNothingIsMissing) {
    Replay replay(kTinyTake);
    const int64_t before_ns = steadyNow_ns();
    ASSERT_TRUE(replay.playsToTheEnd());
    EXPECT_LT(steadyNow_ns() - before_ns, 1'500'000'000);
    EXPECT_EQ(replay.log.expectTinySound(), TakeSound::tiny().sampleCount());
    EXPECT_EQ(replay.log.lostSamples(), 0);
    size_t pulses = 0;
    for (const auto& event : replay.log.all())
        if (const auto* some = std::get_if<link::Pulses>(&event))
            pulses += some->size();
    EXPECT_EQ(pulses, TakeSound::tiny().pulses.size());
}

TEST(ReplayDeviceTest, KeepsTime) {
    Replay replay(kTinyTake, 2);
    const int64_t before_ns = steadyNow_ns();
    ASSERT_TRUE(replay.playsToTheEnd());
    const double passed_s = static_cast<double>(steadyNow_ns() - before_ns) * 1e-9;
    const double wanted_s = 302500.0 / 150000 / 2;
    EXPECT_GE(passed_s, wanted_s - 0.001);
    EXPECT_LE(passed_s, wanted_s + 0.8);
}

TEST(ReplayDeviceTest, TheStatusOfTheTakeComesAtItsTime) {
    Replay replay(kTinyTake);
    ASSERT_TRUE(replay.playsToTheEnd());
    std::vector<int64_t> samples;
    bool started = false;
    for (const auto& event : replay.log.all()) {
        started = started || std::holds_alternative<link::Started>(event);
        if (std::holds_alternative<link::Stopped>(event))
            break;
        if (const auto* status = std::get_if<link::BoxStatus>(&event); status && started)
            samples.push_back(status->sample);
    }
    EXPECT_EQ(samples, (std::vector<int64_t>{0, 150000, 300000}));
}

TEST(ReplayDeviceTest, HolesOfTheTakeAreGapsWithTheirReason) {
    const Folder folder;
    const std::string take = tinyTake(folder);
    runSql(take,
           "DELETE FROM adc_block WHERE first_sample IN (0, 60000, 66000, 300000);"
           "INSERT INTO gap(suit,first_sample,sample_count,reason) VALUES(1,60000,12000,'box')");
    Replay replay(take);
    ASSERT_TRUE(replay.playsToTheEnd());
    EXPECT_EQ(replay.log.expectTinySound(), 302500);
    std::vector<link::Gap> gaps;
    for (const auto& event : replay.log.all())
        if (const auto* gap = std::get_if<link::Gap>(&event))
            gaps.push_back(*gap);
    EXPECT_EQ(gaps, (std::vector<link::Gap>{{0, 6000, link::GapReason::kLink},
                                            {60000, 12000, link::GapReason::kBox},
                                            {300000, 2500, link::GapReason::kLink}}));
    EXPECT_EQ(replay.device->statistics().lost_samples, 20500);
}

TEST(ReplayDeviceTest, ABoardThatWasLostIsLostAgain) {
    const Folder folder;
    const std::string take = tinyTake(folder);
    runSql(take,
           "INSERT INTO gap(suit,first_sample,sample_count,board,reason) "
           "VALUES(1,120000,60000,1,'board')");
    Replay replay(take);
    ASSERT_TRUE(replay.playsToTheEnd());
    std::vector<std::pair<link::Code, int64_t>> errors;
    for (const auto& event : replay.log.all()) {
        if (const auto* error = std::get_if<link::BoxError>(&event))
            errors.emplace_back(error->code, error->sample);
        if (const auto* status = std::get_if<link::BoxStatus>(&event)) {
            EXPECT_EQ(status->board_flags[1], status->sample == 150000 ? 0 : link::kBoardConnected);
        }
    }
    EXPECT_EQ(errors, (std::vector<std::pair<link::Code, int64_t>>{{link::Code::kBoardLost, 120000},
                                                                   {link::Code::kBoardFound, 180000}}));
}

void expectReplayRefused(const std::string& path, ErrorKind kind, const std::string& word) {
    Replay replay(path);
    ASSERT_TRUE(replay.log.waitFor<link::Refused>());
    const Error why = replay.log.last<link::Refused>().why;
    EXPECT_EQ(why.kind, kind);
    EXPECT_NE(why.message.find(path), std::string::npos) << why.text();
    EXPECT_NE(why.text().find(word), std::string::npos) << why.text();
    replay.device->start();
    EXPECT_TRUE(replay.log.waitFor<link::RequestFailed>());
}

TEST(ReplayDeviceTest, WhatHoldsNoSoundIsRefused) {
    const Folder folder;
    const std::string take = tinyTake(folder);
    runSql(take, "INSERT INTO meta VALUES('level','readings')");
    expectReplayRefused(take, ErrorKind::kUnusable, "readings");
    runSql(take, "DELETE FROM meta WHERE key='level'; DELETE FROM adc_block");
    expectReplayRefused(take, ErrorKind::kUnusable, "sound");
    expectReplayRefused(folder.file("nowhere.noctule"), ErrorKind::kUnreadable, "nowhere");
}

}  // namespace
}  // namespace noctule::test
