// SPDX-License-Identifier: Apache-2.0
// `simulate` says what it understood of a motion before it starts, takes corrections, and refuses with the
// option that helps.
#include <fstream>

#include "tests/support/program_run.h"

namespace noctule::test {
namespace {

const std::string kSampleWalk = NOCTULE_SOURCE_DIR "/resources/motions/sample.bvh";

std::vector<std::string> simulation(const std::string& motion, const std::string& out,
                                    const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"simulate", "--motion",   motion,     "--out",
                                          out,        "--level",    "readings", "--rest-seconds",
                                          "0",        "--scenario", "ideal"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

/// The sample with every occurrence of a word replaced.
void writeChanged(const std::string& path, const std::string& from, const std::string& to) {
    std::string text = readBytes(kSampleWalk);
    for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    writeBytes(path, text);
}

TEST(MotionUnderstood, IsSaidOnStandardErrorAndInJson) {
    Folder folder;
    const Ran ran = batch(simulation(kSampleWalk, folder.file("a.noctule"), {"--duration", "2", "--json"}));
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_NE(ran.err.find("zero pose: T pose"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("+Y up"), std::string::npos) << ran.err;
    const nlohmann::json motion = ran.json().at("motion");
    EXPECT_EQ(motion.at("unit"), "cm");
    EXPECT_EQ(motion.at("joints").at("LeftForeArm"), "LeftForeArm");
    EXPECT_NEAR(motion.at("height_m").get<double>(), 1.75, 0.01);
    EXPECT_TRUE(motion.at("warnings").empty()) << motion.at("warnings");
}

TEST(MotionUnderstood, CorrectionsAreTaken) {
    Folder folder;
    const Ran tall = batch(simulation(kSampleWalk, folder.file("tall.noctule"),
                                      {"--duration", "2", "--json", "--height", "1.95"}));
    ASSERT_EQ(tall.exit_code, 0) << tall.err;
    EXPECT_NEAR(tall.json().at("motion").at("height_m").get<double>(), 1.95, 1e-3);

    writeChanged(folder.file("odd.bvh"), "JOINT LeftForeArm", "JOINT Wrist2");
    writeBytes(folder.file("map.json"),
               R"({"format": "noctule-bone-map", "version": 1, "bones": {"LeftForeArm": "Wrist2"}})");
    const Ran mapped = batch(simulation(folder.file("odd.bvh"), folder.file("odd.noctule"),
                                        {"--duration", "2", "--json", "--bones", folder.file("map.json")}));
    ASSERT_EQ(mapped.exit_code, 0) << mapped.err;
    EXPECT_EQ(mapped.json().at("motion").at("joints").at("LeftForeArm"), "Wrist2");
}

TEST(MotionUnderstood, WhatIsNoPersonIsRefusedAndNothingIsWritten) {
    Folder folder;
    writeBytes(
        folder.file("two.bvh"),
        "HIERARCHY\nROOT Box\n{\nOFFSET 0 0 0\nCHANNELS 3 Xrotation Yrotation Zrotation\nJOINT Lid\n{\n"
        "OFFSET 0 1 0\nCHANNELS 3 Xrotation Yrotation Zrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n}\n"
        "MOTION\nFrames: 2\nFrame Time: 0.1\n0 0 0 0 0 0\n1 0 0 9 0 0\n");
    const auto names = folder.names();
    expectRefusal(simulation(folder.file("two.bvh"), folder.file("x.noctule")), 4,
                  {"LeftUpLeg", "--bones MAP.json"});
    writeBytes(folder.file("map.json"), "{\"bones\": 3}");
    expectRefusal(simulation(kSampleWalk, folder.file("x.noctule"), {"--bones", folder.file("map.json")}), 3,
                  {"map.json"});
    std::filesystem::remove(folder.file("map.json"));
    EXPECT_EQ(folder.names(), names);
    expectRefusal({"simulate", "--rig", "rest", "--up", "z", "--out", folder.file("x.noctule")}, 2, {"--up"});
}

}  // namespace
}  // namespace noctule::test
