// SPDX-License-Identifier: Apache-2.0
// The verb `drive` against noctule-virtual-robot, both as any user starts them: a take leads an arm in real
// time.
#include <algorithm>
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

/// A program beside noctule, that says on its first lines where it answers.
class Beside {
public:
    Beside(const std::string& program, std::vector<std::string> words, const std::string& before_address) {
        int ends[2];
        EXPECT_EQ(pipe(ends), 0);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
        posix_spawn_file_actions_addclose(&actions, ends[0]);
        const std::string path = (std::filesystem::path(NOCTULE_PROGRAM).parent_path() / program).string();
        words.insert(words.begin(), path);
        std::vector<char*> argv;
        for (std::string& word : words)
            argv.push_back(word.data());
        argv.push_back(nullptr);
        EXPECT_EQ(posix_spawn(&pid_, path.c_str(), &actions, nullptr, argv.data(), environ), 0);
        posix_spawn_file_actions_destroy(&actions);
        close(ends[1]);
        std::string said;
        for (char c = 0; read(ends[0], &c, 1) == 1;) {
            said += c;
            if (const size_t at = said.find(before_address);
                at != std::string::npos && isspace(c) && at + before_address.size() + 1 < said.size()) {
                address = said.substr(at + (before_address == "tcp://" ? 0 : before_address.size()));
                address.erase(address.find_last_not_of(" \n") + 1);
                break;
            }
        }
        output_ = ends[0];  // open as long as the program may write
        EXPECT_FALSE(address.empty()) << said;
    }
    ~Beside() { end(SIGTERM); }
    void end(int signal) {
        if (pid_ < 0)
            return;
        kill(pid_, signal);
        int status = 0;
        waitpid(pid_, &status, 0);
        close(output_);
        pid_ = -1;
    }
    /// It still runs and answers nothing.
    void stall() { kill(pid_, SIGSTOP); }
    Beside(const Beside&) = delete;
    Beside& operator=(const Beside&) = delete;
    std::string address;

private:
    pid_t pid_ = -1;
    int output_ = -1;
};

/// Waits until it says so, half a minute at most.
bool says(const Started& program, const char* words) {
    for (int i = 0; i < 600 && program.error().find(words) == std::string::npos; ++i)
        usleep(50'000);
    return program.error().find(words) != std::string::npos;
}

/// On a free port, 60 ms late.
Beside virtualRobot(const std::string& urdf, const std::string& profile, const std::string& interface) {
    return {"noctule-virtual-robot",
            {"--robot", urdf, "--profile", profile, interface, "127.0.0.1:0", "--latency-ms", "60"},
            "robot: "};
}

/// A suit of an arm alone: a busy machine keeps up with five boards.
std::string armSuit() {
    auto suit = nlohmann::json::parse(readBytes(NOCTULE_SOURCE_DIR "/resources/suits/default.json"));
    const std::vector<std::string> kept{"Hips", "Chest", "RightArm", "RightForeArm", "RightHand"};
    nlohmann::json boards = nlohmann::json::array(), sources = nlohmann::json::array();
    for (const auto& board : suit["boards"])
        if (std::ranges::count(kept, board["segment"].get<std::string>()) > 0)
            boards.push_back(board);
    sources.push_back(suit["sources"][0]);
    sources.push_back(suit["sources"][1]);
    suit["boards"] = boards;
    suit["sources"] = sources;
    return suit.dump();
}

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

    /// Read from the table alone: from one command to the next at most the joints' speed, and none that moves
    /// later than 100 ms after the data of its pose.
    static void expectNoJump(const std::string& table) {
        std::ifstream file(table);
        std::string line, cell;
        std::getline(file, line);
        std::vector<double> before, now;
        while (std::getline(file, line)) {
            std::stringstream cells(line);
            std::vector<std::string> row;
            while (std::getline(cells, cell, ','))
                row.push_back(cell);
            ASSERT_GE(row.size(), 15U);
            now.clear();
            for (size_t joint = 8; joint < 15; ++joint)
                now.push_back(std::stod(row[joint]));
            bool moves = false;
            for (size_t joint = 0; joint < 7 && !before.empty(); ++joint) {
                EXPECT_LE(std::abs(now[joint] - before[joint]), kPlainArmSpeed / 140 + 2e-6) << line;
                moves |= now[joint] != before[joint];
            }
            // Commands that go back to where the robot is follow nobody.
            const bool goes_back = row[5] == "joint-off" || row[5] == "robot-refuses";
            if (moves && !goes_back && !row[1].empty()) {
                EXPECT_LE(std::stod(row[0]) - std::stod(row[1]), 0.1 + 1.0 / 140 + 2e-6) << line;
            }
            before = now;
        }
    }

    Folder folder_;
    std::string take_;
};

TEST_P(DriveVerb, ATakeDrivesTheRobot) {
    const Beside robot = virtualRobot(file("arm.urdf"), file("arm.json"), GetParam());
    std::string address = robot.address;
    if (address.starts_with("ws:"))
        address.replace(0, 2, "rosbridge");  // either scheme
    std::vector<std::string> all = words(address);
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

class DriveVerbOnce : public DriveVerb {};
INSTANTIATE_TEST_SUITE_P(Over, DriveVerbOnce, ::testing::Values("--udp"),
                         [](const auto&) { return std::string("udp"); });

TEST_P(DriveVerbOnce, ADriveIsRecordedReadBackAndWritten) {
    const Beside robot = virtualRobot(file("arm.urdf"), file("arm.json"), GetParam());
    std::vector<std::string> all = words(robot.address);
    all.insert(all.end(), {"--hold", "--record", "--json"});
    const Ran ran = batch(all);
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const auto driven = ran.json();
    EXPECT_EQ(driven["recorded"]["take"], take_);
    EXPECT_EQ(driven["recorded"]["rows_lost"], 0);
    const Ran inspected = batch({"inspect", take_, "--json"});
    ASSERT_EQ(inspected.exit_code, 0) << inspected.err;
    const auto drives = inspected.json()["takes"][0]["drives"];
    ASSERT_EQ(drives.size(), 1U);
    EXPECT_EQ(drives[0]["commands"], driven["commands"]);
    EXPECT_EQ(drives[0]["commands_following"], driven["commands_following"]);
    EXPECT_EQ(drives[0]["commands_missing"], 0);
    EXPECT_EQ(drives[0]["leader"], "take");
    EXPECT_GT(drives[0]["states"].get<int>(), 20);
    EXPECT_GT(drives[0]["hands"][0]["tracking"]["delay_ms"].get<double>(), 60);
    EXPECT_NE(batch({"inspect", take_}).out.find("robot 1"), std::string::npos);
    const Ran written = batch({"export", take_, "--robot-csv", file("d.csv"), "--robot-trajectory",
                               file("d.json"), "--robot-report", file("d.html")});
    ASSERT_EQ(written.exit_code, 0) << written.err;
    const std::string csv = readBytes(file("d.csv"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), driven["commands"].get<int>() + 1);
    const auto trajectory = nlohmann::json::parse(readBytes(file("d.json")));
    EXPECT_EQ(trajectory["points"].size(), driven["commands"].get<size_t>());
    EXPECT_NE(readBytes(file("d.html")).find("<polyline class='reached'"), std::string::npos);
    EXPECT_EQ(batch({"export", take_, "--robot-csv", file("e.csv"), "--drive", "2"}).exit_code, 4);
    EXPECT_FALSE(std::filesystem::exists(file("e.csv")));
    EXPECT_EQ(batch({"export", take_, "--drive", "1"}).exit_code, 2);
}

TEST_P(DriveVerbOnce, ARobotThatFellSilentIsAFailure) {
    Beside robot = virtualRobot(file("arm.urdf"), file("arm.json"), GetParam());
    std::vector<std::string> all{"--batch"};
    std::ranges::copy(words(robot.address), std::back_inserter(all));
    all.insert(all.end(), {"--hold", "--repeat", "--seconds", "60", "--json"});
    Started drive(all);
    ASSERT_TRUE(says(drive, "Now ")) << drive.error();
    robot.stall();
    ASSERT_TRUE(says(drive, "The robot")) << drive.error();
    usleep(1'500'000);
    drive.send(SIGINT);
    const Ran ran = drive.wait();
    robot.end(SIGKILL);
    EXPECT_NE(ran.exit_code, 0);
    EXPECT_NE(ran.err.find("fell silent"), std::string::npos) << ran.err;
    EXPECT_GT(ran.json()["silent_at_end_s"].get<double>(), 1);
}

/// A worn suit, live over TCP, leads the arm. Then its box is gone from one moment to the next.
TEST_P(DriveVerb, ALiveSuitLeadsAndTheRobotHoldsWhenItIsLost) {
    if (!std::filesystem::exists(kMotion))
        GTEST_SKIP() << kMotion << " comes with assimp-testmodels";
    std::ofstream(file("suit.json")) << armSuit();
    const Ran simulated = batch({"simulate", "--motion", kMotion, "--suit", file("suit.json"), "--out",
                                 file("s.noctule"), "--duration", "5", "--calibration-out", file("s.json")});
    ASSERT_EQ(simulated.exit_code, 0) << simulated.err;
    const Beside robot = virtualRobot(file("arm.urdf"), file("arm.json"), GetParam());
    Beside suit("noctule-virtual-suit", {"--take", file("s.noctule"), "--tcp", "127.0.0.1:0", "--loop"},
                "tcp://");
    Started drive({"--batch",       "drive",
                   "--device",      suit.address,
                   "--calibration", file("s.json"),
                   "--robot",       file("arm.urdf"),
                   "--profile",     file("arm.json"),
                   "--arms",        "right",
                   "--to",          robot.address,
                   "--hold",        "--accept-within",
                   "180",           "--record",
                   "--out-dir",     file("takes"),
                   "--name",        "live",
                   "--out",         file("d.csv"),
                   "--seconds",     "60",
                   "--json"});
    const bool followed = says(drive, "Now following");
    usleep(500'000);
    suit.end(SIGKILL);
    ASSERT_TRUE(says(drive, "No fresh pose")) << drive.error();
    usleep(200'000);
    drive.send(SIGINT);
    const auto driven = drive.wait().json();
    EXPECT_GT(driven["latency"]["count"].get<int>(), 0);
    EXPECT_GT(driven["latency"]["median_ms"].get<double>(), 0);
    EXPECT_LE(driven["largest_speed_use"].get<double>(), 1 + 1e-9) << "no command jumps";
    EXPECT_LE(driven["longest_hold_ms"].get<double>(), 100 + 1000.0 / 140);
    const Ran inspected = batch({"inspect", file("takes/live_001.noctule"), "--json"});
    ASSERT_EQ(inspected.exit_code, 0) << inspected.err;
    const auto take = inspected.json()["takes"][0];
    EXPECT_EQ(take["state"], "complete");
    ASSERT_EQ(take["drives"].size(), 1U);
    EXPECT_EQ(take["drives"][0]["leader"], "suit");
    EXPECT_EQ(take["drives"][0]["commands"], driven["commands"]);
    // The box began the take, so its time 0 is some seconds before the first command.
    EXPECT_GE(take["drives"][0]["take_time_s"].get<double>(), -0.5);
    expectNoJump(file("d.csv"));
    if (!followed)
        GTEST_SKIP() << "the machine is too busy to make live poses in time: the robot held, as it should";
    EXPECT_GT(driven["commands_following"].get<int>(), 0);
}

INSTANTIATE_TEST_SUITE_P(Interfaces, DriveVerb, ::testing::Values("--udp", "--rosbridge"),
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
    const Ran unknown = batch(words("udp://no-such-robot.invalid:41950"));
    EXPECT_EQ(unknown.exit_code, 5);
    EXPECT_NE(unknown.err.find("knows no computer of this name"), std::string::npos) << unknown.err;
    std::vector<std::string> nowhere = words("udp://127.0.0.1:9");
    nowhere.insert(nowhere.end(), {"--record", "--out-dir", file("takes")});
    EXPECT_EQ(batch(nowhere).exit_code, 2) << "--out-dir belongs to --device";
    const Ran address = batch(words("smoke://signal"));
    EXPECT_EQ(address.exit_code, 2);
    const Ran both = batch({"drive", take_, "--device", "tcp://127.0.0.1:9", "--robot", file("arm.urdf"),
                            "--to", "udp://127.0.0.1:9"});
    EXPECT_EQ(both.exit_code, 2);
    EXPECT_NE(both.err.find("one source of poses"), std::string::npos) << both.err;
}

}  // namespace
}  // namespace noctule::test
