// SPDX-License-Identifier: Apache-2.0
// From launch to an exported take of a live suit, every click counted; and what the live picture costs. The
// box plays the tiny take over TCP in real time. NOCTULE_RECORD_S: another length than two seconds, on a
// machine with nothing else to do; NOCTULE_RECORD_TAKE: another take, with the calibration in it.
#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QMessageBox>
#include <QThread>
#include <QUdpSocket>
#include <cstdio>

#include "core/live/latency.h"
#include "tests/devices/support/answerer.h"
#include "tests/devices/support/test_box.h"
#include "tests/ui/main_window/studio_fixture.h"
#include "tests/ui/support/stall_watch.h"
#include "ui/main_window/preferences_dialog.h"
#include "ui/main_window/status_line.h"
#include "ui/main_window/top_bar.h"
#include "ui/scene/scene_view.h"
#include "ui/views/connect/connect_page.h"
#include "ui/views/connect/device_card.h"
#include "ui/views/connect/devices_panel.h"
#include "ui/views/connect/readiness_panel.h"
#include "ui/views/export/export_page.h"
#include "ui/views/readiness_words.h"
#include "ui/views/record/record_bar.h"
#include "ui/views/record/record_center.h"
#include "ui/views/record/record_page.h"
#include "ui/views/record/record_readiness.h"
#include "ui/widgets/button.h"
#include "ui/widgets/record_button.h"

namespace noctule::ui {
namespace {

using noctule::test::Answerer;
using noctule::test::TestBox;

constexpr int kMostClicks = 12;
constexpr double kSampleToScreen_s = 0.1;
constexpr unsigned kScreenStands_s = 3;

class RecordFlow : public test::StudioWindow {
protected:
    void SetUp() override {
        StudioWindow::SetUp();
        studio_->settings().setValue("record/countdown_s", 0);
        studio_->settings().setValue("record/tones", false);
        announced_ = noctule::test::testAnnouncement();
        announced_.tcp_port = box_.port();
        answerer_.announce(announced_);
    }

    /// What the operator does, and nothing else.
    void click(QAbstractButton* button) {
        ASSERT_NE(button, nullptr);
        ASSERT_TRUE(button->isVisible() && button->isEnabled()) << button->text().toStdString();
        ++clicks_;
        QTest::mouseClick(button, Qt::LeftButton);
    }
    QAbstractButton* visibleButton(const QString& text) {
        for (QAbstractButton* button : window_->findChildren<QAbstractButton*>())
            if (button->text() == text && button->isVisible())
                return button;
        return nullptr;
    }
    template <class PageOfStep>
    PageOfStep& pageOf(Step step) {
        return dynamic_cast<PageOfStep&>(window_->page(step));
    }
    RecordPage& record() { return pageOf<RecordPage>(Step::kRecord); }
    /// "Calibrated before" of the way from launch to an exported take.
    void calibrateAsBefore() {
        const Take take = std::move(Take::open(playedTake()).value());
        studio_->suit().setCalibration(take.calibrationInForce()->value);
    }
    static std::string playedTake() {
        const std::string wanted = qEnvironmentVariable("NOCTULE_RECORD_TAKE").toStdString();
        return wanted.empty() ? noctule::test::kTinyTake : wanted;
    }
    void connectDirectly() {
        const Take take = std::move(Take::open(playedTake()).value());
        studio_->suit().connectTo(QString::fromStdString(box_.address()),
                                  {take.calibrationInForce()->value, take.actorInForce()->value, 0.5});
        ASSERT_TRUE(waitFor([&] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; }));
    }
    static double recordedSeconds() {
        const double wanted = qEnvironmentVariable("NOCTULE_RECORD_S").toDouble();
        return wanted > 0 ? wanted : 2;
    }
    bool recordFor(double seconds) {
        return QTest::qWaitFor([&] { return studio_->suit().recordedSeconds() >= seconds; },
                               30'000 + static_cast<int>(seconds * 1e3));
    }

    TestBox box_{{.loops = true, .take = playedTake()}};
    link::Announcement announced_;
    Answerer answerer_{noctule::test::testAnnouncement()};
    int clicks_ = 0;
};

TEST_F(RecordFlow, FromLaunchToAnExportedTake) {
    studio_->finder().start({answerer_.port(), false});
    ASSERT_TRUE(waitFor([&] { return studio_->finder().suits().size() == 1; })) << "not discovered";
    ASSERT_TRUE(waitFor([&] { return visibleButton("Connect") != nullptr; })) << "its card is not shown";
    click(visibleButton("Connect"));
    ASSERT_EQ(window_->step(), Step::kConnect);
    auto& connect_page = pageOf<ConnectPage>(Step::kConnect);
    ASSERT_TRUE(waitFor([&] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; }));
    calibrateAsBefore();
    ASSERT_TRUE(waitFor([&] { return studio_->check().readiness().verdict == Readiness::Verdict::kReady; }));
    click(connect_page.readiness().wayOn());
    ASSERT_EQ(window_->step(), Step::kRecord);
    ASSERT_TRUE(waitFor([&] {
        return record().run().state() == RecordRun::State::kReady && studio_->suit().frame() &&
               studio_->suit().frame()->pose;
    }));
    click(&record().center().bar().button());
    ASSERT_TRUE(recordFor(recordedSeconds()));
    click(&record().center().bar().button());
    ASSERT_TRUE(waitFor([&] { return window_->step() == Step::kReview && studio_->take().isOpen(); }));
    ASSERT_TRUE(waitFor([&] { return studio_->take().shownMotion() != nullptr; })) << "no result is shown";
    EXPECT_GE(studio_->session().session().takes.at(0).duration_s, recordedSeconds());
    click(visibleButton("Export"));
    ASSERT_EQ(window_->step(), Step::kExport);
    auto& export_page = pageOf<ExportPage>(Step::kExport);
    ASSERT_TRUE(waitFor([&] { return export_page.writeButton()->isEnabled(); }));
    click(export_page.writeButton());
    ASSERT_TRUE(waitFor([&] { return export_page.results().has_value(); }));
    EXPECT_EQ(export_page.results()->written(), 1);
    EXPECT_LE(clicks_, kMostClicks);
    std::printf("%d clicks from launch to an exported take of %.0f s\n", clicks_, recordedSeconds());
}

TEST_F(RecordFlow, TheWindowIsNotMadeAnewUnderATake) {
    ASSERT_TRUE(studio_->session().create(home() + "-anew", "anew"));
    connectDirectly();
    PreferencesDialog preferences(*studio_);
    const auto can_change = [&](bool can) {
        for (const QComboBox* box : {&preferences.language(), &preferences.units()})
            if (box->isEnabled() != can || box->toolTip().contains("being recorded") == can)
                return false;
        return true;
    };
    EXPECT_TRUE(can_change(true));
    EXPECT_EQ(studio_->suits().record({"walk", {}, 0, 0}), "");
    ASSERT_TRUE(recordFor(0.2));
    EXPECT_TRUE(can_change(false)) << "markers and notes would be lost";
    EXPECT_FALSE(PreferencesDialog(*studio_).units().isEnabled()) << "nor when it is opened now";
    studio_->suits().stopRecording();
    EXPECT_TRUE(waitFor([&] { return can_change(true); }));
}

TEST_F(RecordFlow, AllScreensTellOneTimeForWhichThereIsRoom) {
    ASSERT_TRUE(studio_->session().create(home() + "-room", "room"));
    connectDirectly();
    record();
    const auto agree = [&] {
        const auto left_s = studio_->suits().storageLeft_s();
        if (!left_s)
            return false;
        const QString words = durationWords(*left_s);
        const QLabel* on_connect = nullptr;
        for (const QLabel* label : pageOf<ConnectPage>(Step::kConnect).readiness().findChildren<QLabel*>())
            if (label->text() == words)
                on_connect = label;
        return on_connect && window_->statusLine().storageText().contains(words) &&
               record().readiness().value(RecordReadiness::Fact::kStorage).contains(words);
    };
    window_->goTo(Step::kConnect);
    window_->goTo(Step::kRecord);
    EXPECT_TRUE(waitFor(agree)) << window_->statusLine().storageText().toStdString();
    record().run().press();
    ASSERT_TRUE(recordFor(0.5));
    EXPECT_TRUE(waitFor(agree)) << window_->statusLine().storageText().toStdString();
    record().run().stop();
    EXPECT_TRUE(waitFor([&] { return !studio_->suits().isTakeOpen() && studio_->jobs().idle(); }));
}

TEST_F(RecordFlow, CtrlRRecordsFromAnywhereAndTheTopBarShowsIt) {
    ASSERT_TRUE(studio_->session().create(home() + "-live", "live"));
    connectDirectly();
    window_->goTo(Step::kExport);
    QTest::keyClick(window_.get(), Qt::Key_R, Qt::ControlModifier);
    EXPECT_EQ(window_->step(), Step::kRecord);
    ASSERT_TRUE(recordFor(0.3));
    window_->goTo(Step::kExport);
    const auto shown = [&] { return window_->topBar().recordButton().text(); };
    EXPECT_TRUE(waitFor([&] { return shown().startsWith("0:") && shown() != "0:00"; }));
    EXPECT_TRUE(window_->topBar().recordButton().isVisible());
    EXPECT_EQ(studio_->suit().phase(), LiveSuit::Phase::kRecording) << "leaving the page ends no take";
    QTest::keyClick(window_.get(), Qt::Key_R, Qt::ControlModifier);
    EXPECT_TRUE(waitFor([&] { return window_->step() == Step::kReview; }));
    EXPECT_EQ(window_->topBar().recordButton().text(), "Record");
}

TEST_F(RecordFlow, AnotherProgramStartsAndStopsATake) {
    ASSERT_TRUE(studio_->session().create(home() + "-live", "live"));
    connectDirectly();
    QUdpSocket sender;
    sender.bind(QHostAddress(QHostAddress::LocalHost), 0);
    const quint16 port = sender.localPort();  // free, once it is closed
    sender.close();
    studio_->remoteStart().setPort(port);
    studio_->remoteStart().setAllowed(true);
    ASSERT_TRUE(studio_->remoteStart().isListening()) << studio_->remoteStart().problem().toStdString();
    const auto send = [&](const char* what) {
        sender.writeDatagram(QByteArray("<") + what + "><Name VALUE=\"dance\"/></" + what + ">",
                             QHostAddress(QHostAddress::LocalHost), port);
    };
    send("CaptureStart");
    ASSERT_TRUE(recordFor(0.3));
    send("CaptureStop");
    ASSERT_TRUE(waitFor([&] { return studio_->session().session().takes.size() == 1; }));
    EXPECT_EQ(studio_->session().session().takes[0].name, "dance_001");
}

TEST_F(RecordFlow, ClosingTheWindowAsksWhileATakeIsRecorded) {
    ASSERT_TRUE(studio_->session().create(home() + "-live", "live"));
    connectDirectly();
    window_->goTo(Step::kRecord);
    QTest::keyClick(window_.get(), Qt::Key_R, Qt::ControlModifier);
    ASSERT_TRUE(recordFor(0.3));
    QString asked;
    const auto answer = [&asked](const QString& with) {
        QTimer::singleShot(100, qApp, [&asked, with] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (!box)
                return;
            asked = box->text();
            for (QAbstractButton* button : box->buttons())
                if (button->text() == with)
                    return button->click();
        });
    };
    answer("Cancel");
    EXPECT_FALSE(window_->close());
    EXPECT_EQ(asked, "The take is being recorded");
    EXPECT_EQ(studio_->suit().phase(), LiveSuit::Phase::kRecording);
    answer("Stop and close");
    EXPECT_FALSE(window_->close()) << "not before the take is complete";
    EXPECT_TRUE(waitFor([&] { return !window_->isVisible(); }));
    ASSERT_EQ(studio_->session().session().takes.size(), 1U);
    EXPECT_EQ(studio_->session().session().takes[0].state, TakeState::kComplete);
}

TEST_F(RecordFlow, AScreenThatStandsStillLosesNothing) {
    ASSERT_TRUE(studio_->session().create(home() + "-live", "live"));
    connectDirectly();
    window_->goTo(Step::kRecord);
    QTest::keyClick(window_.get(), Qt::Key_R, Qt::ControlModifier);
    ASSERT_TRUE(recordFor(0.3));
    QThread::sleep(kScreenStands_s);
    QTest::keyClick(window_.get(), Qt::Key_R, Qt::ControlModifier);
    ASSERT_TRUE(waitFor([&] { return studio_->session().session().takes.size() == 1; }));
    const SessionTake& item = studio_->session().session().takes[0];
    EXPECT_EQ(item.state, TakeState::kComplete);
    EXPECT_GT(item.duration_s, kScreenStands_s);
    const Result<Take> take = Take::open(studio_->session().session().pathOf(item).string());
    ASSERT_TRUE(take) << take.error().text();
    const auto gaps = take->gaps();
    ASSERT_TRUE(gaps);
    int64_t lost_samples = 0;
    for (const GapRow& gap : *gaps) {
        EXPECT_NE(gap.reason, kGapOfStudio) << "sound was lost while the screen stood still";
        lost_samples += gap.sample_count;
    }
    // A box that finds no core sends less, too; of a studio that does not read next to nothing would come.
    EXPECT_LT(lost_samples, kScreenStands_s * 150'000 / 2);
}

TEST_F(RecordFlow, TheLiveBodyIsOnTheScreenSoonAndLeavesTheInterfaceFree) {
    ASSERT_TRUE(studio_->session().create(home() + "-live", "live"));
    connectDirectly();
    window_->goTo(Step::kRecord);
    ASSERT_TRUE(waitFor([&] { return studio_->suit().frame() && studio_->suit().frame()->pose; }));
    QTest::qWait(500);  // the first picture compiles what the others draw with
    LatencyHistogram sample_to_screen;
    QObject::connect(&record().center().scene(), &SceneView::frameDrawn, window_.get(),
                     [&](const std::shared_ptr<const LiveFrame>& frame) {
                         const int64_t behind = box_.sampledSamples() - frame->sample;
                         if (behind >= 0)  // else another stream has begun
                             sample_to_screen.add(behind * 1'000'000'000 / 150'000);
                     });
    record().run().press();
    ASSERT_TRUE(recordFor(0.5));
    test::StallWatch watch;
    ASSERT_TRUE(recordFor(recordedSeconds() + 0.5));
    std::printf(
        "live: %lld pictures, sample to screen %.0f ms in the median, %.0f ms at the 95th percentile; "
        "longest "
        "gap %.0f ms, of it ours %.0f ms\n",
        static_cast<long long>(sample_to_screen.count()), sample_to_screen.quantile_s(0.5) * 1e3,
        sample_to_screen.quantile_s(0.95) * 1e3, watch.longest_ms(), watch.longestOwn_ms());
    EXPECT_TRUE(waitFor([&] { return sample_to_screen.count() > 10; }));
    if (test::timesAreJudged()) {
        EXPECT_LT(sample_to_screen.quantile_s(0.95), kSampleToScreen_s);
        EXPECT_LT(watch.longestOwn_ms(), test::kLongestStall_ms);
    }
    record().run().stop();
    EXPECT_TRUE(waitFor([&] { return window_->step() == Step::kReview; }));
}

}  // namespace
}  // namespace noctule::ui
