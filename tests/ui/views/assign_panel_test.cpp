// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/assign_panel.h"

#include <gtest/gtest.h>

#include <QSettings>
#include <QTest>

#include "core/recording/take.h"
#include "tests/devices/support/test_box.h"
#include "tests/support/take_files.h"
#include "tests/ui/support/wait.h"
#include "ui/models/studio.h"
#include "ui/style/theme.h"
#include "ui/widgets/button.h"

namespace noctule::ui {
namespace {

using noctule::test::TakeSound;
using noctule::test::TestBox;

TEST(AssignPanel, GoesOnListeningWhenTheStreamBeginsAnew) {
    Theme::install(*qApp);
    QSettings().clear();
    const noctule::test::Folder home;
    Studio studio{StudioParts{"test", [] { return std::string(); }, {}, {}}};
    studio.settings().setValue("folders/suits", QString::fromStdString(home.file("suits")));
    ASSERT_TRUE(studio.session().create(QString::fromStdString(home.file("s")), "Test"));
    AssignPanel panel(studio);

    TestBox box({});  // silent after its take: nothing is found
    studio.suit().connectTo(QString::fromStdString(box.address()));
    ASSERT_TRUE(waitFor([&] { return studio.suit().phase() == LiveSuit::Phase::kLooking; }));
    const Take take = std::move(Take::open(noctule::test::kTinyTake).value());
    const Calibration calibration = take.calibrationInForce()->value;
    studio.suit().setCalibration(calibration);
    const auto sample = [&] {
        const auto frame = studio.suit().frame();
        return frame && frame->readings.size() == 2 ? frame->sample : 0;
    };
    const int64_t end = TakeSound::tiny().sampleCount();
    ASSERT_TRUE(waitFor([&] { return sample() > end; }));
    panel.findButton()->click();
    ASSERT_TRUE(waitFor(
        [&] { return panel.words().contains("Listening for") && !panel.words().endsWith("for 0 s."); }));

    studio.suit().setCalibration(calibration);
    ASSERT_TRUE(waitFor([&] { return sample() > 0 && sample() < end; })) << "the box plays it once more";
    EXPECT_TRUE(panel.isFinding());
    EXPECT_FALSE(panel.words().contains("for -")) << panel.words().toStdString();
}

}  // namespace
}  // namespace noctule::ui
