// SPDX-License-Identifier: Apache-2.0
#include "core/processing/take_contacts.h"

#include "tests/core/processing/made_take.h"

namespace noctule::test {
namespace {

class TakeContacts : public MadeTake {
protected:
    std::optional<std::vector<FootContacts>> edited(int suit = 1) const {
        return Take::open(path()).value().editedContacts(suit).value();
    }
};

TEST_F(TakeContacts, AreSetAndGoBack) {
    const ContactsChange change{.after = {{{"LeftFoot", {{0.5, 1}, {1.25, 1.5, 0, true}}}}}};
    EXPECT_FALSE(edited());
    ASSERT_TRUE(changeContacts(path(), change, {}));
    const auto feet = edited();
    ASSERT_TRUE(feet);
    ASSERT_EQ(feet->size(), 1u);
    ASSERT_EQ(feet->front().contacts.size(), 2u);
    EXPECT_FALSE(feet->front().contacts[0].by_hand);
    EXPECT_TRUE(feet->front().contacts[1].by_hand);
    EXPECT_NEAR(feet->front().contacts[1].to_s, 1.5, 1e-9);
    ASSERT_TRUE(changeContacts(path(), change.reversed(), {}));
    EXPECT_FALSE(edited());
}

TEST_F(TakeContacts, OutsideTheTakeOrBackwardsAreRefusedAndChangeNothing) {
    ASSERT_TRUE(changeContacts(path(), {.after = {{{"LeftFoot", {{0.5, 1}}}}}}, {}));
    for (const FootContact bad : {FootContact{-0.1, 1}, {1, 2.5}, {1, 1}, {1.5, 1}}) {
        const Status status = changeContacts(path(), {.after = {{{"LeftFoot", {bad}}}}}, {});
        ASSERT_FALSE(status);
        EXPECT_EQ(status.error().kind, ErrorKind::kUsage);
    }
    EXPECT_EQ(edited()->front().contacts[0].from_s, 0.5);
}

TEST_F(TakeContacts, OfOneSuitAreNotThoseOfAnother) {
    Take take = Take::open(path(), Access::kReadWrite).value();
    auto edit = TakeEdit::begin(take).value();
    ASSERT_TRUE(edit.setContacts(std::vector<FootContacts>{{"LeftFoot", {{0.5, 1}}}}, 2));
    ASSERT_TRUE(edit.commit());
    EXPECT_FALSE(edited());
    ASSERT_TRUE(edited(2));
    EXPECT_EQ(edited(2)->size(), 1u);
}

TEST_F(TakeContacts, RowsOfOthersThatDoNotSayByWhomAreAnOperators) {
    {
        Take take = Take::open(path(), Access::kReadWrite).value();
        auto edit = TakeEdit::begin(take).value();
        ASSERT_TRUE(edit.setContacts(std::vector<FootContacts>{{"LeftFoot", {{0.5, 1}}}}));
        ASSERT_TRUE(edit.commit());
    }
    auto database = Database::open(path(), Access::kReadWrite);
    ASSERT_TRUE(database);
    ASSERT_TRUE(database->execute("UPDATE contact SET by_hand=NULL"));
    EXPECT_TRUE(edited()->front().contacts[0].by_hand);
}

}  // namespace
}  // namespace noctule::test
