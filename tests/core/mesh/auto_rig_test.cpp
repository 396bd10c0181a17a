// SPDX-License-Identifier: Apache-2.0
// Our skeleton in figures that have none, against the rigs that artists gave them.
#include "core/mesh/rig/auto_rig.h"

#include <gtest/gtest.h>

#include "core/body/actor.h"
#include "core/mesh/mannequin/mannequin.h"
#include "core/mesh/retarget/retarget.h"
#include "core/mesh/rig/bone_map.h"
#include "core/mesh/rig/sight.h"
#include "core/mesh/surface_graph.h"
#include "tests/support/shared_meshes.h"

namespace noctule {
namespace {

/// A closed tube along Y from 0 to 1 m, radius 0.1 m.
TriangleMesh tube() {
    constexpr uint32_t kRound = 16, kRings = 41;
    TriangleMesh mesh;
    for (uint32_t r = 0; r < kRings; ++r)
        for (uint32_t i = 0; i < kRound; ++i) {
            const double a = 2 * std::numbers::pi * i / kRound;
            mesh.points.push_back({0.1 * std::cos(a), r / double{kRings - 1}, 0.1 * std::sin(a)});
        }
    for (uint32_t r = 0; r + 1 < kRings; ++r)
        for (uint32_t i = 0; i < kRound; ++i) {
            const uint32_t a = r * kRound + i, b = r * kRound + (i + 1) % kRound;
            mesh.triangles.push_back({a, a + kRound, b});
            mesh.triangles.push_back({b, a + kRound, b + kRound});
        }
    return mesh;
}

const std::vector<BoneLine> kTwoBones = {{0, {0, 0, 0}, {0, 0.5, 0}}, {1, {0, 0.5, 0}, {0, 1, 0}}};

TEST(HeatWeights, TwoBonesInATubeMeetHalfWay) {
    const TriangleMesh mesh = tube();
    const auto weights = heatWeights(mesh, kTwoBones, 2);
    ASSERT_TRUE(weights);
    double before = 2;
    for (uint32_t p = 0; p < mesh.points.size(); ++p) {
        const double y = mesh.points[p].y();
        EXPECT_NEAR(weights->row(p).sum(), 1, 1e-9);
        EXPECT_GE(weights->row(p).minCoeff(), 0);
        if (p % 16)
            continue;
        EXPECT_LT((*weights)(p, 0), before + 1e-9) << y;  // falls all the way
        before = (*weights)(p, 0);
        if (y < 0.2 || y > 0.8) {
            EXPECT_NEAR((*weights)(p, 0), y < 0.5 ? 1 : 0, 0.02) << y;
        }
        if (y == 0.5) {
            EXPECT_NEAR((*weights)(p, 0), 0.5, 0.15);  // this ring is as near to both bones; the first has it
        }
    }
}

TEST(HeatWeights, SatisfyTheEquationOfHeatOnATube) {
    // Far from ends and round the tube everything is the same: w'' = H (w - p) along it, H = warmth / r^2.
    // From the border on, between rings 20 and 21, the weight of the other bone falls as exp(-sqrt(H) y) / 2.
    const TriangleMesh mesh = tube();
    for (const double warmth : {0.5, 1.0, 2.0}) {
        const auto weights = heatWeights(mesh, kTwoBones, 2, {warmth});
        ASSERT_TRUE(weights);
        const double rate = std::sqrt(warmth) / 0.1;
        for (const uint32_t ring : {24U, 28U}) {
            const double y = ring / 40.0 - 0.5, expected = 0.5 * std::exp(-rate * (y - 0.5 / 40));
            EXPECT_NEAR((*weights)(ring * 16, 0) / expected, 1, 0.05) << warmth << " " << y;
        }
    }
}

TEST(HeatWeights, ABoneBehindAWallDoesNotWarm) {
    // Two tubes side by side; the second tube's bone is nearer to some of the first's skin than its own.
    TriangleMesh mesh = tube();
    const auto count = static_cast<uint32_t>(mesh.points.size());
    const TriangleMesh other = tube();
    for (const Vector3d& p : other.points)
        mesh.points.push_back(p + Vector3d(0.205, 0, 0));
    for (const auto& t : other.triangles)
        mesh.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
    const std::vector<BoneLine> lines = {{0, {-0.02, 0, 0}, {-0.02, 1, 0}}, {1, {0.19, 0, 0}, {0.19, 1, 0}}};
    const auto weights = heatWeights(mesh, lines, 2);
    ASSERT_TRUE(weights);
    EXPECT_GT(weights->col(0).head(count).minCoeff(), 0.999);
    EXPECT_GT(weights->col(1).tail(count).minCoeff(), 0.999);
}

TEST(Sight, EndsAtTheNextWall) {
    const TriangleMesh mesh = tube();
    const Sight sight(mesh);
    for (uint32_t p = 16 * 5; p < 16 * 35; p += 7) {
        const Vector3d& from_m = mesh.points[p];
        const Vector3d across(-from_m.x() + 0.0037, from_m.y() + 0.011, -from_m.z() + 0.0021);  // past edges
        EXPECT_TRUE(sight.isClear(p, {0, from_m.y(), 0})) << p;
        EXPECT_TRUE(sight.isClear(p, {0, 0.5, 0})) << p;
        EXPECT_FALSE(sight.isClear(p, from_m + 1.2 * (across - from_m))) << p;
    }
}

TEST(HeatWeights, CanBeCancelled) {
    CancelFlag cancel;
    cancel.cancel();
    const auto weights = heatWeights(tube(), kTwoBones, 2, {}, {nullptr, &cancel});
    ASSERT_FALSE(weights);
    EXPECT_EQ(weights.error().kind, ErrorKind::kCancelled);
}

Vector3d ownJoint(const RiggedMesh& mesh, const BoneMap& map, const std::string& joint) {
    return mesh.nodes[static_cast<size_t>(mesh.find(map.node_of_joint.at(joint)))].T_world_rest.translation();
}

TEST(BodyLandmarks, AreNearTheJointsOfTheMannequin) {
    const Actor actor = defaultActor();
    const SkinnedMesh body = makeMannequin(actor);
    const auto found = findLandmarks(welded(body).mesh, "mannequin");
    ASSERT_TRUE(found) << found.error().text();
    const GlobalPose bound = globalPose(actor.skeleton, bindPose(actor.skeleton));
    for (const std::string& joint : mainJoints())
        EXPECT_LT(
            (found->at(joint) - bound.p_world_joint[static_cast<size_t>(actor.skeleton.find(joint))]).norm(),
            0.08)
            << joint;
}

TEST(BodyLandmarks, AreNearTheJointsThatArtistsSet) {
    if (!test::isShared(test::kMakeHuman))
        GTEST_SKIP() << test::sayMissing(test::kMakeHuman);
    const test::MakeHuman human;
    const BoneMap map = findBoneMap(human.mesh());
    const auto found = findLandmarks(welded(human.mesh().skin).mesh, "MakeHuman");
    ASSERT_TRUE(found) << found.error().text();
    double sum = 0;
    int count = 0;
    for (const std::string side : {"Left", "Right"})
        for (const char* joint : {"Arm", "ForeArm", "Hand", "UpLeg", "Leg", "Foot"}) {
            const double off = (found->at(side + joint) - ownJoint(human.mesh(), map, side + joint)).norm();
            EXPECT_LT(off, 0.06) << side << joint;
            sum += off;
            ++count;
        }
    EXPECT_LT(sum / count, 0.035);
    std::printf("limb joints %.1f mm off in the mean\n", 1e3 * sum / count);
}

TEST(BodyLandmarks, AreNotFoundInABox) {
    TriangleMesh box = tube();
    EXPECT_FALSE(findLandmarks(box, "tube"));
    for (Vector3d& p : box.points)
        p = {p.x(), p.z(), p.y()};
    const auto lying = findLandmarks(box, "tube");
    ASSERT_FALSE(lying);
    EXPECT_NE(lying.error().message.find("upright"), std::string::npos);
}

TEST(BodyLandmarks, TypicalOnesStandOnTheGroundAsTallAsAsked) {
    const Landmarks landmarks = typicalLandmarks(0.9);
    EXPECT_EQ(landmarks.size(), landmarkNames().size());
    double low = 1, high = 0;
    for (const auto& [name, p_m] : landmarks) {
        low = std::min(low, p_m.y());
        high = std::max(high, p_m.y());
        const std::string other = otherSideOf(name);
        EXPECT_NEAR(p_m.x(), other.empty() ? 0 : -landmarks.at(other).x(), 1e-9) << name;
    }
    EXPECT_NEAR(low, 0, 1e-9);
    EXPECT_NEAR(high, 0.9, 0.03);
    EXPECT_GT(landmarks.at("LeftHandEnd").x(), 0.3) << "arms stretched out, its left to +X";
    EXPECT_EQ(landmarkBones().size(), landmarks.size() - 1) << "all hang together";
}

TEST(BodyLandmarks, SetByHandKeepBothSidesAlikeWhenWanted) {
    Landmarks landmarks = typicalLandmarks(1.8);
    for (auto& [name, p_m] : landmarks)
        p_m.x() += 0.1;  // beside the origin
    const Landmarks before = landmarks;
    putLandmark(landmarks, "RightHand", {-0.5, 1.2, 0.3}, true);
    EXPECT_EQ(landmarks.at("RightHand"), Vector3d(-0.5, 1.2, 0.3));
    EXPECT_NEAR((landmarks.at("LeftHand") - Vector3d(0.7, 1.2, 0.3)).norm(), 0, 1e-12);
    putLandmark(landmarks, "Chest", {0.4, 1.3, 0.05}, true);
    EXPECT_EQ(landmarks.at("Chest"), Vector3d(before.at("Chest").x(), 1.3, 0.05)) << "stays in the middle";
    putLandmark(landmarks, "LeftFoot", {0.4, 0.1, 0}, false);
    putLandmark(landmarks, "Chest", {0.4, 1.3, 0.05}, false);
    EXPECT_EQ(landmarks.at("LeftFoot"), Vector3d(0.4, 0.1, 0));
    EXPECT_EQ(landmarks.at("Chest"), Vector3d(0.4, 1.3, 0.05));
    EXPECT_EQ(landmarks.at("RightFoot"), before.at("RightFoot"));
}

TEST(BodyLandmarks, AreKeptAsJson) {
    Landmarks landmarks;
    for (const std::string& name : landmarkNames())
        landmarks[name] = Vector3d(1, 2, static_cast<double>(name.size()));
    const auto again = landmarksFromJson(toJson(landmarks), "x");
    ASSERT_TRUE(again);
    EXPECT_EQ(*again, landmarks);
    landmarks.erase("Neck");
    const auto missing = landmarksFromJson(toJson(landmarks), "x");
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().message.find("Neck"), std::string::npos);
}

/// MakeHuman's own weights on our joints: every bone counts for the mapped one above it. Its vertebra at the
/// height of our chest is spine03.
std::map<std::string, double> foldedWeights(const RiggedMesh& own, const BoneMap& map,
                                            const SkinnedVertex& vertex) {
    std::map<std::string, std::string> joint_of_node;
    for (const auto& [joint, node] : map.node_of_joint)
        joint_of_node[node] = joint;
    std::map<std::string, double> weights;
    for (size_t i = 0; i < 4; ++i) {
        int node = own.node_of_bone[vertex.bones[i]];
        while (node > 0 && !joint_of_node.contains(own.nodes[static_cast<size_t>(node)].name))
            node = own.nodes[static_cast<size_t>(node)].parent;
        weights[joint_of_node[own.nodes[static_cast<size_t>(node)].name]] +=
            static_cast<double>(vertex.weights[i]);
    }
    return weights;
}

/// Share of the weight that hangs on other joints than with the artists, mean over vertices.
double weightError(const RiggedMesh& own, const BoneMap& map, const RiggedMesh& ours) {
    double sum = 0;
    for (size_t v = 0; v < own.skin.vertices.size(); ++v) {
        auto weights = foldedWeights(own, map, own.skin.vertices[v]);
        const SkinnedVertex& vertex = ours.skin.vertices[v];
        for (size_t i = 0; i < 4; ++i) {
            std::string joint = ours.skin.bones[vertex.bones[i]].joint;
            if (joint.ends_with("ToeBase"))  // its toes count for the foot
                joint = joint.substr(0, joint.size() - 7) + "Foot";
            weights[joint] -= static_cast<double>(vertex.weights[i]);
        }
        for (const auto& [joint, difference] : weights)
            sum += std::abs(difference) / 2;
    }
    return sum / static_cast<double>(own.skin.vertices.size());
}

TEST(AutoRig, WeightsAreNearThoseOfTheArtists) {
    if (!test::isShared(test::kMakeHuman))
        GTEST_SKIP() << test::sayMissing(test::kMakeHuman);
    const test::MakeHuman human;
    BoneMap map = findBoneMap(human.mesh());
    map.node_of_joint["Chest"] = "spine03";
    const auto landmarks = findLandmarks(welded(human.mesh().skin).mesh, "MakeHuman");
    ASSERT_TRUE(landmarks);
    const auto ours = autoRigged(human.mesh(), *landmarks, "MakeHuman");
    ASSERT_TRUE(ours) << ours.error().text();
    EXPECT_TRUE(checkRiggedMesh(*ours, "MakeHuman"));
    const double error = weightError(human.mesh(), map, *ours);
    std::printf("%.1f %% of the weight on other joints than MakeHuman's\n", 100 * error);
    EXPECT_LT(error, 0.18);
    Landmarks wrong = *landmarks;  // knees at mid-thigh
    for (const std::string side : {"Left", "Right"})
        wrong[side + "Leg"] = 0.5 * (wrong[side + "Leg"] + wrong[side + "UpLeg"]);
    const auto worse = autoRigged(human.mesh(), wrong, "MakeHuman");
    ASSERT_TRUE(worse);
    EXPECT_GT(weightError(human.mesh(), map, *worse), error + 0.005);
}

TEST(AutoRig, FollowsOurPose) {
    if (!test::isShared(test::kMakeHuman))
        GTEST_SKIP() << test::sayMissing(test::kMakeHuman);
    const RiggedMesh skin = test::makeHumanSkin();
    const auto landmarks = findLandmarks(welded(skin.skin).mesh, "MakeHuman");
    ASSERT_TRUE(landmarks);
    const auto rigged = autoRigged(skin, *landmarks, "MakeHuman");
    ASSERT_TRUE(rigged);
    const Skeleton source = defaultActor().skeleton;
    EXPECT_TRUE(Retargeter::make(*rigged, findBoneMap(*rigged), source, {}, "MakeHuman"));
    for (size_t n = 0; n < rigged->nodes.size(); ++n)
        EXPECT_EQ(rigged->nodes[n].name, source.joint(static_cast<int>(n)).name);
}

TEST(AutoRig, EveryLandmarkIsNeeded) {
    RiggedMesh figure;
    const auto rigged = autoRigged(figure, {{"Hips", Vector3d::Zero()}}, "figure");
    ASSERT_FALSE(rigged);
    EXPECT_EQ(rigged.error().kind, ErrorKind::kUsage);
}

}  // namespace
}  // namespace noctule
