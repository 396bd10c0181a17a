// SPDX-License-Identifier: Apache-2.0
// Is the covariance of a root that feet hold honest? Normalised estimation errors squared against the truth.
#include "tests/support/root_consistency.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/formats/bvh.h"
#include "tests/support/files.h"
#include "tests/support/simulated_take.h"

namespace noctule {
namespace {

struct HeldMotion {
    const char* name;
    /// Of the place along the floor. Both feet of a hop land and slip together, longer than is allowed for.
    double most_nees;
};

class HeldRoot : public testing::TestWithParam<HeldMotion> {};

TEST_P(HeldRoot, OfAPersonOnALevelFloor) {
    const std::string motion = std::string("/usr/share/assimp/models/BVH/") + GetParam().name;
    if (!std::filesystem::exists(motion))
        GTEST_SKIP() << "no " << motion << " (package assimp-testmodels)";
    const test::Folder folder;
    const std::string path = folder.file("held.noctule");
    const Status written =
        test::writeSimulatedTake(path, {.clip = toClip(readBvh(motion).value()).value(), .duration_s = 14});
    ASSERT_TRUE(written) << written.error().text();
    const auto root = test::judgeRoot(Take::open(path).value(), {});
    EXPECT_GT(root.count, 150);
    EXPECT_GT(root.nees_horizontal, 0.3);
    EXPECT_LT(root.nees_horizontal, GetParam().most_nees);
    EXPECT_LT(root.nees_vertical, 3);
    EXPECT_GT(root.nees_velocity, 0.3);
    EXPECT_LT(root.nees_velocity, 3);
}

/// Windows of what boards felt are used on flesh only.
TEST(RootConsistency, NothingOnFleshMakesTheHeadingSurer) {
    const std::string motion = "/usr/share/assimp/models/BVH/Boxing_Toes.bvh";
    if (!std::filesystem::exists(motion))
        GTEST_SKIP() << "no " << motion << " (package assimp-testmodels)";
    const test::Folder folder;
    const std::string path = folder.file("fleshy.noctule");
    simulation::Scenario person = simulation::Scenario::realistic();
    person.mounting_rad = person.mounting_m = person.source_position_m = 0;
    const Status written = test::writeSimulatedTake(
        path, {.clip = toClip(readBvh(motion).value()).value(), .duration_s = 14, .scenario = person});
    ASSERT_TRUE(written) << written.error().text();
    const auto root = test::judgeRoot(Take::open(path).value(), {});
    EXPECT_GE(root.yaw_sigma_rad, root.yaw_sigma_begin_rad);
}

INSTANTIATE_TEST_SUITE_P(Motions, HeldRoot,
                         testing::Values(HeldMotion{"Boxing_Toes.bvh", 3}, HeldMotion{"01_01.bvh", 6}),
                         [](const auto& held) { return std::string(held.param.name).substr(0, 5); });

}  // namespace
}  // namespace noctule
