// SPDX-License-Identifier: Apache-2.0
#include "core/report/take_verdict.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/body/actor.h"
#include "core/report/joint_support.h"
#include "core/report/verdict.h"
#include "core/suit/default_suit.h"

namespace noctule {
namespace {

constexpr double kDuration_s = 20;

/// A take without fault: every pair used every 64 ms with 3 mm of residual.
class TakeVerdictTest : public testing::Test {
protected:
    void SetUp() override {
        report_.take.duration_s = kDuration_s;
        ReportRun run;
        run.sensors = "AGD";
        report_.runs = {run};
        for (const Board& board : suit_.boards)
            report_.boards.push_back({board.id, board.segment, 2800, 0});
        for (const Source& source : suit_.sources)
            report_.sources.push_back({source.id, ""});
        for (int source = 0; source < 8; ++source)
            for (int board = 0; board < 18; ++board) {
                ReportPair pair{source, board, {}};
                for (int i = 0; i < 312; ++i)
                    pair.pulses.push_back({static_cast<float>(i) * 0.064F, PulseFate::kUsed, 0.8F, 0.5F,
                                           i % 2 == 0 ? 0.003F : -0.003F});
                report_.pairs.push_back(std::move(pair));
            }
        for (const Joint& joint : skeleton_.joints())
            if (joint.type != JointType::kFixed && joint.type != JointType::kFree)
                report_.support.push_back({joint.name, 0.95, 0.05, {}, 0});
    }

    Comparison& compare(double mean_deg) {
        Comparison comparison;
        comparison.mean_deg = mean_deg;
        for (const JointSupport& support : report_.support) {
            JointComparison joint;
            joint.name = support.joint;
            joint.angle.mean_deg = mean_deg, joint.angle.max_deg = 2 * mean_deg;
            comparison.joints.push_back(joint);
        }
        report_.runs[0].comparison = comparison;
        return *report_.runs[0].comparison;
    }

    TakeVerdict verdict() const { return judgeTake(report_); }

    const Suit suit_ = defaultSuit();
    const Skeleton skeleton_ = defaultActor().skeleton;
    ReportData report_;
};

TEST_F(TakeVerdictTest, AFaultlessTakeIsGoodWithoutReference) {
    const TakeVerdict verdict = this->verdict();
    EXPECT_EQ(verdict.grade, Grade::kGood);
    EXPECT_TRUE(verdict.reasons.empty());
    EXPECT_NEAR(verdict.backed_share, 0.95, 1e-9);
    ASSERT_TRUE(verdict.residual_rms_m);
    EXPECT_NEAR(*verdict.residual_rms_m, 0.003, 1e-6);
    EXPECT_FALSE(verdict.mean_error_deg);
    EXPECT_EQ(verdict.joints.size(), report_.support.size());
    EXPECT_TRUE(verdict.worst_joint.empty());
}

TEST_F(TakeVerdictTest, TheErrorAgainstAReferenceDecides) {
    compare(2);
    EXPECT_EQ(verdict().grade, Grade::kGood);
    EXPECT_EQ(verdict().mean_error_deg, 2);
    EXPECT_EQ(verdict().joints[3].worst_deg, 4);
    compare(5);
    EXPECT_EQ(verdict().grade, Grade::kUsable);
    EXPECT_EQ(verdict().reasons.front(), VerdictReason::kMeanError);
    compare(20);
    EXPECT_EQ(verdict().grade, Grade::kNotUsable);
    compare(NAN);
    EXPECT_EQ(verdict().grade, Grade::kNotUsable);
}

TEST_F(TakeVerdictTest, OneBadJointIsNamed) {
    compare(2).joints[5].angle.mean_deg = 12;
    const TakeVerdict verdict = this->verdict();
    EXPECT_EQ(verdict.grade, Grade::kUsable);
    EXPECT_EQ(verdict.reasons, std::vector{VerdictReason::kJointError});
    EXPECT_EQ(verdict.worst_joint, report_.support[5].joint);
    EXPECT_EQ(verdict.joints[5].grade, Grade::kUsable);
    EXPECT_EQ(verdict.joints[4].grade, Grade::kGood);
}

TEST_F(TakeVerdictTest, TellsFromWhenAJointWasLessCertain) {
    const int hand = skeleton_.find("LeftHand");
    for (ReportPair& pair : report_.pairs) {
        const Board& board = suit_.boards[static_cast<size_t>(pair.board)];
        if (board.segment == "LeftHand")
            for (PulseAtBoard& pulse : pair.pulses)
                if (pulse.time_s > 12)
                    pulse.fate = PulseFate::kMissing;
    }
    ASSERT_GE(hand, 0);
    report_.support = jointSupport(skeleton_, suit_, report_.pairs,
                                   std::vector<double>(suit_.boards.size(), 1.0), report_.take);
    const TakeVerdict verdict = this->verdict();
    EXPECT_EQ(verdict.grade, Grade::kUsable);
    EXPECT_EQ(verdict.reasons, std::vector{VerdictReason::kSupport});
    EXPECT_EQ(verdict.worst_joint, "LeftHand");
    ASSERT_TRUE(verdict.worst_from_s);
    EXPECT_NEAR(*verdict.worst_from_s, 12.15, 0.2);
    compare(1);  // what is known to be right does not suffer from it
    EXPECT_EQ(this->verdict().grade, Grade::kGood);
}

TEST_F(TakeVerdictTest, AJointThatNothingToldAboutLowersTheGrade) {
    report_.support[2] = {report_.support[2].joint, 0, 0.9, {}, 0};
    EXPECT_EQ(verdict().grade, Grade::kUsable);
    report_.support[2].inertia = 0.5;
    EXPECT_EQ(verdict().grade, Grade::kNotUsable);
    EXPECT_EQ(verdict().reasons, std::vector{VerdictReason::kSupport});
    report_.support[2].inertia = 1;  // a foot that no microphone heard
    EXPECT_EQ(verdict().grade, Grade::kGood);
    EXPECT_EQ(verdict().joints[2].grade, Grade::kUsable);
}

TEST_F(TakeVerdictTest, AJointWithoutSensorIsAloneByDesignAndUsable) {
    JointSupport& support = report_.support[2];
    support = {support.joint, 0, 0.9, {}, 0};
    EXPECT_EQ(verdict().alone_joint, support.joint);
    EXPECT_FALSE(verdict().alone_by_design);
    EXPECT_NE(judge(report_).reasons[0].find("was told by no sensor for 10 %"), std::string::npos);
    support.inertia = 0;
    EXPECT_EQ(verdict().grade, Grade::kUsable);
    EXPECT_TRUE(verdict().alone_by_design);
    EXPECT_NE(judge(report_).reasons[0].find("has no sensor"), std::string::npos);
}

TEST_F(TakeVerdictTest, TooFewRangesOverallLowerTheGrade) {
    for (JointSupport& support : report_.support)
        support.ranges = 0.4, support.inertia = 0.6;
    EXPECT_EQ(verdict().grade, Grade::kUsable);
    for (JointSupport& support : report_.support)
        support.ranges = 0.1, support.inertia = 0.9;
    EXPECT_EQ(verdict().grade, Grade::kNotUsable);
}

TEST_F(TakeVerdictTest, WithoutDistancesATakeIsUsableAtBest) {
    report_.runs[0].sensors = "AG";
    for (JointSupport& support : report_.support)
        support.ranges = 0, support.inertia = 1;
    EXPECT_EQ(verdict().grade, Grade::kUsable);
    EXPECT_EQ(verdict().reasons, std::vector{VerdictReason::kSupport});
}

TEST_F(TakeVerdictTest, WithoutGyroscopesAnglesAreGuesses) {
    for (const auto& [sensors, words] :
         {std::pair{"D", "Made of distances alone"}, std::pair{"A", "Made of accelerometers alone"},
          std::pair{"AD", "Made of accelerometers and distances"}}) {
        report_.runs[0].sensors = sensors;
        report_.runs[0].comparison.reset();
        for (JointSupport& support : report_.support)
            support.inertia = 0;  // and so told by nothing at times, which follows from it
        EXPECT_EQ(verdict().grade, Grade::kNotUsable) << sensors;
        EXPECT_EQ(verdict().reasons, std::vector{VerdictReason::kNoGyroscopes}) << sensors;
        EXPECT_EQ(verdict().sensors, sensors);
        ASSERT_EQ(judge(report_).reasons.size(), 1u) << sensors;
        EXPECT_EQ(judge(report_).reasons[0].find(words), 0u) << judge(report_).reasons[0];
        compare(2);
        EXPECT_EQ(verdict().grade, Grade::kUsable) << sensors << ": never good";
    }
}

TEST_F(TakeVerdictTest, LossyBoardsAreListedWorstFirst) {
    report_.boards[3].frames_lost = 280;
    report_.boards[7].frames_lost = 1400;
    report_.boards[8].frames_lost = 14;
    const TakeVerdict verdict = this->verdict();
    EXPECT_EQ(verdict.grade, Grade::kUsable);
    ASSERT_EQ(verdict.lossy_boards.size(), 2u);
    EXPECT_EQ(verdict.lossy_boards[0].board, 7);
    EXPECT_DOUBLE_EQ(verdict.lossy_boards[1].lost_share, 0.1);
    EXPECT_FALSE(verdict.lost_together);
    for (ReportBoard& board : report_.boards)
        board.frames_lost = 1000;
    EXPECT_EQ(this->verdict().grade, Grade::kNotUsable);
    EXPECT_TRUE(this->verdict().lost_together) << "it is the link";
    report_.boards[7].frames_lost = 1400;
    EXPECT_FALSE(this->verdict().lost_together) << "one lost more than the link did";
}

TEST_F(TakeVerdictTest, BoardsThatComeAndGoAreSaidSo) {
    for (ReportBoard& board : report_.boards)
        board.frames_lost = board.frames_absent = 1000, board.joined_s = 7.1;
    report_.boards[7].frames_lost = 1400;
    report_.boards[7].left_s = 12;
    const TakeVerdict verdict = this->verdict();
    EXPECT_FALSE(verdict.lost_together);
    EXPECT_EQ(verdict.lossy_boards.front().joined_s, 7.1);
    std::string reasons;
    for (const std::string& reason : judge(report_).reasons)
        reasons += reason + "\n";
    EXPECT_NE(reasons.find("All boards joined at 0:07."), std::string::npos) << reasons;
    EXPECT_NE(reasons.find("Left hand (board 8) left at 0:12."), std::string::npos) << reasons;
    EXPECT_EQ(reasons.find("joined", reasons.find("joined") + 1), std::string::npos) << "once\n" << reasons;
    EXPECT_EQ(reasons.find("driver box"), std::string::npos) << reasons;
}

TEST_F(TakeVerdictTest, HolesAreMergedBeforeTheyAreMeasured) {
    report_.gaps_s = {{5, 5.2}, {5.1, 5.3}, {5.3, 5.4}, {19.95, 30}};
    const TakeVerdict verdict = this->verdict();
    EXPECT_NEAR(verdict.hole_s, 0.45, 1e-9);
    EXPECT_NEAR(verdict.longest_hole_s, 0.4, 1e-9);
    EXPECT_EQ(verdict.reasons, std::vector{VerdictReason::kHole});
}

TEST_F(TakeVerdictTest, LargeResidualsAreAReason) {
    for (ReportPair& pair : report_.pairs)
        for (PulseAtBoard& pulse : pair.pulses)
            pulse.residual_m = 0.06F;
    EXPECT_EQ(verdict().grade, Grade::kNotUsable);
    EXPECT_EQ(verdict().reasons, std::vector{VerdictReason::kResidual});
}

TEST_F(TakeVerdictTest, MostDistancesThrownOutIsNeverGood) {
    for (ReportPair& pair : report_.pairs)
        for (PulseAtBoard& pulse : pair.pulses)
            if (pulse.fate == PulseFate::kUsed)
                pulse.fate = PulseFate::kRejected;
    compare(1);
    EXPECT_EQ(verdict().grade, Grade::kUsable) << "a small error too tells nothing of the distances";
    EXPECT_EQ(std::ranges::count(verdict().reasons, VerdictReason::kDistances), 1);
}

TEST_F(TakeVerdictTest, AnUncalibratedTakeHasOneReasonAndNoOther) {
    report_.lack = lackOf(suit_, Calibration{});
    for (JointSupport& support : report_.support)
        support.ranges = 0, support.inertia = 0.5;
    for (ReportPair& pair : report_.pairs)
        for (PulseAtBoard& pulse : pair.pulses)
            pulse.residual_m = 0.2F;
    const TakeVerdict verdict = this->verdict();
    EXPECT_EQ(verdict.grade, Grade::kNotUsable);
    EXPECT_EQ(verdict.reasons, std::vector{VerdictReason::kNotCalibrated});
    EXPECT_TRUE(verdict.lack.isTotal());
    compare(1);
    EXPECT_EQ(this->verdict().grade, Grade::kGood) << "against a reference the error is known";
}

TEST_F(TakeVerdictTest, AMissingCalibrationIsToldBeforeMissingGyroscopes) {
    report_.lack = lackOf(suit_, Calibration{});
    report_.runs[0].sensors = "AD";
    EXPECT_EQ(verdict().reasons, (std::vector{VerdictReason::kNotCalibrated, VerdictReason::kNoGyroscopes}));
    EXPECT_EQ(judge(report_).headline.find("Not usable: this take has no calibration"), 0u)
        << judge(report_).headline;
    compare(1);
    EXPECT_EQ(verdict().reasons, std::vector{VerdictReason::kNoGyroscopes})
        << "against a reference the error is known";
}

TEST_F(TakeVerdictTest, AMissingRestPoseMakesItUsable) {
    report_.lack.board_count = 18;
    report_.lack.rest_pose = {3, 4};
    EXPECT_EQ(verdict().grade, Grade::kUsable);
    EXPECT_EQ(verdict().reasons, std::vector{VerdictReason::kNotCalibrated});
}

TEST_F(TakeVerdictTest, TheMedianOfResidualsIsWhatIsUsual) {
    for (ReportPair& pair : report_.pairs)
        pair.pulses[0].residual_m = 1.5F;  // an echo
    EXPECT_NEAR(*verdict().residual_median_m, 0.003, 1e-6);
    EXPECT_GT(*verdict().residual_rms_m, 0.05);
}

TEST_F(TakeVerdictTest, PairsThatAreAlwaysLateDoNotCondemnTheTake) {
    for (ReportPair& pair : report_.pairs)
        if (pair.board < 2 && pair.source % 3 == 0)  // sound that goes round the body
            for (PulseAtBoard& pulse : pair.pulses)
                pulse.residual_m = 0.55F;
    EXPECT_EQ(verdict().grade, Grade::kGood);
    EXPECT_NEAR(*verdict().residual_spread_m, 0.003, 1e-6);
    EXPECT_GT(*verdict().residual_rms_m, 0.05);
}

TEST_F(TakeVerdictTest, RangesThatMissEverywhereCondemnIt) {
    for (ReportPair& pair : report_.pairs)
        for (size_t i = 0; i < pair.pulses.size(); ++i)
            if (i % 2 == 0)
                pair.pulses[i].residual_m = 0.06F;
    EXPECT_EQ(verdict().grade, Grade::kNotUsable);
    EXPECT_EQ(verdict().reasons, std::vector{VerdictReason::kResidual});
    EXPECT_FALSE(verdict().astray);
}

TEST_F(TakeVerdictTest, ASourceGoneAstrayIsNamed) {
    for (ReportPair& pair : report_.pairs)
        if (pair.source == 5)
            for (PulseAtBoard& pulse : pair.pulses)
                pulse.residual_m = 0.03F;
    EXPECT_EQ(verdict().grade, Grade::kUsable);
    ASSERT_TRUE(verdict().astray);
    EXPECT_TRUE(verdict().astray->is_source);
    EXPECT_EQ(verdict().astray->index, 5);
    EXPECT_NEAR(verdict().astray->median_m, 0.03, 1e-6);
}

TEST_F(TakeVerdictTest, TheReportSaysTheSameInSentences) {
    EXPECT_EQ(judge(report_).headline, "Good. Without a reference the error of this take is not known.");
    EXPECT_TRUE(judge(report_).reasons.empty());
    for (const double ranges : {0.4, 0.1}) {
        for (JointSupport& support : report_.support)
            support.ranges = ranges, support.inertia = 1 - ranges;
        EXPECT_EQ(judge(report_).grade, verdict().grade);
        ASSERT_EQ(judge(report_).reasons.size(), 1u);
        EXPECT_EQ(judge(report_).reasons[0].find("Ranges backed the joints only"), 0u);
    }
    report_.support[3].lost_from_s = 12, report_.support[3].lost_share = 0.6;
    EXPECT_NE(judge(report_).reasons[0].find("is less certain from 0:12 on"), std::string::npos);
    report_.gaps_s = {{5, 5.5}};
    report_.boards[3].frames_lost = 280;
    const Verdict said = judge(report_);
    ASSERT_EQ(said.reasons.size(), 3u);
    EXPECT_NE(said.reasons[1].find("0.50 s in one piece"), std::string::npos);
    EXPECT_NE(said.reasons[2].find("lost 10 % of its frames"), std::string::npos);
    report_.sources.clear();
    report_.support[3].lost_from_s.reset(), report_.support[3].lost_share = 0;
    EXPECT_EQ(judge(report_).reasons[0].find("The suit has no sources"), 0u);
}

TEST_F(TakeVerdictTest, TheReportNamesWhatIsAstray) {
    for (ReportPair& pair : report_.pairs)
        if (pair.source == 5)
            for (PulseAtBoard& pulse : pair.pulses)
                pulse.residual_m = 0.03F;
    ASSERT_EQ(judge(report_).reasons.size(), 1u);
    EXPECT_EQ(judge(report_).reasons[0].find("Source 6: half of its ranges miss the pose by more than 30 mm"),
              0u);
    compare(2).joints[5].angle.mean_deg = 12;
    EXPECT_EQ(judge(report_).grade, Grade::kUsable);
    ASSERT_EQ(judge(report_).reasons.size(), 1u);
    EXPECT_EQ(judge(report_).reasons[0].find("1 joint is more than 8° off on average"), 0u);
}

TEST_F(TakeVerdictTest, DistancesBetweenPerformersWhomNothingJoinsMeanNothing) {
    report_.people_apart = true;
    EXPECT_EQ(verdict().reasons, std::vector{VerdictReason::kPeopleApart});
    ASSERT_EQ(judge(report_).reasons.size(), 1u);
    EXPECT_NE(judge(report_).reasons[0].find("Distances between them mean nothing"), std::string::npos);
    report_.unjoined = {"Bea"};
    ASSERT_EQ(judge(report_).reasons.size(), 1u);
    EXPECT_NE(judge(report_).reasons[0].find("others: Bea."), std::string::npos);
    EXPECT_NE(judge(report_).reasons[0].find("Distances to them mean nothing"), std::string::npos);
}

TEST_F(TakeVerdictTest, AMissingCalibrationIsTheOnlyOneToBlame) {
    report_.lack.board_count = 18;
    report_.lack.rest_pose = {3, 4};
    for (ReportPair& pair : report_.pairs)
        for (size_t i = 0; i < pair.pulses.size(); ++i) {
            pair.pulses[i].residual_m = 0.2F;
            if (i % 3 == 0)
                pair.pulses[i].fate = PulseFate::kRejected;
        }
    const Verdict said = judge(report_);
    EXPECT_EQ(said.grade, Grade::kNotUsable);
    ASSERT_EQ(said.reasons.size(), 2u);
    EXPECT_NE(said.reasons[0].find("Calibrate what is missing first"), std::string::npos);
    EXPECT_EQ(said.reasons[1].find("This take was made without calibration of rest pose"), 0u);
    compare(9).nees = 20;
    for (const std::string& reason : judge(report_).reasons)
        EXPECT_EQ(reason.find("too sure"), std::string::npos) << reason;
}

TEST_F(TakeVerdictTest, WithoutARunThereIsNothingToUse) {
    report_.runs.clear();
    EXPECT_EQ(verdict().grade, Grade::kNotUsable);
    EXPECT_EQ(verdict().reasons, std::vector{VerdictReason::kNoPoses});
    EXPECT_EQ(judge(report_).grade, Grade::kUnknown);
}

}  // namespace
}  // namespace noctule
