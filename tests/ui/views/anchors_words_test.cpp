// SPDX-License-Identifier: Apache-2.0
// What Connect calls a box of anchors, which nobody wears.
#include <QLabel>

#include "tests/devices/support/answerer.h"
#include "tests/ui/views/record_fixture.h"
#include "ui/views/connect/device_card.h"
#include "ui/views/connect/devices_panel.h"
#include "ui/views/connect/readiness_panel.h"
#include "ui/widgets/problem_card.h"

namespace noctule::ui {
namespace {

using AnchorsWords = test::RecordFixture;

TEST_F(AnchorsWords, NoBodyIsToMove) {
    const noctule::test::TestBox room({.loops = true, .fixed = true});
    studio_->suit().connectTo(QString::fromStdString(room.address()));
    ReadinessPanel panel(*studio_);
    ASSERT_TRUE(waitFor([&] { return panel.verdict() == "Connected"; }));
    EXPECT_TRUE(panel.verdictText().startsWith(
        "Without calibration of the source offsets: places of the anchors are found to decimetres only."))
        << panel.verdictText().toStdString();
    const bool told = std::ranges::any_of(panel.cards(), [](const ProblemCard* card) {
        const auto labels = card->findChildren<QLabel*>();
        return std::ranges::any_of(labels, [](const QLabel* label) {
            return label->text().startsWith("Places of the anchors are found to decimetres only.");
        });
    });
    EXPECT_TRUE(told);
}

TEST_F(AnchorsWords, TheyAreAddedAsAnchorsOnceTheyAreKnown) {
    const noctule::test::TestBox suit({.loops = true, .serial = "NB-000001"});
    studio_->suit().connectTo(QString::fromStdString(suit.address()));
    noctule::test::Answerer box(noctule::test::testAnnouncement());
    studio_->finder().start({box.port(), false});
    DevicesPanel devices(*studio_);
    const auto offers = [&](const QString& action) {
        return waitFor([&] {
            return std::ranges::any_of(
                devices.cards(), [&](const DeviceCard* card) { return card->words().action == action; });
        });
    };
    EXPECT_TRUE(offers("Add this suit"));
    studio_->finder().remember("NB-000777", true);
    EXPECT_TRUE(offers("Add these anchors"));
    EXPECT_EQ(devices.cards().size(), 2u) << "and the suit, which is connected";
}

}  // namespace
}  // namespace noctule::ui
