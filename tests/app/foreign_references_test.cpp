// SPDX-License-Identifier: Apache-2.0
// References as other programs write them, attached to and compared with the take of the same performance.
// Needs the inputs beside the repository (../shared/data); skips without them.
#include <sys/stat.h>

#include <chrono>
#include <thread>

#include "tests/support/program_run.h"

namespace noctule::test {
namespace {

const std::string kFieldInputs = NOCTULE_SOURCE_DIR "/../shared/data/field/";

class ForeignReferences : public testing::Test {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(kFieldInputs + "base.bvh"))
            GTEST_SKIP() << "needs ../shared/data/field";
    }
    std::string processed(const std::string& motion) {
        const std::string take = folder_.file(std::filesystem::path(motion).stem().string() + ".noctule");
        const Ran simulated = batch(
            {"simulate", "--motion", motion, "--level", "readings", "--scenario", "ideal", "--out", take});
        EXPECT_EQ(simulated.exit_code, 0) << simulated.err;
        const Ran ran = batch({"process", take});
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return take;
    }
    Folder folder_;
};

TEST_F(ForeignReferences, DialectsOfOneWalkAreBelowThreeDegrees) {
    const std::string take = processed(kFieldInputs + "base.bvh");
    for (const char* dialect :
         {"base", "z_up_blender", "bones_along_x", "names_japanese", "reference_12_m_away", "child_85_cm",
          "dropouts_zero_rows", "zero_pose_a", "zero_pose_sitting", "zero_pose_toes_down", "names_biped",
          "names_lower_case", "names_asf", "names_rigify_def", "names_robot_prefix", "names_smpl"}) {
        const std::string reference = kFieldInputs + dialect + ".bvh";
        const Ran attached =
            batch({"attach", take, "--reference", reference, "--align", "3000", "--overwrite", "--json"});
        ASSERT_EQ(attached.exit_code, 0) << dialect << attached.err;
        EXPECT_GE(attached.json()["matched"].size(), 15u) << dialect;
        const Ran ran = batch({"evaluate", take, "--json"});
        ASSERT_EQ(ran.exit_code, 0) << dialect << ran.err;
        EXPECT_LT(ran.json()["mean_deg"].get<double>(), 3) << dialect;
        EXPECT_GE(ran.json()["joints_matched"].size(), 15u) << dialect;
    }
}

TEST_F(ForeignReferences, AFileIsUnderstoodByEvaluateToo) {
    const std::string take = processed(kFieldInputs + "base.bvh");
    const Ran plain = batch({"evaluate", take, "--reference", kFieldInputs + "base.bvh", "--json"});
    ASSERT_EQ(plain.exit_code, 0) << plain.err;
    EXPECT_TRUE(plain.json()["motion"]["warnings"].empty());
    const Ran along_x =
        batch({"evaluate", take, "--reference", kFieldInputs + "bones_along_x.bvh", "--up", "y", "--json"});
    ASSERT_EQ(along_x.exit_code, 0) << along_x.err;
    EXPECT_NE(along_x.err.find("joints"), std::string::npos) << "says what was understood";
    EXPECT_NEAR(along_x.json()["mean_deg"].get<double>(), plain.json()["mean_deg"].get<double>(), 0.5);
    expectRefusal({"evaluate", take, "--height", "1.8"}, 2, {"--height", "--reference"});
}

TEST_F(ForeignReferences, AShortMotionOfAnotherAxisIsComparedWithItself) {
    const std::string motion = NOCTULE_SOURCE_DIR "/../shared/data/bvh/peers/makehuman/zombieWalk1.bvh";
    if (!std::filesystem::exists(motion))
        GTEST_SKIP() << "needs ../shared/data/bvh";
    const std::string take = processed(motion);
    expectRefusal({"attach", take, "--reference", motion, "--overwrite"}, 4, {"two seconds", "--align"});
    const Ran attached =
        batch({"attach", take, "--reference", motion, "--align", "3000", "--overwrite", "--json"});
    ASSERT_EQ(attached.exit_code, 0) << attached.err;
    const Ran ran = batch({"evaluate", take, "--json"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_LT(ran.json()["mean_deg"].get<double>(), 15) << "37 degrees with axes taken from the run";
    for (const auto& joint : ran.json()["joints_matched"])
        EXPECT_EQ(joint["axes_from"], "same") << joint;
}

TEST(ForeignInputs, JointNamesThatAreNotUtf8AreShownAndKept) {
    Folder folder;
    std::string text = readBytes(NOCTULE_SOURCE_DIR "/resources/motions/sample.bvh");
    const size_t at = text.find("JOINT Neck");
    ASSERT_NE(at, std::string::npos);
    text.replace(at, 10, "JOINT \x8e\xf1");
    writeBytes(folder.file("sjis.bvh"), text);
    const std::string take = folder.file("t.noctule");
    ASSERT_EQ(batch({"simulate", "--motion", folder.file("sjis.bvh"), "--level", "readings", "--duration",
                     "4", "--out", take})
                  .exit_code,
              0);
    const Ran ran = batch(
        {"attach", take, "--reference", folder.file("sjis.bvh"), "--align", "3000", "--overwrite", "--json"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(ran.json()["matched"]["Neck"], "\\x8e\\xf1");
}

TEST_F(ForeignReferences, AWalkThatRepeatsItselfIsNotShiftedByAStep) {
    const std::string take = processed(kFieldInputs + "walk_8_s.bvh");
    const Ran ran =
        batch({"attach", take, "--reference", kFieldInputs + "walk_8_s.bvh", "--overwrite", "--json"});
    if (ran.exit_code == 0)
        EXPECT_NEAR(ran.json()["shift_ms"].get<double>(), 3000, 20);
    else
        EXPECT_NE(ran.err.find("repeats itself"), std::string::npos) << ran.err;
}

TEST_F(ForeignReferences, ARealWalkIsFoundWithItsUncertainty) {
    const std::string motion = NOCTULE_SOURCE_DIR "/../shared/data/bvh/cmu/02_01.bvh";
    if (!std::filesystem::exists(motion))
        GTEST_SKIP() << "needs ../shared/data/bvh";
    const Ran ran = batch({"attach", processed(motion), "--reference", motion, "--overwrite", "--json"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_NEAR(ran.json()["shift_ms"].get<double>(), 3000, 20);
    EXPECT_GT(ran.json()["shift_sigma_ms"].get<double>(), 0);
    EXPECT_LE(ran.json()["shift_sigma_ms"].get<double>(), 20);
}

TEST_F(ForeignReferences, TablesOfTheField) {
    const std::string take = folder_.file("t.noctule");
    ASSERT_EQ(batch({"simulate", "--motion", kFieldInputs + "base.bvh", "--level", "readings", "--out", take})
                  .exit_code,
              0);
    const Ran refused = batch({"attach", take, "--reference", kFieldInputs + "positions_time_in_ms.csv",
                               "--as", "external-root", "--align", "3000", "--overwrite"});
    EXPECT_EQ(refused.exit_code, 4);
    EXPECT_NE(refused.err.find("of 60 rows lie outside the take"), std::string::npos) << refused.err;
    EXPECT_NE(refused.err.find("milliseconds"), std::string::npos) << refused.err;
    const Ran wide = batch({"attach", take, "--reference", kFieldInputs + "positions_utf16.csv", "--as",
                            "external-root", "--align", "3000", "--overwrite", "--json"});
    ASSERT_EQ(wide.exit_code, 0) << wide.err;
    EXPECT_EQ(wide.json()["rows"], 60);
}

TEST(ForeignInputs, NamesThatAreNotUtf8AreRefusedInWords) {
    for (const char* verb : {"simulate", "process", "evaluate", "export", "inspect", "attach", "recover"}) {
        const Ran ran = batch({verb, "walk\xFF.bvh"});
        EXPECT_EQ(ran.exit_code, 2) << verb;
        EXPECT_NE(ran.err.find("'walk\\xff.bvh' is not UTF-8"), std::string::npos) << verb << ran.err;
        EXPECT_EQ(ran.err.find("internal"), std::string::npos);
    }
}

TEST(ForeignInputs, APipeWithoutAWriterCanBeInterrupted) {
    Folder folder;
    const std::string pipe = folder.file("motion.bvh");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    Started started({"--batch", "simulate", "--motion", pipe, "--out", folder.file("t.noctule")});
    for (int i = 0; i < 500 && !started.catches(SIGINT); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    started.send(SIGINT);
    const Ran ran = started.wait();
    EXPECT_EQ(ran.exit_code, 130) << ran.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"motion.bvh"});
}

TEST(ForeignInputs, EndlessInputsEndByAStatedLimit) {
    Folder folder;
    const Ran ran = batch({"simulate", "--motion", "/dev/zero", "--out", folder.file("t.noctule")});
    EXPECT_EQ(ran.exit_code, 3);
    EXPECT_NE(ran.err.find("more than 256 MB"), std::string::npos) << ran.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

}  // namespace
}  // namespace noctule::test
