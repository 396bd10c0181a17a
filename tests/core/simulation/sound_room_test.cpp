// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/sound_room.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/simulation/sound_test_world.h"

namespace noctule::simulation {
namespace {

/// One board that walks 4 m forward in 1000 s.
TestWorld walker() {
    TestWorld world;
    world.boards = {{.p_m = {0, 1, 0}, .v_m_per_s = {0, 0, 0.004}, .segment = 1}};
    world.sources = {{.p_m = {0, 1.2, 0.1}, .segment = 2}};
    return world;
}

SoundScenario bareFloor() {
    SoundScenario scenario;
    scenario.reflections = true;
    scenario.walls = scenario.scattering_points = 0;
    return scenario;
}

Room::Query query(const Vector3d& source, const Vector3d& microphone) {
    Room::Query result;
    result.ends = {source, (microphone - source).normalized(), microphone};
    result.source_later_m = source + Vector3d(0.001, 0, 0);
    result.ka = 3.2;
    return result;
}

TEST(Room, IsEmptyWithoutReflections) {
    const Room room(walker(), {}, 1);
    EXPECT_TRUE(room.planes().empty());
    EXPECT_TRUE(room.spheres().empty());
}

TEST(Room, HasTheFloorTwoWallsAndSixPoints) {
    SoundScenario scenario;
    scenario.reflections = true;
    const TestWorld world = walker();
    for (uint64_t seed = 0; seed < 20; ++seed) {
        const Room room(world, scenario, seed);
        ASSERT_EQ(room.planes().size(), 3u);
        EXPECT_EQ(room.planes()[0].normal, Vector3d::UnitY());
        EXPECT_EQ(room.planes()[0].offset_m, 0);
        EXPECT_EQ(room.spheres().size(), 6u);
        for (const Room::Plane& plane : room.planes()) {
            EXPECT_GE(20 * std::log10(plane.gain), -14);
            EXPECT_LE(20 * std::log10(plane.gain), -8);
        }
        for (size_t i = 1; i < 3; ++i) {
            const Room::Plane& wall = room.planes()[i];
            double nearest = 100;
            for (double t = 0; t <= 1000; t += 10)
                nearest = std::min(nearest, wall.normal.dot(world.microphone(0, t)) - wall.offset_m);
            EXPECT_GE(nearest, 1 - 1e-9);
            EXPECT_LE(nearest, 3 + 1e-9);
        }
    }
}

TEST(Room, TheFloorMirrorsTheSource) {
    const Room room(walker(), bareFloor(), 1);
    std::vector<EchoPath> echoes;
    const Vector3d source(0, 1.2, 0), microphone(0.6, 0.4, 0);
    room.echoes(query(source, microphone), {}, {.directivity = false}, echoes);
    ASSERT_EQ(echoes.size(), 1u);
    const double length = echoes[0].now.before_m + (microphone - echoes[0].now.last_point_m).norm();
    EXPECT_NEAR(length, std::hypot(0.6, 1.6), 1e-12);
    EXPECT_NEAR(echoes[0].gain, room.planes()[0].gain * airGain(length, 1.3), 1e-12);
    EXPECT_NEAR((echoes[0].later.last_point_m - echoes[0].now.last_point_m).norm(), 0.001, 1e-12);
}

TEST(Room, TheBodyHidesTheFloor) {
    const Room room(walker(), bareFloor(), 1);
    // The floor's mirror point is at x = 0.45: a capsule lies on the way down.
    const std::vector<WorldCapsule> thigh{{{0.2, 0.7, -0.3}, {0.2, 0.7, 0.3}, 0.08, 7}};
    std::vector<EchoPath> echoes;
    Room::Query asked = query({0, 1.2, 0}, {0.6, 0.4, 0});
    asked.board_segment = 7;
    room.echoes(asked, thigh, {}, echoes);
    EXPECT_TRUE(echoes.empty());
    room.echoes(asked, thigh, {.occlusion = false}, echoes);
    EXPECT_EQ(echoes.size(), 1u);
}

TEST(Room, OtherLimbsReflectWeaklyAtEqualAngles) {
    SoundScenario scenario = bareFloor();
    const Room room(walker(), scenario, 1);
    const std::vector<WorldCapsule> arm{{{0.4, 0.5, 0}, {0.4, 1.9, 0}, 0.05, 5}};
    const Vector3d source(0, 1.4, 0.3), microphone(0, 1.1, -0.3);
    Room::Query asked = query(source, microphone);
    asked.ends.normal = Vector3d::UnitX();
    asked.least_gain = 1e-9;
    std::vector<EchoPath> echoes;
    room.echoes(asked, arm, {}, echoes);
    ASSERT_EQ(echoes.size(), 2u);
    const Vector3d point = echoes[1].now.last_point_m;
    const Vector3d normal = (point - Vector3d(0.4, point.y(), 0)).normalized();
    EXPECT_NEAR((point - Vector3d(0.4, point.y(), 0)).norm(), 0.05, 1e-3);
    EXPECT_NEAR((source - point).normalized().dot(normal), (microphone - point).normalized().dot(normal),
                0.02);
    EXPECT_LT(echoes[1].gain, 0.3 * airGain((source - microphone).norm(), 1.3));
    EXPECT_GT(echoes[1].gain, 0.01);
    // Not over the limb that carries the board.
    asked.board_segment = 5;
    room.echoes(asked, arm, {}, echoes);
    EXPECT_EQ(echoes.size(), 1u);
}

TEST(Room, ALimbInTheWayIsNoMirror) {
    const Room room(walker(), bareFloor(), 1);
    const std::vector<WorldCapsule> arm{{{0, 0.5, 0}, {0, 1.9, 0}, 0.05, 5}};
    std::vector<EchoPath> echoes;
    Room::Query asked = query({0.01, 1.2, 0.3}, {-0.01, 1.2, -0.3});
    room.echoes(asked, arm, {}, echoes);
    for (const EchoPath& echo : echoes)
        EXPECT_LT(echo.now.last_point_m.y(), 0);  // only the floor's image
}

}  // namespace
}  // namespace noctule::simulation
