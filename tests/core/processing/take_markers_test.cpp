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

/// Somebody whose box began a quarter of a second after that of the room, which stands first.
std::string lateTake(const Folder& folder) {
    const std::string path = folder.file("late.noctule");
    Suit room{"room", {}, {}}, worn{"worn", {}, {}};
    room.boards.emplace_back().id = "anchor";
    worn.boards.emplace_back().id = "chest";
    worn.boards[0].segment = "Chest";
    TakeHeader header;
    header.name = "late";
    header.uuid = "0";
    header.created_utc = "2026-01-01T00:00:00Z";
    header.sample_rate_hz = kRate_hz;
    header.board_count = 1;
    auto take = TakeWriter::create(path, header);
    EXPECT_TRUE(take);
    EXPECT_TRUE(take->setMeta("level", "readings"));
    EXPECT_TRUE(take->setMeta("sample_count", std::to_string(2 * kRate_hz)));
    EXPECT_TRUE(take->setMeta("subjects", R"([{"room":true,"suits":[1]},{"name":"Ada","suits":[2]}])"));
    EXPECT_TRUE(take->addSuit(room));
    EXPECT_TRUE(take->addSuit(worn, SuitClock{0.25e9, 1}));
    EXPECT_TRUE(take->addActor(defaultActor(), "", 2));
    EXPECT_TRUE(take->finish());
    return path;
}

TEST_F(TakeMarkers, StandOnTheTakesClockWithWhomTheMarkersAreReadOf) {
    const Folder folder;
    const std::string late = lateTake(folder);
    const MarkerChange set{.after = UserMarker{1.25, "turn"}};
    const Status status = changeMarker(late, set, {});
    ASSERT_TRUE(status) << status.error().text();
    auto take = Take::open(late).value();
    EXPECT_TRUE(take.markers(1)->empty()) << "the room has none";
    const auto markers = take.markers(2);
    ASSERT_EQ(markers->size(), 1u);
    EXPECT_EQ(markers->front().sample, kRate_hz) << "of a box that began later";
    const auto clock = markerClock(take);
    ASSERT_TRUE(clock);
    EXPECT_DOUBLE_EQ(clock->seconds(markers->front().sample), 1.25);
    EXPECT_TRUE(changeMarker(late, set.reversed(), {})) << "it is found again";
    EXPECT_TRUE(Take::open(late).value().markers(2)->empty());
    EXPECT_FALSE(changeMarker(late, {.after = UserMarker{0.1, "early"}}, {})) << "the box was not there yet";
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
