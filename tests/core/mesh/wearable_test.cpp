// SPDX-License-Identifier: Apache-2.0
// From a file to a body that moves as we do, in one go.
#include "core/mesh/rig/wearable.h"

#include <gtest/gtest.h>

#include "core/body/actor.h"
#include "core/mesh/mannequin/mannequin.h"
#include "core/mesh/retarget/retarget.h"
#include "tests/support/named_rig.h"
#include "tests/support/shared_meshes.h"

namespace noctule {
namespace {

RiggedMesh bareMannequin() {
    RiggedMesh mesh;
    mesh.skin = makeMannequin(defaultActor());
    mesh.skin.bones.clear();
    for (SkinnedVertex& vertex : mesh.skin.vertices) {
        vertex.p_m += Eigen::Vector3f(3, -0.7F, 1);
        vertex.bones = {};
        vertex.weights = {};
    }
    mesh.nodes.push_back({"root", -1});
    mesh.parts.push_back({"body", 0, static_cast<uint32_t>(mesh.skin.triangles.size())});
    return mesh;
}

TEST(Wearable, ABareFigureIsPutOnTheGroundAndRigged) {
    const auto body = wearable(bareMannequin(), "bare.obj");
    ASSERT_TRUE(body) << body.error().text();
    EXPECT_TRUE(checkRiggedMesh(body->mesh, "bare.obj"));
    EXPECT_TRUE(missingMainJoints(body->bones).empty());
    ASSERT_TRUE(body->landmarks);
    EXPECT_NEAR(body->landmarks->at("Hips").x(), 0, 0.01);
    EXPECT_NEAR(body->landmarks->at("LeftLeg").y(), 0.5, 0.06);
    EXPECT_TRUE(Retargeter::make(body->mesh, body->bones, defaultActor().skeleton, {}, "bare.obj"));
}

TEST(Wearable, LandmarksSetByHandAreTaken) {
    const auto found = wearable(bareMannequin(), "bare.obj");
    ASSERT_TRUE(found);
    WearingChoices choices;
    choices.landmarks = found->landmarks;
    (*choices.landmarks)["LeftForeArm"].x() += 0.02;
    const auto body = wearable(bareMannequin(), "bare.obj", choices);
    ASSERT_TRUE(body);
    const auto elbow = static_cast<size_t>(body->mesh.find("LeftForeArm"));
    EXPECT_NEAR(
        (body->mesh.nodes[elbow].T_world_rest.translation() - found->landmarks->at("LeftForeArm")).norm(),
        0.02, 1e-9);
}

TEST(Wearable, BonesSetByHandAreTakenAndChecked) {
    const RiggedMesh named = test::namedRig([](const std::string& joint) { return joint; });
    RiggedMesh rig = named;
    test::giveSkin(rig);
    WearingChoices choices;
    choices.bones = findBoneMap(named);
    choices.bones->node_of_joint.erase("Neck");
    const auto body = wearable(rig, "rig.glb", choices);
    ASSERT_TRUE(body) << body.error().text();
    EXPECT_FALSE(body->bones.node_of_joint.contains("Neck"));
    choices.bones->node_of_joint["Head"] = "Skull";
    const auto wrong = wearable(rig, "rig.glb", choices);
    ASSERT_FALSE(wrong);
    EXPECT_NE(wrong.error().message.find("rig.glb: the mesh has no bone Skull"), std::string::npos);
}

TEST(Wearable, MakeHumansFileLosesItsAids) {
    if (!test::isShared(test::kMakeHuman))
        GTEST_SKIP() << test::sayMissing(test::kMakeHuman);
    const auto body = wearable(test::sharedMesh(test::kMakeHuman + "base.obj"), "base.obj");
    ASSERT_TRUE(body) << body.error().text();
    ASSERT_EQ(body->mesh.parts.size(), 1U);
    EXPECT_EQ(body->mesh.parts.front().name, "body");
    float low = 1, high = 0;
    for (const SkinnedVertex& vertex : body->mesh.skin.vertices) {
        low = std::min(low, vertex.p_m.y());
        high = std::max(high, vertex.p_m.y());
    }
    EXPECT_NEAR(low, 0, 1e-6);
    EXPECT_NEAR(high, 1.666, 0.01);
}

}  // namespace
}  // namespace noctule
