// SPDX-License-Identifier: Apache-2.0
// The command line itself: help and mistakes.
#include <array>
#include <cstdlib>
#include <optional>

#include "core/suit/calibration.h"
#include "core/suit/default_suit.h"
#include "tests/support/program_run.h"

namespace noctule::test {
namespace {

const std::vector<std::string> kVerbs = {"simulate", "process", "evaluate", "export",  "inspect",
                                         "attach",   "devices", "record",   "recover", "check"};
const std::vector<std::string> kCalibrations = {"sources", "accelerometers", "gyroscopes", "rest-pose"};

/// The environment without a way to a screen, as on a server; as it was afterwards.
class NoScreen {
public:
    NoScreen() {
        for (size_t i = 0; i < kNames.size(); ++i) {
            if (const char* value = getenv(kNames[i]))
                before_[i] = value;
            unsetenv(kNames[i]);
        }
    }
    ~NoScreen() {
        for (size_t i = 0; i < kNames.size(); ++i)
            if (before_[i])
                setenv(kNames[i], before_[i]->c_str(), 1);
    }

private:
    static constexpr std::array kNames{"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"};
    std::array<std::optional<std::string>, kNames.size()> before_;
};

TEST(Usage, TheStudioSaysWhenThereIsNoScreen) {
    const NoScreen server;
    for (const auto& arguments : {std::vector<std::string>{}, {"take.noctule"}}) {
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.exit_code, 2);
        EXPECT_NE(ran.err.find("display"), std::string::npos) << ran.err;
        EXPECT_NE(ran.err.find("--batch"), std::string::npos) << ran.err;
    }
}

TEST(Usage, TheStudioSaysWhenItsScreenCannotBeReached) {
    const NoScreen server;
    setenv("DISPLAY", ":987", 1);
    const Ran ran = run({});
    unsetenv("DISPLAY");
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_NE(ran.err.find("--batch"), std::string::npos) << ran.err;
}

TEST(Usage, VersionAndHelpEndWell) {
    EXPECT_EQ(run({"--version"}).out.substr(0, 8), "noctule ");
    EXPECT_EQ(batch({"--version"}).out, run({"--version"}).out);
    for (const auto& arguments :
         {std::vector<std::string>{"--help"}, {"--batch", "--help"}, {"--batch", "help"}}) {
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.exit_code, 0);
        for (const std::string& verb : kVerbs)
            EXPECT_NE(ran.out.find("\n  " + verb + " "), std::string::npos) << verb;
        for (const std::string& kind : kCalibrations)
            EXPECT_NE(ran.out.find("\n  calibrate " + kind), std::string::npos) << kind;
    }
}

TEST(Usage, EveryVerbExplainsItselfWithOneExample) {
    for (const std::string& verb : kVerbs) {
        const Ran ran = batch({verb, "--help"});
        EXPECT_EQ(ran.exit_code, 0) << verb;
        EXPECT_NE(ran.out.find("example: noctule --batch " + verb + " "), std::string::npos) << ran.out;
        for (const char* common : {"--json", "--quiet", "--seed", "--jobs", "--overwrite", "--help"})
            EXPECT_NE(ran.out.find(common), std::string::npos) << verb << " " << common;
        for (const char* run : {" a run", " the run", "every run", "last run", "new run", "which run"})
            EXPECT_EQ(ran.out.find(run), std::string::npos) << verb << ": it is called a result";
    }
    for (const std::string& kind : kCalibrations) {
        const Ran ran = batch({"calibrate", kind, "--help"});
        EXPECT_EQ(ran.exit_code, 0) << kind;
        EXPECT_NE(ran.out.find("example: noctule --batch calibrate " + kind + " "), std::string::npos);
    }
}

TEST(Usage, AWordBeforeVerbsListsThem) {
    const Ran ran = batch({"calibrate", "--help"});
    EXPECT_EQ(ran.exit_code, 0);
    for (const std::string& kind : kCalibrations)
        EXPECT_NE(ran.out.find("\n  calibrate " + kind), std::string::npos) << kind;
    EXPECT_EQ(ran.out.find("simulate"), std::string::npos);
}

TEST(Usage, UnknownWordsNameTheNearestKnownOne) {
    expectRefusal({}, 2, {"no verb", "simulate"});
    expectRefusal({"evalute"}, 2, {"evalute", "evaluate"});
    expectRefusal({"simulate", "--mtion", "x"}, 2, {"--mtion", "--motion"});
    expectRefusal({"evaluate", "-x", "t"}, 2, {"-x"});
    expectRefusal({"calibrate"}, 2,
                  {"sources, accelerometers, gyroscopes, magnetometers, inertial, "
                   "rest-pose, motion or room"});
    expectRefusal({"calibrate", "sorces", "t"}, 2, {"rest-pose"});
    expectRefusal({"calibrate", "sources", "t"}, 2, {"--out"});
    expectRefusal({"calibrate", "sources", "t", "--out", "c.json"}, 2,
                  {"--digitizer", "--distances", "--photos"});
}

TEST(Usage, ValuesAreChecked) {
    const std::string m = kMotion;
    expectRefusal({"simulate", "--motion", m}, 2, {"--out"});
    expectRefusal({"simulate", "--motion", m, "--out"}, 2, {"--out has no value"});
    expectRefusal({"simulate", "--motion", "--out", "x"}, 2, {"--motion has no value"});
    expectRefusal({"simulate", "--out", "x"}, 2, {"--motion", "--rig"});
    expectRefusal({"simulate", "--motion", m, "--rig", "rest", "--out", "x"}, 2, {"--motion", "--rig"});
    expectRefusal({"simulate", "--motion", m, "--out", "x", "--scenario", "good"}, 2,
                  {"--scenario", "good", "nominal"});
    for (const char* bad : {"-4", "nan", "inf", "1e999", "3s", ""})
        expectRefusal({"simulate", "--motion", m, "--out", "x", "--duration", bad}, 2, {"--duration", bad});
    expectRefusal({"simulate", "--motion", m, "--out", "x", "--seed", "1.5"}, 2, {"--seed", "whole"});
    expectRefusal({"simulate", "--out=x", "--out", "y"}, 2, {"--out", "twice"});
    expectRefusal({"process", "t", "--overwrite=yes"}, 2, {"--overwrite", "no value"});
    expectRefusal({"process"}, 2, {"T.noctule"});
    expectRefusal({"evaluate", "a", "b"}, 2, {"'b'"});
    for (const char* bad : {"AX", "AA", "", "A,G"})
        expectRefusal({"process", "t", "--sensors", bad}, 2, {"--sensors"});
    expectRefusal({"process", "t", "--paper-sigma", "3"}, 2, {"--paper-sigma", "--estimator paper"});
    expectRefusal({"process", "t", "./t"}, 2, {"twice"});
    expectRefusal({"export", "t"}, 2, {"--bvh"});
    expectRefusal({"export", "t", "--bvh", "x", "--angles"}, 2, {"--angles"});
    expectRefusal({"export", "t", "--bvh", "x", "--from", "3", "--to", "2"}, 2, {"--from"});
    expectRefusal({"export", "t", "u", "--bvh", "x"}, 2, {"{name}"});
    expectRefusal({"export", "t", "--bvh", "x", "--mesh", "none"}, 2, {"--mesh", "--glb"});
    expectRefusal({"export", "t", "u", "--fbx", "{name}.fbx", "--stacks"}, 2, {"--stacks", "{name}"});
    expectRefusal({"export", "t", "u", "--fbx", "x.fbx", "--bvh", "x", "--stacks"}, 2, {"--stacks"});
    expectRefusal({"export", "t", "u", "--bvh", "x", "--stacks"}, 2, {"--stacks", "--fbx", "--glb"});
    expectRefusal({"export", "t", "--glb", "x", "--bones", "b"}, 2, {"--bones", "--mesh FILE"});
    expectRefusal({"export", "t", "--glb", "x", "--feet", "free"}, 2, {"--feet", "--mesh FILE"});
    expectRefusal({"export", "t", "--png", "x", "--size", "640"}, 2, {"640", "1280x720"});
    expectRefusal({"export", "t", "--video", "x.gif"}, 2, {"x.gif", ".mp4"});
    expectRefusal({"export", "t", "--png", "x.jpg"}, 2, {"x.jpg", ".png"});
    expectRefusal({"export", "t", "--fbx", "x.GLB"}, 2, {"x.GLB", ".fbx"});
    expectRefusal({"export", "t", "--glb", "x", "--mesh", "nowhere.glb"}, 3, {"nowhere.glb"});
    const std::vector<std::string> record = {"record", "--device", "replay:" + kTinyTake, "--out-dir", "d"};
    const auto recordWith = [&](std::vector<std::string> words) {
        words.insert(words.begin(), record.begin(), record.end());
        return words;
    };
    expectRefusal(recordWith({"--pre-roll", "1"}), 2, {"--pre-roll", "--trigger"});
    expectRefusal(recordWith({"--trigger", "40111", "--trigger-from", "next door"}), 2,
                  {"next door", "10.0.0.5"});
}

TEST(Usage, ThePapersEstimatorHasNoSmoother) {
    expectRefusal({"process", "t", "--estimator", "paper", "--smooth", "full"}, 2,
                  {"--smooth full", "paper"});
}

TEST(Usage, ErrorsAreJsonTooWhenAskedFor) {
    const Ran ran = batch({"inspect", "nowhere.noctule", "--json"});
    EXPECT_EQ(ran.exit_code, 3);
    EXPECT_EQ(ran.json()["error"]["exit_code"], 3);
    EXPECT_NE(ran.err.find("nowhere.noctule"), std::string::npos);
}

TEST(Usage, FarWordsAreNotProposed) {
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"simulate", "--frobnicate", "x"}, {"frobnicate"}}) {
        const Ran ran = batch(words);
        EXPECT_EQ(ran.exit_code, 2);
        EXPECT_EQ(ran.err.find("Did you mean"), std::string::npos) << ran.err;
    }
}

/// A name is no file that is read.
TEST(Usage, ANameMayBeThatOfTheOutput) {
    const Folder folder;
    const std::string out = folder.file("x.csv");
    const Ran ran = batch({"orient", kTinyTake, "--run-name", out, "--csv", out});
    EXPECT_EQ(ran.err.find("is read and would be written"), std::string::npos) << ran.err;
    writeBytes(out, toJson(nominalCalibration(defaultSuit())).dump());
    expectRefusal({"orient", kTinyTake, "--calibration", out, "--csv", out}, 2, {out, "is read"});
}

TEST(Usage, AReaderThatHasEnoughIsNoError) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    close(ends[0]);
    const std::string command = std::string("'") + NOCTULE_PROGRAM + "' --batch inspect '" + kTinyTake +
                                "' 2>&1 >&" + std::to_string(ends[1]) + " | grep -q . && exit 99; '" +
                                NOCTULE_PROGRAM + "' --batch inspect '" + kTinyTake + "' >&" +
                                std::to_string(ends[1]);
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 0) << "99: something was said";
    close(ends[1]);
}

TEST(Usage, AFullStandardOutputIsADiskError) {
    if (!std::filesystem::exists("/dev/full"))
        GTEST_SKIP() << "no /dev/full";
    const std::string command = std::string("'") + NOCTULE_PROGRAM + "' --batch inspect '" + kTinyTake +
                                "' --json >/dev/full 2>/dev/null";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 6);
}

}  // namespace
}  // namespace noctule::test
