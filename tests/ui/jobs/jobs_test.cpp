// SPDX-License-Identifier: Apache-2.0
#include "ui/jobs/jobs.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <atomic>
#include <stdexcept>
#include <thread>

#include "core/job/staged_progress.h"

namespace noctule::ui {
namespace {

using Work = std::function<Result<int>(const JobContext&)>;

constexpr int kLong_ms = 5000;

Job* startNumber(Jobs& jobs, const Work& work, const std::function<QString(Result<int>)>& done = {},
                 Jobs::Loudness loudness = Jobs::Loudness::kNormal) {
    return jobs.start<int>(
        "number", work, [done](Result<int> result) { return done ? done(std::move(result)) : QString(); },
        loudness);
}

Result<int> untilCancelled(const JobContext& job) {
    while (!job.cancelled())
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return JobContext::cancelledError();
}

bool waitUntilIdle(Jobs& jobs) {
    return QTest::qWaitFor([&] { return jobs.idle(); }, kLong_ms);
}

TEST(Jobs, WorkRunsElsewhereAndDoneOnTheInterfacesThread) {
    Jobs jobs;
    const auto interface = std::this_thread::get_id();
    std::atomic<bool> worked_elsewhere = false;
    bool told_here = false;
    int value = 0;
    const Job* job = startNumber(
        jobs,
        [&](const JobContext&) -> Result<int> {
            worked_elsewhere = std::this_thread::get_id() != interface;
            return 42;
        },
        [&](Result<int> result) {
            told_here = std::this_thread::get_id() == interface;
            value = *result;
            return QString("It is 42");
        });
    EXPECT_EQ(job->state(), Job::State::kRunning);
    ASSERT_TRUE(waitUntilIdle(jobs));
    EXPECT_TRUE(worked_elsewhere);
    EXPECT_TRUE(told_here);
    EXPECT_EQ(value, 42);
    EXPECT_EQ(job->state(), Job::State::kDone);
    EXPECT_EQ(job->outcome(), "It is 42");
    EXPECT_EQ(job->fraction(), 1);
    EXPECT_FALSE(job->error());
}

TEST(Jobs, EndIsExactlyOneOfDoneFailedCancelled) {
    struct Case {
        Work work;
        Job::State state;
        QString outcome;
    };
    const Case cases[] = {{[](const JobContext&) -> Result<int> { return 1; }, Job::State::kDone, ""},
                          {[](const JobContext&) -> Result<int> {
                               return Error{ErrorKind::kDisk, "The disk is full", "Free some"};
                           },
                           Job::State::kFailed, "The disk is full. Free some"},
                          {[](const JobContext&) -> Result<int> { return JobContext::cancelledError(); },
                           Job::State::kCancelled, "Cancelled"}};
    for (const Case& c : cases) {
        Jobs jobs;
        int told = 0;
        Job* job = startNumber(jobs, c.work, [&](const Result<int>&) {
            ++told;
            return QString();
        });
        QSignalSpy ended(job, &Job::ended);
        ASSERT_TRUE(waitUntilIdle(jobs));
        QTest::qWait(80);
        EXPECT_EQ(told, 1);
        EXPECT_EQ(ended.count(), 1);
        EXPECT_EQ(job->state(), c.state);
        EXPECT_EQ(job->outcome(), c.outcome);
    }
}

TEST(Jobs, CancelReachesTheWork) {
    Jobs jobs;
    Job* job = startNumber(jobs, untilCancelled);
    QTest::qWait(20);
    EXPECT_EQ(job->state(), Job::State::kRunning);
    job->cancel();
    ASSERT_TRUE(waitUntilIdle(jobs));
    EXPECT_EQ(job->state(), Job::State::kCancelled);
}

TEST(Jobs, WorkThatEndedBeforeItHeardOfCancelIsDone) {
    Jobs jobs;
    std::atomic<bool> go = false;
    Job* job = startNumber(jobs, [&](const JobContext&) -> Result<int> {
        while (!go)
            std::this_thread::yield();
        return 7;
    });
    QTest::qWait(20);
    job->cancel();
    go = true;
    ASSERT_TRUE(waitUntilIdle(jobs));
    EXPECT_EQ(job->state(), Job::State::kDone);
}

TEST(Jobs, BrokenPromiseBecomesAFailureInWords) {
    Jobs jobs;
    ErrorKind kind = ErrorKind::kUsage;
    const Job* job = startNumber(
        jobs, [](const JobContext&) -> Result<int> { throw std::logic_error("a leg too many"); },
        [&](const Result<int>& result) {
            kind = result.error().kind;
            return QString();
        });
    ASSERT_TRUE(waitUntilIdle(jobs));
    EXPECT_EQ(job->state(), Job::State::kFailed);
    EXPECT_EQ(kind, ErrorKind::kInternal);
    EXPECT_TRUE(job->outcome().contains("a leg too many"));
}

TEST(Jobs, MistakeWhileTellingIsAFailureToo) {
    Jobs jobs;
    const Job* job = startNumber(
        jobs, [](const JobContext&) -> Result<int> { return 1; },
        [](const Result<int>&) -> QString { throw std::logic_error("nobody listens"); });
    ASSERT_TRUE(waitUntilIdle(jobs));
    EXPECT_EQ(job->state(), Job::State::kFailed);
    EXPECT_TRUE(job->outcome().contains("nobody listens"));
}

TEST(Jobs, ProgressNeverFallsWithinAStageAndStaysCalm) {
    Jobs jobs;
    Job* job = startNumber(jobs, [](const JobContext& context) -> Result<int> {
        for (int i = 0; i <= 30000; ++i) {
            context.progress(i / 30000.0, "Counting");
            if (i % 300 == 0)
                std::this_thread::sleep_for(std::chrono::milliseconds(3));
        }
        return 1;
    });
    std::vector<double> seen;
    QObject::connect(job, &Job::changed, [&] { seen.push_back(job->fraction()); });
    QElapsedTimer clock;
    clock.start();
    ASSERT_TRUE(waitUntilIdle(jobs));
    EXPECT_GT(seen.size(), 3u);
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    EXPECT_LE(static_cast<double>(seen.size()), static_cast<double>(clock.elapsed()) / 50 + 4);
    EXPECT_EQ(job->stage(), "Counting");
}

TEST(Jobs, ClosingTheStudioCancelsAndWaits) {
    std::atomic<bool> running = false, stopped = false;
    bool told = false;
    {
        Jobs jobs;
        startNumber(
            jobs,
            [&](const JobContext& job) {
                running = true;
                const auto result = untilCancelled(job);
                std::this_thread::sleep_for(std::chrono::milliseconds(30));
                stopped = true;
                return result;
            },
            [&](const Result<int>&) {
                told = true;
                return QString();
            });
        ASSERT_TRUE(QTest::qWaitFor([&] { return running.load(); }, kLong_ms));
    }
    EXPECT_TRUE(stopped);
    QTest::qWait(30);
    EXPECT_FALSE(told);
}

TEST(Jobs, ManyJobsAllEnd) {
    Jobs jobs;
    int sum = 0;
    for (int i = 0; i < 200; ++i)
        startNumber(
            jobs, [i](const JobContext&) -> Result<int> { return i; },
            [&](Result<int> result) {
                sum += *result;
                return QString();
            });
    EXPECT_EQ(jobs.running(), 200);
    ASSERT_TRUE(waitUntilIdle(jobs));
    EXPECT_EQ(sum, 199 * 200 / 2);
    EXPECT_EQ(jobs.all().size(), 200u);
    jobs.clearEnded();
    EXPECT_TRUE(jobs.all().empty());
}

TEST(Jobs, DoneMayStartAnotherJobAndClearTheList) {
    Jobs jobs;
    int second = 0;
    startNumber(
        jobs, [](const JobContext&) -> Result<int> { return 1; },
        [&](const Result<int>&) {
            startNumber(
                jobs, [](const JobContext&) -> Result<int> { return 2; },
                [&](Result<int> result) {
                    second = *result;
                    jobs.clearEnded();
                    return QString();
                });
            return QString();
        });
    ASSERT_TRUE(waitUntilIdle(jobs));
    EXPECT_EQ(second, 2);
}

TEST(Jobs, QuietWorkIsNotListed) {
    Jobs jobs;
    QSignalSpy started(&jobs, &Jobs::started);
    startNumber(
        jobs, [](const JobContext&) -> Result<int> { return 1; }, {}, Jobs::Loudness::kQuiet);
    EXPECT_TRUE(jobs.all().empty());
    EXPECT_FALSE(jobs.idle());
    ASSERT_TRUE(waitUntilIdle(jobs));
    EXPECT_TRUE(jobs.all().empty());
    EXPECT_EQ(started.count(), 0);
}

TEST(Jobs, QuietWorkThatFailsIsListed) {
    Jobs jobs;
    QSignalSpy started(&jobs, &Jobs::started);
    startNumber(
        jobs,
        [](const JobContext&) -> Result<int> {
            return Error{ErrorKind::kUnreadable, "No", "Look"};
        },
        {}, Jobs::Loudness::kQuiet);
    ASSERT_TRUE(waitUntilIdle(jobs));
    ASSERT_EQ(jobs.all().size(), 1u);
    EXPECT_EQ(jobs.all().front()->state(), Job::State::kFailed);
    EXPECT_EQ(started.count(), 1);
}

TEST(Jobs, QuietWorkIsListedWhileItTakesLong) {
    Jobs jobs;
    Job* job = startNumber(jobs, untilCancelled, {}, Jobs::Loudness::kQuiet);
    ASSERT_TRUE(QTest::qWaitFor([&] { return jobs.all().size() == 1; }, kLong_ms));
    EXPECT_EQ(jobs.running(), 1);
    job->cancel();
    ASSERT_TRUE(waitUntilIdle(jobs));
    EXPECT_TRUE(jobs.all().empty());
}

TEST(RemainingTime, IsAbsentAtFirstAndThenRight) {
    RemainingTime time;
    EXPECT_FALSE(time.seconds());
    time.report(0.5, 0.05);
    EXPECT_FALSE(time.seconds());
    for (double t = 1; t <= 5; t += 0.05)
        time.report(t, t / 10);
    ASSERT_TRUE(time.seconds());
    EXPECT_NEAR(*time.seconds(), 5, 1);
}

TEST(RemainingTime, FollowsAJumpCalmly) {
    RemainingTime time;
    for (double t = 0; t <= 2; t += 0.05)
        time.report(t, t / 10);
    const int before = time.seconds().value();
    time.report(2.05, 0.8);  // what it estimates now is half a second
    EXPECT_GE(*time.seconds(), before - 1);
    for (double t = 2.1; t <= 6; t += 0.05)
        time.report(t, 0.8 + (t - 2.05) / 100);
    EXPECT_LE(*time.seconds(), 2);
}

TEST(RemainingTime, BeginsAgainWithAStage) {
    RemainingTime time;
    for (double t = 0; t <= 2; t += 0.05)
        time.report(t, t / 2);
    time.report(2.05, 0);
    EXPECT_FALSE(time.seconds());
    for (double t = 2.1; t <= 4; t += 0.05)
        time.report(t, (t - 2.05) / 20);
    EXPECT_NEAR(time.seconds().value(), 18, 1);
}

TEST(StagedProgress, MapsItsPartIntoTheWhole) {
    struct Sink : ProgressSink {
        void progress(double fraction, const std::string&) override { last = fraction; }
        double last = -1;
    } sink;
    StagedProgress stage({&sink, nullptr}, 0.25, 0.75);
    stage.job().progress(0, "a");
    EXPECT_EQ(sink.last, 0.25);
    stage.job().progress(0.5, "a");
    EXPECT_EQ(sink.last, 0.5);
    stage.job().progress(1, "a");
    EXPECT_EQ(sink.last, 0.75);
}

}  // namespace
}  // namespace noctule::ui
