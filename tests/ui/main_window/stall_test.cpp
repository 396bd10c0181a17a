// SPDX-License-Identifier: Apache-2.0
// Nothing should keep the interface from answering for more than 50 ms, whatever is opened, computed or
// played; what does yet stands below by name. Each gap is judged without the time in which the machine had no
// core for the thread (stall_watch.h), because other jobs share the cores of a test machine.
#include <QElapsedTimer>
#include <atomic>
#include <cstdio>
#include <thread>

#include "tests/ui/main_window/studio_fixture.h"
#include "tests/ui/support/stall_watch.h"

namespace noctule::ui {
namespace {

#ifdef NOCTULE_SANITIZED
constexpr double kSlower = 10;
#else
constexpr double kSlower = 1;
#endif
constexpr double kLongest_ms = 50 * kSlower;
// Not there yet; the limits only keep it from growing. Measured on two cores, idle and with a load of ten:
// - the first frame of a 3D view (opening 139 to 168 ms, Performer 178 to 256): with a software OpenGL a
//   tenth of all samples of the thread lie in LLVM, which compiles shaders where is drawn;
// - what draws a 3D view or a session's picture while or before the interface answers, because the CPU draws
// it:
//   processing 31 to 86, playing 49 to 83, Review again 55 to 75, the start page again 49 to 52, Review after
//   Performer 57 to 117;
// - Record for the first time (61 ms): its page with a 3D view is made;
// - Connect for the first time (84 to 157 ms): the body's figure is built and painted, twice as the layout
// settles.
constexpr double kFirst3DView_ms = 400 * kSlower, kFirstConnect_ms = 300 * kSlower,
                 kFirstRecord_ms = 100 * kSlower, kOther3DView_ms = 200 * kSlower;
constexpr int kFirstWindow_ms = static_cast<int>(1500 * kSlower);

class Stalls : public test::StudioWindow {
protected:
    void expectFree(const test::StallWatch& watch, const char* during, double longest_ms = kLongest_ms) {
        std::printf("%s: longest gap %.0f ms, of it ours %.0f ms\n", during, watch.longest_ms(),
                    watch.longestOwn_ms());
        EXPECT_LT(watch.longestOwn_ms(), longest_ms) << during;
    }
};

TEST_F(Stalls, OpeningATakeLeavesTheInterfaceFree) {
    test::StallWatch watch;
    openSampleTake();
    QTest::qWait(1000);
    expectFree(watch, "making, processing and opening a take", kFirst3DView_ms);
}

TEST_F(Stalls, GoingToAPageLeavesTheInterfaceFree) {
    openSampleTake();
    QTest::qWait(1000);
    struct Visit {
        Step step;
        const char* name;
        double longest_ms = kLongest_ms;
    };
    for (const Visit& visit : {Visit{Step::kConnect, "Connect", kFirstConnect_ms},
                               {Step::kCalibrate, "Calibrate"},
                               {Step::kRecord, "Record", kFirstRecord_ms},
                               {Step::kExport, "Export"},
                               {Step::kReview, "Review again", kOther3DView_ms},
                               {Step::kStart, "start page again", kOther3DView_ms},
                               {Step::kPerformer, "Performer", kFirst3DView_ms},
                               {Step::kReview, "Review after Performer", kOther3DView_ms}}) {
        test::StallWatch watch;
        window_->goTo(visit.step);
        QTest::qWait(400);
        expectFree(watch, visit.name, visit.longest_ms);
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
    expectFree(watch, "processing", kOther3DView_ms);
}

TEST_F(Stalls, PlayingLeavesTheInterfaceFree) {
    openSampleTake();
    QTest::qWait(500);
    test::StallWatch watch;
    studio_->time().play();
    QTest::qWait(2000);
    studio_->time().pause();
    expectFree(watch, "playing", kOther3DView_ms);
}

TEST_F(Stalls, TheWatchSeesAStall) {
    test::StallWatch watch;
    QTimer::singleShot(20, qApp, [] { QTest::qSleep(200); });
    QTest::qWait(400);
    EXPECT_GT(watch.longest_ms(), 190);
    EXPECT_GT(watch.longestOwn_ms(), 100) << "a thread that sleeps does not wait for a core";
}

TEST_F(Stalls, TheWatchForgivesAMachineWithoutCores) {
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
