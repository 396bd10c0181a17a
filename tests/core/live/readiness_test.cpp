// SPDX-License-Identifier: Apache-2.0
#include "core/live/readiness.h"

#include <gtest/gtest.h>

#include "core/live/battery_forecast.h"

namespace noctule {
namespace {

constexpr int kJudgedBoards = 4, kJudgedSources = 3, kJudgedRate_hz = 1000;

/// Everything as it should be at `t_s`.
HealthReport wellAt(double t_s) {
    HealthReport health;
    health.sample = static_cast<int64_t>(t_s * kJudgedRate_hz);
    BoardHealth board;
    board.frames_per_s = 140;
    board.silent = false;
    health.boards.assign(kJudgedBoards, board);
    health.pairs.assign(kJudgedBoards * kJudgedSources, PairHealth{0.05, 0.8, 0.8, 0.5});
    health.suit.battery_percent = 78;
    return health;
}

class ReadinessTest : public testing::Test {
protected:
    PairHealth& pair(HealthReport& health, int source, int board) {
        return health.pairs[static_cast<size_t>(source * kJudgedBoards + board)];
    }
    Readiness judge(const HealthReport& health) {
        facts_.health = &health;
        return judge_.judge(facts_);
    }
    /// The only problem there is, or none.
    static ReadinessProblem only(const Readiness& readiness) {
        EXPECT_EQ(readiness.problems.size(), 1u);
        return readiness.problems.empty() ? ReadinessProblem{} : readiness.problems[0];
    }

    ReadinessJudge judge_{kJudgedBoards, kJudgedSources, kJudgedRate_hz};
    ReadinessFacts facts_;
};

TEST_F(ReadinessTest, NothingIsJudgedBeforeItHasSettled) {
    EXPECT_EQ(judge_.judge(facts_).verdict, Readiness::Verdict::kWaiting);
    HealthReport early = wellAt(1);
    early.boards[0].silent = true;
    EXPECT_EQ(judge(early).verdict, Readiness::Verdict::kWaiting);
    EXPECT_TRUE(judge(early).problems.empty());
}

TEST_F(ReadinessTest, AGoodSuitIsReady) {
    const Readiness ready = judge(wellAt(3));
    EXPECT_EQ(ready.verdict, Readiness::Verdict::kReady);
    EXPECT_TRUE(ready.problems.empty());
    EXPECT_EQ(ready.boards_there, kJudgedBoards);
    EXPECT_EQ(ready.sources_heard, kJudgedSources);
    EXPECT_EQ(ready.good_pairs, kJudgedBoards * kJudgedSources);
    EXPECT_EQ(ready.boards[2].good_pairs, kJudgedSources);
    EXPECT_EQ(ready.source_good_pairs[1], kJudgedBoards);
    EXPECT_EQ(ready.boards[0].state, BoardReadiness::State::kFine);
}

TEST_F(ReadinessTest, ASilentBoardHindersUntilTheOperatorGoesOnWithoutIt) {
    HealthReport health = wellAt(3);
    health.boards[2].silent = true;
    Readiness readiness = judge(health);
    EXPECT_EQ(readiness.verdict, Readiness::Verdict::kNotReady);
    EXPECT_EQ(only(readiness), (ReadinessProblem{ProblemKind::kBoardSilent, true, 2, -1, 0, false}));
    EXPECT_EQ(readiness.boards[2].state, BoardReadiness::State::kSilent);
    EXPECT_EQ(readiness.boards_there, kJudgedBoards - 1);
    EXPECT_EQ(readiness.good_pairs, (kJudgedBoards - 1) * kJudgedSources) << "what it heard before is void";
    facts_.without_boards = {2};
    readiness = judge(health);
    EXPECT_EQ(readiness.verdict, Readiness::Verdict::kReady);
    EXPECT_TRUE(only(readiness).accepted);
}

TEST_F(ReadinessTest, ABoardThatTheBoxMissesIsSilentThoughItsWireHums) {
    facts_.board_is_plugged = {true, true, true, false};
    EXPECT_EQ(only(judge(wellAt(3))).kind, ProblemKind::kBoardSilent);
}

TEST_F(ReadinessTest, FramesTellAPoorWireFromAnUnreadableOne) {
    judge(wellAt(3));
    HealthReport health = wellAt(4);
    health.boards[1].frames_per_s = 100;
    EXPECT_TRUE(judge(health).problems.empty()) << "for a second: a take in a loop begins anew";
    health.sample = static_cast<int64_t>(5.1 * kJudgedRate_hz);
    ReadinessProblem problem = only(judge(health));
    EXPECT_EQ(problem.kind, ProblemKind::kBoardLosesFrames);
    EXPECT_FALSE(problem.hinders);
    EXPECT_EQ(problem.value, 100);
    health.boards[1].frames_per_s = 2;
    problem = only(judge(health));
    EXPECT_EQ(problem.kind, ProblemKind::kBoardUnreadable);
    EXPECT_TRUE(problem.hinders);
    health.boards[1] = wellAt(3).boards[1];
    health.boards[1].clipped_samples = 500;
    EXPECT_EQ(only(judge(health)).kind, ProblemKind::kBoardClips);
}

TEST_F(ReadinessTest, APairCountsForHalfASecondAfterItWasGood) {
    EXPECT_EQ(judge(wellAt(3)).good_pairs, 12);
    HealthReport worse = wellAt(3.3);
    pair(worse, 0, 0).confidence = 0.1;
    EXPECT_EQ(judge(worse).good_pairs, 12);
    worse = wellAt(3.8);
    pair(worse, 0, 0).confidence = 0.1;
    const Readiness later = judge(worse);
    EXPECT_EQ(later.good_pairs, 11);
    EXPECT_FALSE(later.pair_is_good[0]);
}

TEST_F(ReadinessTest, ASourceThatNobodyHearsForSecondsIsSilentAndAMuffledOneFaint) {
    judge(wellAt(3));
    HealthReport health = wellAt(4);
    for (int board = 0; board < kJudgedBoards; ++board)
        pair(health, 1, board) = {1.0, 0.8, 0.8, 0.5};
    EXPECT_TRUE(judge(health).problems.empty()) << "for a second: the performer turned";
    health.sample = 6 * kJudgedRate_hz;
    for (int board = 0; board < kJudgedBoards; ++board)
        pair(health, 1, board).age_s = 3.0;
    Readiness readiness = judge(health);
    EXPECT_EQ(only(readiness), (ReadinessProblem{ProblemKind::kSourceSilent, false, -1, 1, 0, false}));
    EXPECT_EQ(readiness.sources_heard, kJudgedSources - 1);
    for (int board = 0; board < kJudgedBoards; ++board)
        pair(health, 1, board) = {0.05, 0.25, 0.25, 0.5};
    EXPECT_EQ(only(judge(health)).kind, ProblemKind::kSourceFaint);
    facts_.without_sources = {1};
    EXPECT_TRUE(only(judge(health)).accepted);
}

TEST_F(ReadinessTest, WithoutAnySourceItIsNotReady) {
    judge(wellAt(3));
    HealthReport health = wellAt(20);
    for (PairHealth& unheard : health.pairs)
        unheard = {};
    const Readiness readiness = judge(health);
    const ReadinessProblem problem = only(readiness);
    EXPECT_EQ(problem.kind, ProblemKind::kSourceSilent);
    EXPECT_EQ(problem.alike, (std::vector{0, 1, 2})) << "that no board hears one follows from it";
    EXPECT_EQ(readiness.verdict, Readiness::Verdict::kNotReady);
    facts_.without_sources = {0, 1, 2};
    EXPECT_EQ(judge(health).verdict, Readiness::Verdict::kReady) << "the operator goes on without them";
}

TEST_F(ReadinessTest, ARoomIsReadyThoughItsAnchorsDoNotHearEachOtherAndNobodyWearsIt) {
    facts_.is_room = true;
    facts_.is_assigned = false;
    facts_.fit = SuitFit::kUnchecked;
    judge(wellAt(3));
    HealthReport health = wellAt(20);
    for (PairHealth& unheard : health.pairs)
        unheard = {};
    const Readiness readiness = judge(health);
    EXPECT_EQ(readiness.verdict, Readiness::Verdict::kReady);
    EXPECT_TRUE(readiness.problems.empty());
    EXPECT_TRUE(readiness.isFit());
    health.boards[0].silent = true;
    EXPECT_EQ(judge(health).verdict, Readiness::Verdict::kNotReady);
}

/// As after a stream that began in the midst of a movement: the pose is wrong, plugs and cables are not.
TEST_F(ReadinessTest, WhatThePoseRefusesIsHeardAllTheSame) {
    judge(wellAt(3));
    HealthReport health = wellAt(20);
    for (PairHealth& refused : health.pairs)
        refused.confidence = 0;
    const Readiness readiness = judge(health);
    EXPECT_TRUE(readiness.problems.empty());
    EXPECT_EQ(readiness.verdict, Readiness::Verdict::kReady);
    EXPECT_EQ(readiness.sources_heard, kJudgedSources);
    EXPECT_EQ(readiness.good_pairs, 0);
}

/// A pose that lags hands its ranges on late.
TEST_F(ReadinessTest, ASourceWhoseRangesComeLateIsHeard) {
    for (const double t_s : {3.0, 6.0, 9.0}) {
        HealthReport health = wellAt(t_s);
        for (PairHealth& late : health.pairs)
            late.age_s = 1;
        const Readiness readiness = judge(health);
        EXPECT_EQ(readiness.sources_heard, kJudgedSources) << t_s;
        EXPECT_TRUE(readiness.problems.empty());
        EXPECT_EQ(readiness.good_pairs, 0) << "that is now";
    }
}

TEST_F(ReadinessTest, ABoardMayHearNothingForAWhile) {
    judge(wellAt(3));
    HealthReport health = wellAt(8);
    for (int source = 0; source < kJudgedSources; ++source)
        pair(health, source, 3).confidence = pair(health, source, 3).heard = 0;
    EXPECT_TRUE(judge(health).problems.empty());
    health.sample = 14 * kJudgedRate_hz;
    const ReadinessProblem problem = only(judge(health));
    EXPECT_EQ(problem.kind, ProblemKind::kBoardDeaf);
    EXPECT_EQ(problem.board, 3);
}

TEST_F(ReadinessTest, SuppliesAndPlacesAreJudged) {
    HealthReport health = wellAt(3);
    health.suit.battery_percent = 15;
    EXPECT_EQ(only(judge(health)).kind, ProblemKind::kBatteryLow);
    health.suit.battery_percent = 3;
    EXPECT_EQ(judge(health).verdict, Readiness::Verdict::kNotReady);
    health.suit.battery_percent.reset();
    facts_.storage_left_s = 300;
    EXPECT_FALSE(only(judge(health)).hinders);
    facts_.storage_left_s = 20;
    EXPECT_TRUE(only(judge(health)).hinders);
    facts_.storage_left_s = 9e9;
    facts_.is_assigned = false;
    EXPECT_EQ(only(judge(health)).kind, ProblemKind::kNotAssigned);
}

TEST_F(ReadinessTest, WithoutACalibrationItIsRecordableButNotFit) {
    EXPECT_TRUE(judge(wellAt(3)).isFit());
    facts_.lack.gyroscopes = {0, 1, 2, 3};
    facts_.lack.board_count = kJudgedBoards;
    facts_.fit = SuitFit::kUnchecked;
    Readiness readiness = judge(wellAt(3));
    EXPECT_EQ(readiness.verdict, Readiness::Verdict::kReady);
    EXPECT_FALSE(readiness.isFit());
    EXPECT_EQ(only(readiness).kind, ProblemKind::kNotCalibrated) << "one cause, one card";
    EXPECT_TRUE(readiness.lack.ofMostGyroscopes());
    facts_.lack = {};
    EXPECT_EQ(only(judge(wellAt(3))).kind, ProblemKind::kNotChecked);
    facts_.fit = SuitFit::kMoved;
    EXPECT_EQ(only(judge(wellAt(3))).kind, ProblemKind::kMoved);
    facts_.fit = SuitFit::kChecked;
    EXPECT_TRUE(judge(wellAt(3)).isFit());
}

CalibrationStepState stepOfAge(CalibrationStep step, double age_h, const char* worst = "good") {
    CalibrationStepState state;
    state.step = step;
    state.made = state.parts = kJudgedBoards;
    state.worst = worst;
    state.age_h = age_h;
    return state;
}

TEST_F(ReadinessTest, AStepThatIsNotUsableIsNoCalibration) {
    facts_.steps = {stepOfAge(CalibrationStep::kAccelerometers, 1, "usable"),
                    stepOfAge(CalibrationStep::kGyroscopes, 9999, "not usable")};
    const Readiness readiness = judge(wellAt(3));
    EXPECT_EQ(only(readiness).kind, ProblemKind::kStepNotUsable) << "its age is no second cause";
    EXPECT_EQ(only(readiness).step, CalibrationStep::kGyroscopes);
    EXPECT_FALSE(readiness.isFit());
    EXPECT_EQ(readiness.verdict, Readiness::Verdict::kReady) << "it can be recorded";
    facts_.steps = {stepOfAge(CalibrationStep::kRestPose, 1, "not usable")};
    facts_.fit = SuitFit::kMoved;
    EXPECT_EQ(only(judge(wellAt(3))).kind, ProblemKind::kStepNotUsable)
        << "where boards sit cannot be told from it";
}

TEST_F(ReadinessTest, AStepThatIsDueAgainIsAWarning) {
    constexpr double kDay_h = 24;
    facts_.steps = {stepOfAge(CalibrationStep::kSources, 300 * kDay_h),
                    stepOfAge(CalibrationStep::kAccelerometers, 80 * kDay_h),
                    stepOfAge(CalibrationStep::kGyroscopes, 100 * kDay_h)};
    const Readiness readiness = judge(wellAt(3));
    EXPECT_EQ(only(readiness).kind, ProblemKind::kStepOld);
    EXPECT_EQ(only(readiness).step, CalibrationStep::kGyroscopes);
    EXPECT_EQ(only(readiness).value, 100 * kDay_h);
    EXPECT_FALSE(only(readiness).hinders);
    EXPECT_TRUE(readiness.isFit());
}

TEST_F(ReadinessTest, AnOldRestPoseIsOfAnEarlierWearingUntilItIsChecked) {
    facts_.steps = {stepOfAge(CalibrationStep::kRestPose, 26), stepOfAge(CalibrationStep::kMovement, 26)};
    facts_.fit = SuitFit::kUnchecked;
    const Readiness readiness = judge(wellAt(3));
    EXPECT_EQ(only(readiness).kind, ProblemKind::kRestPoseOld) << "one cause, one card";
    EXPECT_EQ(only(readiness).value, 26);
    EXPECT_FALSE(only(readiness).hinders);
    EXPECT_FALSE(readiness.isFit());
    facts_.steps[0].age_h = 3;
    EXPECT_EQ(only(judge(wellAt(3))).kind, ProblemKind::kNotChecked);
    facts_.steps[0].age_h = 26;
    facts_.fit = SuitFit::kChecked;
    EXPECT_TRUE(judge(wellAt(3)).problems.empty());
}

TEST_F(ReadinessTest, WhatBefallsMostBoardsAlikeIsOneProblem) {
    judge(wellAt(3));
    HealthReport health = wellAt(6);
    for (BoardHealth& board : health.boards)
        board.frames_per_s = 90;
    health.boards[2].frames_per_s = 70;
    Readiness readiness = judge(health);
    const ReadinessProblem problem = only(readiness);
    EXPECT_EQ(problem.kind, ProblemKind::kBoardLosesFrames);
    EXPECT_EQ(problem.board, -1);
    EXPECT_EQ(problem.alike, (std::vector{0, 1, 2, 3}));
    EXPECT_EQ(problem.value, 85);
    EXPECT_FALSE(problem.accepted);
    facts_.without_boards = {0, 1, 2};
    EXPECT_FALSE(only(judge(health)).accepted);
    facts_.without_boards = {0, 1, 2, 3};
    EXPECT_TRUE(only(judge(health)).accepted);
    for (PairHealth& unheard : health.pairs)
        unheard = {};
    health.sample = 9 * kJudgedRate_hz;
    EXPECT_EQ(judge(health).problems.size(), 1U) << "sources that are not heard follow from it";
    facts_.without_boards.clear();
    EXPECT_EQ(judge(health).verdict, Readiness::Verdict::kNotReady) << "no source is heard";
    health.pairs = wellAt(3).pairs;
    health.boards[0].frames_per_s = health.boards[1].frames_per_s = 140;
    EXPECT_EQ(judge(health).problems.size(), 2U) << "half of them each have their own card";
}

TEST_F(ReadinessTest, ALinkThatReturnsIsNoFaultOfItsBoards) {
    judge(wellAt(3));
    facts_.link_is_lost = true;
    judge(wellAt(3));
    facts_.link_is_lost = false;
    HealthReport back = wellAt(20);  // the box counted on
    for (BoardHealth& board : back.boards)
        board.frames_per_s = 40;  // of the last second little has come yet
    EXPECT_TRUE(judge(back).problems.empty());
    back.sample = static_cast<int64_t>(22.5 * kJudgedRate_hz);
    EXPECT_EQ(only(judge(back)).kind, ProblemKind::kBoardLosesFrames) << "it stays so";
}

TEST_F(ReadinessTest, TheWorstStandsFirst) {
    judge(wellAt(0.5));
    HealthReport health = wellAt(3);
    health.suit.battery_percent = 15;
    health.boards[0].frames_per_s = 90;
    health.boards[1].silent = true;
    health.boards[3].silent = true;
    facts_.without_boards = {3};
    std::vector<ProblemKind> kinds;
    for (const ReadinessProblem& problem : judge(health).problems)
        kinds.push_back(problem.kind);
    EXPECT_EQ(kinds, (std::vector{ProblemKind::kBoardSilent, ProblemKind::kBoardLosesFrames,
                                  ProblemKind::kBatteryLow, ProblemKind::kBoardSilent}));
}

TEST_F(ReadinessTest, ALostLinkIsAllThatCanBeSaid) {
    HealthReport health = wellAt(3);
    health.boards[1].silent = true;
    facts_.link_is_lost = true;
    const Readiness readiness = judge(health);
    EXPECT_EQ(only(readiness).kind, ProblemKind::kLinkLost);
    EXPECT_EQ(readiness.verdict, Readiness::Verdict::kNotReady);
    EXPECT_EQ(readiness.boards[0].state, BoardReadiness::State::kUnknown);
    facts_.link_is_lost = false;
    facts_.sound_stalls = true;
    EXPECT_EQ(only(judge(health)).kind, ProblemKind::kNoSound);
}

TEST_F(ReadinessTest, ANewStreamIsJudgedAfresh) {
    judge(wellAt(30));
    HealthReport health = wellAt(2);
    for (PairHealth& unheard : health.pairs)
        unheard = {};
    const Readiness readiness = judge(health);
    EXPECT_EQ(readiness.good_pairs, 0);
    EXPECT_TRUE(readiness.problems.empty()) << "two seconds are not yet over";
}

TEST(BatteryForecast, LastsAsLongAsTheLossSoFarSays) {
    BatteryForecast forecast;
    EXPECT_FALSE(forecast.left_s());
    forecast.add(0, 80);
    forecast.add(150, 79);
    EXPECT_FALSE(forecast.left_s()) << "one percent may be rounding";
    forecast.add(300, 78);
    forecast.add(450, 77);
    forecast.add(600, 76);
    EXPECT_NEAR(*forecast.left_s(), 76 * 150.0, 1e-6);
    forecast.add(601, 40);
    EXPECT_FALSE(forecast.left_s()) << "it was changed";
    forecast.add(700, 90);
    EXPECT_FALSE(forecast.left_s()) << "it was charged";
}

}  // namespace
}  // namespace noctule
