// SPDX-License-Identifier: Apache-2.0
// Recordings of other sensors from the command line: a map made by hand, and orientations as a table.
#include "tests/core/import/example_files.h"
#include "tests/support/program_run.h"

namespace noctule::test {
namespace {

class Import : public ::testing::Test {
protected:
    void SetUp() override {
        std::vector<int> counts(200);
        for (size_t i = 0; i < counts.size(); ++i)
            counts[i] = int(i);
        writeBytes(one_, xsensExample(counts, '\t', true, "\n", "0001"));
        writeBytes(two_, xsensExample(counts, '\t', true, "\n", "0002"));
    }

    Folder folder_;
    const std::string one_ = folder_.file("walk_0001.txt"), two_ = folder_.file("walk_0002.txt"),
                      map_ = folder_.file("map.json"), take_ = folder_.file("walk.noctule");
};

TEST_F(Import, AMapIsWrittenFilledInAndUsed) {
    const Ran listed = batch({"import", one_, two_, "--map-template", map_});
    ASSERT_EQ(listed.exit_code, 0) << listed.err;
    EXPECT_NE(listed.err.find("2 of 2 sensors have no segment"), std::string::npos) << listed.err;
    EXPECT_NE(listed.err.find("0001, 0002"), std::string::npos) << listed.err;
    auto map = nlohmann::json::parse(readBytes(map_));
    map["sensors"][0]["segment"] = "LeftArm";
    map["sensors"][1]["segment"] = "LeftForeArm";
    writeBytes(map_, map.dump());
    const Ran made = batch({"import", one_, two_, "--map", map_, "--out", take_, "--json"});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    EXPECT_EQ(made.json()["sensors"][1]["segment"], "LeftForeArm");
    EXPECT_EQ(made.err.find("no segment"), std::string::npos) << made.err;

    const std::string csv = folder_.file("o.csv");
    const Ran oriented = batch({"orient", take_, "--csv", csv, "--angles", "ZXZ"});
    ASSERT_EQ(oriented.exit_code, 0) << oriented.err;
    std::istringstream lines(readBytes(csv));
    std::string head, first, line, last;
    std::getline(lines, head);
    std::getline(lines, first);
    for (size_t n = 0; std::getline(lines, line); ++n)
        last = line;
    EXPECT_EQ(head,
              "time_s,sensor,segment,qw,qx,qy,qz,angle1_z_deg,angle2_x_deg,angle3_z_deg,relative_to,"
              "relative_qw,relative_qx,relative_qy,relative_qz,relative_angle1_z_deg,relative_angle2_x_deg,"
              "relative_angle3_z_deg");
    EXPECT_TRUE(first.starts_with("0.000000,0001,LeftArm,")) << first;
    EXPECT_TRUE(first.ends_with(",,,,,,,,")) << "nothing sits before the upper arm: " << first;
    // Both sensors read the same: one is not turned against the other.
    EXPECT_NE(last.find(",0002,LeftForeArm,"), std::string::npos) << last;
    EXPECT_NE(last.find(",0001,1.0000000,"), std::string::npos) << last;
    expectRefusal({"orient", take_, "--csv", csv}, 2, {"o.csv"});
}

TEST_F(Import, AMapThatDoesNotFitIsRefusedAndNothingIsLeft) {
    writeBytes(map_,
               R"({"format":"noctule-import-map","version":1,"sensors":[{"id":"7","segment":"Hips"}]})");
    expectRefusal({"import", one_, two_, "--map", map_, "--out", take_}, 2, {"\"7\"", "0001"});
    writeBytes(map_,
               R"({"format":"noctule-import-map","version":1,"sensors":[{"id":"0001","segment":"Hip"}]})");
    expectRefusal({"import", one_, two_, "--map", map_, "--out", take_}, 2, {"\"Hip\"", "Hips"});
    expectRefusal({"import", one_, two_, "--map", map_, "--assign", "auto", "--out", take_}, 2,
                  {"--assign auto"});
    EXPECT_FALSE(std::filesystem::exists(take_));
}

}  // namespace
}  // namespace noctule::test
