// SPDX-License-Identifier: Apache-2.0
// Is the covariance of a root that feet hold honest? Normalised estimation errors squared against the truth.
#include "tests/support/root_consistency.h"

#include <gtest/gtest.h>

#include "core/formats/bvh.h"
#include "tests/support/files.h"
#include "tests/support/simulated_take.h"

namespace noctule {
namespace {

constexpr const char* kWalkedSteps = NOCTULE_SOURCE_DIR "/resources/motions/sample.bvh";

/// One path is one sample of an error that grows: the mean over some suits counts.
TEST(RootConsistency, OfStepsOnALevelFloor) {
    constexpr int kSuits = 3;
    test::RootConsistency mean;
    for (uint64_t seed = 1; seed <= kSuits; ++seed) {
        const test::Folder folder;
        const std::string path = folder.file("steps.noctule");
        const Status written = test::writeSimulatedTake(
            path, {.clip = toClip(readBvh(kWalkedSteps).value()).value(), .duration_s = 14, .seed = seed});
        ASSERT_TRUE(written) << written.error().text();
        const auto root = test::judgeRoot(Take::open(path).value(), {});
        EXPECT_GT(root.count, 150);
        mean.nees_horizontal += root.nees_horizontal / kSuits;
        mean.nees_vertical += root.nees_vertical / kSuits;
        mean.nees_velocity += root.nees_velocity / kSuits;
    }
    for (const double nees : {mean.nees_horizontal, mean.nees_vertical, mean.nees_velocity}) {
        EXPECT_GT(nees, 0.2);
        EXPECT_LT(nees, 3);
    }
    std::printf("NEES along the floor %.2f, of the height %.2f, of the velocity %.2f\n", mean.nees_horizontal,
                mean.nees_vertical, mean.nees_velocity);
}

}  // namespace
}  // namespace noctule
