// SPDX-License-Identifier: Apache-2.0
// The studio's own jobs: the virtual suit and processing.
#include "ui/models/studio.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/support/take_files.h"
#include "tests/ui/support/wait.h"

namespace noctule::ui {
namespace {

namespace fs = std::filesystem;

class StudioTest : public testing::Test {
protected:
    void SetUp() override {
        QSettings().clear();
        studio_ = std::make_unique<Studio>(StudioParts{
            "noctule test", [] { return std::string("2026-03-01T10:00:00Z"); },
            [this](const std::string& path, const JobContext& job) { return makeTake(path, job); }});
        studio_->settings().setValue("folders/sessions",
                                     QString::fromStdString((home_ / "sessions").string()));
    }
    void TearDown() override { studio_.reset(); }

    Status makeTake(const std::string& path, const JobContext& job) {
        ++made_;
        while (hold_ && !job.cancelled())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (job.cancelled())
            return JobContext::cancelledError();
        fs::copy_file(fs::path(NOCTULE_TEST_DATA) / "takes" / "tiny_take.noctule", path);
        return Done{};
    }
    bool waitForTake() {
        return waitFor([this] { return studio_->take().isOpen() && studio_->jobs().idle(); });
    }
    fs::path sessions() const { return home_ / "sessions"; }

    const noctule::test::Folder folder_;
    const fs::path home_ = folder_.path();
    std::atomic<int> made_ = 0;
    std::atomic<bool> hold_ = false;
    std::unique_ptr<Studio> studio_;
};

TEST_F(StudioTest, VirtualSuitEndsInReviewWithAProcessedTake) {
    QSignalSpy steps(studio_.get(), &Studio::stepRequested);
    Job* job = studio_->tryVirtualSuit();
    std::vector<double> fractions;
    QObject::connect(job, &Job::changed, [&] { fractions.push_back(job->fraction()); });
    ASSERT_TRUE(waitForTake());
    EXPECT_EQ(job->state(), Job::State::kDone);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    ASSERT_EQ(steps.count(), 1);
    EXPECT_EQ(steps[0][0].value<Step>(), Step::kReview);
    EXPECT_EQ(studio_->session().session().name, "Virtual suit");
    ASSERT_EQ(studio_->session().session().takes.size(), 1u);
    EXPECT_TRUE(studio_->session().session().takes[0].processed);
    EXPECT_EQ(studio_->take().overview()->runs.size(), 1u);
    EXPECT_EQ(studio_->take().overview()->runs[0].run.software, "noctule test");
    for (const auto& entry : fs::directory_iterator(sessions() / "Virtual suit"))
        EXPECT_FALSE(entry.path().filename().string().starts_with('.')) << entry.path();
}

TEST_F(StudioTest, VirtualSuitMadeBeforeIsUsedAgain) {
    studio_->tryVirtualSuit();
    ASSERT_TRUE(waitForTake());
    studio_->session().close();
    studio_->tryVirtualSuit();
    ASSERT_TRUE(waitForTake());
    EXPECT_EQ(made_, 1);
    EXPECT_EQ(std::distance(fs::directory_iterator(sessions()), {}), 1);
}

TEST_F(StudioTest, FolderOfSomethingElseIsLeftAlone) {
    fs::create_directories(sessions() / "Virtual suit");
    std::ofstream(sessions() / "Virtual suit" / "letter.txt") << "dear";
    studio_->tryVirtualSuit();
    ASSERT_TRUE(waitForTake());
    EXPECT_EQ(studio_->session().session().name, "Virtual suit 2");
    EXPECT_EQ(std::distance(fs::directory_iterator(sessions() / "Virtual suit"), {}), 1);
}

TEST_F(StudioTest, CancelLeavesNothing) {
    hold_ = true;
    Job* job = studio_->tryVirtualSuit();
    EXPECT_EQ(studio_->tryVirtualSuit(), job);
    ASSERT_TRUE(waitFor([&] { return made_ == 1; }));
    job->cancel();
    ASSERT_TRUE(waitFor([&] { return job->state() == Job::State::kCancelled; }));
    EXPECT_TRUE(fs::is_empty(sessions()));
    EXPECT_FALSE(studio_->session().isOpen());
}

TEST_F(StudioTest, CancelInAnEarlierSessionLeavesItAsItWas) {
    studio_->tryVirtualSuit();
    ASSERT_TRUE(waitForTake());
    studio_->session().trashTake(0);
    studio_->session().close();
    hold_ = true;
    Job* job = studio_->tryVirtualSuit();
    ASSERT_TRUE(waitFor([&] { return made_ == 2; }));
    job->cancel();
    ASSERT_TRUE(waitFor([&] { return job->state() == Job::State::kCancelled; }));
    EXPECT_TRUE(fs::exists(sessions() / "Virtual suit" / "session.json"));
    EXPECT_TRUE(fs::is_empty(sessions() / "Virtual suit" / "takes"));
}

TEST_F(StudioTest, ProcessingShowsTheNewRun) {
    studio_->tryVirtualSuit();
    ASSERT_TRUE(waitForTake());
    ProcessRequest request;
    request.take_path = studio_->take().path().toStdString();
    request.tracker.sensors = {false, true, false};
    QSignalSpy said(studio_.get(), &Studio::said);
    const Job* job = studio_->process(request);
    ASSERT_TRUE(waitFor([&] { return studio_->take().overview()->runs.size() == 2; }));
    EXPECT_EQ(job->state(), Job::State::kDone);
    EXPECT_EQ(studio_->take().shownRun(), 1);
    const DerivedRun& run = studio_->take().overview()->runs[1].run;
    EXPECT_EQ(run.name, "G");
    EXPECT_EQ(run.created_utc, "2026-03-01T10:00:00Z");
    ASSERT_EQ(said.count(), 1);
    EXPECT_TRUE(said[0][0].toString().startsWith("G of sample_001 is ready"));
}

TEST_F(StudioTest, ProcessingThatFailsIsTold) {
    QSignalSpy failed(studio_.get(), &Studio::failed);
    ProcessRequest request;
    request.take_path = (home_ / "nothing.noctule").string();
    const Job* job = studio_->process(request);
    ASSERT_TRUE(waitFor([&] { return failed.count() == 1; }));
    EXPECT_EQ(job->state(), Job::State::kFailed);
    EXPECT_TRUE(failed[0][0].toString().contains("nothing.noctule"));
    EXPECT_FALSE(failed[0][1].toString().isEmpty());
}

TEST_F(StudioTest, DamageThatProcessingFindsIsOfferedToBeSaved) {
    studio_->tryVirtualSuit();
    ASSERT_TRUE(waitForTake());
    const QString path = studio_->take().path();
    noctule::test::damageRowsOf(path.toStdString(), "adc_block");
    QSignalSpy failed(studio_.get(), &Studio::failed), torn(studio_.get(), &Studio::tornTake);
    const Job* job = studio_->processAccurately(path.toStdString());
    ASSERT_TRUE(waitFor([&] { return job->state() == Job::State::kFailed; }));
    ASSERT_EQ(torn.count(), 1);
    EXPECT_EQ(torn[0][0].toString(), path);
    EXPECT_TRUE(studio_->take().isDamaged());
    EXPECT_EQ(failed.count(), 0) << "it is told once";
    studio_->saveReadable(path);
    EXPECT_TRUE(waitFor([this] { return studio_->jobs().idle() && studio_->take().isOpen(); }));
    EXPECT_FALSE(studio_->take().isDamaged());
}

TEST_F(StudioTest, WhatFailedIsStillToldWhenTheNextTakesWereProcessed) {
    studio_->tryVirtualSuit();
    ASSERT_TRUE(waitForTake());
    QStringList told;
    QObject::connect(studio_.get(), &Studio::failed,
                     [&](const QString& what, const QString&, About) { told += what; });
    QObject::connect(studio_.get(), &Studio::settled, [&](About about) {
        if (about == About::kProcess)
            told.clear();
    });
    const size_t before = studio_->jobs().all().size();
    studio_->processInTurn(
        {{(home_ / "nothing.noctule").string(), {}}, {studio_->take().path().toStdString(), {}}});
    ASSERT_TRUE(
        waitFor([&] { return studio_->jobs().all().size() >= before + 2 && studio_->jobs().idle(); }));
    ASSERT_EQ(told.size(), 1);
    EXPECT_TRUE(told[0].contains("nothing.noctule")) << told[0].toStdString();
    studio_->processInTurn({{studio_->take().path().toStdString(), {}}});
    EXPECT_TRUE(told.isEmpty()) << "it is tried anew";
    EXPECT_TRUE(waitFor([&] { return studio_->jobs().idle(); }));
}

TEST_F(StudioTest, TwoResultsOfOneTakeAreMadeOneAfterTheOther) {
    studio_->tryVirtualSuit();
    ASSERT_TRUE(waitForTake());
    ProcessRequest request;
    request.take_path = studio_->take().path().toStdString();
    const Job* first = studio_->process(request);
    const Job* second = studio_->process(request);
    ASSERT_TRUE(waitFor([&] { return studio_->jobs().idle(); }));
    EXPECT_EQ(first->state(), Job::State::kDone);
    EXPECT_EQ(second->state(), Job::State::kDone);
}

}  // namespace
}  // namespace noctule::ui
