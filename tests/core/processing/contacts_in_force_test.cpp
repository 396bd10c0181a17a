// SPDX-License-Identifier: Apache-2.0
// Whose word on the feet holds, and that exports lock them by it.
#include "core/processing/contacts_in_force.h"

#include "core/processing/export_motion.h"
#include "core/processing/pose_runs.h"
#include "tests/core/processing/made_export.h"

namespace noctule {
namespace {

class ContactsInForceTest : public test::MadeExport {
protected:
    void edit(const std::function<void(TakeEdit&)>& change) {
        Take take = Take::open(path(), Access::kReadWrite).value();
        auto edit = TakeEdit::begin(take).value();
        change(edit);
        ASSERT_TRUE(edit.commit());
    }
    /// A run that looked for contacts and found these.
    void addLookingRun(const std::vector<FootContacts>& found) {
        edit([&](TakeEdit& take) {
            const auto run = take.beginRun({0, "pose", "looked", "", "", R"({"ground":"level"})", 1, 1});
            ASSERT_TRUE(run);
            for (int frame = 0; frame < test::kFrames; ++frame)
                ASSERT_TRUE(take.addPose(*run, {std::llround(frame * 1e9 / 140), poseAt(frame / 140.0), {}}));
            ASSERT_TRUE(take.addContacts(*run, found));
        });
    }
    ContactsInForce inForce(const std::string& run_name) const {
        const Take take = Take::open(path()).value();
        const DerivedRun run = choosePoseRun(take, run_name).value();
        return contactsInForce(take, run, take.poses(run.run).value()).value();
    }
};

TEST_F(ContactsInForceTest, TheOperatorsThenTheRunsThenTheMotions) {
    addLookingRun({{"LeftFoot", {{0.5, 0.9, 0}}}});
    const ContactsInForce runs = inForce("looked");
    EXPECT_EQ(runs.from, ContactsFrom::kRun);
    ASSERT_EQ(runs.feet.size(), 1U);
    ASSERT_EQ(runs.feet[0].contacts.size(), 1U);
    EXPECT_EQ(runs.feet[0].contacts[0].to_s, 0.9);
    EXPECT_EQ(inForce("AGD manifold").from, ContactsFrom::kMotion) << "this one did not look";

    edit([](TakeEdit& take) {
        ASSERT_TRUE(take.setContacts(std::vector<FootContacts>{{"RightFoot", {{1, 1.2, 0}}}}));
    });
    for (const char* run : {"looked", "AGD manifold"}) {
        const ContactsInForce edited = inForce(run);
        EXPECT_EQ(edited.from, ContactsFrom::kOperator);
        ASSERT_EQ(edited.feet.size(), 1U);
        EXPECT_EQ(edited.feet[0].foot, "RightFoot");
    }
    edit([](TakeEdit& take) { ASSERT_TRUE(take.setContacts(std::vector<FootContacts>{})); });
    EXPECT_EQ(inForce("looked").from, ContactsFrom::kOperator) << "none at all is also a word";
    EXPECT_TRUE(inForce("looked").feet.empty());
    edit([](TakeEdit& take) { ASSERT_TRUE(take.setContacts(std::nullopt)); });
    EXPECT_EQ(inForce("looked").from, ContactsFrom::kRun);
}

TEST_F(ContactsInForceTest, LockTheFeetOfAnExport) {
    addLookingRun({{"LeftFoot", {{0.5, 0.9, 0}}}});
    request_.worn = std::make_shared<const WearableBody>();  // asked for; its mesh is not looked at here
    request_.run = "looked";
    const auto left = [&] { return exportedMotion(request_).value().feet.plants[0]; };
    ASSERT_EQ(left().size(), 1U);
    EXPECT_NEAR(left()[0].from_s, 0.1, 1e-9) << "the file begins at 0.4 s";
    EXPECT_NEAR(left()[0].to_s, 0.5, 1e-9);
    edit([](TakeEdit& take) {
        ASSERT_TRUE(take.setContacts(std::vector<FootContacts>{
            {"LeftFoot", {{0.5, 0.7, 0}, {0.6, 0.65, 0}, {0.68, 1.1, 0}, {1.2, 1.3, 0}}},
            {"LeftToeBase", {{0.4, 1.6, 0}}}}));
    });
    ASSERT_EQ(left().size(), 2U) << "what overlaps is one, and toes are no foot";
    EXPECT_NEAR(left()[0].from_s, 0.1, 1e-9);
    EXPECT_NEAR(left()[0].to_s, 0.7, 1e-9);
    EXPECT_NEAR(left()[1].from_s, 0.8, 1e-9);
    EXPECT_TRUE(exportedMotion(request_).value().feet.plants[1].empty());
    request_.lock_feet = false;
    EXPECT_TRUE(left().empty());
}

}  // namespace
}  // namespace noctule
