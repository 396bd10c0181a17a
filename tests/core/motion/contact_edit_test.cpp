// SPDX-License-Identifier: Apache-2.0
#include "core/motion/contact_edit.h"

#include <gtest/gtest.h>

namespace noctule {
namespace {

std::vector<FootContacts> two() {
    return {{"LeftFoot", {{1, 2}, {3, 4}}}};
}

TEST(ContactEdit, OneThatTouchesOthersBecomesOneWithThem) {
    ContactPlace place{"LeftFoot", 0};
    const auto feet = withContact(two(), place, {1.5, 3});
    ASSERT_EQ(feet[0].contacts.size(), 1u);
    EXPECT_EQ(feet[0].contacts[0].from_s, 1.5);
    EXPECT_EQ(feet[0].contacts[0].to_s, 4);
    EXPECT_TRUE(feet[0].contacts[0].by_hand);
    EXPECT_EQ(place, (ContactPlace{"LeftFoot", 0}));
}

TEST(ContactEdit, OneThatIsMovedPastAnotherStaysInOrder) {
    ContactPlace place{"LeftFoot", 0};
    const auto feet = withContact(two(), place, {5, 6});
    ASSERT_EQ(feet[0].contacts.size(), 2u);
    EXPECT_EQ(feet[0].contacts[0].from_s, 3);
    EXPECT_FALSE(feet[0].contacts[0].by_hand);
    EXPECT_EQ(place.index, 1);
    EXPECT_EQ(findContact(feet, place)->to_s, 6);
}

TEST(ContactEdit, AFootThatNeverStoodGetsItsOwn) {
    ContactPlace place{"RightFoot"};
    auto feet = withContact(two(), place, {1, 2});
    ASSERT_EQ(feet.size(), 2u);
    EXPECT_EQ(findContact(feet, place)->from_s, 1);
    feet = withoutContact(feet, place);
    EXPECT_EQ(findContact(feet, place), nullptr);
    EXPECT_EQ(feet[0].contacts.size(), 2u);
}

TEST(ContactEdit, NearIsTheOneThereElseTheNextElseTheLast) {
    EXPECT_EQ(contactNear(two(), "LeftFoot", 1.5).index, 0);
    EXPECT_EQ(contactNear(two(), "LeftFoot", 2.5).index, 1);
    EXPECT_EQ(contactNear(two(), "LeftFoot", 9).index, 1);
    EXPECT_EQ(contactNear(two(), "RightFoot", 1).index, -1);
}

}  // namespace
}  // namespace noctule
