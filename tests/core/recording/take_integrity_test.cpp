// SPDX-License-Identifier: Apache-2.0
// The check of a whole take: told of, cancelled, and done once.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "core/recording/recover_take.h"
#include "tests/support/stage_fractions.h"
#include "tests/support/take_files.h"

namespace noctule {
namespace {

using test::Folder;
using test::StageFractions;

TEST(TakeIntegrity, TellsHowFarItIs) {
    StageFractions checking("Checking");
    const Status sound = checkIntegrity(test::kTinyTake, checking.job());
    ASSERT_TRUE(sound) << sound.error().text();
    EXPECT_GT(checking.told.size(), 50u);
    EXPECT_TRUE(std::ranges::is_sorted(checking.told));
    EXPECT_GT(checking.told.back(), 0.9);
}

TEST(TakeIntegrity, IsCancelledBetweenTwoPages) {
    StageFractions checking("Checking", 0.3);
    const Status sound = checkIntegrity(test::kTinyTake, checking.job());
    ASSERT_FALSE(sound);
    EXPECT_EQ(sound.error().kind, ErrorKind::kCancelled);
    EXPECT_FALSE(sound.error().is_damage);
    EXPECT_LT(checking.told.back(), 0.35);
}

TEST(TakeIntegrity, ACancelledRecoveryLeavesNothing) {
    const Folder folder;
    const std::string take = test::tinyTake(folder), saved = folder.file("saved.noctule");
    StageFractions checking("Checking", 0.3);
    const auto done = recoverTake(take, saved, checking.job());
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().kind, ErrorKind::kCancelled);
    const std::filesystem::path beside = std::filesystem::path(take).parent_path();
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(beside), {}), 1);
}

TEST(TakeIntegrity, WhatIsKnownToBeDamagedIsNotChecked) {
    const Folder folder;
    const std::string torn = test::tinyTake(folder);
    test::damageRowsOf(torn, "note");
    const Status sound = checkIntegrity(torn, {});
    ASSERT_FALSE(sound);
    EXPECT_TRUE(sound.error().is_damage);
    StageFractions checking("Checking");
    const auto done = recoverTake(torn, folder.file("saved.noctule"), checking.job(), sound.error());
    ASSERT_TRUE(done) << done.error().text();
    ASSERT_TRUE(*done);
    EXPECT_EQ((*done)->tables.at(0).table, "note");
    EXPECT_TRUE(checking.told.empty());
}

}  // namespace
}  // namespace noctule
