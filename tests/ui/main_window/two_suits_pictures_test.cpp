// SPDX-License-Identifier: Apache-2.0
// Pictures of two virtual suits on Connect, on Record and in Review, and of one whose program ends.
#include <signal.h>

#include "tests/ui/main_window/live_pictures.h"
#include "ui/models/countdown_setting.h"
#include "ui/views/record/record_page.h"

namespace noctule::ui {
namespace {

class TwoSuitsPictures : public test::LivePictures {};

TEST_F(TwoSuitsPictures, FromConnectToReview) {
    if (!studio_->virtualSuit().canBeTwo())
        GTEST_SKIP() << "NOCTULE_SCREENSHOT_PAIR is not set";
    LiveSuits& suits = studio_->suits();
    const auto bothMove = [&] {
        const auto all = suits.connected();
        return all.size() == 2 && std::ranges::all_of(all, [](const SuitInUse* worn) {
                   return worn->suit.frame() && worn->suit.frame()->pose;
               });
    };
    QDir().mkpath(home());
    ASSERT_TRUE(studio_->session().create(QDir(home()).filePath("Stage duet"), "Stage duet"));
    studio_->startVirtualSuit();
    ASSERT_TRUE(waitFor([&] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; }));
    window_->goTo(Step::kConnect);
    studio_->startSecondVirtualSuit();
    ASSERT_TRUE(waitFor(bothMove));
    QTest::qWait(5000);
    save("two-connect", {{1440, 900}, {1280, 800}, {1920, 1080}});
    window_->goTo(Step::kRecord);
    suits.setCurrent(*suits.connected()[0]);
    RecordRun& run = dynamic_cast<RecordPage&>(window_->page(Step::kRecord)).run();
    CountdownSetting::get().setSeconds(0);
    run.setTones(false);
    run.setName("turn");
    QTest::qWait(3000);
    save("two-ready", {{1440, 900}});
    run.press();
    run.recordAnyway();
    ASSERT_TRUE(waitFor([&] { return suits.recordedSeconds() > 5; }));
    run.addMarker();
    save("two-recording", {{1440, 900}, {1280, 800}, {1920, 1080}});
    run.stop();
    ASSERT_TRUE(waitFor([&] { return studio_->take().isOpen() && studio_->take().shownMotion(); }));
    QTest::qWait(3000);
    save("two-review", {{1440, 900}, {1280, 800}, {1920, 1080}});
    window_->goTo(Step::kRecord);
    ASSERT_TRUE(waitFor(bothMove));
    run.setOpensReview(false);
    run.press();
    run.recordAnyway();
    ASSERT_TRUE(waitFor([&] { return suits.recordedSeconds() > 2; }));
    kill(static_cast<pid_t>(studio_->secondVirtualSuit().processId()), SIGKILL);
    QTest::qWait(3000);
    save("two-lost", {{1440, 900}});
    run.stop();
    ASSERT_TRUE(waitFor([&] { return !suits.isTakeOpen() && studio_->jobs().idle(); }));
}

}  // namespace
}  // namespace noctule::ui
