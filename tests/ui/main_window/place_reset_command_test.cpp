// SPDX-License-Identifier: Apache-2.0
// The command "Reset heading and place" of the window: when it can be done, and how it is taken back.
#include "tests/devices/support/test_box.h"
#include "tests/ui/main_window/studio_fixture.h"

namespace noctule::ui {
namespace {

using noctule::test::TestBox;

class PlaceResetCommand : public test::StudioWindow {
protected:
    QAction& action(Command command) { return *window_->actions()[command]; }
    FloorMove floor() { return *studio_->suits().current().floor; }
};

TEST_F(PlaceResetCommand, IsThereWhileABodyIsShownLiveAndIsTakenBack) {
    studio_->settings().setValue("record/tones", false);
    QAction &now = action(Command::kResetPlace), &later = action(Command::kResetPlaceLater);
    EXPECT_FALSE(now.isEnabled() || later.isEnabled());
    EXPECT_EQ(now.toolTip(), "No suit is connected. Connect one first.");
    const TestBox box({.loops = true});
    const Take take = std::move(Take::open(noctule::test::kTinyTake).value());
    studio_->suit().connectTo(QString::fromStdString(box.address()),
                              {take.calibrationInForce()->value, take.actorInForce()->value, 0.5});
    ASSERT_TRUE(waitFor([&] { return now.isEnabled() && later.isEnabled(); }));
    EXPECT_EQ(now.toolTip(), "Reset heading and place");
    now.trigger();
    EXPECT_FALSE(floor() == FloorMove{});
    EXPECT_EQ(window_->notices().titles(), QStringList({"Heading and place of Performer 1 are reset"}));
    action(Command::kUndo).trigger();
    EXPECT_TRUE(floor() == FloorMove{});
    EXPECT_EQ(window_->notices().count(), 0) << "its Undo is done";
    later.trigger();
    EXPECT_TRUE(studio_->placeReset().isCounting());
    later.trigger();
    EXPECT_FALSE(studio_->placeReset().isCounting());
    later.trigger();
    ASSERT_TRUE(studio_->placeReset().isCounting());
    studio_->suit().disconnectSuit();
    EXPECT_FALSE(now.isEnabled());
    ASSERT_TRUE(later.isEnabled()) << "a countdown that runs can always be ended";
    later.trigger();
    EXPECT_FALSE(studio_->placeReset().isCounting());
    EXPECT_FALSE(now.isEnabled() || later.isEnabled());
}

TEST_F(PlaceResetCommand, HasKeysThatNothingElseHas) {
    for (const Command command : {Command::kResetPlace, Command::kResetPlaceLater})
        for (const QAction* other : window_->actions().all())
            EXPECT_TRUE(other == &action(command) || other->shortcut() != action(command).shortcut())
                << other->text().toStdString();
}

}  // namespace
}  // namespace noctule::ui
