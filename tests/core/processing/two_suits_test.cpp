// SPDX-License-Identifier: Apache-2.0
// A take of two performers and a room (format 1.1). The example lies beside the repository (../shared/spec)
// and is not part of it: without it these tests are skipped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "core/processing/evaluate_take.h"
#include "core/processing/inspect_take.h"
#include "core/processing/process_take.h"
#include "core/processing/run_subjects.h"
#include "tests/support/take_files.h"

namespace noctule {
namespace {

using test::Folder;
using test::runSql;

const std::string kTwoSuits = NOCTULE_SOURCE_DIR "/../shared/spec/vectors/two_suits.noctule";

class TwoSuits : public testing::Test {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(kTwoSuits))
            GTEST_SKIP() << "no " << kTwoSuits;
        path_ = folder_.file("two.noctule");
        std::filesystem::copy_file(kTwoSuits, path_);
    }

    ProcessRequest request(std::vector<std::string> subjects = {}) const {
        ProcessRequest request;
        request.take_path = path_;
        request.subjects = std::move(subjects);
        request.tracker.root_given = true;
        request.software = "test";
        return request;
    }

    /// What processing says of the take after a change by SQL; the take must stay as that left it.
    Error refusalAfter(const std::string& sql) const {
        runSql(path_, sql);
        const auto summary = processTake(request(), {});
        EXPECT_FALSE(summary) << sql;
        const auto take = Take::open(path_);
        if (take) {
            EXPECT_TRUE(take->derivedRuns()->empty()) << "something was written";
        }
        return summary ? Error{} : summary.error();
    }

    Folder folder_;
    std::string path_;
};

TEST_F(TwoSuits, SubjectsAndTheirSuitsAreRead) {
    Take take = Take::open(path_).value();
    const auto subjects = take.subjects().value();
    ASSERT_EQ(subjects.size(), 3u);
    EXPECT_EQ(subjects[0].name, "A");
    EXPECT_EQ(subjects[1].suits, std::vector<int>{2});
    EXPECT_TRUE(subjects[2].room);
    EXPECT_EQ(take.header().drive_hz, 40000);
    take.view(2);
    EXPECT_EQ(take.header().drive_hz, 48000);
    EXPECT_EQ(take.header().pulse_interval_samples, 1230);
    EXPECT_EQ(take.suit()->name, "B welch");
    EXPECT_EQ(take.pulses()->size(), 303u);
    EXPECT_EQ(take.pulses(1)->size(), 311u);
    EXPECT_EQ(take.reference()->frames.size(), 350u);
    EXPECT_LT(take.suitClock().offset_ns, -2e7);
}

TEST_F(TwoSuits, EachSubjectIsProcessedAndEveryRowKept) {
    const auto before = inspectTake(path_, {}).value();
    const auto summary = processTake(request(), {});
    ASSERT_TRUE(summary) << summary.error().text();
    ASSERT_EQ(summary->subjects.size(), 2u);
    const auto says = [&](const std::string& words) {
        return std::ranges::any_of(
            summary->warnings, [&](const auto& warning) { return warning.find(words) != std::string::npos; });
    };
    EXPECT_TRUE(says("Distances between suits are not used"));
    EXPECT_TRUE(says("--root given"));

    const auto subjects = subjectsOfRun(path_, "").value();
    ASSERT_EQ(subjects.size(), 2u);
    for (size_t s = 0; s < 2; ++s) {
        SCOPED_TRACE(subjects[s].name);
        EXPECT_GT(summary->subjects[s].poses, 300);
        EXPECT_GT(summary->subjects[s].ranges.used, 50);
        EvaluateRequest evaluation;
        evaluation.take_path = path_;
        evaluation.suit = subjects[s].suit();
        const auto data = evaluateTake(evaluation, {});
        ASSERT_TRUE(data) << data.error().text();
        ASSERT_TRUE(data->shownRun()->comparison);
        std::printf("%s: %.2f degrees, %lld of %lld ranges\n", subjects[s].name.c_str(),
                    data->shownRun()->comparison->mean_deg,
                    static_cast<long long>(summary->subjects[s].ranges.used),
                    static_cast<long long>(summary->subjects[s].ranges.heard));
        EXPECT_LT(data->shownRun()->comparison->root.position_m, 0.01) << "the root was given, on take time";
    }

    const auto after = inspectTake(path_, {}).value();
    ASSERT_EQ(after.suits.size(), 3u);
    for (size_t s = 0; s < 3; ++s) {
        EXPECT_EQ(after.suits[s].pulses, before.suits[s].pulses);
        EXPECT_EQ(after.suits[s].blocks, 63);
        EXPECT_EQ(after.suits[s].status.size(), 3u);
        EXPECT_EQ(after.suits[s].reference_frames, s < 2 ? 350 : 0);
    }
    EXPECT_EQ(after.suits[1].subject, "B");
    EXPECT_TRUE(after.suits[2].room);
    EXPECT_TRUE(after.problems.empty()) << after.problems.front();
}

TEST_F(TwoSuits, InspectNamesTheReferenceOfALaterSuitAlone) {
    runSql(path_, "DELETE FROM reference WHERE suit=1");
    const auto in = inspectTake(path_, {}).value();
    EXPECT_EQ(in.reference_frames, 0);
    EXPECT_EQ(in.suits[1].reference_frames, 350);
    EXPECT_EQ(in.reference_kind, "simulated");
}

/// Not only the first suit: parts, calibration, actor and quality of each, the room's too.
TEST_F(TwoSuits, InspectShowsEverySuit) {
    ASSERT_TRUE(processTake(request(), {}));
    runSql(path_, "DELETE FROM calibration WHERE suit=2");
    const auto in = inspectTake(path_, {}).value();
    ASSERT_EQ(in.suits.size(), 3u);
    EXPECT_EQ(in.boards, in.suits[0].boards);
    EXPECT_EQ(in.calibration, in.suits[0].calibration);
    EXPECT_FALSE(in.suits[0].actor.empty());
    EXPECT_FALSE(in.suits[1].actor.empty());
    EXPECT_TRUE(in.suits[1].calibration.empty());
    EXPECT_FALSE(in.suits[2].calibration.empty());
    EXPECT_EQ(in.suits[2].boards.front(), "anchor1");
    EXPECT_TRUE(std::ranges::any_of(in.problems, [](const std::string& problem) {
        return problem.starts_with("B: Not usable");
    })) << "whose calibration is missing is said";
    for (size_t s = 0; s < 2; ++s) {
        const SuitSummary& suit = in.suits[s];
        EXPECT_EQ(suit.wires.size(), suit.boards.size());
        EXPECT_EQ(suit.board_quality.size(), suit.boards.size());
        EXPECT_EQ(suit.pairs.size(), suit.boards.size() * suit.sources.size());
        EXPECT_TRUE(
            std::ranges::any_of(suit.pairs, [](const PairSummary& pair) { return pair.heard_share > 0.2; }));
    }
    EXPECT_TRUE(in.suits[2].board_quality.empty()) << "anchors do not move";
    const auto json = toJson(in);
    EXPECT_EQ(json["suits"][1]["subject"], "B");
    EXPECT_EQ(json["suits"][2]["board_ids"][0], "anchor1");
    EXPECT_EQ(json["suits"][1]["boards"], in.suits[1].boards.size()) << "the count stays where it was";
    EXPECT_TRUE(json["suits"][1]["quality"].contains("pairs"));
}

/// The example holds sound, and nothing has measured distances between its suits yet.
TEST_F(TwoSuits, WhatCannotBeJoinedIsSaid) {
    ProcessRequest wanted = request();
    wanted.tracker.root_given = false;
    wanted.between = Wanted::kOn;
    auto refused = processTake(wanted, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(refused.error().message.find("no distances between its suits"), std::string::npos)
        << refused.error().message;
    wanted.subjects = {"B"};
    refused = processTake(wanted, {});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("needs two subjects"), std::string::npos)
        << refused.error().message;
    wanted.subjects = {};
    runSql(path_, "UPDATE suit SET json=replace(json, '\"carrier_hz\": 48000', '\"carrier_hz\": 40000')");
    refused = processTake(wanted, {});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("A (suit 1) and B (suit 2) sound on one carrier, 40 kHz"),
              std::string::npos)
        << refused.error().message;
    EXPECT_TRUE(Take::open(path_)->derivedRuns()->empty());
    wanted.between = Wanted::kAuto;
    const auto alone = processTake(wanted, {});
    ASSERT_TRUE(alone) << alone.error().text();
    EXPECT_FALSE(alone->together);
    EXPECT_NE(alone->warnings.front().find("one carrier"), std::string::npos) << alone->warnings.front();
}

TEST_F(TwoSuits, OneSubjectAloneGivesTheSamePoses) {
    const auto both = processTake(request(), {});
    const auto alone = processTake(request({"B"}), {});
    ASSERT_TRUE(both && alone);
    Take take = Take::open(path_).value();
    take.view(2);
    const auto with = take.poses(both->pose_run).value(), without = take.poses(alone->pose_run).value();
    ASSERT_EQ(with.frames.size(), without.frames.size());
    for (size_t i = 0; i < with.frames.size(); ++i) {
        EXPECT_EQ(with.frames[i].time_ns, without.frames[i].time_ns);
        EXPECT_EQ(with.frames[i].pose->p_world_root, without.frames[i].pose->p_world_root);
    }
    take.view(1);
    EXPECT_TRUE(take.poses(alone->pose_run)->frames.empty());
}

TEST_F(TwoSuits, SubjectsThatCannotBeAreNamed) {
    const auto refusal = [&](const std::string& subjects) {
        return refusalAfter("UPDATE meta SET value='" + subjects + "' WHERE key='subjects'");
    };
    Error error = refusal(R"([{"name":"A","suits":[1]},{"name":"B","suits":[1]}])");
    EXPECT_EQ(error.kind, ErrorKind::kUnreadable);
    EXPECT_NE(error.message.find("suit 1 is named twice"), std::string::npos) << error.message;
    error = refusal(R"([{"name":"A","suits":[1]},{"name":"C","suits":[3]}])");
    EXPECT_EQ(error.kind, ErrorKind::kUnreadable);
    EXPECT_NE(error.message.find("subject 'C' has no actor"), std::string::npos) << error.message;
    error = refusal(R"([{"name":"A","suits":[7]}])");
    EXPECT_NE(error.message.find("suit 7"), std::string::npos) << error.message;
    error = refusal(R"([{"name":"A","suits":[1]},{"name":"A","suits":[2]}])");
    EXPECT_NE(error.message.find("'A'"), std::string::npos) << error.message;
    error = refusal(R"([{"room":true,"suits":[3]}])");
    EXPECT_NE(error.message.find("nobody"), std::string::npos) << error.message;
    error = refusal("A and B");
    EXPECT_EQ(error.kind, ErrorKind::kUnreadable);
    const auto unknown = processTake(request({"Bob"}), {});
    EXPECT_FALSE(unknown);
}

TEST_F(TwoSuits, SensorsThatCannotBeAreNamed) {
    Error error =
        refusalAfter("UPDATE suit SET json=json_set(json,'$.sources[0].board','nowhere') WHERE id=2");
    EXPECT_EQ(error.kind, ErrorKind::kUnreadable);
    EXPECT_NE(error.message.find("'nowhere'"), std::string::npos) << error.message;
    for (const char* rate : {"0", "-5", "1e9"}) {
        error = refusalAfter(
            std::string("UPDATE suit SET json=json_remove(json_set(json,'$.boards[1].rate_hz',") + rate +
            "),'$.sources[0].board') WHERE id=2");
        EXPECT_EQ(error.kind, ErrorKind::kUnreadable);
        EXPECT_NE(error.message.find("r_wrist"), std::string::npos) << error.message;
        EXPECT_NE(error.message.find("rate_hz"), std::string::npos) << error.message;
    }
}

}  // namespace
}  // namespace noctule
