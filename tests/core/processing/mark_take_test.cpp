// SPDX-License-Identifier: Apache-2.0
#include "core/processing/mark_take.h"

#include "tests/core/processing/made_take.h"

namespace noctule::test {
namespace {

using MarkTake = MadeTake;

TEST_F(MarkTake, AddsAMarkerOfTheOperatorAndKeepsTheRest) {
    addReference(0);
    ASSERT_TRUE(markTake(path(), 1.25, "turn", {}));
    const auto markers = Take::open(path()).value().markers();
    ASSERT_TRUE(markers);
    ASSERT_EQ(markers->size(), 3u);  // with begin and end of the rest pose
    EXPECT_EQ(markers->back().kind, "user");
    EXPECT_EQ(markers->back().label, "turn");
    EXPECT_EQ(markers->back().sample, kRate_hz * 5 / 4);
}

TEST_F(MarkTake, OutsideTheTakeIsRefused) {
    for (const double t_s : {-0.1, 2.1, std::nan("")}) {
        const Status status = markTake(path(), t_s, "", {});
        ASSERT_FALSE(status) << t_s;
        EXPECT_EQ(status.error().kind, ErrorKind::kUsage);
    }
    EXPECT_TRUE(Take::open(path()).value().markers()->empty());
}

TEST_F(MarkTake, AMissingTakeIsNamed) {
    const Status status = markTake(file("none.noctule"), 0, "", {});
    ASSERT_FALSE(status);
    EXPECT_NE(status.error().message.find("none.noctule"), std::string::npos);
}

TEST_F(MarkTake, CancelledLeavesTheTakeAsItWas) {
    CancelFlag cancel;
    cancel.cancel();
    const Status status = markTake(path(), 1, "", {nullptr, &cancel});
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().kind, ErrorKind::kCancelled);
    EXPECT_TRUE(Take::open(path()).value().markers()->empty());
}

}  // namespace
}  // namespace noctule::test
