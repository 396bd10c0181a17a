// SPDX-License-Identifier: Apache-2.0
#include "core/processing/held_pose.h"

#include <gtest/gtest.h>

namespace noctule {
namespace {

constexpr int64_t kFrame_ns = 20'000'000, kFirst_ns = 1'000'000'000, kLast_ns = 3'000'000'000;

std::vector<std::string> wordsOf(int64_t before_ns, int64_t after_ns) {
    return heldInWords("Bea", {kFirst_ns, kLast_ns}, kFirst_ns - before_ns, kLast_ns + after_ns, kFrame_ns);
}

TEST(HeldPose, IsToldFromOneFrameOn) {
    EXPECT_TRUE(wordsOf(0, 0).empty());
    EXPECT_TRUE(wordsOf(kFrame_ns - 1, kFrame_ns - 1).empty()) << "nobody sees a part of a frame";
    const auto said = wordsOf(kFrame_ns, kFrame_ns);
    ASSERT_EQ(said.size(), 2U);
    EXPECT_EQ(said[0], "Bea holds its first pose until 1.000 s.");
    EXPECT_EQ(said[1], "Bea holds its last pose from 3.000 s on.");
    EXPECT_EQ(wordsOf(500'000'000, 0).at(0), "Bea holds its first pose until 1.0 s.");
}

}  // namespace
}  // namespace noctule
