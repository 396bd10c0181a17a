// SPDX-License-Identifier: Apache-2.0
#include "core/robot_film/robot_film.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "core/body/actor.h"
#include "core/robot/urdf_reader.h"
#include "core/robot_film/robot_mesh.h"
#include "tests/support/files.h"
#include "tests/support/plain_arm.h"

namespace noctule::robot {
namespace {

TEST(RobotMesh, CapsulesFaceOutwardsAndStandWhereTheLinksAre) {
    const auto model = parseUrdf(test::plainArmUrdf(), "arm");
    ASSERT_TRUE(model);
    const RobotProfile profile = test::plainArmProfile();
    const auto mesh = meshOf(*model, profile);
    ASSERT_GT(mesh->triangles.size(), 100U);
    double volume = 0;
    for (const auto& triangle : mesh->triangles) {
        const auto p = [&](int i) {
            return mesh->vertices[triangle[static_cast<size_t>(i)]].p_m.cast<double>().eval();
        };
        volume += p(0).dot(p(1).cross(p(2))) / 6;
        const Vector3d across = (p(1) - p(0)).cross(p(2) - p(0));
        if (across.norm() > 1e-12) {
            EXPECT_GT(across.dot(mesh->vertices[triangle[0]].normal.cast<double>()), 0);
        }
    }
    // Lines from the shoulder to the elbow, to the forearm's turn and to the wrist, and from the base.
    const double r = profile.capsule_radius_m, pi = std::numbers::pi;
    const double base = std::hypot(0.2, 1.4);
    const double expected = pi * r * r * (base + 0.3 + 0.1 + 0.2) + 4 * 4.0 / 3 * pi * r * r * r;
    EXPECT_NEAR(volume, expected, 0.05 * expected);
    const Eigen::AlignedBox3d box = boxOf(*model, profile, {}, standingRoot(*model, profile, 0));
    EXPECT_NEAR(box.max().y(), 1.4 + r, 1e-9) << "z of the robot is up";
    EXPECT_NEAR(box.min().x(), -0.2 - r, 1e-9) << "its right is the performer's right";
}

/// A tetrahedron of 1 m along x, y and z as STL.
std::string tetrahedron() {
    const std::array<Vector3d, 4> p{Vector3d::Zero(), Vector3d::UnitX(), Vector3d::UnitY(),
                                    Vector3d::UnitZ()};
    std::ostringstream text;
    text << "solid t\n";
    for (const auto& face :
         {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{0, 3, 2}, std::array{1, 2, 3}}) {
        text << "facet normal 0 0 0\nouter loop\n";
        for (const int corner : face)
            text << "vertex " << p[static_cast<size_t>(corner)].transpose() << '\n';
        text << "endloop\nendfacet\n";
    }
    text << "endsolid t\n";
    return text.str();
}

TEST(RobotLook, ShowsTheMeshesThatAreThereAndCapsulesForTheOthers) {
    const test::Folder folder;
    std::filesystem::create_directories(folder.file("meshes"));
    std::filesystem::create_directories(folder.file("urdf"));
    std::ofstream(folder.file("meshes/part.STL")) << tetrahedron();
    std::ofstream(folder.file("meshes/broken.stl")) << "no mesh";
    const auto link = [](const std::string& name, const std::string& mesh) {
        return "<link name='" + name +
               "'><visual><origin xyz='0 0 0.5' rpy='0 0 0'/><geometry><mesh filename='" + mesh +
               "' scale='0.1 0.1 -0.2'/></geometry></visual><collision><geometry><sphere radius='0.05'/>" +
               "</geometry></collision></link>";
    };
    const auto joint = [](const std::string& child) {
        return "<joint name='to_" + child + "' type='fixed'><parent link='base'/><child link='" + child +
               "'/></joint>";
    };
    const std::string urdf = "<robot name='r'>" + link("base", "package://r_description/meshes/part.STL") +
                             link("gone", "package://r_description/meshes/gone.stl") +
                             link("broken", "../meshes/broken.stl") + joint("gone") + joint("broken") +
                             "</robot>";
    std::ofstream(folder.file("urdf/r.urdf")) << urdf;
    const auto model = readUrdf(folder.file("urdf/r.urdf"));
    ASSERT_TRUE(model) << model.error().text();

    const RobotLook look = lookOf(*model, {}, folder.file("urdf/r.urdf"));
    ASSERT_EQ(look.mesh->bones.size(), 3U);
    EXPECT_EQ(look.mesh->bones[0].joint, "base");
    Eigen::AlignedBox3f of_part;
    double volume = 0;
    for (size_t i = 0; i < 4; ++i) {
        std::array<Vector3d, 3> corners;
        for (size_t k = 0; k < 3; ++k) {
            const SkinnedVertex& vertex = look.mesh->vertices[look.mesh->triangles[i][k]];
            ASSERT_EQ(vertex.bones[0], 0);
            of_part.extend(vertex.p_m);
            corners[k] = vertex.p_m.cast<double>() - Vector3d(0, 0, 0.5);
        }
        volume += corners[0].dot(corners[1].cross(corners[2])) / 6;
    }
    EXPECT_TRUE(of_part.isApprox(
        Eigen::AlignedBox3f(Eigen::Vector3f(0, 0, 0.3F), Eigen::Vector3f(0.1F, 0.1F, 0.5F)), 1e-5F));
    EXPECT_NEAR(volume, 0.1 * 0.1 * 0.2 / 6, 1e-9) << "faces outwards although it is mirrored";
    ASSERT_EQ(look.notices.size(), 2U);
    EXPECT_NE(look.notices[0].find("broken.stl"), std::string::npos) << look.notices[0];
    EXPECT_NE(look.notices[1].find("1 of 3 meshes"), std::string::npos) << look.notices[1];
}

TEST(RobotFilm, TheRobotStandsOnTheGroundBesideThePerformersWayAndMovesAsCommanded) {
    const auto model = parseUrdf(test::plainArmUrdf(), "arm");
    ASSERT_TRUE(model);
    const RobotProfile profile = test::plainArmProfile();
    const Actor actor = defaultActor();
    MotionClip clip{"walk", actor.skeleton, 1.0 / 30, {}, {}};
    for (int frame = 0; frame < 60; ++frame) {
        clip.frames.push_back(actor.restPose());
        clip.frames.back().p_world_root += Vector3d(0.05 * frame, 0, 0);
    }
    RobotTrajectory commands;
    commands.frame_time_s = 0.01;
    for (const RobotJoint& joint : model->joints)
        if (joint.moves() && !joint.mimic)
            commands.joints.push_back(joint.name);
    for (int frame = 0; frame < 100; ++frame)
        commands.frames.emplace_back(commands.joints.size(), frame < 50 ? 0.0 : 0.4);

    const FilmCompanion robot = companionOf(clip, *model, profile, meshOf(*model, profile), commands);
    ASSERT_EQ(robot.skin.size(), clip.frames.size());
    Eigen::AlignedBox3d filled;
    for (const auto& skin : robot.skin)
        for (const Eigen::Vector3f& p_m : skinned(*robot.mesh, skin).points_m)
            filled.extend(p_m.cast<double>());
    EXPECT_NEAR(filled.min().y(), 0, 0.02);
    const double way_end_m = clip.frames.back().p_world_root.x();
    EXPECT_GT(filled.min().x(), way_end_m + 0.5) << "clear of the arms";
    const auto bone = robot.skin[0].size() - 1;
    EXPECT_EQ(robot.skin[0][bone], robot.skin[14][bone]) << "0.47 s: nothing has moved";
    EXPECT_NE(robot.skin[14][bone], robot.skin[16][bone]) << "0.53 s";
    EXPECT_EQ(robot.skin[16][bone], robot.skin[59][bone]) << "the last command stays";
}

}  // namespace
}  // namespace noctule::robot
