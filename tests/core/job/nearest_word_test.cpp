// SPDX-License-Identifier: Apache-2.0
#include "core/job/nearest_word.h"

#include <gtest/gtest.h>

namespace noctule {
namespace {

TEST(NearestWord, OnlyWordsThatAreNearAreProposed) {
    const std::vector<std::string> known = {"simulate", "evaluate", "out", "to", "q"};
    EXPECT_EQ(nearestWord("evalute", known), "evaluate");
    EXPECT_EQ(nearestWord("simualte", known), "simulate");
    EXPECT_EQ(nearestWord("outt", known), "out");
    for (const char* far : {"", "x", "record", "frobnicate", "into_it"})
        EXPECT_EQ(nearestWord(far, known), "") << far;
    EXPECT_EQ(nearestWord("evalute", {}), "");
}

}  // namespace
}  // namespace noctule
