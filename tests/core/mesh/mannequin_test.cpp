// SPDX-License-Identifier: Apache-2.0
// The default body: what a renderer and a calibration may take for granted, and that the shipped file is the
// one that the generator makes.
#include "core/mesh/mannequin/mannequin.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/body/actor.h"
#include "core/math/rotation.h"
#include "core/mesh/import/glb_reader.h"
#include "core/mesh/skinning.h"

namespace noctule {
namespace {

using Eigen::Vector3f;

const Actor& actor() {
    static const Actor made = defaultActor();
    return made;
}

const SkinnedMesh& body() {
    static const SkinnedMesh made = makeMannequin(actor());
    return made;
}

std::vector<Vector3f> posed(const Pose& pose) {
    const GlobalPose global = globalPose(actor().skeleton, pose);
    return skinned(body(), skinMatrices(body(), actor().skeleton, global)).points_m;
}

double volume_m3(const std::vector<Vector3f>& points) {
    double sum = 0;
    for (const auto& [a, b, c] : body().triangles)
        sum += points[a].cast<double>().dot(points[b].cast<double>().cross(points[c].cast<double>())) / 6;
    return sum;
}

double areaOf_m2(const std::array<uint32_t, 3>& t) {
    const auto p = [&](size_t i) { return body().vertices[t[i]].p_m.cast<double>(); };
    return (p(1) - p(0)).cross(p(2) - p(0)).norm() / 2;
}

double weightOf(const std::string& joint, const SkinnedVertex& vertex) {
    double sum = 0;
    for (size_t i = 0; i < 4; ++i)
        if (body().bones[vertex.bones[i]].joint == joint)
            sum += vertex.weights[i];
    return sum;
}

TEST(Mannequin, IsSmallEnoughToDrawAnywhere) {
    EXPECT_LT(body().triangles.size(), 12000U);
    EXPECT_GT(body().triangles.size(), 8000U);
}

TEST(Mannequin, IsClosedAndOriented) {
    std::map<std::pair<uint32_t, uint32_t>, int> edges;
    for (const auto& t : body().triangles)
        for (size_t i = 0; i < 3; ++i)
            ++edges[{t[i], t[(i + 1) % 3]}];
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1) << edge.first << " to " << edge.second;
        ASSERT_EQ((edges.count({edge.second, edge.first})), 1U) << edge.first << " to " << edge.second;
    }
    EXPECT_EQ(edges.size() / 2, body().triangles.size() * 3 / 2);
    const auto euler = static_cast<long>(body().vertices.size() + body().triangles.size() - edges.size() / 2);
    EXPECT_EQ(euler, 2) << "one surface without holes or handles";
    EXPECT_GT(volume_m3(posed(bindPose(actor().skeleton))), 0.05);
}

TEST(Mannequin, HasNoDegenerateTriangle) {
    for (size_t t = 0; t < body().triangles.size(); ++t)
        ASSERT_GT(areaOf_m2(body().triangles[t]), 1e-7) << "triangle " << t;
}

TEST(Mannequin, NormalsLookOutward) {
    size_t disagreeing = 0;
    for (const auto& t : body().triangles) {
        const SkinnedVertex &a = body().vertices[t[0]], &b = body().vertices[t[1]],
                            &c = body().vertices[t[2]];
        const Vector3f face = (b.p_m - a.p_m).cross(c.p_m - a.p_m);
        for (const SkinnedVertex* vertex : {&a, &b, &c}) {
            ASSERT_NEAR(vertex->normal.norm(), 1, 1e-5);
            disagreeing += face.normalized().dot(vertex->normal) < 0.2F;
        }
    }
    EXPECT_LT(disagreeing, body().triangles.size() * 3 / 200) << "fewer than one corner in 200";
}

TEST(Mannequin, IsTheSameOnBothSides) {
    std::set<std::array<long, 3>> places;
    const auto rounded = [](float v) { return std::lround(v * 1e5); };
    for (const SkinnedVertex& v : body().vertices)
        places.insert({rounded(v.p_m.x()), rounded(v.p_m.y()), rounded(v.p_m.z())});
    for (const SkinnedVertex& v : body().vertices)
        ASSERT_TRUE(places.contains({rounded(-v.p_m.x()), rounded(v.p_m.y()), rounded(v.p_m.z())}))
            << v.p_m.transpose();
}

TEST(Mannequin, HasTheActorsHeightAndStandsOnTheFloor) {
    float low = 1, high = 0;
    for (const SkinnedVertex& v : body().vertices) {
        low = std::min(low, v.p_m.y());
        high = std::max(high, v.p_m.y());
    }
    EXPECT_NEAR(low, 0, 0.002);
    EXPECT_NEAR(high, actor().height_m, 0.015);
}

TEST(Mannequin, EveryMovingJointCarriesSkin) {
    for (const Joint& joint : actor().skeleton.joints()) {
        double heaviest = 0;
        for (const SkinnedVertex& v : body().vertices)
            heaviest = std::max(heaviest, weightOf(joint.name, v));
        EXPECT_GT(heaviest, 0.75) << joint.name;
    }
}

TEST(Mannequin, WeightsSumToOneAndStayOnTheirSide) {
    for (const SkinnedVertex& v : body().vertices) {
        float sum = 0;
        for (size_t i = 0; i < 4; ++i) {
            EXPECT_GE(v.weights[i], 0);
            sum += v.weights[i];
            const std::string other_side = v.p_m.x() > 0 ? "Right" : "Left";
            if (v.weights[i] > 0 && std::abs(v.p_m.x()) > 0.01) {
                ASSERT_FALSE(body().bones[v.bones[i]].joint.starts_with(other_side)) << v.p_m.transpose();
            }
        }
        ASSERT_NEAR(sum, 1, 1e-6);
    }
}

TEST(Mannequin, TheBindPoseLeavesTheSkinWhereItIs) {
    const std::vector<Vector3f> points = posed(bindPose(actor().skeleton));
    for (size_t v = 0; v < points.size(); ++v)
        ASSERT_LT((points[v] - body().vertices[v].p_m).norm(), 1e-6F);
}

/// A leg holds about 9 litres; linear blending loses a tenth of one at the inside of the bend.
TEST(Mannequin, ABentKneeKeepsTheVolumeOfTheLeg) {
    Pose pose = bindPose(actor().skeleton);
    const double before_m3 = volume_m3(posed(pose));
    pose.q_parent_joint[static_cast<size_t>(actor().skeleton.find("LeftLeg"))] =
        axisAngle(Vector3d::UnitX(), std::numbers::pi / 2);
    EXPECT_NEAR(volume_m3(posed(pose)), before_m3, 0.15e-3);
}

TEST(Mannequin, ARaisedArmKeepsTheVolumeOfTheShoulder) {
    Pose pose = bindPose(actor().skeleton);
    const double before_m3 = volume_m3(posed(pose));
    for (const double angle_rad : {-1.3, 1.3}) {
        pose.q_parent_joint[static_cast<size_t>(actor().skeleton.find("LeftArm"))] =
            axisAngle(Vector3d::UnitZ(), angle_rad);
        EXPECT_NEAR(volume_m3(posed(pose)), before_m3, 0.35e-3) << angle_rad;
    }
}

TEST(Mannequin, TheShippedFileIsWhatTheGeneratorMakes) {
    const auto shipped = readSkinnedMesh(NOCTULE_SOURCE_DIR "/resources/bodies/mannequin.glb");
    ASSERT_TRUE(shipped) << shipped.error().text();
    const char* remedy = "run noctule-make-mannequin resources/bodies/mannequin.glb";
    ASSERT_EQ(shipped->vertices.size(), body().vertices.size()) << remedy;
    ASSERT_EQ(shipped->triangles, body().triangles) << remedy;
    for (size_t v = 0; v < body().vertices.size(); ++v)
        ASSERT_LT((shipped->vertices[v].p_m - body().vertices[v].p_m).norm(), 1e-5F) << remedy;
}

}  // namespace
}  // namespace noctule
