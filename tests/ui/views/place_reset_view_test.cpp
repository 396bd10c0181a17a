// SPDX-License-Identifier: Apache-2.0
// Where the live picture shows a body whose heading and place were reset.
#include "core/math/rotation.h"
#include "tests/ui/views/record_fixture.h"
#include "ui/scene/live_scene.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

using PlaceResetView = test::RecordFixture;

TEST_F(PlaceResetView, TheBodyStandsInItsRowAndFacesForward) {
    const Take take = std::move(Take::open(noctule::test::kTinyTake).value());
    const LiveWearer wearer{take.actorInForce()->value, take.suit().value(),
                            take.calibrationInForce()->value};
    Pose pose = wearer.actor.restPose();
    const Vector3d at_rest = pose.p_world_root;
    pose.p_world_root += Vector3d(1, 0, 2);
    pose.q_parent_joint[0] = axisAngle(Vector3d::UnitY(), radians(70)) * pose.q_parent_joint[0];
    auto frame = std::make_shared<LiveFrame>();
    frame->pose = TimedPose{0, pose, {}};
    LiveScene scene;
    scene.setWearer(wearer);
    const auto root = [&] {
        const ComposedScene composed = scene.compose(*studio_, {});
        const GlobalPose& joints = composed.places.joints;
        return std::pair(joints.p_world_joint.at(0), floorHeading(joints.q_world_joint.at(0)));
    };
    scene.setFrame(frame, false);
    EXPECT_NEAR(root().second, radians(70), 1e-9);
    scene.setFrame(frame, false, moveToOrigin(pose));
    EXPECT_LT((root().first - at_rest).norm(), 1e-9);
    EXPECT_NEAR(root().second, 0, 1e-9);
    scene.setCompany(1, {LiveCompanion{wearer, frame, 0, false, moveToOrigin(pose)}});
    EXPECT_LT((root().first - at_rest - LiveScene::kApart_m * Vector3d::UnitX()).norm(), 1e-9);
    const ComposedScene both = scene.compose(*studio_, {});
    EXPECT_LT(both.others.min().x(), at_rest.x()) << "the other one stands at the row's beginning";
    EXPECT_GT(both.others.max().x(), at_rest.x());
}

TEST_F(PlaceResetView, TheButtonSaysWhyItIsGreyAndTheTakesListTellsOfIt) {
    ToolButton& button = page_->center().placeResetButton();
    EXPECT_FALSE(button.isEnabled());
    EXPECT_EQ(button.toolTip(), "No suit is connected. Connect one first.");
    const noctule::test::TestBox box({.loops = true});
    openSession();
    ASSERT_TRUE(connectTo(box));
    run().setOpensReview(false);
    ASSERT_TRUE(recordFor(0.5));
    ASSERT_TRUE(waitFor([&] { return button.isEnabled(); }));
    button.click();
    ASSERT_EQ(run().marks().size(), 1u);
    EXPECT_EQ(run().marks()[0].text, "heading and place reset");
    EXPECT_FALSE(*studio_->suits().current().floor == FloorMove{});
    run().stop();
    ASSERT_TRUE(waitFor([this] { return session().takes.size() == 1; }));
}

TEST_F(PlaceResetView, EscEndsTheCountdownAlsoOnceTheSuitIsGone) {
    studio_->settings().setValue("record/tones", false);
    const noctule::test::TestBox box({.loops = true});
    ASSERT_TRUE(connectTo(box));
    PlaceReset& place = studio_->placeReset();
    ASSERT_TRUE(waitFor([&] { return place.whyNot().isEmpty(); }));
    place.resetLater();
    ASSERT_TRUE(place.isCounting());
    studio_->suit().disconnectSuit();
    ASSERT_FALSE(place.whyNot().isEmpty());
    QTest::keyClick(page_.get(), Qt::Key_Escape);
    EXPECT_FALSE(place.isCounting());
}

}  // namespace
}  // namespace noctule::ui
