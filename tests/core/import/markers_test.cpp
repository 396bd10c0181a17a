// SPDX-License-Identifier: Apache-2.0
// Recordings of markers: bytes after their specifications.
#include "core/import/markers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "tests/core/import/example_files.h"

namespace noctule::test {
namespace {

TEST(Markers, SixKindsOfC3dAgree) {
    for (const int processor : {84, 85, 86})
        for (const bool floats : {false, true}) {
            const auto read = parseC3d(C3dExample(processor, floats).bytes(), "x.c3d", {});
            ASSERT_TRUE(read) << read.error().text();
            EXPECT_EQ(read->names, (std::vector<std::string>{"LASI", "Hips"}));
            EXPECT_EQ(read->rate_hz, 200);
            EXPECT_EQ(read->up, "Z");
            ASSERT_EQ(read->rows(), 3u);
            EXPECT_LT((read->at(2, 0) - Vector3d(0.102, -0.2, 0.3)).norm(), 1e-6) << processor << floats;
            EXPECT_FALSE(read->at(1, 1).allFinite());
            EXPECT_TRUE(read->warnings.empty()) << read->warnings.front();
        }
}

TEST(Markers, C3dNamesDoNotDependOnCaseAndLongFramesCountMore) {
    std::string bytes = C3dExample(84, true, true).bytes();
    for (const std::string name : {"LABELS", "POINT", "Y_SCREEN"}) {
        const size_t at = bytes.find(name);
        ASSERT_NE(at, std::string::npos);
        std::transform(bytes.begin() + long(at), bytes.begin() + long(at + name.size()),
                       bytes.begin() + long(at), [](unsigned char c) { return char(std::tolower(c)); });
    }
    const auto read = parseC3d(bytes, "x.c3d", {});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->names, (std::vector<std::string>{"LASI", "Hips"}));
    EXPECT_EQ(read->up, "Z");
    EXPECT_EQ(read->rows(), 3u);
}

std::string trcWithNames(const std::string& names) {
    std::string text = trcExample();
    const std::string old = "Hips\t\t\tLASI\t\t";
    return text.replace(text.find(old), old.size(), names);
}

/// One tab between names, several between keys, and a marker without a name.
TEST(Markers, TrcNamesStandWhereTheirColumnsAre) {
    const auto close = parseTrc(trcWithNames("Hips\tLASI"), "x.trc", {});
    ASSERT_TRUE(close) << close.error().text();
    EXPECT_EQ(close->names, (std::vector<std::string>{"Hips", "LASI"}));
    EXPECT_LT((close->at(0, 1) - Vector3d(0.001, 0.002, 0.003)).norm(), 1e-12);
    const auto unnamed = parseTrc(trcWithNames("\t\t\tLASI\t\t"), "x.trc", {});
    ASSERT_TRUE(unnamed) << unnamed.error().text();
    EXPECT_EQ(unnamed->names, (std::vector<std::string>{"point 1", "LASI"}));
    EXPECT_LT((unnamed->at(0, 1) - Vector3d(0.001, 0.002, 0.003)).norm(), 1e-12);
    std::string spread = trcExample();
    spread.replace(spread.find("DataRate\t"), 9, "DataRate\t\t");
    const auto same = parseTrc(spread, "x.trc", {});
    ASSERT_TRUE(same) << same.error().text();
    EXPECT_EQ(same->rate_hz, 100);
    EXPECT_EQ(same->unit, "mm");
}

TEST(Markers, TrcKeepsRowsWhateverItsHeaderCounts) {
    const auto read = parseTrc(trcExample(), "x.trc", {});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->names, (std::vector<std::string>{"Hips", "LASI"}));
    ASSERT_EQ(read->rows(), 3u);
    EXPECT_LT((read->at(2, 0) - Vector3d(1.002, 0.5, 0.25)).norm(), 1e-12);
    EXPECT_FALSE(read->at(1, 1).allFinite());
    EXPECT_TRUE(mentions(read->warnings, "states 99 rows"));
    const auto unknown = jointsOfMarkers(*read, {}, "", "x.trc");
    ASSERT_FALSE(unknown);
    EXPECT_NE(unknown.error().text().find("--up"), std::string::npos);
    const auto joints = jointsOfMarkers(*read, {{"Hips", {"Hips", "LASI"}}}, "Z", "x.trc");
    ASSERT_TRUE(joints) << joints.error().text();
    EXPECT_EQ(joints->time_s.size(), 2u) << "the row in which LASI is not seen is left out";
    EXPECT_LT((joints->at(0, 0) - Vector3d(0.251, 0.1265, 0.5005)).norm(), 1e-9) << "Z up becomes Y up";
    EXPECT_FALSE(jointsOfMarkers(*read, {{"Hips", {"RASI"}}}, "Z", "x.trc"));
}

}  // namespace
}  // namespace noctule::test
