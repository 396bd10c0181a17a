// SPDX-License-Identifier: Apache-2.0
// FBX files read back through assimp: joints, skin, frame rate, names, units; and files that are not what
// they should be are refused.
#include "core/formats/fbx_writer.h"
#include "core/formats/scene_check.h"
#include "core/job/atomic_file.h"
#include "core/math/rotation.h"
#include "tests/core/formats/sample_figure.h"
#include "tests/support/files.h"

namespace noctule {
namespace {

class Fbx : public testing::Test {
protected:
    std::string path() const { return folder_.file("walk.fbx"); }
    SceneDifference differenceTo(const Figure& figure) const {
        const auto difference = compareScene(path(), "walk.fbx", SceneFormat::kFbx, figure);
        EXPECT_TRUE(difference) << difference.error().text();
        return difference ? *difference : SceneDifference{};
    }
    std::string bytes() const { return *readWholeFile(path()); }

    test::Folder folder_;
};

TEST_F(Fbx, HoldsMotionAndSkin) {
    const Figure figure = test::sampleFigure(true);
    const Status written = writeFbx(path(), figure, {}, false);
    ASSERT_TRUE(written) << written.error().text();
    const SceneDifference difference = differenceTo(figure);
    EXPECT_EQ(difference.frames, 120U);
    EXPECT_NEAR(difference.frames_per_second, 60.0 / 7, 1e-6) << "any rate";
    EXPECT_LT(difference.joint_m, 5e-6);
    EXPECT_LT(difference.vertex_m, 5e-6);
    EXPECT_GT(difference.joint_m, 0) << "float32 in the file";
}

TEST_F(Fbx, HoldsASkeletonAlone) {
    const Figure figure = test::sampleFigure(false);
    ASSERT_TRUE(writeFbx(path(), figure, {0.01, "Armature"}, false));
    EXPECT_LT(differenceTo(figure).joint_m, 5e-6);
    EXPECT_EQ(bytes().find("Deformer"), std::string::npos);
    EXPECT_NE(bytes().find(fbxObjectName("Armature", "Model")), std::string::npos);
}

TEST_F(Fbx, AnyUnitAndTheNamesOfOtherPrograms) {
    const Figure figure = test::sampleFigure(true, JointNames::kHumanIk);
    FbxOptions options;
    options.metres_per_unit = 1;
    ASSERT_TRUE(writeFbx(path(), figure, options, false));
    EXPECT_LT(differenceTo(figure).joint_m, 5e-6);
    EXPECT_NE(bytes().find(fbxObjectName("Spine2", "Model")), std::string::npos);
    EXPECT_EQ(bytes().find(fbxObjectName("Chest", "Model")), std::string::npos);
}

/// The numbers of the file are compared with something: every kind of change is seen.
TEST_F(Fbx, DifferencesAreSeen) {
    const Figure figure = test::sampleFigure(true);
    ASSERT_TRUE(writeFbx(path(), figure, {}, false));
    Figure turned = figure;
    Quaterniond& elbow =
        turned.clip.frames[60].q_parent_joint[static_cast<size_t>(turned.clip.skeleton.find("LeftForeArm"))];
    elbow = elbow * axisAngle(Vector3d::UnitY(), 0.01);
    EXPECT_NEAR(differenceTo(turned).joint_m, 0.0025, 5e-4) << "a forearm of 0.25 m";
    Figure dented = figure;
    dented.body->vertices[100].p_m.x() += 0.001F;
    EXPECT_NEAR(differenceTo(dented).vertex_m, 0.001, 5e-5);
    EXPECT_FALSE(checkScene(path(), "walk.fbx", SceneFormat::kFbx, turned));
    EXPECT_FALSE(checkScene(path(), "walk.fbx", SceneFormat::kFbx, dented));
    EXPECT_TRUE(checkScene(path(), "walk.fbx", SceneFormat::kFbx, figure));
}

/// The file's own word on its unit and its axes counts.
TEST_F(Fbx, AnotherUnitAndAnotherUpAreSeen) {
    const Figure figure = test::sampleFigure(false);
    ASSERT_TRUE(writeFbx(path(), figure, {}, false));
    std::string changed = bytes();
    const auto setNumber = [&](const std::string& name, const auto value) {
        // behind the name stand type, label and flags, each a letter and its length, then the letter of the
        // value
        size_t at =
            changed.find("S" + std::string("\x0f\0\0\0", 4).replace(0, 1, 1, char(name.size())) + name);
        ASSERT_NE(at, std::string::npos) << name;
        at += 5 + name.size();
        for (int text = 0; text < 3; ++text)
            at += 5 + static_cast<unsigned char>(changed[at + 1]);
        std::memcpy(changed.data() + at + 1, &value, sizeof value);
        ASSERT_TRUE(writeFileAtomically(path(), changed, true));
    };
    setNumber("UnitScaleFactor", 2.54);
    EXPECT_GT(differenceTo(figure).joint_m, 1) << "inches";
    setNumber("UnitScaleFactor", 1.0);
    EXPECT_LT(differenceTo(figure).joint_m, 5e-6);
    setNumber("UpAxis", int32_t{2});
    EXPECT_FALSE(compareScene(path(), "walk.fbx", SceneFormat::kFbx, figure));
}

TEST_F(Fbx, AnotherRateAnotherLengthAndAnotherNameAreRefused) {
    const Figure figure = test::sampleFigure(false);
    ASSERT_TRUE(writeFbx(path(), figure, {}, false));
    Figure faster = figure, shorter = figure, other = figure;
    faster.clip.frame_time_s *= 0.99;
    shorter.clip.frames.pop_back();
    other.clip.name = "walk_002";
    for (const Figure& wrong : {faster, shorter, other})
        EXPECT_FALSE(compareScene(path(), "walk.fbx", SceneFormat::kFbx, wrong));
}

TEST_F(Fbx, SeveralMotionsAreStacks) {
    std::vector<Figure> figures(3, test::sampleFigure(true));
    figures[1].clip.name = "walk_002";
    std::reverse(figures[1].clip.frames.begin(), figures[1].clip.frames.end());
    figures[2].clip.name = "walk_003";
    figures[2].clip.frames.resize(17);
    const Status written = writeFbx(path(), sourceOf(figures), {}, false);
    ASSERT_TRUE(written) << written.error().text();
    for (const Figure& figure : figures) {
        EXPECT_EQ(differenceTo(figure).frames, figure.clip.frames.size());
        EXPECT_LT(differenceTo(figure).joint_m, 5e-6);
        EXPECT_LT(differenceTo(figure).vertex_m, 5e-6);
        EXPECT_NE(bytes().find(fbxObjectName(figure.clip.name, "AnimStack")), std::string::npos);
    }
    Figure exchanged = figures[1];
    exchanged.clip.name = "walk_001";
    EXPECT_GT(differenceTo(exchanged).joint_m, 0.1);
    EXPECT_FALSE(checkScene(path(), "walk.fbx", SceneFormat::kFbx, exchanged));
}

TEST_F(Fbx, PerformersAreCharactersOfOneStack) {
    Figure tall = test::sampleFigure(true), other = tall;
    std::reverse(other.clip.frames.begin(), other.clip.frames.end());
    std::vector<Joint> joints = tall.clip.skeleton.joints();
    for (Joint& joint : joints)
        joint.offset_m *= 1.1;
    tall.clip.skeleton = Skeleton::make(joints).value();
    tall.rest = bindPose(tall.clip.skeleton);
    tall.body.reset();  // a skeleton beside a body
    const std::vector<Figure> figures{asCharacter(tall, "A"), asCharacter(other, "B")};
    const Status written = writeFbx(path(), sourceOf(figures), {}, false);
    ASSERT_TRUE(written) << written.error().text();
    for (const Figure& figure : figures) {
        EXPECT_EQ(differenceTo(figure).frames, 120U);
        EXPECT_LT(differenceTo(figure).joint_m, 6e-6);
        EXPECT_LT(differenceTo(figure).vertex_m, 6e-6);
        EXPECT_NE(bytes().find(fbxObjectName(figure.character, "Model")), std::string::npos);
        EXPECT_NE(bytes().find(fbxObjectName(figure.character + ":Hips", "Model")), std::string::npos);
    }
    size_t stacks = 0;
    const std::string stack = fbxObjectName(tall.clip.name, "AnimStack"), all = bytes();
    for (size_t at = all.find(stack); at != std::string::npos; at = all.find(stack, at + 1))
        ++stacks;
    EXPECT_EQ(stacks, 1U);
    Figure exchanged = asCharacter(other, "A");
    exchanged.body.reset();
    EXPECT_GT(differenceTo(exchanged).joint_m, 0.05) << "the others' bones and frames";
    const std::vector<Figure> twice{figures[0], figures[0]};
    const Status refused = writeFbx(folder_.file("twice.fbx"), sourceOf(twice), {}, false);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("A is the name of two performers"), std::string::npos);
}

TEST_F(Fbx, MotionsOfOtherBonesRatesOrTheSameNameGoIntoNoFile) {
    const Figure figure = test::sampleFigure(false);
    Figure same = figure, longer = figure, faster = figure;
    longer.clip.name = faster.clip.name = "walk_002";
    std::vector<Joint> joints = figure.clip.skeleton.joints();
    joints[4].offset_m.y() += 0.01;
    longer.clip.skeleton = Skeleton::make(joints).value();
    faster.clip.frame_time_s *= 0.5;
    for (const Figure& wrong : {same, longer, faster}) {
        const Status refused = writeFbx(path(), sourceOf(std::vector{figure, wrong}), {}, false);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().kind, ErrorKind::kUnusable);
        EXPECT_NE(refused.error().message.find(wrong.clip.name), std::string::npos);
    }
}

TEST_F(Fbx, ADamagedFileIsRefused) {
    const Figure figure = test::sampleFigure(false);
    ASSERT_TRUE(writeFbx(path(), figure, {}, false));
    const std::string whole = bytes();
    for (const double share : {0.0, 0.2, 0.6, 0.95}) {
        const auto length = static_cast<size_t>(share * static_cast<double>(whole.size()));
        ASSERT_TRUE(writeFileAtomically(path(), whole.substr(0, length), true));
        EXPECT_FALSE(compareScene(path(), "walk.fbx", SceneFormat::kFbx, figure)) << share;
    }
}

TEST_F(Fbx, AnExistingFileIsKept) {
    ASSERT_TRUE(writeFileAtomically(path(), "mine", false));
    const Status refused = writeFbx(path(), test::sampleFigure(false), {}, false);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
    EXPECT_EQ(bytes(), "mine");
}

TEST_F(Fbx, WhatIsNoNumberIsRefused) {
    MotionClip clip = test::sampleClip();
    clip.frames[3].p_world_root.x() = NAN;
    const auto figure = makeFigure(clip, std::nullopt, JointNames::kOwn);
    ASSERT_FALSE(figure);
    EXPECT_EQ(figure.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(figure.error().message.find("frame 4"), std::string::npos) << figure.error().message;
}

TEST_F(Fbx, BonesWithoutAJointFoldIntoTheOneAbove) {
    std::vector<Joint> joints = defaultActor().skeleton.joints();
    joints.pop_back();  // the right toes
    MotionClip clip;
    clip.name = "no toes";
    clip.skeleton = Skeleton::make(joints).value();
    clip.frames = {clip.skeleton.zeroPose(), clip.skeleton.zeroPose()};
    clip.frames[1].q_parent_joint.back() = axisAngle(Vector3d::UnitX(), 0.3);
    const auto figure = makeFigure(clip, test::shippedBody(), JointNames::kOwn);
    ASSERT_TRUE(figure);
    EXPECT_EQ(figure->body->bones.size(), 20U);
    ASSERT_TRUE(writeFbx(path(), *figure, {}, false));
    EXPECT_LT(differenceTo(*figure).vertex_m, 5e-6);
}

/// Records are found by their names and read by hand: the reader above knows nothing of confidence.
TEST_F(Fbx, ConfidenceIsACurveOfEveryBone) {
    Figure figure = test::sampleFigure(false);
    ASSERT_TRUE(writeFbx(path(), figure, {}, true));
    EXPECT_EQ(bytes().find("confidence"), std::string::npos) << "not known";
    const size_t joints = static_cast<size_t>(figure.clip.skeleton.size());
    figure.confidence.assign(figure.clip.frames.size(), std::vector<float>(joints, 0.75F));
    figure.confidence[1][2] = 0.3125F;
    const Status written = writeFbx(path(), figure, {}, true);
    ASSERT_TRUE(written) << written.error().text();
    EXPECT_LT(differenceTo(figure).joint_m, 5e-6) << "the motion is still read";
    const std::string file = bytes();
    size_t curves = 0;
    for (size_t at = 0;
         (at = file.find(fbxObjectName("confidence", "AnimCurveNode"), at)) != std::string::npos; ++at)
        ++curves;
    EXPECT_EQ(curves, joints);
    std::string two_keys(8, '\0');
    const float expected[] = {0.75F, 0.3125F};
    std::memcpy(two_keys.data(), expected, sizeof expected);
    EXPECT_NE(file.find(two_keys), std::string::npos);
}

}  // namespace
}  // namespace noctule
