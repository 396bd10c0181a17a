// SPDX-License-Identifier: Apache-2.0
// The main job from file to file: what it writes, what it refuses, and how near its poses are to the
// reference.
#include "core/processing/process_take.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/formats/bvh.h"
#include "core/motion/comparison.h"
#include "core/processing/evaluate_take.h"
#include "core/processing/inspect_take.h"
#include "core/processing/pose_runs.h"
#include "tests/core/processing/processed_runs.h"
#include "tests/core/recording/collect.h"

namespace noctule {
namespace {

using test::Folder;
using test::requestFor;
using test::runSql;
using Json = nlohmann::json;

struct SegmentError {
    double mean_deg = 0, max_deg = 0;
};

/// Of a segment's orientation in the world. With boards on two segments alone nothing says how a turn spreads
/// over the joints between them, so single joints cannot be asked for.
SegmentError segmentError(const TimedMotion& poses, const TimedMotion& reference,
                          const std::string& segment) {
    PoseSampler truth(reference, bridgeableGap_ns(reference));
    SegmentError error;
    int compared = 0;
    for (const TimedPose& timed : poses.frames) {
        const auto true_pose = truth.at(timed.time_ns);
        if (!true_pose || timed.time_ns < 500'000'000)
            continue;
        const auto orientation = [&](const Skeleton& skeleton, const Pose& pose) {
            return globalPose(skeleton, pose).q_world_joint[static_cast<size_t>(skeleton.find(segment))];
        };
        const double angle_deg = degrees(orientation(poses.skeleton, *timed.pose)
                                             .angularDistance(orientation(reference.skeleton, *true_pose)));
        error.mean_deg += angle_deg;
        error.max_deg = std::max(error.max_deg, angle_deg);
        ++compared;
    }
    EXPECT_GT(compared, 200);
    error.mean_deg /= compared;
    return error;
}

TEST(ProcessTinyTake, GravityIsThatOfTheTake) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    ProcessRequest request = requestFor(path);
    request.tracker.root_given = false;
    const auto height_after_m = [&] {
        const auto summary = processTake(request, {});
        EXPECT_TRUE(summary) << summary.error().text();
        const Take take = Take::open(path).value();
        return take.poses(summary->pose_run).value().frames.back().pose->p_world_root.y();
    };
    const double height_m = height_after_m();
    runSql(path, "INSERT OR REPLACE INTO meta VALUES('g_m_per_s2','9.3')");
    EXPECT_GT(height_after_m() - height_m, 0.05) << "0.5 m/s^2 more than gravity lift the root";
}

TEST(ProcessTinyTake, SaysWhenTheCalibrationIsOfAnotherBoard) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    ProcessRequest request = requestFor(path);
    const Take take = Take::open(path).value();
    request.calibration = take.calibrationInForce().value().value;
    const Board board = take.suit().value().boards[0];
    request.calibration->boards[0].serial = "NB-else";
    ASSERT_EQ(request.calibration->boards[0].id, board.id);
    const auto others = [&] {
        const auto summary = processTake(request, {});
        EXPECT_TRUE(summary) << summary.error().text();
        return std::ranges::count_if(summary->warnings, [&](const std::string& warning) {
            return warning.find("calibrated was NB-else") != std::string::npos;
        });
    };
    EXPECT_EQ(others(), board.serial.empty() ? 0 : 1);
    Json suit = toJson(take.suit().value());
    suit["boards"][0]["serial"] = "NB-17";
    runSql(path, "UPDATE suit SET json='" + suit.dump() + "'");
    EXPECT_EQ(others(), 1);
}

TEST(ProcessTinyTake, SaysWhenTheCalibrationNamesAnotherBox) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    runSql(path, "INSERT OR REPLACE INTO meta VALUES('box_serial', 'NB-000001')");
    ProcessRequest request = requestFor(path);
    request.calibration = Take::open(path).value().calibrationInForce().value().value;
    for (const char* box : {"", "NB-000001", "NB-000002"}) {
        request.calibration->box_serial = box;
        const auto summary = processTake(request, {});
        ASSERT_TRUE(summary) << summary.error().text();
        EXPECT_EQ(std::ranges::count_if(summary->warnings,
                                        [](const std::string& warning) {
                                            return warning.starts_with(
                                                "The calibration was made for another suit, box NB-000002");
                                        }),
                  std::string(box) == "NB-000002" ? 1 : 0)
            << box;
    }
}

TEST(ProcessTinyTake, BothEstimatorsGivePosesNearTheReference) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    for (const std::string estimator : {kManifoldEstimator, kPaperEstimator}) {
        SCOPED_TRACE(estimator);
        ProcessRequest request = requestFor(path);
        request.tracker.estimator = estimator;
        const auto summary = processTake(request, {});
        ASSERT_TRUE(summary) << summary.error().text();
        EXPECT_NEAR(summary->duration_s, 302500 / 150000.0, 1e-9);
        EXPECT_EQ(summary->frames_lost, 0);
        EXPECT_GT(summary->ranges.used, 60);

        const Take take = Take::open(path).value();
        const TimedMotion poses = take.poses(summary->pose_run).value();
        ASSERT_EQ(std::ssize(poses.frames), summary->poses);
        EXPECT_GE(summary->poses, 280);
        EXPECT_EQ(poses.frames.front().time_ns, 0);
        for (size_t i = 0; i < poses.frames.size(); ++i) {
            EXPECT_NEAR(static_cast<double>(poses.frames[i].time_ns), static_cast<double>(i) * 1e9 / 140, 1);
            EXPECT_TRUE(poses.frames[i].pose && isUsable(*poses.frames[i].pose));
        }
        // Measured means: manifold 0.15, 0.6 and 1.0 degrees, paper 0.1, 2.3 and 1.9.
        const bool paper = estimator == kPaperEstimator;
        const TimedMotion reference = take.reference().value();
        EXPECT_LT(segmentError(poses, reference, "Hips").mean_deg, 0.5);
        EXPECT_LT(segmentError(poses, reference, "Chest").mean_deg, paper ? 4 : 1.5);
        EXPECT_LT(segmentError(poses, reference, "LeftHand").mean_deg, paper ? 4 : 2);
        EXPECT_LT(segmentError(poses, reference, "LeftHand").max_deg, 8);
    }
}

/// The paper's filter keeps the gyroscopes' zeros of the rest pose: over minutes its heading drifts.
TEST(ProcessTinyTake, DriftOfALongTakeIsSaidByProcessAndReport) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    runSql(path, "UPDATE meta SET value=90*150000 WHERE key='sample_count'");
    const auto drifts = [](const std::vector<std::string>& warnings) {
        return std::ranges::any_of(warnings, [](const std::string& warning) {
            return warning.find("1.5 minutes after the rest pose") != std::string::npos;
        });
    };
    ProcessRequest request = requestFor(path);
    request.tracker.root_given = false;
    EvaluateRequest evaluation;
    evaluation.take_path = path;
    for (const std::string estimator : {kPaperEstimator, kManifoldEstimator}) {
        request.tracker.estimator = estimator;
        const auto summary = processTake(request, {});
        ASSERT_TRUE(summary) << summary.error().text();
        const bool is_paper = estimator == kPaperEstimator;
        EXPECT_EQ(drifts(summary->warnings), is_paper) << estimator;
        const auto report = evaluateTake(evaluation, {});
        ASSERT_TRUE(report) << report.error().text();
        EXPECT_EQ(drifts(report->warnings), is_paper) << estimator;
    }
    EXPECT_EQ(driftWarning(kPaperEstimator, "AGD", false, 30), "") << "too short to be seen";
    EXPECT_EQ(driftWarning(kPaperEstimator, "AGD", true, 300), "") << "another system gives the heading";
    EXPECT_NE(driftWarning(kPaperEstimator, "AGD", false, 300), "");
}

TEST(ProcessTinyTake, WritesItsRunsWithTheirSettings) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    const auto first = processTake(requestFor(path), {});
    const auto second = processTake(requestFor(path), {});
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->run_name, "AGD");
    EXPECT_EQ(second->run_name, "AGD 2");
    EXPECT_EQ(second->inertial_run, first->inertial_run) << "readings do not depend on the estimator";
    EXPECT_NE(second->pose_run, first->pose_run);
    EXPECT_NE(second->range_run, first->range_run);

    const Take take = Take::open(path).value();
    const auto runs = take.derivedRuns().value();
    ASSERT_EQ(runs.size(), 5u);
    EXPECT_EQ(std::ranges::count(runs, std::string("inertial"), &DerivedRun::kind), 1);
    for (const auto& summary : {*first, *second}) {
        const auto run = std::ranges::find(runs, summary.pose_run, &DerivedRun::run);
        ASSERT_NE(run, runs.end());
        EXPECT_EQ(run->kind, "pose");
        EXPECT_EQ(run->name, summary.run_name);
        EXPECT_EQ(run->software, "test");
        EXPECT_EQ(run->created_utc, "2026-01-01T00:00:00Z");
        EXPECT_EQ(run->calibration_id, 1);
        EXPECT_EQ(run->actor_id, 1);
        const auto settings = nlohmann::json::parse(run->settings_json);
        EXPECT_EQ(settings["sensors"], "AGD");
        EXPECT_EQ(settings["root"], "given");
        EXPECT_EQ(settings["estimator"], "manifold");
        EXPECT_EQ(settings["detector"], "matched");
        EXPECT_EQ(settings["program"], "test");
        EXPECT_EQ(settings["parameters"]["range.gate"], 5);
        EXPECT_GT(settings["parameters"].size(), 90u);
        EXPECT_EQ(settings["made_by"].get<std::string>().size(), 16u);
        EXPECT_EQ(settings["inertial_run"], summary.inertial_run);
        EXPECT_EQ(settings["range_run"], summary.range_run);
        EXPECT_NEAR(settings["rest_end_s"].get<double>(), 74999 / 150000.0, 1e-9);
        auto ranges = take.ranges(summary.range_run).value();
        EXPECT_EQ(std::ssize(test::collect(ranges)), summary.ranges.heard);
    }
    auto readings = take.readings(first->inertial_run).value();
    EXPECT_EQ(std::ssize(test::collect(readings)), first->frames_seen);
    EXPECT_TRUE(take.skippedRows().empty());
}

TEST(ProcessTinyTake, RepeatsItselfToTheLastBit) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    const auto first = processTake(requestFor(path), {});
    const auto second = processTake(requestFor(path), {});
    ASSERT_TRUE(first && second);
    const Take take = Take::open(path).value();
    const TimedMotion a = take.poses(first->pose_run).value(), b = take.poses(second->pose_run).value();
    ASSERT_EQ(a.frames.size(), b.frames.size());
    for (size_t i = 0; i < a.frames.size(); ++i) {
        EXPECT_EQ(a.frames[i].sigma_rad, b.frames[i].sigma_rad);
        for (size_t j = 0; j < a.frames[i].pose->q_parent_joint.size(); ++j)
            EXPECT_EQ(a.frames[i].pose->q_parent_joint[j].coeffs(),
                      b.frames[i].pose->q_parent_joint[j].coeffs());
    }
}

/// Cancels when the work is half done, as a user would.
class CancelHalfWay : public ProgressSink {
public:
    void progress(double fraction, const std::string&) override {
        if (fraction > 0.5)
            flag.cancel();
    }
    CancelFlag flag;
};

TEST(ProcessTinyTake, CancelledItLeavesTheFileAsItWas) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    const std::string before = test::readBytes(path);
    CancelHalfWay user;
    const auto cancelled = processTake(requestFor(path), {&user, &user.flag});
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().kind, ErrorKind::kCancelled);
    EXPECT_TRUE(test::readBytes(path) == before);
    EXPECT_EQ(folder.names().size(), 1u);
}

TEST(ProcessTinyTake, SmoothedRunsSayBySettingsAndNameHow) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    const auto plain = processTake(requestFor(path), {});
    ASSERT_TRUE(plain) << plain.error().text();
    for (const Smoother smoother : {Smoother::kLag, Smoother::kFull, Smoother::kBatch}) {
        SCOPED_TRACE(smootherName(smoother));
        ProcessRequest request = requestFor(path);
        request.tracker.smoother = smoother;
        const auto summary = processTake(request, {});
        ASSERT_TRUE(summary) << summary.error().text();
        EXPECT_EQ(summary->run_name, smoother == Smoother::kLag    ? "AGD lag"
                                     : smoother == Smoother::kFull ? "AGD smoothed"
                                                                   : "AGD batch");
        EXPECT_EQ(summary->ranges.used, plain->ranges.used) << "the filter judges ranges as it does alone";
        const Take take = Take::open(path).value();
        const auto runs = take.derivedRuns().value();
        const auto run = std::ranges::find(runs, summary->pose_run, &DerivedRun::run);
        EXPECT_EQ(runSettings(*run, runs, take.level()).smoother, smootherName(smoother));
        const TimedMotion poses = take.poses(summary->pose_run).value(),
                          filtered = take.poses(plain->pose_run).value();
        ASSERT_EQ(poses.frames.size(), filtered.frames.size());
        for (size_t i = 0; i < poses.frames.size(); ++i)
            EXPECT_EQ(poses.frames[i].time_ns, filtered.frames[i].time_ns);
    }
}

/// Cancels as soon as smoothing begins.
class CancelSmoothing : public ProgressSink {
public:
    void progress(double fraction, const std::string& stage) override {
        EXPECT_GE(fraction, last_);
        last_ = fraction;
        if (stage == "Smoothing")
            flag.cancel();
    }
    CancelFlag flag;

private:
    double last_ = 0;
};

TEST(ProcessTinyTake, CancelledWhileSmoothingItLeavesTheFileAsItWas) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    const std::string before = test::readBytes(path);
    for (const Smoother smoother : {Smoother::kFull, Smoother::kBatch}) {
        ProcessRequest request = requestFor(path);
        request.tracker.smoother = smoother;
        CancelSmoothing user;
        const auto cancelled = processTake(request, {&user, &user.flag});
        ASSERT_FALSE(cancelled);
        EXPECT_EQ(cancelled.error().kind, ErrorKind::kCancelled);
        EXPECT_TRUE(test::readBytes(path) == before);
        EXPECT_EQ(folder.names().size(), 1u);
    }
}

TEST(ProcessTinyTake, WithoutACalibrationItSaysThatTheResultIsNotUsable) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    test::runSql(path, "DELETE FROM calibration");
    const auto summary = processTake(requestFor(path), {});
    ASSERT_TRUE(summary) << summary.error().text();
    EXPECT_EQ(summary->calibrated, Grade::kNotUsable);
    EXPECT_TRUE(summary->lack.isTotal());
    EXPECT_EQ(std::ranges::count(summary->warnings,
                                 "Not usable: this take has no calibration. Process it with one."),
              1);
    const auto inspection = inspectTake(path, {});
    ASSERT_TRUE(inspection);
    EXPECT_EQ(std::ranges::count(inspection->problems,
                                 "Not usable: this take has no calibration. Process it with one."),
              1);
}

TEST(ProcessTinyTake, RefusesACalibrationOfAnotherSuit) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    const std::string before = test::readBytes(path);
    ProcessRequest request = requestFor(path);
    request.calibration = nominalCalibration(defaultSuit());
    for (BoardCalibration& board : request.calibration->boards)
        board.id += " of another suit";
    const auto refused = processTake(request, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUnusable);
    for (const char* expected : {"tiny.noctule", "chest", "l_hand"})
        EXPECT_NE(refused.error().message.find(expected), std::string::npos) << refused.error().text();
    EXPECT_FALSE(refused.error().remedy.empty());
    EXPECT_TRUE(test::readBytes(path) == before);
}

TEST(ProcessTinyTake, RefusesAGivenRootThatTheTakeDoesNotHave) {
    const Folder folder;
    const std::string path = tinyTake(folder);
    test::runSql(path, "DELETE FROM external_root");
    const auto refused = processTake(requestFor(path), {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(refused.error().message.find("external_root"), std::string::npos) << refused.error().text();
    ProcessRequest free_root = requestFor(path);
    free_root.tracker.root_given = false;
    EXPECT_TRUE(processTake(free_root, {}));
}

}  // namespace
}  // namespace noctule
