// SPDX-License-Identifier: Apache-2.0
// Pictures of Record: without a suit, ready, counting down, recording, and with faults.
#include <QPointer>

#include "core/session/shot_list.h"
#include "tests/ui/main_window/live_pictures.h"
#include "ui/models/countdown_setting.h"
#include "ui/views/record/record_page.h"

namespace noctule::ui {
namespace {

class RecordPictures : public test::LivePictures {
protected:
    RecordRun& run() { return dynamic_cast<RecordPage&>(window_->page(Step::kRecord)).run(); }
    bool recordFor(double seconds) {
        return waitFor([&] { return studio_->suit().recordedSeconds() >= seconds; });
    }
    bool isReady() {
        return waitFor([&] {
            return studio_->check().readiness().verdict == Readiness::Verdict::kReady &&
                   studio_->suit().frame() && studio_->suit().frame()->pose;
        });
    }
    /// The countdown's menu, by itself.
    void saveMenu(const QString& name) {
        QList<QPointer<QPushButton>> buttons;  // cards of readiness come and go meanwhile
        for (auto* button : window_->findChildren<QPushButton*>())
            buttons.append(button);
        for (const auto& button : buttons)
            if (button && button->menu() && button->isVisible()) {
                button->menu()->popup(button->mapToGlobal(QPoint()));
                QTest::qWait(300);
                if (button)
                    saveAs(*button->menu(), name);
                if (button)
                    button->menu()->close();
            }
    }
    void recordOneTake(double seconds) {
        run().press();
        ASSERT_TRUE(recordFor(seconds));
        run().stop();
        ASSERT_TRUE(waitFor([&] { return run().state() == RecordRun::State::kReady; }));
    }
};

TEST_F(RecordPictures, FromWithoutASuitToFaults) {
    window_->goTo(Step::kRecord);
    save("record-without");
    studio_->startVirtualSuit();
    ASSERT_TRUE(isReady());
    QDir().mkpath(home());
    ASSERT_TRUE(studio_->session().create(QDir(home()).filePath("Stage tests"), "Stage tests"));
    window_->goTo(Step::kRecord);
    studio_->session().setShots(
        shotsFromText("Walk, straight line\nReach, high and low\nTurn, both ways x3\nSit and stand x3\n"
                      "Step over a box x2\nKick, each leg x2"));
    CountdownSetting::get().setSeconds(0);
    run().setTones(false);
    run().setOpensReview(false);
    recordOneTake(3);
    recordOneTake(2);
    QTest::qWait(3000);
    save("record-ready");
    saveMenu("record-menu-dark");
    Theme::get().setScheme(Scheme::kLight);
    saveMenu("record-menu-light");
    Theme::get().setScheme(Scheme::kDark);
    CountdownSetting::get().setSeconds(10);
    run().press();
    QTest::qWait(6500);
    Theme::get().setScheme(Scheme::kDark);
    saveAs("record-countdown-dark-1920");
    Theme::get().setScheme(Scheme::kLight);
    QTest::qWait(300);
    saveAs("record-countdown-light-1920");
    Theme::get().setScheme(Scheme::kDark);
    ASSERT_TRUE(recordFor(4));
    run().addMarker();
    QTest::qWait(1500);
    run().addMarker();
    run().addNote("left heel slips");
    save("record-recording");
    saveLarge("record-recording-dark");
    tell("unplug 14");
    ASSERT_TRUE(
        waitFor([&] { return studio_->check().readiness().verdict == Readiness::Verdict::kNotReady; }));
    QTest::qWait(1500);
    save("record-fault");
    run().stop();
    ASSERT_TRUE(waitFor([&] { return run().state() == RecordRun::State::kRefused; }));
    run().press();
    save("record-refused");
}

}  // namespace
}  // namespace noctule::ui
