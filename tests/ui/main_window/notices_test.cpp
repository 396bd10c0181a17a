// SPDX-License-Identifier: Apache-2.0
// What failed is told until it is tried anew, succeeds, or another one is there.
#include "ui/main_window/notices.h"

#include "tests/devices/support/test_box.h"
#include "tests/ui/main_window/studio_fixture.h"

namespace noctule::ui {
namespace {

using noctule::test::TestBox;

class NoticesTest : public test::StudioWindow {
protected:
    QStringList told() const { return window_->notices().titles(); }
    bool connectTo(TestBox& box) {
        studio_->suits().add(QString::fromStdString(box.address()));
        return waitFor([this] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; });
    }
};

TEST_F(NoticesTest, AFailedConnectionIsForgottenWithTheNextOne) {
    studio_->suits().add("nowhere");
    ASSERT_EQ(told().size(), 1);
    TestBox box{{.loops = true}};
    studio_->suits().add(QString::fromStdString(box.address()));
    EXPECT_EQ(told(), QStringList()) << "it is tried anew";
}

TEST_F(NoticesTest, WhatHinderedARecordingIsForgottenWhenOneBegins) {
    ASSERT_TRUE(studio_->session().create(home() + "-notices", "notices"));
    TestBox box{{.loops = true}};
    ASSERT_TRUE(connectTo(box));
    emit studio_->failed("Recording did not begin", "Wait", About::kCapture);
    emit studio_->failed("Something else", "Do something");
    ASSERT_EQ(told().size(), 2);
    ASSERT_EQ(studio_->suits().record({"walk", {}, 0, 0}), "");
    EXPECT_EQ(told(), QStringList{"Something else"});
    ASSERT_TRUE(waitFor([this] { return studio_->suit().recordedSeconds() > 0.2; }));
    studio_->suits().stopRecording();
    EXPECT_TRUE(waitFor([this] { return !studio_->suits().isTakeOpen() && studio_->jobs().idle(); }));
}

TEST_F(NoticesTest, WhatFailedWithOneTakeIsNotToldOfAnother) {
    openSampleTake();
    const QString path = studio_->take().path();
    emit studio_->failed("The marker was not written", "Free some room", About::kTake);
    studio_->take().open(folder_.filePath("nothing.noctule"));
    EXPECT_FALSE(told().contains("The marker was not written"));
    ASSERT_TRUE(waitFor([&] { return told().size() == 1; })) << "the other one cannot be opened";
    studio_->take().open(path);
    EXPECT_TRUE(waitFor([&] { return studio_->take().isOpen() && told().isEmpty(); }))
        << told().join('\n').toStdString();
}

TEST_F(NoticesTest, AFailedProcessingIsForgottenWithTheNext) {
    openSampleTake();
    emit studio_->failed("The take could not be processed", "Free some room", About::kProcess);
    ASSERT_EQ(told().size(), 1);
    studio_->processAccurately(studio_->take().path().toStdString(), {});
    EXPECT_EQ(told(), QStringList());
    EXPECT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
}

TEST_F(NoticesTest, OfFilesTheLatestIsTold) {
    emit studio_->failed("one.csv could not be written", "Free some room", About::kFile);
    emit studio_->failed("two.csv could not be written", "Free some room", About::kFile);
    EXPECT_EQ(told(), QStringList{"two.csv could not be written"});
    studio_->sayOfFile("two.csv is written.");
    EXPECT_EQ(told(), QStringList());
}

}  // namespace
}  // namespace noctule::ui
