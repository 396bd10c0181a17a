// SPDX-License-Identifier: Apache-2.0
// Commands for a robot from a motion, through the command line. The arm stands in the test.
#include <fstream>

#include "core/media/video_file.h"
#include "tests/support/program_run.h"

namespace noctule::test {
namespace {

const std::string kCircle = NOCTULE_SOURCE_DIR "/resources/motions/trajectories/circle.bvh";

std::string armOfFour(const std::string& lower) {
    const char* const axes[] = {"0 1 0", "1 0 0", "0 0 1", "0 1 0"};
    std::string text = "<robot name=\"bench\"><link name=\"l0\"/>";
    for (int i = 0; i < 4; ++i) {
        const std::string from = "l" + std::to_string(i), to = "l" + std::to_string(i + 1);
        text += "<link name=\"" + to +
                "\"><inertial><origin xyz=\"0 0 -0.12\"/><mass value=\"1\"/><inertia ixx=\"1\" "
                "ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial></link><joint name=\"j" +
                std::to_string(i) + "\" type=\"revolute\"><parent link=\"" + from + "\"/><child link=\"" +
                to + "\"/><axis xyz=\"" + axes[i] + "\"/><origin xyz=\"0 0 " + (i == 3 ? "-0.3" : "0") +
                "\"/><limit lower=\"" + lower + "\" upper=\"2.6\" velocity=\"3\" effort=\"1\"/></joint>";
    }
    return text + "</robot>";
}

class RobotVerb : public ::testing::Test {
protected:
    std::string robot(const std::string& lower = "-2.6") {
        std::ofstream(folder_.file("arm.urdf")) << armOfFour(lower);
        return folder_.file("arm.urdf");
    }
    std::string file(const std::string& name) const { return folder_.file(name); }

    Folder folder_;
};

TEST_F(RobotVerb, WritesCommandsTrajectoryAndProfile) {
    const Ran ran = batch({"robot", kCircle, "--robot", robot(), "--out", file("c.csv"), "--trajectory",
                           file("t.json"), "--profile-out", file("p.json"), "--loop", "--json"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const auto json = ran.json();
    EXPECT_EQ(json["joints"].size(), 4u);
    EXPECT_LE(json["limit_use"]["speed"].get<double>(), 1 + 1e-6);
    std::ifstream table(file("c.csv"));
    std::string line;
    std::getline(table, line);
    EXPECT_EQ(line, "time_s,j0,j1,j2,j3");
    size_t rows = 0;
    while (std::getline(table, line))
        ++rows;
    EXPECT_EQ(rows, json["frames"].get<size_t>());
    std::ifstream trajectory(file("t.json"));
    EXPECT_EQ(nlohmann::json::parse(trajectory)["points"].size(), rows);
    const Ran again = batch({"robot", kCircle, "--robot", robot(), "--out", file("c2.csv"), "--profile",
                             file("p.json"), "--loop"});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    std::ifstream one(file("c.csv")), two(file("c2.csv"));
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(one), {}),
              std::string(std::istreambuf_iterator<char>(two), {}));
}

TEST_F(RobotVerb, FilmsTheRobotBesideThePerformer) {
    const Ran ran =
        batch({"robot", kCircle, "--robot", robot(), "--out", file("c.csv"), "--video", file("c.avi")});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const auto film = readVideo(file("c.avi"));
    ASSERT_TRUE(film);
    EXPECT_NEAR(film->frames_per_second, 30, 0.1);
    EXPECT_GT(film->frames, 20U);
}

TEST_F(RobotVerb, BadInputLeavesNoFile) {
    const Ran film =
        batch({"robot", kCircle, "--robot", robot(), "--out", file("c.csv"), "--video", file("c.gif")});
    EXPECT_EQ(film.exit_code, 2);
    EXPECT_NE(film.err.find(".mp4, .mkv or .avi"), std::string::npos) << film.err;
    const Ran limits = batch({"robot", kCircle, "--robot", robot("nan"), "--out", file("c.csv")});
    EXPECT_EQ(limits.exit_code, 3);
    EXPECT_NE(limits.err.find("lower limit of joint \"j0\""), std::string::npos) << limits.err;
    std::ofstream(file("p.json")) << "{}";
    const Ran profile =
        batch({"robot", kCircle, "--robot", robot(), "--profile", file("p.json"), "--out", file("c.csv")});
    EXPECT_EQ(profile.exit_code, 3);
    EXPECT_NE(profile.err.find("is no profile of a robot"), std::string::npos) << profile.err;
    const Ran same = batch({"robot", kCircle, "--robot", robot(), "--out", kCircle, "--overwrite"});
    EXPECT_EQ(same.exit_code, 2);
    const Ran trunk = batch({"robot", kCircle, "--robot", robot(), "--out", file("c.csv"), "--trunk"});
    EXPECT_EQ(trunk.exit_code, 4);
    EXPECT_FALSE(std::filesystem::exists(file("c.csv")));
}

}  // namespace
}  // namespace noctule::test
