// SPDX-License-Identifier: Apache-2.0
// Several takes are processed from their dialog; the screen goes on while a take makes it wait.
#include "core/recording/database.h"
#include "tests/core/simulation/swaying_pair.h"
#include "tests/ui/views/reviewed_session.h"
#include "ui/views/review/process_takes_dialog.h"

namespace noctule::ui {
namespace {

using ProcessTakes = test::ReviewedSession;

TEST_F(ProcessTakes, ATakeThatIsHeldDoesNotHoldTheScreenUp) {
    addTake("swing_002");
    ProcessTakesDialog dialog(*studio_, std::nullopt);
    dialog.tick({"swing_001", "swing_002"});
    // Whoever opens it waits for seconds.
    const auto other = Database::open(takePath("swing_001").toStdString(), Access::kReadWrite);
    ASSERT_TRUE(other && other->execute("BEGIN EXCLUSIVE"));
    dialog.process();
    ASSERT_FALSE(studio_->jobs().all().empty());
    Job* job = studio_->jobs().all().back();
    EXPECT_EQ(job->title(), "Processing swing_001");
    EXPECT_EQ(job->state(), Job::State::kRunning) << "process() waited for the take";
    ASSERT_TRUE(other->execute("ROLLBACK"));
    job->cancel();
    ASSERT_TRUE(waitFor([&] { return job->state() == Job::State::kCancelled; }));
    ASSERT_TRUE(waitFor([&] { return studio_->jobs().all().back()->title() == "Processing swing_002"; }))
        << "the next one has its turn";
    studio_->jobs().all().back()->cancel();
}

TEST_F(ProcessTakes, TakesOfSeveralKeepWhatEachOneHas) {
    const std::string pair = outsideFile("pair.noctule").toStdString();
    ASSERT_TRUE(noctule::test::writeSwayingPair(pair));
    const PartsOfOne own{Calibration{}, defaultActor()};
    const ProcessRequest of_one =
        Studio::accurateRequest(takePath("swing_001").toStdString(), own, JobContext{});
    EXPECT_TRUE(of_one.calibration && of_one.actor);
    EXPECT_EQ(of_one.tracker.smoother, Smoother::kFull);
    const ProcessRequest of_two = Studio::accurateRequest(pair, own, JobContext{});
    EXPECT_FALSE(of_two.calibration || of_two.actor);
}

}  // namespace
}  // namespace noctule::ui
