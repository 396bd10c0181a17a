// SPDX-License-Identifier: Apache-2.0
#include "core/processing/evaluate_take.h"

#include "core/processing/pose_runs.h"
#include "core/report/range_statistics.h"
#include "tests/core/processing/made_take.h"
#include "tests/support/take_files.h"

namespace noctule::test {
namespace {

class EvaluateTake : public MadeTake {
protected:
    ReportData evaluate(EvaluateRequest request = {}) {
        request.take_path = path();
        auto data = evaluateTake(request, {});
        EXPECT_TRUE(data) << data.error().text();
        return data ? std::move(*data) : ReportData{};
    }
};

TEST_F(EvaluateTake, AKnownErrorComesOutAfterTheRest) {
    addRuns("mine");
    addReference(radians(10));
    const ReportData data = evaluate();
    ASSERT_EQ(data.runs.size(), 1u);
    ASSERT_TRUE(data.runs[0].comparison);
    const Comparison& c = *data.runs[0].comparison;
    EXPECT_NEAR(c.find("RightArm")->angle.mean_deg, 10, 1e-6);
    EXPECT_NEAR(c.find("LeftArm")->angle.mean_deg, 0, 1e-6);
    EXPECT_NEAR(c.mean_deg, 10 / static_cast<double>(c.joints.size()), 1e-6);
    EXPECT_NEAR(c.root.position_m, 0, 1e-9);
    EXPECT_NEAR(c.duration_s, 1.5, 0.01);
    EXPECT_NEAR(data.take.rest_s, 0.5, 1e-9);
    EXPECT_EQ(data.take.reference_kind, "simulated");
    EXPECT_TRUE(data.warnings.empty());
}

TEST_F(EvaluateTake, ATrueBodyWithOtherBonesHasTheSameAngles) {
    addRuns("mine");
    addReference(radians(10));
    const double before_deg = evaluate().runs[0].comparison->mean_deg;
    nlohmann::json truth = toJson(actor_);
    for (nlohmann::json& joint : truth["joints"])
        if (joint["name"] == "RightUpLeg")
            for (nlohmann::json& along : joint["offset_m"])
                along = 1.1 * along.get<double>();
    runSql(path(), "INSERT INTO meta (key, value) VALUES ('reference_actor', '" + truth.dump() + "')");
    const ReportData data = evaluate();
    ASSERT_TRUE(data.runs[0].comparison);
    EXPECT_NEAR(data.runs[0].comparison->mean_deg, before_deg, 1e-9);
    EXPECT_NEAR(data.runs[0].comparison->find("RightUpLeg")->angle.mean_deg, 0, 1e-6);
}

TEST_F(EvaluateTake, SettingsOfTheRunAreShown) {
    addRuns("mine");
    const ReportData data = evaluate();
    EXPECT_EQ(data.runs[0].sensors, "GD");
    EXPECT_EQ(data.runs[0].estimator, "manifold");
    EXPECT_TRUE(data.runs[0].root_given);
    EXPECT_FALSE(data.runs[0].comparison) << "there is no reference";
    ASSERT_EQ(data.warnings.size(), 1u);
    EXPECT_NE(data.warnings[0].find("no reference"), std::string::npos);
}

/// Of 90 s, whose suit began 40 s after the take, the rest pose takes half a second.
TEST_F(EvaluateTake, DriftIsCountedOnTheClockOfTheSuit) {
    addRuns("mine");
    runSql(path(),
           "UPDATE derived SET settings='{\"sensors\":\"AGD\",\"estimator\":\"paper\",\"root\":\"free\"}' "
           "WHERE kind='pose';"
           "UPDATE suit SET clock_offset_ns=40e9;"
           "UPDATE meta SET value=90*150000 WHERE key='sample_count'");
    const auto drift = [this] {
        std::string said;
        for (const std::string& warning : evaluate().warnings)
            if (warning.find("minutes after the rest pose") != std::string::npos)
                said += warning;
        return said;
    };
    EXPECT_NE(drift().find("1.5 minutes"), std::string::npos) << "without a rest pose: " << drift();
    runSql(path(), "INSERT INTO marker(sample,kind,label) VALUES(0,'rest','begin'),(75000,'rest','end')");
    EXPECT_NE(drift().find("1.5 minutes"), std::string::npos) << drift();
}

/// Poses, references and holes are on the take's clock, so pulses and the share that was compared are too.
TEST_F(EvaluateTake, ABoxThatBeganLateIsReportedOnTheTakesClock) {
    addRuns("mine");
    const ReportData prompt = evaluate();
    runSql(path(),
           "UPDATE suit SET clock_offset_ns=7e9;"
           "INSERT INTO marker(sample,kind,label) VALUES(0,'rest','begin'),(75000,'rest','end')");
    const ReportData late = evaluate();
    EXPECT_DOUBLE_EQ(late.take.begin_s, 7);
    EXPECT_DOUBLE_EQ(late.take.rest_s, 7.5);
    EXPECT_NEAR(late.take.afterRest_s(), prompt.take.duration_s - 0.5, 1e-9);
    EXPECT_FLOAT_EQ(late.pairs[0].pulses[100].time_s, 7 + prompt.pairs[0].pulses[100].time_s);
    ASSERT_EQ(late.support.size(), prompt.support.size());
    for (size_t j = 0; j < late.support.size(); ++j)
        EXPECT_NEAR(late.support[j].ranges, prompt.support[j].ranges, 0.02) << late.support[j].joint;
}

TEST_F(EvaluateTake, PulsesHaveTheirFates) {
    addRuns("mine");
    const ReportData data = evaluate();
    ASSERT_EQ(data.pairs.size(), 2u);
    const RangeStatistics heard = rangeStatistics(data.pairs[0]);
    EXPECT_EQ(heard.pulses(), kPulses);
    EXPECT_EQ(heard.of(PulseFate::kUsed), 2 * kPulses / 5);
    EXPECT_EQ(heard.of(PulseFate::kRejected), kPulses / 5);
    EXPECT_EQ(heard.of(PulseFate::kUnused), kPulses / 5);
    EXPECT_NEAR(*heard.residualRms_m(), 0.002, 1e-7);
    EXPECT_NEAR(heard.meanConfidence(), 0.25 * 0.8, 1e-6);
    const RangeStatistics silent = rangeStatistics(data.pairs[1]);
    EXPECT_EQ(silent.heard(), 0);
    EXPECT_EQ(silent.of(PulseFate::kOccluded) + silent.of(PulseFate::kMissing), kPulses);
    EXPECT_FLOAT_EQ(data.pairs[0].pulses[100].time_s, 0.8f);
}

TEST_F(EvaluateTake, BoardsOweTheirFrames) {
    addRuns("mine");
    const ReportData data = evaluate();
    ASSERT_EQ(data.boards.size(), 2u);
    EXPECT_EQ(data.boards[0].frames_expected, kFrames);
    EXPECT_EQ(data.boards[0].frames_lost, 0);
    EXPECT_EQ(data.boards[0].readings_expected, 6 * 160) << "160 frames after all axes can be known";
    EXPECT_EQ(data.boards[0].readings_present, 6 * 160);
    EXPECT_EQ(data.boards[0].clipped_gyro, 1);
    EXPECT_EQ(data.boards[0].clipped_accel, 0);
    EXPECT_EQ(data.boards[1].frames_lost, 60 + 40) << "every fourth, and those at the end that never came";
    EXPECT_EQ(data.boards[1].readings_present, 6 * 90);
    EXPECT_FALSE(data.support.empty());
}

TEST_F(EvaluateTake, AReferenceFromAFileIsAlignedInTime) {
    addRuns("mine");
    TimedMotion motion{actor_.skeleton, {}};
    for (int i = 0; i < 1400; ++i)  // begins 5 s earlier
        motion.frames.push_back({std::llround(i * 1e9 / 100), poseAt(i / 100.0 - 5), {}});
    // A swing at a steady pace fits at many shifts; the file has a motion that does not repeat.
    for (TimedPose& frame : motion.frames) {
        const double t_s = static_cast<double>(frame.time_ns) * 1e-9 - 5;
        frame.pose = poseAt(t_s);
        if (t_s < 0 || t_s > 2)
            frame.pose->q_parent_joint = actor_.restPose().q_parent_joint;
    }
    EvaluateRequest request;
    request.reference = toClip("optical", motion, 100);
    request.reference_name = "optical.bvh";
    const ReportData data = evaluate(request);
    ASSERT_TRUE(data.runs[0].comparison);
    EXPECT_NEAR(static_cast<double>(data.runs[0].comparison->offset.add_to_reference_ns) * 1e-9, -5, 0.02);
    EXPECT_LT(data.runs[0].comparison->mean_deg, 0.2);
    EXPECT_EQ(data.take.reference_name, "optical.bvh");
}

TEST_F(EvaluateTake, RunsAreChosenByName) {
    addRuns("first");
    addRuns("second");
    EXPECT_EQ(evaluate().shownRun()->name, "second");
    EvaluateRequest request;
    request.run = "first";
    EXPECT_EQ(evaluate(request).runs.size(), 1u);
    request.all_runs = true;
    const ReportData all = evaluate(request);
    EXPECT_EQ(all.runs.size(), 2u);
    EXPECT_EQ(all.shownRun()->name, "first");
    request.run = "third";
    request.take_path = path();
    const auto refused = evaluateTake(request, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(refused.error().remedy.find("'first', 'second'"), std::string::npos);
}

TEST_F(EvaluateTake, OtherRunsAreHeldAgainstTheShownOneWithoutAReference) {
    addRuns("first", radians(4));
    addRuns("second");
    EXPECT_FALSE(evaluate().runs[0].from_shown) << "one run alone";
    EvaluateRequest request;
    request.all_runs = true;
    const ReportData data = evaluate(request);
    ASSERT_EQ(data.runs.size(), 2u);
    EXPECT_FALSE(data.shownRun()->from_shown);
    ASSERT_TRUE(data.runs[0].from_shown);
    EXPECT_NEAR(data.runs[0].from_shown->find("RightArm")->angle.mean_deg, 4, 1e-6);
    EXPECT_NEAR(data.runs[0].from_shown->find("LeftArm")->angle.mean_deg, 0, 1e-6);
}

DerivedRun runOf(int64_t number, const std::string& kind, const std::string& settings = "") {
    DerivedRun run;
    run.run = number;
    run.kind = kind;
    run.settings_json = settings;
    return run;
}

TEST(RunSettings, MissingOnesAreGuessedFromTheRunsBefore) {
    const std::vector<DerivedRun> runs = {runOf(1, "inertial"), runOf(2, "range"), runOf(3, "pose"),
                                          runOf(4, "range"), runOf(5, "pose")};
    EXPECT_EQ(runSettings(runs[2], runs, TakeLevel::kSignal).range_run, 2);
    EXPECT_EQ(runSettings(runs[4], runs, TakeLevel::kSignal).range_run, 4);
    EXPECT_EQ(runSettings(runs[4], runs, TakeLevel::kSignal).inertial_run, 1);
    EXPECT_EQ(runSettings(runs[2], {runs[2]}, TakeLevel::kReadings).range_run, kPrimaryRun);
    EXPECT_FALSE(runSettings(runs[2], {runs[2]}, TakeLevel::kSignal).range_run);
    EXPECT_EQ(runSettings(runOf(3, "pose", "not json"), {}, TakeLevel::kSignal).sensors, "AGD");
}

TEST(RunSettings, PeopleStandApartWhereNothingSaysWhereTheyAre) {
    const auto apart = [](const std::string& suits, const std::string& rest) {
        const DerivedRun run = runOf(1, "pose", R"({"subjects": [)" + suits + "]" + rest + "}");
        return runSettings(run, {}, TakeLevel::kReadings).people_apart;
    };
    const std::string two = R"({"suit": 1}, {"suit": 2})";
    EXPECT_TRUE(apart(two, ""));
    EXPECT_TRUE(apart(two, R"(, "root": "free", "between": false, "room": false)"));
    EXPECT_FALSE(apart(R"({"suit": 2})", ""));
    for (const char* told : {R"(, "between": true)", R"(, "room": true)", R"(, "root": "given")"})
        EXPECT_FALSE(apart(two, told)) << told;
}

TEST(RunSettings, WhoCouldNotBePlacedIsJoinedToNobody) {
    const auto settings = [](const std::string& rest) {
        return runSettings(
            runOf(1, "pose", R"({"subjects": [{"suit": 1}, {"suit": 2}, {"suit": 3}])" + rest + "}"), {},
            TakeLevel::kReadings);
    };
    const RunSettings third_apart = settings(R"(, "between": true, "unjoined": [3])");
    EXPECT_TRUE(third_apart.joins(1, 2));
    EXPECT_FALSE(third_apart.joins(1, 3));
    EXPECT_FALSE(third_apart.joins(3, 2));
    EXPECT_FALSE(settings("").joins(1, 2));
    EXPECT_TRUE(settings(R"(, "between": true)").joins(1, 3));
}

}  // namespace
}  // namespace noctule::test
