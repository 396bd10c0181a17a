// SPDX-License-Identifier: Apache-2.0
// Nothing keeps the interface from answering for more than 50 ms, whatever is opened, computed or played.
// Times are judged where nothing else needs the cores (packaging/acceptance.sh studio), elsewhere the cases
// skip.
#include <QElapsedTimer>
#include <atomic>
#include <cstdio>
#include <thread>

#include "tests/ui/main_window/studio_fixture.h"
#include "tests/ui/support/stall_watch.h"

namespace noctule::ui {
namespace {

constexpr int kFirstWindow_ms = 1500;

class Stalls : public test::StudioWindow {
protected:
    void SetUp() override {
        if (!test::timesAreJudged())
            GTEST_SKIP() << test::kWhyNotJudged;
        test::StudioWindow::SetUp();
    }
    void expectFree(const test::StallWatch& watch, const char* during) {
        std::printf("%s: longest gap %.0f ms, of it ours %.0f ms\n", during, watch.longest_ms(),
                    watch.longestOwn_ms());
        EXPECT_LT(watch.longestOwn_ms(), test::kLongestStall_ms) << during;
    }
};

TEST_F(Stalls, OpeningATakeLeavesTheInterfaceFree) {
    test::StallWatch watch;
    openSampleTake();
    QTest::qWait(1000);
    expectFree(watch, "making, processing and opening a take");
}

TEST_F(Stalls, GoingToAPageLeavesTheInterfaceFree) {
    openSampleTake();
    QTest::qWait(1000);
    struct Visit {
        Step step;
        const char* name;
    };
    for (const Visit& visit : {Visit{Step::kConnect, "Connect"},
                               {Step::kCalibrate, "Calibrate"},
                               {Step::kRecord, "Record"},
                               {Step::kExport, "Export"},
                               {Step::kReview, "Review again"},
                               {Step::kStart, "start page again"},
                               {Step::kPerformer, "Performer"},
                               {Step::kRobot, "Robot"},
                               {Step::kReview, "Review after Performer"}}) {
        test::StallWatch watch;
        window_->goTo(visit.step);
        QTest::qWait(400);
        expectFree(watch, visit.name);
    }
}

TEST_F(Stalls, AJobLeavesTheInterfaceFree) {
    openSampleTake();
    QTest::qWait(500);
    test::StallWatch watch;
    ProcessRequest request;
    request.take_path = studio_->take().path().toStdString();
    request.tracker.sensors = {false, true, false};
    Job* job = studio_->process(request);
    ASSERT_TRUE(waitFor([&] { return job->state() != Job::State::kRunning; }));
    QTest::qWait(300);
    expectFree(watch, "processing");
}

TEST_F(Stalls, PlayingLeavesTheInterfaceFree) {
    openSampleTake();
    QTest::qWait(500);
    test::StallWatch watch;
    studio_->time().play();
    QTest::qWait(2000);
    studio_->time().pause();
    expectFree(watch, "playing");
}

TEST(StallWatch, SeesAStall) {
    test::StallWatch watch;
    QTimer::singleShot(20, qApp, [] { QTest::qSleep(200); });
    QTest::qWait(400);
    EXPECT_GT(watch.longest_ms(), 190);
    EXPECT_GT(watch.longestOwn_ms(), 100) << "a thread that sleeps does not wait for a core";
}

TEST(StallWatch, ForgivesAMachineWithoutCores) {
    test::StallWatch watch;
    if (!watch.seesQueue())
        GTEST_SKIP() << "the kernel keeps no schedstat";
    // Four times as many as there are cores compute beside this thread, which computes too.
    std::atomic<bool> ended = false;
    std::vector<std::thread> others;
    for (unsigned i = 0; i < 4 * std::max(1U, std::thread::hardware_concurrency()); ++i)
        others.emplace_back([&] {
            while (!ended)
                continue;
        });
    watch.restart();
    QElapsedTimer clock;
    clock.start();
    QTimer::singleShot(0, qApp, [&clock] {
        while (clock.elapsed() < 300)
            continue;
    });
    QTest::qWait(400);
    ended = true;
    for (std::thread& other : others)
        other.join();
    EXPECT_GT(watch.longest_ms(), 290);
    EXPECT_LT(watch.longestOwn_ms(), 0.7 * watch.longest_ms());
}

TEST_F(Stalls, TheWindowIsThereQuickly) {
    TearDown();
    QElapsedTimer clock;
    clock.start();
    StudioParts parts;
    parts.software = "noctule 0.1.0";
    parts.utc_now = [] { return std::string("2026-01-01T00:00:00Z"); };
    studio_ = std::make_unique<Studio>(parts);
    window_ = std::make_unique<MainWindow>(*studio_);
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    QCoreApplication::processEvents();
    RecordProperty("first_window_ms", std::to_string(clock.elapsed()));
    EXPECT_LT(clock.elapsed(), kFirstWindow_ms);
}

}  // namespace
}  // namespace noctule::ui
