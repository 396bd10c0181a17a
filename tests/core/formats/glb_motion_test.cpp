// SPDX-License-Identifier: Apache-2.0
// Figures in motion as GLB: read back through assimp, and judged by Khronos' validator where that can be had.
#include <sys/wait.h>

#include <cstdio>
#include <cstring>
#include <filesystem>

#include "core/formats/glb_writer.h"
#include "core/formats/scene_check.h"
#include "core/job/atomic_file.h"
#include "core/math/rotation.h"
#include "tests/core/formats/sample_figure.h"
#include "tests/support/files.h"
#include "tests/support/painted_surface.h"

namespace noctule {
namespace {

class GlbMotion : public testing::Test {
protected:
    std::string path() const { return folder_.file("walk.glb"); }
    Result<SceneDifference> differenceTo(const Figure& figure) const {
        return compareScene(path(), "walk.glb", SceneFormat::kGlb, figure);
    }
    /// What the validator prints; nothing where it cannot be had.
    std::optional<std::string> verdict(int& exit_code) const {
        const std::string command = std::string("node '") + NOCTULE_SOURCE_DIR +
                                    "/tests/support/validate_gltf.js' '" NOCTULE_GLTF_VALIDATOR "' '" +
                                    path() + "' 2>&1";
        FILE* pipe = popen(command.c_str(), "r");
        std::string said;
        for (int c = 0; pipe && (c = fgetc(pipe)) != EOF;)
            said += static_cast<char>(c);
        exit_code = pipe ? WEXITSTATUS(pclose(pipe)) : 127;
        return exit_code == 77 || exit_code == 127 ? std::nullopt : std::optional(said);
    }

    test::Folder folder_;
};

TEST_F(GlbMotion, HoldsMotionAndSkin) {
    const Figure figure = test::sampleFigure(true);
    const Status written = writeGlb(path(), figure, false);
    ASSERT_TRUE(written) << written.error().text();
    const auto difference = differenceTo(figure);
    ASSERT_TRUE(difference) << difference.error().text();
    EXPECT_EQ(difference->frames, 120U);
    EXPECT_NEAR(difference->frames_per_second, 60.0 / 7, 1e-4);
    EXPECT_LT(difference->joint_m, 5e-6);
    EXPECT_LT(difference->vertex_m, 5e-6);
}

TEST_F(GlbMotion, DifferencesAreSeen) {
    const Figure figure = test::sampleFigure(true);
    ASSERT_TRUE(writeGlb(path(), figure, false));
    Figure turned = figure, dented = figure, shorter = figure;
    Quaterniond& thigh =
        turned.clip.frames[60].q_parent_joint[static_cast<size_t>(turned.clip.skeleton.find("LeftUpLeg"))];
    thigh = thigh * axisAngle(Vector3d::UnitX(), 0.01);
    EXPECT_GT(differenceTo(turned)->joint_m, 0.004) << "a leg of 0.86 m";
    dented.body->vertices[100].p_m.x() += 0.001F;
    EXPECT_NEAR(differenceTo(dented)->vertex_m, 0.001, 5e-5);
    shorter.clip.frames.pop_back();
    EXPECT_FALSE(differenceTo(shorter));
}

TEST_F(GlbMotion, HoldsASkeletonAlone) {
    const Figure figure = test::sampleFigure(false, JointNames::kHumanIk);
    const Status written = writeGlb(path(), figure, false);
    ASSERT_TRUE(written) << written.error().text();
    EXPECT_LT(differenceTo(figure)->joint_m, 5e-6);
}

TEST_F(GlbMotion, HoldsPaintedCharactersAndSeveralMotionsAndKhronosAgrees) {
    Figure painted = test::sampleFigure(true);
    test::paint(*painted.body);
    const std::vector<Figure> pair{asCharacter(painted, "Ada"), asCharacter(painted, "Bea")};
    Figure again = test::sampleFigure(false);
    again.clip.name = "again";
    const std::vector<Figure> motions{painted, again};
    for (const std::vector<Figure>& figures : {pair, motions}) {
        const Status written = writeGlb(path(), sourceOf(figures), true);
        ASSERT_TRUE(written) << written.error().text();
        for (const Figure& figure : figures)
            EXPECT_LT(differenceTo(figure)->joint_m, 5e-6) << "colours and textures are compared too";
        int exit_code = 0;
        if (const auto said = verdict(exit_code)) {
            EXPECT_NE(said->find("walk.glb: 0 errors, 0 warnings"), std::string::npos) << *said;
        }
    }
}

TEST_F(GlbMotion, OfTwoThatCannotShareAFileNothingIsWritten) {
    const Figure figure = test::sampleFigure(false);
    Figure slower = figure;
    slower.clip.name = "slower";
    slower.clip.frame_time_s *= 2;
    for (const auto& figures : {std::vector{figure, figure},
                                {figure, slower},
                                {asCharacter(figure, "Ada"), asCharacter(figure, "Ada")}}) {
        const Status written = writeGlb(path(), sourceOf(figures), false);
        ASSERT_FALSE(written);
        EXPECT_EQ(written.error().kind, ErrorKind::kUnusable);
        EXPECT_FALSE(std::filesystem::exists(path()));
    }
}

TEST_F(GlbMotion, KhronosFindsNoErrors) {
    std::vector<Figure> figures = {test::sampleFigure(true), test::sampleFigure(true),
                                   test::sampleFigure(false)};
    test::paint(*figures[0].body);
    for (const Figure& figure : figures) {
        ASSERT_TRUE(writeGlb(path(), figure, true));
        int exit_code = 0;
        const auto said = verdict(exit_code);
        if (!said)
            GTEST_SKIP() << "Khronos' glTF validator cannot be had: node, npm or the network is not there";
        EXPECT_EQ(exit_code, 0) << *said;
        EXPECT_NE(said->find("walk.glb: 0 errors, 0 warnings"), std::string::npos) << *said;
    }
    std::string bytes = *readWholeFile(path());
    const size_t at = bytes.find("\"VEC4\"");
    ASSERT_NE(at, std::string::npos);
    bytes.replace(at, 6, "\"VEC3\"");
    ASSERT_TRUE(writeFileAtomically(path(), bytes, true));
    int exit_code = 0;
    const auto said = verdict(exit_code);
    EXPECT_EQ(exit_code, 1) << "a broken one is seen: " << said.value_or("");
}

}  // namespace
}  // namespace noctule
