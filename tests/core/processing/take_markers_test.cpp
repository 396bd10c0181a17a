// SPDX-License-Identifier: Apache-2.0
#include "core/processing/take_markers.h"

#include "tests/core/processing/made_take.h"

namespace noctule::test {
namespace {

class TakeMarkers : public MadeTake {
protected:
    Status set(double t_s, const std::string& label = "") {
        return changeMarker(path(), {.after = UserMarker{t_s, label}}, {});
    }
    std::vector<std::string> labels() const {
        std::vector<std::string> labels;
        const auto markers = Take::open(path()).value().markers().value();
        for (const MarkerRow& marker : markers)
            labels.push_back(marker.label);
        return labels;
    }
};

TEST_F(TakeMarkers, AddsAMarkerOfTheOperatorAndKeepsTheRest) {
    addReference(0);
    ASSERT_TRUE(set(1.25, "turn"));
    const auto markers = Take::open(path()).value().markers();
    ASSERT_TRUE(markers);
    ASSERT_EQ(markers->size(), 3u);  // with begin and end of the rest pose
    EXPECT_EQ(markers->back().kind, "user");
    EXPECT_EQ(markers->back().label, "turn");
    EXPECT_EQ(markers->back().sample, kRate_hz * 5 / 4);
}

TEST_F(TakeMarkers, RenamingAndDeletingAreChangesThatGoBack) {
    ASSERT_TRUE(set(0.5, "a"));
    ASSERT_TRUE(set(1.5, "b"));
    const MarkerChange rename{UserMarker{0.5, "a"}, UserMarker{0.5, "jump"}};
    ASSERT_TRUE(changeMarker(path(), rename, {}));
    EXPECT_EQ(labels(), (std::vector<std::string>{"jump", "b"}));
    ASSERT_TRUE(changeMarker(path(), rename.reversed(), {}));
    EXPECT_EQ(labels(), (std::vector<std::string>{"a", "b"}));
    const MarkerChange deletion{.before = UserMarker{0.5, "a"}};
    ASSERT_TRUE(changeMarker(path(), deletion, {}));
    EXPECT_EQ(labels(), std::vector<std::string>{"b"});
    ASSERT_TRUE(changeMarker(path(), deletion.reversed(), {}));
    EXPECT_EQ(labels(), (std::vector<std::string>{"a", "b"}));
}

TEST_F(TakeMarkers, OneOfTwoEqualMarkersGoes) {
    ASSERT_TRUE(set(1, "same"));
    ASSERT_TRUE(set(1, "same"));
    ASSERT_TRUE(changeMarker(path(), {.before = UserMarker{1, "same"}}, {}));
    EXPECT_EQ(labels(), std::vector<std::string>{"same"});
}

TEST_F(TakeMarkers, WhatIsNotThereIsNotReplaced) {
    ASSERT_TRUE(set(1, "a"));
    const Status status = changeMarker(path(), {UserMarker{1, "b"}, UserMarker{1, "c"}}, {});
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().kind, ErrorKind::kUsage);
    EXPECT_EQ(labels(), std::vector<std::string>{"a"});
}

TEST_F(TakeMarkers, OutsideTheTakeIsRefused) {
    for (const double t_s : {-0.1, 2.1, std::nan("")}) {
        const Status status = set(t_s);
        ASSERT_FALSE(status) << t_s;
        EXPECT_EQ(status.error().kind, ErrorKind::kUsage);
    }
    EXPECT_TRUE(Take::open(path()).value().markers()->empty());
}

TEST_F(TakeMarkers, AMissingTakeIsNamed) {
    const Status status = changeMarker(file("none.noctule"), {.after = UserMarker{}}, {});
    ASSERT_FALSE(status);
    EXPECT_NE(status.error().message.find("none.noctule"), std::string::npos);
}

TEST_F(TakeMarkers, CancelledLeavesTheTakeAsItWas) {
    CancelFlag cancel;
    cancel.cancel();
    const Status status = changeMarker(path(), {.after = UserMarker{1}}, {nullptr, &cancel});
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().kind, ErrorKind::kCancelled);
    EXPECT_TRUE(Take::open(path()).value().markers()->empty());
}

}  // namespace
}  // namespace noctule::test
