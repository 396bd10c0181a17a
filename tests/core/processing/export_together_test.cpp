// SPDX-License-Identifier: Apache-2.0
// Performers of one take in one file: only where all of them are seen, and never fewer than all.
#include <gtest/gtest.h>

#include <set>

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

TEST_F(ExportTogether, OnlyWhereBothAreSeen) {
    leaveOut("suit = 2 AND time_ns < 1500000000");
    const auto requests = requestsTogether(request_);
    ASSERT_TRUE(requests) << requests.error().text();
    ASSERT_EQ(requests->size(), 2U);
    for (const ExportRequest& one : *requests) {
        ASSERT_TRUE(one.from_s);
        EXPECT_NEAR(*one.from_s, 1.5, 0.01) << one.character;
        EXPECT_FALSE(one.character.empty());
    }
    const auto summary = exportStacks(*requests, {});
    ASSERT_TRUE(summary) << summary.error().text();
    const auto checks = checkStacks(*requests, {});
    ASSERT_TRUE(checks) << checks.error().text();
    ASSERT_EQ(checks->size(), 2U);
    for (const ExportCheck& check : *checks) {
        EXPECT_TRUE(check.ok()) << check.faults.front();
        EXPECT_EQ(check.frames, summary->frames);
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

TEST_F(ExportTogether, WhoAreNeverSeenAtOneTimeAreRefused) {
    leaveOut("suit = 2 AND time_ns < 1500000000 OR suit = 1 AND time_ns > 1400000000");
    const auto requests = requestsTogether(request_);
    ASSERT_FALSE(requests);
    EXPECT_EQ(requests.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(requests.error().text().find("never seen at the same time"), std::string::npos)
        << requests.error().text();
}

TEST_F(ExportTogether, APerformerWithoutPosesIsNotLeftOutSilently) {
    leaveOut("suit = 2");
    EXPECT_FALSE(requestsTogether(request_));
}

}  // namespace
}  // namespace noctule
