// SPDX-License-Identifier: Apache-2.0
#include "core/robot_film/robot_film.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/body/actor.h"
#include "core/robot/urdf_reader.h"
#include "core/robot_film/robot_mesh.h"
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
    const Eigen::AlignedBox3d box = boxOf(*model, profile, {}, standingRoot(0));
    EXPECT_NEAR(box.max().y(), 1.4 + r, 1e-9) << "z of the robot is up";
    EXPECT_NEAR(box.min().x(), -0.2 - r, 1e-9) << "its right is the performer's right";
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

    const FilmCompanion robot = companionOf(clip, *model, profile, commands);
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
