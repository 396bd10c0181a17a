// SPDX-License-Identifier: Apache-2.0
// A take of two of whom one was lost while the rest pose was held, in Review.
#include "tests/core/simulation/swaying_pair.h"
#include "tests/ui/views/reviewed_session.h"
#include "ui/scene/scene_words.h"
#include "ui/scene/take_scene.h"
#include "ui/views/review_words.h"

namespace noctule::ui {
namespace {

using LostInRest = test::ReviewedSession;

TEST_F(LostInRest, NothingFailsAndTheReasonIsSaidOfHerAlone) {
    const std::string made = outsideFile("lost.noctule").toStdString();
    const Status written = noctule::test::writePairLostInRest(made);
    ASSERT_TRUE(written) << written.error().text();
    studio_->session().importTakes({QString::fromStdString(made)});
    ASSERT_TRUE(waitFor([this] { return studio_->session().session().takes.size() == 2 && jobsAreDone(); }));
    openTake("lost");
    TakeDocument& take = studio_->take();
    TakeScene scene(*studio_);
    studio_->time().setTime(2);
    EXPECT_TRUE(waitFor([&] { return scene.compose({}).hasBody() && jobsAreDone(); }));
    EXPECT_EQ(take.motionOf(1), nullptr);
    EXPECT_EQ(take.betweenTracks(0, 1), nullptr);
    EXPECT_TRUE(jobsAreDone()) << "nothing is loaded that is not there";
    EXPECT_EQ(take.problem(), "");

    take.setSubject(1);
    ASSERT_TRUE(waitFor([&] { return take.subject() == 1 && take.verdict() && jobsAreDone(); }))
        << take.problem().toStdString();
    EXPECT_EQ(take.shownMotion(), nullptr);
    EXPECT_EQ(take.problem(), "");
    const QString why = whyEmpty(*studio_);
    EXPECT_TRUE(why.startsWith("Bea was lost at 0:0")) << why.toStdString();
    EXPECT_TRUE(why.endsWith(", before the rest pose ended. There is no motion of them."));
    const auto problems = problemsInWords(*take.verdict(), *take.overview());
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_TRUE(problems[0].title.endsWith(", before the rest pose ended"))
        << problems[0].title.toStdString();
}

}  // namespace
}  // namespace noctule::ui
