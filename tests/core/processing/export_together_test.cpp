// SPDX-License-Identifier: Apache-2.0
// Performers of one take in one file, or in one each: all on one clock, and never fewer than all.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/formats/positions_csv.h"
#include "core/formats/scene_reader.h"
#include "core/mesh/import/gltf_document.h"
#include "core/processing/check_export.h"
#include "core/processing/run_subjects.h"
#include "core/recording/database.h"
#include "tests/core/simulation/swaying_pair.h"
#include "tests/support/files.h"

namespace noctule {
namespace {

class ExportTogether : public testing::Test {
protected:
    void SetUp() override {
        const Status written = test::writeProcessedPair(path());
        ASSERT_TRUE(written) << written.error().text();
        request_.take_path = path();
        request_.fbx_path = folder_.file("both.fbx");
        request_.frames_per_second = 60;
        request_.with_body = false;
    }
    std::string path() const { return folder_.file("pair.noctule"); }
    void leaveOut(const std::string& rows) const {
        auto database = Database::open(path(), Access::kReadWrite);
        ASSERT_TRUE(database);
        ASSERT_TRUE(database->execute("DELETE FROM pose WHERE " + rows));
    }

    test::Folder folder_;
    ExportRequest request_;
};

TEST_F(ExportTogether, WhoJoinsLateHoldsTheFirstPoseUntilThen) {
    leaveOut("suit = 2 AND time_ns < 1500000000");
    const auto requests = requestsTogether(request_);
    ASSERT_TRUE(requests) << requests.error().text();
    ASSERT_EQ(requests->size(), 2U);
    for (const ExportRequest& one : *requests) {
        ASSERT_TRUE(one.from_s && one.to_s);
        EXPECT_LT(*one.from_s, 0.1) << one.character << ": where Ada begins";
        EXPECT_EQ(*one.from_s, *requests->front().from_s);
        EXPECT_EQ(*one.to_s, *requests->front().to_s);
        EXPECT_FALSE(one.character.empty());
    }
    const auto summary = exportStacks(*requests, {});
    ASSERT_TRUE(summary) << summary.error().text();
    const std::string said = "Bea holds its first pose until 1.5 s.";
    EXPECT_EQ(std::ranges::count(summary->held, said), 1);
    const auto checks = checkStacks(*requests, {});
    ASSERT_TRUE(checks) << checks.error().text();
    ASSERT_EQ(checks->size(), 2U);
    for (const ExportCheck& check : *checks) {
        EXPECT_TRUE(check.ok()) << check.faults.front();
        EXPECT_EQ(check.frames, summary->frames);
    }
    ASSERT_FALSE(checks->back().held.empty());
    EXPECT_EQ(checks->back().held.front(), said);
}

TEST_F(ExportTogether, AFileForEachBeginsAndEndsAtTheSameInstants) {
    leaveOut("suit = 2 AND time_ns < 1500000000 OR suit = 1 AND time_ns > 2500000000");
    request_.fbx_path.clear();
    request_.csv_path = folder_.file("each.csv");
    const auto requests = requestsOfSubjects(request_);
    ASSERT_TRUE(requests) << requests.error().text();
    ASSERT_EQ(requests->size(), 2U);
    std::vector<ExportSummary> summaries;
    std::vector<PositionTable> tables;
    for (const ExportRequest& one : *requests) {
        const auto summary = exportTake(one, {});
        ASSERT_TRUE(summary) << summary.error().text();
        summaries.push_back(*summary);
        const auto table = readPositionsCsv(one.csv_path);
        ASSERT_TRUE(table) << table.error().text();
        tables.push_back(*table);
        EXPECT_NEAR(table->time_s.front(), summary->begin_s, 1e-9) << "the take's time";
        const auto checks = checkExport(one, {});
        ASSERT_TRUE(checks) << checks.error().text();
        EXPECT_TRUE(checks->front().ok()) << checks->front().faults.front();
    }
    EXPECT_EQ(summaries[0].begin_s, summaries[1].begin_s);
    EXPECT_EQ(tables[0].time_s, tables[1].time_s);
    EXPECT_GT(tables[0].time_s.back(), 2.7) << "where Bea ends";
    ASSERT_EQ(summaries[0].held.size(), 1U);
    EXPECT_EQ(summaries[0].held[0], "Ada holds its last pose from 2.5 s on.");
    EXPECT_EQ(summaries[1].held.at(0), "Bea holds its first pose until 1.5 s.");
    const auto moved_m = [&](size_t who, double from_s, double to_s) {
        const PositionTable& table = tables[who];
        const auto row = [&](double s) {
            return static_cast<size_t>(std::ranges::lower_bound(table.time_s, s) - table.time_s.begin());
        };
        return (table.at(row(to_s), 0) - table.at(row(from_s), 0)).norm();
    };
    EXPECT_EQ(moved_m(1, 0.5, 1.4), 0) << "she stands still";
    EXPECT_GT(moved_m(1, 1.6, 2.4), 1e-3);
    EXPECT_EQ(moved_m(0, 2.55, 2.7), 0);
}

TEST_F(ExportTogether, FramesStayOnTheGridOfTheSecondThatIsAskedFor) {
    leaveOut("suit = 1 AND time_ns < 1200000000 OR suit = 2 AND time_ns < 1500000000");
    request_.from_s = 0.5;
    request_.to_s = 2;
    const auto requests = requestsOfSubjects(request_);
    ASSERT_TRUE(requests) << requests.error().text();
    for (const ExportRequest& one : *requests) {
        const double frames = (*one.from_s - 0.5) * request_.frames_per_second;
        EXPECT_NEAR(frames, std::round(frames), 1e-6);
        EXPECT_NEAR(*one.from_s, 1.2, 0.03);
        EXPECT_DOUBLE_EQ(*one.to_s, 2);
    }
}

TEST_F(ExportTogether, GlbHoldsEachWithASkinOfItsOwnInOneAnimation) {
    request_.fbx_path.clear();
    request_.glb_path = folder_.file("both.glb");
    request_.with_body = true;
    const auto requests = requestsTogether(request_);
    ASSERT_TRUE(requests) << requests.error().text();
    ASSERT_EQ(requests->size(), 2U);
    const auto summary = exportStacks(*requests, {});
    ASSERT_TRUE(summary) << summary.error().text();
    EXPECT_EQ(summary->files, std::vector{request_.glb_path});
    const auto checks = checkStacks(*requests, {});
    ASSERT_TRUE(checks) << checks.error().text();
    ASSERT_EQ(checks->size(), 2U);
    for (const ExportCheck& check : *checks)
        EXPECT_TRUE(check.ok()) << check.faults.front();
    EXPECT_GT(((*checks)[0].height_m), 1);

    const auto file = GltfDocument::open(request_.glb_path);
    ASSERT_TRUE(file) << file.error().text();
    EXPECT_EQ(file->count("animations"), 1U);
    ASSERT_EQ(file->count("skins"), 2U);
    std::set<std::string> tops, characters;
    for (const auto& top : file->item("scenes", 0)["nodes"])
        tops.insert(file->item("nodes", top.get<size_t>())["name"].get<std::string>());
    for (const size_t skin : {0U, 1U}) {
        std::set<std::string> own;
        for (const auto& joint : file->item("skins", skin)["joints"])
            own.insert(std::string(
                characterOf(file->item("nodes", joint.get<size_t>())["name"].get<std::string>())));
        ASSERT_EQ(own.size(), 1U) << "a skin hangs on the joints of one performer";
        characters.insert(*own.begin());
    }
    EXPECT_EQ(characters, tops);
}

TEST_F(ExportTogether, WhoAreNeverSeenAtOneTimeStandStillInTurn) {
    leaveOut("suit = 2 AND time_ns < 1500000000 OR suit = 1 AND time_ns > 1400000000");
    const auto requests = requestsTogether(request_);
    ASSERT_TRUE(requests) << requests.error().text();
    const auto summary = exportStacks(*requests, {});
    ASSERT_TRUE(summary) << summary.error().text();
    EXPECT_EQ(summary->held, (std::vector<std::string>{"Ada holds its last pose from 1.4 s on.",
                                                       "Bea holds its first pose until 1.5 s."}));
}

TEST_F(ExportTogether, APerformerWithoutPosesIsNotLeftOutSilently) {
    leaveOut("suit = 2");
    EXPECT_FALSE(requestsTogether(request_));
}

}  // namespace
}  // namespace noctule
