// SPDX-License-Identifier: Apache-2.0
// What step Record shows of a suit whose link breaks while it is recorded.
#include <QLabel>

#include "core/live/heard_window.h"
#include "tests/ui/views/record_fixture.h"
#include "ui/plots/level_meters.h"
#include "ui/plots/pairs_heard.h"
#include "ui/scene/live_scene.h"
#include "ui/views/record/levels_panel.h"
#include "ui/views/record/record_readiness.h"

namespace noctule::ui {
namespace {

using noctule::test::TestBox;
using RecordLost = test::RecordFixture;

TEST_F(RecordLost, ALostSuitKeepsNoLevelsAndSaysSinceWhen) {
    TestBox box({.loops = true});
    openSession();
    ASSERT_TRUE(connectTo(box));
    run().setOpensReview(false);
    ASSERT_TRUE(recordFor(1));
    const LevelsPanel& levels = page_->center().levels();
    LevelMeters& meters = page_->center().levels().meters();
    ASSERT_TRUE(waitFor([&] { return meters.levels().size() == 2 && !levels.pairsInWords().isEmpty(); }));
    box.freeze(true);
    box.cut();
    ASSERT_TRUE(waitFor([&] { return levels.pairsInWords().startsWith("0 of 4 good now. Lost since 0:0"); }))
        << levels.pairsInWords().toStdString();
    EXPECT_TRUE(meters.levels().empty());
    QTest::qWait(200);
    EXPECT_TRUE(meters.levels().empty()) << "nothing brings back what was heard before";
    box.freeze(false);
    EXPECT_TRUE(waitFor([&] { return meters.levels().size() == 2; })) << "it is back";
    EXPECT_FALSE(levels.pairsInWords().contains("Lost"));
    run().stop();
    ASSERT_TRUE(waitFor([this] { return session().takes.size() == 1; }));
}

/// The box answers and sends hardly a block: the link is not lost.
TEST_F(RecordLost, AStalledSuitKeepsNoLevelsEither) {
    TestBox box({.loops = true});
    openSession();
    ASSERT_TRUE(connectTo(box));
    const LevelsPanel& levels = page_->center().levels();
    LevelMeters& meters = page_->center().levels().meters();
    ASSERT_TRUE(waitFor([&] { return meters.levels().size() == 2 && !levels.pairsInWords().isEmpty(); }));
    box.stutter(true);
    ASSERT_TRUE(waitFor([&] { return levels.pairsInWords().contains("Nothing has arrived since "); }))
        << levels.pairsInWords().toStdString();
    EXPECT_TRUE(levels.pairsInWords().startsWith("0 of 4 good now. "));
    EXPECT_TRUE(studio_->suits().current().check.nothingSince().isValid());
    EXPECT_TRUE(meters.levels().empty());
    box.stutter(false);
    EXPECT_TRUE(waitFor([&] { return meters.levels().size() == 2; })) << "it flows again";
    EXPECT_FALSE(levels.pairsInWords().contains("since"));
}

TEST_F(RecordLost, WhatItToldLastIsMarkedAndTheRestIsNotKnown) {
    TestBox box({.loops = true, .temperature_c = 23.0F});
    openSession();
    ASSERT_TRUE(connectTo(box));
    using Fact = RecordReadiness::Fact;
    RecordReadiness& readiness = page_->readiness();
    readiness.show();
    const auto isMarked = [&] {
        const auto labels = readiness.findChildren<QLabel*>();
        return std::ranges::any_of(labels, [](const QLabel* label) {
            return label->text() == "last known" && !label->parentWidget()->isHidden();
        });
    };
    ASSERT_TRUE(waitFor([&] {
        return readiness.value(Fact::kLink).contains("MB/s") && readiness.value(Fact::kBoards) == "2 of 2" &&
               !readiness.value(Fact::kAir).isEmpty();
    }));
    EXPECT_TRUE(studio_->check().bytesPerSecond());
    EXPECT_FALSE(isMarked());
    box.freeze(true);
    box.cut();
    ASSERT_TRUE(waitFor([&] { return readiness.value(Fact::kLink) == "broken"; }));
    EXPECT_EQ(readiness.value(Fact::kView), QChar(0x2013)) << "no latency";
    EXPECT_EQ(readiness.value(Fact::kBoards), "");
    EXPECT_FALSE(readiness.value(Fact::kAir).isEmpty());
    EXPECT_TRUE(isMarked());
    EXPECT_TRUE(waitFor([&] { return !studio_->check().bytesPerSecond(); }));
    box.freeze(false);
    EXPECT_TRUE(waitFor([&] { return studio_->check().bytesPerSecond() && !isMarked(); })) << "it is back";
    readiness.hide();
}

TEST_F(RecordLost, ItsBodyFadesAndHearsNothing) {
    TestBox box({.loops = true});
    openSession();
    ASSERT_TRUE(connectTo(box));
    const LiveSuit& suit = studio_->suit();
    ASSERT_TRUE(waitFor([&] {
        return suit.frame() && suit.frame()->pose && suit.frame()->pose->pose &&
               std::ranges::any_of(suit.frame()->ranges, [](const auto& range) { return range.has_value(); });
    }));
    const auto frame = suit.frame();
    LiveScene scene;
    scene.setWearer({suit.actor(), suit.suit(), suit.calibration()});
    scene.setFrame(frame, false);
    const ComposedScene followed = scene.compose(*studio_, {});
    scene.setFrame(frame, true);
    const ComposedScene lost = scene.compose(*studio_, {});
    ASSERT_FALSE(lost.scene.bones.empty());
    EXPECT_LT(lost.scene.bones[0].color.a, followed.scene.bones[0].color.a / 2);
    EXPECT_TRUE(lost.pairs.empty());
    EXPECT_TRUE(lost.scene.rays.empty());
    EXPECT_EQ(lost.pair_count, followed.pair_count);
}

}  // namespace
}  // namespace noctule::ui
