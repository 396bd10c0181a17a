// SPDX-License-Identifier: Apache-2.0
// Our motion on bodies of other programs, as FBX and GLB hold it: the skin is where the view draws it, bones
// keep their names and rest poses, and nothing beside the joints is taken for one of them.
#include "core/formats/rigged_figure.h"

#include "core/formats/fbx_writer.h"
#include "core/formats/glb_writer.h"
#include "core/formats/scene_check.h"
#include "core/math/rotation.h"
#include "core/mesh/retarget/moving_body.h"
#include "tests/core/formats/sample_figure.h"
#include "tests/support/files.h"
#include "tests/support/named_rig.h"
#include "tests/support/painted_surface.h"
#include "tests/support/shared_meshes.h"

namespace noctule {
namespace {

MotionClip shortClip() {
    return test::sampleClip(40);
}

/// An A pose, lying on its back, bones along their own axes, twice our size, under Mixamo's names.
WearableBody lyingBody() {
    RiggedMesh rig = test::namedRig(
        [](const std::string& joint) { return "mixamorig:" + (joint == "Chest" ? "Spine2" : joint); },
        [](const std::string& joint) {
            if (joint == "Hips")
                return axisAngle(Vector3d::UnitX(), -M_PI / 2);
            return joint == "LeftArm"    ? axisAngle(Vector3d::UnitZ(), -0.7)
                   : joint == "RightArm" ? axisAngle(Vector3d::UnitZ(), 0.7)
                                         : Quaterniond::Identity();
        },
        2, axisAngle(Vector3d(1, 2, 3).normalized(), 1));
    test::giveSkin(rig);
    return wearable(std::move(rig), "lying").value();
}

WearableBody sharedBody(const std::string& name) {
    return wearable(test::sharedMesh(name), name).value();
}

/// Largest distance of the figure's skin from what the view draws, before it scales.
double skinError(const WearableBody& body, const MotionClip& clip, const Figure& figure) {
    const auto retargeter =
        Retargeter::make(body.mesh, bonesFor(body.bones, clip.skeleton), clip.skeleton, {}, body.name);
    double largest = 0;
    for (size_t f = 0; f < clip.frames.size(); ++f) {
        const auto seen = skinned(body.mesh.skin, skinMatrices(body.mesh, retargeter->pose(clip.frames[f])));
        const auto held = skinned(
            *figure.body, skinMatrices(*figure.body, figure.clip.skeleton, globalPose(figure.clip, f)));
        for (size_t v = 0; v < seen.points_m.size(); ++v)
            largest = std::max(largest, static_cast<double>((seen.points_m[v] - held.points_m[v]).norm()));
    }
    return largest;
}

void expectHeldByFiles(const WearableBody& body) {
    const MotionClip clip = shortClip();
    const auto figure = riggedFigure(clip, {}, body, JointNames::kOwn, {});
    ASSERT_TRUE(figure) << figure.error().text();
    EXPECT_LT(skinError(body, clip, *figure), 2e-5) << body.name;
    const test::Folder folder;
    for (const SceneFormat format : {SceneFormat::kFbx, SceneFormat::kGlb}) {
        const std::string path = folder.file(format == SceneFormat::kFbx ? "a.fbx" : "a.glb");
        const Status written =
            format == SceneFormat::kFbx ? writeFbx(path, *figure, {}, false) : writeGlb(path, *figure, false);
        ASSERT_TRUE(written) << body.name << ": " << written.error().text();
        const auto difference = compareScene(path, path, format, *figure);
        ASSERT_TRUE(difference) << difference.error().text();
        EXPECT_LT(difference->joint_m, 2e-5) << body.name;
        EXPECT_LT(difference->vertex_m, 2e-5) << body.name;
        const auto again = importMesh(path);
        ASSERT_TRUE(again) << again.error().text();
        EXPECT_EQ(again->skin.triangles.size(), figure->body->triangles.size());
        EXPECT_TRUE(missingMainJoints(findBoneMap(*again)).empty()) << "as another program would map it";
    }
}

TEST(RiggedFigure, FilesHoldABodyThatLiesInAnotherRestPose) {
    const WearableBody body = lyingBody();
    expectHeldByFiles(body);
    const auto figure = riggedFigure(shortClip(), {}, body, JointNames::kOwn, {});
    const GlobalPose rest = globalPose(figure->clip.skeleton, figure->rest);
    const auto at = [&](const char* bone) {
        return rest.p_world_joint[static_cast<size_t>(figure->clip.skeleton.find(bone))];
    };
    EXPECT_NEAR(at("mixamorig:Head").x(), at("mixamorig:Hips").x(), 1e-9) << "upright";
    EXPECT_GT(at("mixamorig:Head").y(), at("mixamorig:Hips").y() + 1);
    EXPECT_GT(at("mixamorig:LeftArm").x(), at("mixamorig:RightArm").x() + 0.3) << "its left to +X";
}

TEST(RiggedFigure, FilesHoldBodiesOfOthers) {
    for (const std::string& name : {test::kCesiumMan, test::kKenney}) {
        if (!test::isShared(name))
            GTEST_SKIP() << test::sayMissing(name);
        expectHeldByFiles(sharedBody(name));
    }
}

TEST(RiggedFigure, ColourAndTextureStandInTheFiles) {
    if (!test::isShared(test::kCesiumMan))
        GTEST_SKIP() << test::sayMissing(test::kCesiumMan);
    const auto figure = riggedFigure(shortClip(), {}, sharedBody(test::kCesiumMan), JointNames::kOwn, {});
    ASSERT_TRUE(figure && figure->body->surface.size() == 1 && figure->body->surface[0].look->texture);
    test::Folder folder;
    for (const SceneFormat format : {SceneFormat::kFbx, SceneFormat::kGlb}) {
        const std::string path = folder.file(format == SceneFormat::kFbx ? "t.fbx" : "t.glb");
        const Status written =
            format == SceneFormat::kFbx ? writeFbx(path, *figure, {}, false) : writeGlb(path, *figure, false);
        ASSERT_TRUE(written) << written.error().text();
        Figure moved = *figure, painted = *figure, plain = *figure;
        moved.body->vertices[7].uv.x() += 0.01F;
        painted.body->surface[0].look->base_color.x() = 0.5F;
        plain.body->surface[0].look->texture = std::make_shared<const SurfaceTexture>(SurfaceTexture{"none"});
        EXPECT_TRUE(checkScene(path, path, format, *figure));
        for (const Figure& other : {moved, painted, plain})
            EXPECT_FALSE(checkScene(path, path, format, other));
    }
}

using Repaint = std::function<void(std::vector<SurfacePart>&)>;

/// What a file could hold instead of the looks that it should.
std::vector<std::pair<const char*, Repaint>> otherLooks() {
    return {
        {"another colour of one part", [](auto& parts) { parts[2].look->base_color.x() = 0.6F; }},
        {"another texture of one part", [](auto& parts) { parts[3].look->texture = parts[1].look->texture; }},
        {"no texture", [](auto& parts) { parts[2].look->texture = nullptr; }},
        {"a texture where none was", [](auto& parts) { parts[0].look->texture = parts[1].look->texture; }},
        {"textures exchanged",
         [](auto& parts) { std::swap(parts[1].look->texture, parts[3].look->texture); }},
        {"fewer looks",
         [](auto& parts) {
             parts[2].triangles += parts[3].triangles;
             parts.pop_back();
         }},
        {"another border", [](auto& parts) {
             ++parts[0].triangles;
             ++parts[1].first_triangle;
             --parts[1].triangles;
         }}};
}

TEST(RiggedFigure, EveryLookStandsInTheFiles) {
    RiggedMesh rig = test::namedRig([](const std::string& joint) { return joint; });
    test::giveSkin(rig);
    test::paint(rig.skin);
    const auto figure = riggedFigure(shortClip(), {}, wearable(rig, "painted").value(), JointNames::kOwn, {});
    ASSERT_TRUE(figure && figure->body->surface.size() == 4);
    const test::Folder folder;
    for (const SceneFormat format : {SceneFormat::kFbx, SceneFormat::kGlb}) {
        const std::string path = folder.file(format == SceneFormat::kFbx ? "t.fbx" : "t.glb");
        const Status written =
            format == SceneFormat::kFbx ? writeFbx(path, *figure, {}, false) : writeGlb(path, *figure, false);
        ASSERT_TRUE(written) << written.error().text();
        EXPECT_LT(compareScene(path, path, format, *figure)->vertex_m, 2e-5);
        for (const auto& [what, repaint] : otherLooks()) {
            Figure other = *figure;
            repaint(other.body->surface);
            EXPECT_FALSE(checkScene(path, path, format, other)) << path << ": " << what;
        }
        Figure moved = *figure;
        moved.body->vertices[moved.body->triangles.back()[1]].uv.x() += 0.01F;
        EXPECT_FALSE(checkScene(path, path, format, moved));
    }
}

/// As another program would see it.
TEST(RiggedFigure, AFileOfOursComesBackInItsLooks) {
    RiggedMesh rig = test::namedRig([](const std::string& joint) { return joint; });
    test::giveSkin(rig);
    test::paint(rig.skin);
    const auto figure = riggedFigure(shortClip(), {}, wearable(rig, "painted").value(), JointNames::kOwn, {});
    const test::Folder folder;
    ASSERT_TRUE(writeGlb(folder.file("t.glb"), *figure, false));
    const auto again = importMesh(folder.file("t.glb"));
    ASSERT_TRUE(again) << again.error().text();
    const std::vector<SurfacePart>&seen = again->skin.surface, &wanted = figure->body->surface;
    ASSERT_EQ(seen.size(), wanted.size());
    for (size_t p = 0; p < seen.size(); ++p) {
        EXPECT_EQ(seen[p].triangles, wanted[p].triangles);
        EXPECT_LT((seen[p].look->base_color - wanted[p].look->base_color).norm(), 1e-6F);
        EXPECT_EQ(seen[p].look->texture ? seen[p].look->texture->file : "",
                  wanted[p].look->texture ? wanted[p].look->texture->file : "");
    }
    EXPECT_EQ(texturesOf(seen).size(), 2U);
}

TEST(RiggedFigure, BonesBesideTheHipsGoAlongAndEmptyOnesStayOut) {
    RiggedMesh rig = test::namedRig([](const std::string& joint) { return joint; });
    rig.nodes.push_back({"Lamp", -1});
    RigNode prop{"Prop", 0};
    prop.T_world_rest.translation() = Vector3d(0.5, 1, 0);
    rig.nodes.push_back(prop);
    test::giveSkin(rig);
    const auto lamp = std::find_if(rig.skin.bones.begin(), rig.skin.bones.end(),
                                   [](const SkinBone& bone) { return bone.joint == "Lamp"; });
    rig.node_of_bone[static_cast<size_t>(lamp - rig.skin.bones.begin())] = 1;  // nothing hangs on it
    const auto body = wearable(std::move(rig), "rig");
    ASSERT_TRUE(body) << body.error().text();
    const MotionClip clip = shortClip();
    const auto figure = riggedFigure(clip, {}, *body, JointNames::kOwn, {});
    ASSERT_TRUE(figure);
    EXPECT_EQ(figure->clip.skeleton.joint(0).name, "Hips");
    EXPECT_EQ(figure->clip.skeleton.find("Lamp"), -1);
    EXPECT_EQ(figure->clip.skeleton.find("Armature"), -1);
    const int held = figure->clip.skeleton.find("Prop");
    ASSERT_GE(held, 0);
    EXPECT_EQ(figure->clip.skeleton.joint(held).parent, 0);
    EXPECT_LT(skinError(*body, clip, *figure), 2e-5);
}

TEST(RiggedFigure, ConfidenceGoesToEveryBone) {
    const WearableBody body = lyingBody();
    const MotionClip clip = shortClip();
    std::vector<float> row;
    for (int j = 0; j < clip.skeleton.size(); ++j)
        row.push_back(0.01F * static_cast<float>(j));
    const auto figure = riggedFigure(clip, std::vector<std::vector<float>>(clip.frames.size(), row), body,
                                     JointNames::kOwn, {});
    const Skeleton& bones = figure->clip.skeleton;
    for (const char* joint : {"Hips", "LeftHand", "RightFoot"})
        EXPECT_EQ(figure->confidence[3][static_cast<size_t>(bones.find(std::string("mixamorig:") + joint))],
                  row[static_cast<size_t>(clip.skeleton.find(joint))]);
}

TEST(RiggedFigure, ZeroPoseOfRestParallelFramesIsTheRestPose) {
    const auto figure = riggedFigure(shortClip(), {}, lyingBody(), JointNames::kOwn, {});
    const GlobalPose rest = globalPose(figure->clip.skeleton, figure->rest);
    const MotionClip turned = restParallel(figure->clip, rest.q_world_joint);
    Pose zero = turned.skeleton.zeroPose();
    zero.p_world_root = figure->rest.p_world_root;
    const GlobalPose same = globalPose(turned.skeleton, zero), moved = globalPose(turned, 5),
                     expected = globalPose(figure->clip, 5);
    for (size_t j = 0; j < rest.p_world_joint.size(); ++j) {
        EXPECT_LT((same.p_world_joint[j] - rest.p_world_joint[j]).norm(), 1e-9);
        EXPECT_LT((moved.p_world_joint[j] - expected.p_world_joint[j]).norm(), 1e-9);
    }
}

/// Names that the files give to what stands beside the joints.
TEST(SceneNames, JointsMayBeCalledLikeWhatStandsBesideThem) {
    for (const std::string name : {"Body", "Reference", "Mannequin", "RootNode", "ROOT"}) {
        Figure figure = test::sampleFigure(true);
        std::vector<Joint> joints = figure.clip.skeleton.joints();
        for (const size_t j : {size_t{0}, size_t{7}}) {
            joints[j].name = j == 0 ? name : name + "_";
            figure.body->bones[j].joint = joints[j].name;
        }
        figure.clip.skeleton = Skeleton::make(joints).value();
        const test::Folder folder;
        const Status fbx = writeFbx(folder.file("n.fbx"), figure, {}, false);
        EXPECT_TRUE(fbx) << name << ": " << fbx.error().text();
        const Status glb = writeGlb(folder.file("n.glb"), figure, false);
        EXPECT_TRUE(glb) << name << ": " << glb.error().text();
    }
}

}  // namespace
}  // namespace noctule
