// SPDX-License-Identifier: Apache-2.0
// The verb `drive` against noctule-virtual-robot, both as any user starts them: a take leads an arm in real
// time.
#include <fstream>

#include "core/math/rotation.h"
#include "core/recording/take_edit.h"
#include "tests/support/plain_arm.h"
#include "tests/support/program_run.h"

namespace noctule::test {
namespace {

constexpr double kPosesPerSecond = 100;
constexpr int kFramesOfTake = 300;

/// Upper arms hang, forearms point ahead, as the robot's does at first; the right one swings.
Pose swingingPose(const Skeleton& skeleton, int frame) {
    Pose pose = skeleton.zeroPose();
    const auto q = [&](const char* name) -> Quaterniond& {
        return pose.q_parent_joint[static_cast<size_t>(skeleton.find(name))];
    };
    q("RightArm") = axisAngle(Vector3d::UnitZ(), radians(90));
    q("RightForeArm") =
        axisAngle(Vector3d::UnitY(), radians(90) + 0.3 * (1 - std::cos(4 * frame / kPosesPerSecond)));
    q("LeftArm") = axisAngle(Vector3d::UnitZ(), radians(-90));
    return pose;
}

/// The virtual robot as a process of its own, on a free port.
class VirtualRobot {
public:
    VirtualRobot(const std::string& urdf, const std::string& profile, const std::string& interface) {
        int ends[2];
        EXPECT_EQ(pipe(ends), 0);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
        posix_spawn_file_actions_addclose(&actions, ends[0]);
        const std::string program =
            (std::filesystem::path(NOCTULE_PROGRAM).parent_path() / "noctule-virtual-robot").string();
        std::vector<std::string> words{program,   "--robot",     urdf,        "--profile", profile,
                                       interface, "127.0.0.1:0", "--latency", "60"};
        std::vector<char*> argv;
        for (std::string& word : words)
            argv.push_back(word.data());
        argv.push_back(nullptr);
        EXPECT_EQ(posix_spawn(&pid_, program.c_str(), &actions, nullptr, argv.data(), environ), 0);
        posix_spawn_file_actions_destroy(&actions);
        close(ends[1]);
        std::string line;
        for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';)
            line += c;
        close(ends[0]);
        EXPECT_EQ(line.rfind("robot: ", 0), 0U) << line;
        address = line.substr(std::min<size_t>(7, line.size()));
    }
    ~VirtualRobot() {
        kill(pid_, SIGTERM);
        int status = 0;
        waitpid(pid_, &status, 0);
    }
    std::string address;

private:
    pid_t pid_ = -1;
};

class DriveVerb : public ::testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        std::ofstream(file("arm.urdf")) << plainArmUrdf();
        std::ofstream(file("arm.json")) << robot::toJson(plainArmProfile()).dump();
        makeTake();
    }
    void makeTake() {
        take_ = tinyTake(folder_);
        Take take = Take::open(take_, Access::kReadWrite).value();
        auto edit = TakeEdit::begin(take).value();
        const Skeleton skeleton = defaultActor().skeleton;
        ASSERT_TRUE(edit.addActor(defaultActor(), "2026-01-01T00:00:00Z"));
        const auto run = edit.beginRun({0, "pose", "swing", "", "test", "{}", {}, {}});
        ASSERT_TRUE(run);
        for (int i = 0; i < kFramesOfTake; ++i)
            ASSERT_TRUE(
                edit.addPose(*run, {std::llround(i * 1e9 / kPosesPerSecond), swingingPose(skeleton, i), {}}));
        ASSERT_TRUE(edit.commit());
    }
    std::string file(const std::string& name) const { return folder_.file(name); }
    std::vector<std::string> words(const std::string& address) const {
        return {"drive",          take_,  "--run", "swing",  "--robot", file("arm.urdf"), "--profile",
                file("arm.json"), "--to", address, "--arms", "right"};
    }

    Folder folder_;
    std::string take_;
};

TEST_P(DriveVerb, ATakeDrivesTheRobot) {
    const VirtualRobot robot(file("arm.urdf"), file("arm.json"), GetParam());
    std::vector<std::string> all = words(robot.address);
    all.insert(all.end(), {"--hold", "--out", file("d.csv"), "--report", file("d.html"), "--json"});
    const Ran ran = batch(all);
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const auto json = ran.json();
    EXPECT_GT(json["commands_following"].get<int>(), 20);
    EXPECT_LE(json["largest_speed_use"].get<double>(), 1 + 1e-9);
    EXPECT_EQ(json["joints"].size(), 7U);
    std::ifstream table(file("d.csv"));
    std::string line;
    std::getline(table, line);
    EXPECT_EQ(line.rfind("time_s,pose_arrived_s,pose_time_s,sequence,state,", 0), 0U);
    int rows = 0, following = 0;
    while (std::getline(table, line)) {
        ++rows;
        following += line.find(",following,") != std::string::npos;
    }
    EXPECT_EQ(rows, json["commands"].get<int>());
    EXPECT_EQ(following, json["commands_following"].get<int>());
    const auto tracking = json["hands"][0]["tracking"];
    ASSERT_FALSE(tracking.is_null()) << json.dump();
    EXPECT_GT(tracking["delay_ms"].get<double>(), 60) << "60 ms until a command is heard, and 20 ms of lag";
    EXPECT_LT(tracking["rest_rms_mm"].get<double>(), tracking["apart_rms_mm"].get<double>());
    const std::string report = readBytes(file("d.html"));
    EXPECT_NE(report.find("<polyline class='reached'"), std::string::npos);
    EXPECT_NE(report.find("Rest after the delay, rms"), std::string::npos) << "the hand moved, so it has one";
}

INSTANTIATE_TEST_SUITE_P(Interfaces, DriveVerb, ::testing::Values("--udp", "--ws"),
                         [](const auto& one) { return std::string(one.param).substr(2); });

class DriveVerbAlone : public DriveVerb {};
INSTANTIATE_TEST_SUITE_P(Nobody, DriveVerbAlone, ::testing::Values("--udp"),
                         [](const auto&) { return std::string("answers"); });

TEST_P(DriveVerbAlone, BadInputSaysWhatIsWrongAndLeavesNoFile) {
    std::vector<std::string> silent = words("udp://127.0.0.1:9");
    silent.insert(silent.end(), {"--out", file("d.csv")});
    const Ran nobody = batch(silent);
    EXPECT_NE(nobody.exit_code, 0);
    EXPECT_NE(nobody.err.find("127.0.0.1:9"), std::string::npos) << nobody.err;
    EXPECT_FALSE(std::filesystem::exists(file("d.csv")));
    const Ran address = batch(words("smoke://signal"));
    EXPECT_EQ(address.exit_code, 2);
    const Ran both = batch({"drive", take_, "--device", "tcp://127.0.0.1:9", "--robot", file("arm.urdf"),
                            "--to", "udp://127.0.0.1:9"});
    EXPECT_EQ(both.exit_code, 2);
    EXPECT_NE(both.err.find("one source of poses"), std::string::npos) << both.err;
}

}  // namespace
}  // namespace noctule::test
