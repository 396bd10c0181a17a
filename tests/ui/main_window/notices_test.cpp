// SPDX-License-Identifier: Apache-2.0
// What failed is told until it is tried anew, succeeds, or another one is there.
#include "ui/main_window/notices.h"

#include <QDir>
#include <QSignalSpy>

#include "core/suit/default_suit.h"
#include "tests/devices/support/test_box.h"
#include "tests/ui/main_window/studio_fixture.h"
#include "ui/main_window/status_line.h"
#include "ui/style/theme.h"
#include "ui/views/session/big_button.h"
#include "ui/views/session/start_page.h"
#include "ui/widgets/button.h"
#include "ui/widgets/problem_card.h"

namespace noctule::ui {
namespace {

using noctule::test::TestBox;

class NoticesTest : public test::StudioWindow {
protected:
    QStringList told() const { return window_->notices().titles(); }
    /// After what was said of the last job is gone.
    bool bottomLineEndsWith(const char* words) const {
        return waitFor([&] { return window_->statusLine().openText().endsWith(words); });
    }
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
    emit studio_->failed("Something else", "Do something", About::kSession);
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

TEST_F(NoticesTest, AMarkerThatWasNotWrittenIsToldUntilTheNextIsSet) {
    openSampleTake();
    emit studio_->changes().failed("The marker was not written", "Free some room");
    emit studio_->changes().written("another.noctule", MarkerChange{});
    EXPECT_EQ(told(), QStringList{"The marker was not written"}) << "another one was";
    emit studio_->changes().ordered("another.noctule", MarkerChange{});
    EXPECT_EQ(told(), QStringList());
}

TEST_F(NoticesTest, WhatFailedWithATakeOfTheSessionIsForgottenWhenItIsTriedAnew) {
    openSampleTake();
    ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
    SessionModel& session = studio_->session();
    auto kept = session.keepInPlace(session.takePath(0));
    session.renameTake(0, "kick");
    ASSERT_EQ(told().size(), 1);
    kept.reset();
    session.renameTake(0, "kick");
    EXPECT_EQ(told(), QStringList());
}

TEST_F(NoticesTest, ACalibrationThatIsGoneIsToldWhileItIsInForce) {
    ASSERT_TRUE(studio_->session().create(home() + "-notices", "notices"));
    const QStringList gone{"The calibration gone.json of this session is gone or damaged"};
    const auto become = [this](const QStringList& wanted) {
        return waitFor([&] { return told() == wanted; });
    };
    studio_->session().setCalibration("gone.json", "Going back to gone");
    EXPECT_TRUE(become(gone)) << told().join(", ").toStdString();
    const QSignalSpy warned(&studio_->calibrations(), &CalibrationShelf::warned);
    const QDir calibrations(
        QString::fromStdString(studio_->session().session().calibrationFolder().string()));
    ASSERT_TRUE(calibrations.mkpath("."));
    const std::string another = toJson(nominalCalibration(defaultSuit())).dump();
    QFile file(calibrations.filePath("another.json"));
    ASSERT_TRUE(file.open(QFile::WriteOnly) && file.write(another.c_str()) > 0);
    file.close();
    emit studio_->session().changed();
    EXPECT_EQ(studio_->calibrations().all().size(), 1u) << "it came from outside";
    EXPECT_EQ(warned.count(), 0) << "that was told";
    studio_->session().undoStack().undo();
    EXPECT_TRUE(become({}));
    studio_->session().undoStack().redo();
    const QString folder = QString::fromStdString(studio_->session().session().folder.string());
    studio_->session().close();
    EXPECT_TRUE(become({}));
    studio_->session().open(folder);
    EXPECT_TRUE(become(gone)) << told().join(", ").toStdString();
}

TEST_F(NoticesTest, LookingAtAnotherPerformerHidesNothing) {
    TestBox ann{{.loops = true, .serial = "NB-000001", .drive_hz = 40000}},
        bob{{.loops = true, .serial = "NB-000002", .drive_hz = 48000}};
    ASSERT_TRUE(connectTo(ann));
    ASSERT_TRUE(connectTo(bob));
    emit studio_->failed("walk_001 ended by itself", "Free some room", About::kCapture);
    studio_->suits().setCurrent(*studio_->suits().connected()[0]);
    EXPECT_TRUE(told().contains("walk_001 ended by itself"));
}

TEST_F(NoticesTest, TexturesThatAreNotDrawnAreToldWhileTheirMeshIsShown) {
    emit studio_->shownBody().warned("The textures are not drawn. Install the module.");
    ASSERT_EQ(told().size(), 1);
    emit studio_->shownBody().changed();
    EXPECT_EQ(told(), QStringList());
}

TEST_F(NoticesTest, AFailedProcessingIsForgottenWithTheNext) {
    openSampleTake();
    emit studio_->failed("The take could not be processed", "Free some room", About::kProcess);
    ASSERT_EQ(told().size(), 1);
    studio_->processAccurately(studio_->take().path().toStdString(), {});
    EXPECT_EQ(told(), QStringList());
    EXPECT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
}

TEST_F(NoticesTest, ADamagedTakeIsInErrorAndCanBeSaved) {
    openSampleTake();
    ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
    EXPECT_EQ(window_->statusLine().tone(), Tone::kOk);
    studio_->take().noteDamage(studio_->take().path(),
                               {ErrorKind::kUnreadable, "the file is damaged", "Save it", true});
    EXPECT_EQ(window_->statusLine().tone(), Tone::kError);
    EXPECT_TRUE(bottomLineEndsWith("damaged"));
    EXPECT_EQ(told(), QStringList{"sample_001 is damaged"});
    QStringList actions;
    for (const auto* button : window_->notices().findChildren<Button*>())
        actions.append(button->text());
    EXPECT_TRUE(actions.contains("Save what can be read"));
}

TEST_F(NoticesTest, ASessionThatCannotBeWrittenIsReadOnly) {
    openSampleTake();
    ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
    studio_->session().setReadOnly(true);
    EXPECT_EQ(window_->statusLine().tone(), Tone::kWarn);
    EXPECT_TRUE(bottomLineEndsWith("read only"));
    const int steps = studio_->session().undoStack().count();
    studio_->markers().add(0.5);
    EXPECT_EQ(told(), QStringList{"The session can be read but not written"});
    EXPECT_EQ(studio_->session().undoStack().count(), steps);
    studio_->take().close();
    EXPECT_TRUE(bottomLineEndsWith("read only: changes are not kept"));
    studio_->session().close();
    EXPECT_FALSE(studio_->session().isReadOnly());
}

TEST_F(NoticesTest, TwoAreShownAndAButtonStepsToTheOthers) {
    for (const char* what : {"One", "Two", "Three"})
        emit studio_->failed(what, "Do something", About::kSession);
    const auto shown = [this] {
        QStringList titles;
        for (const auto* card : window_->notices().findChildren<ProblemCard*>())
            if (card->isVisible())
                titles.append(card->title());
        titles.sort();
        return titles;
    };
    EXPECT_EQ(shown(), (QStringList{"Three", "Two"}));
    Button* more = window_->notices().moreButton();
    ASSERT_TRUE(more->isVisible());
    EXPECT_EQ(more->text(), "and 1 more");
    QTest::mouseClick(more, Qt::LeftButton);
    EXPECT_EQ(shown(), (QStringList{"One", "Three"}));
    EXPECT_EQ(told().first(), "One");
    window_->notices().remove("One");
    EXPECT_EQ(shown(), (QStringList{"Three", "Two"}));
    EXPECT_FALSE(more->isVisible());
}

TEST_F(NoticesTest, OfFilesTheLatestIsTold) {
    emit studio_->failed("one.csv could not be written", "Free some room", About::kFile);
    emit studio_->failed("two.csv could not be written", "Free some room", About::kFile);
    EXPECT_EQ(told(), QStringList{"two.csv could not be written"});
    studio_->sayOfFile("two.csv is written.");
    EXPECT_EQ(told(), QStringList());
}

TEST_F(NoticesTest, AQuestionIsNoSuccess) {
    window_->offerTour();
    auto* card = window_->notices().findChild<ProblemCard*>();
    ASSERT_TRUE(card);
    const QColor stripe = card->grab().toImage().pixelColor(1, card->height() / 2);
    EXPECT_EQ(stripe.name(), colorOf(Tone::kNeutral).name());
    EXPECT_NE(stripe.name(), Theme::get().tokens().ok.name());
}

TEST_F(NoticesTest, TheTourIsOfferedUntilItIsStartedOrClosed) {
    const QStringList offer{"New to Noctule?"};
    window_->offerTour();
    ASSERT_EQ(told(), offer);
    restart();
    window_->offerTour();
    ASSERT_EQ(told(), offer) << "nobody has answered";
    emit window_->notices().findChild<ProblemCard*>()->closed();
    EXPECT_EQ(told(), QStringList());
    window_->offerTour();
    EXPECT_EQ(told(), QStringList());
    studio_->settings().remove("tour/offered");
    window_->showTour();
    window_->offerTour();
    EXPECT_EQ(told(), QStringList()) << "it has begun";
}

/// Only a mouse that is over the page could miss what moves.
TEST_F(NoticesTest, NothingOfThePageMovesUnderTheMouse) {
    QWidget& page = window_->page(Step::kStart);
    QWidget* stack = page.parentWidget();
    const auto mouse = [stack](QEvent::Type type) {
        QEvent event(type);
        QCoreApplication::sendEvent(stack, &event);
    };
    const auto top = [&] { return page.mapTo(window_.get(), QPoint()).y(); };
    const auto overlap = [&] {
        const Notices& notices = window_->notices();
        return QRect(notices.mapTo(window_.get(), QPoint()), notices.size())
            .intersects(QRect(page.mapTo(window_.get(), QPoint()), page.size()));
    };
    mouse(QEvent::Leave);
    QTest::qWait(0);
    const int alone = top();
    mouse(QEvent::Enter);
    emit studio_->failed("One", "Do something", About::kSession);
    QTest::qWait(50);
    EXPECT_EQ(top(), alone);
    EXPECT_TRUE(window_->notices().isVisible());
    EXPECT_GT(window_->notices().height(), 0);
    mouse(QEvent::Leave);
    EXPECT_TRUE(waitFor([&] { return top() > alone && !overlap(); }));
    const int below = top();
    mouse(QEvent::Enter);
    window_->notices().remove("One");
    QTest::qWait(50);
    EXPECT_EQ(top(), below);
    mouse(QEvent::Leave);
    EXPECT_TRUE(waitFor([&] { return top() == alone; }));
}

TEST_F(NoticesTest, NothingOfOneSessionIsToldInAnother) {
    ASSERT_TRUE(studio_->session().create(home() + "-first", "first"));
    for (const About about : {About::kSession, About::kTakes, About::kCapture, About::kSuit, About::kTake,
                              About::kProcess, About::kFile}) {
        const QString which = QString::number(static_cast<int>(about));
        emit studio_->failed("Failed " + which, "Do something", about);
        emit studio_->warned("Warned " + which + ". Know it.", about);
    }
    ASSERT_FALSE(told().isEmpty());
    ASSERT_TRUE(studio_->session().create(home() + "-second", "second"));
    EXPECT_EQ(told(), QStringList());
}

class TakeWithoutPoses : public NoticesTest {
protected:
    void SetUp() override {
        NoticesTest::SetUp();
        ASSERT_TRUE(studio_->session().create(home() + "-first", "first"));
        const QString path = folder_.filePath("swing.noctule");
        ASSERT_TRUE(test::makeQuickTake(path.toStdString(), {}));
        studio_->session().importTakes({path});
        ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
        tell("swing");
    }
    void tell(const QString& take) {
        emit studio_->suits().posesMissing(take);
        ASSERT_EQ(told(), QStringList{take + " has no poses yet"});
    }
};

TEST_F(TakeWithoutPoses, IsToldUntilItIsProcessed) {
    Button* process = nullptr;
    for (auto* button : window_->notices().findChildren<Button*>())
        if (button->text() == "Process")
            process = button;
    ASSERT_TRUE(process);
    QTest::mouseClick(process, Qt::LeftButton);
    ASSERT_FALSE(studio_->jobs().all().empty());
    EXPECT_EQ(studio_->jobs().all().back()->title(), "Processing swing");
    EXPECT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
    EXPECT_TRUE(studio_->session().session().takes[0].processed);
    EXPECT_EQ(told(), QStringList());
}

TEST_F(TakeWithoutPoses, IsNoLongerToldOnceItWent) {
    studio_->session().renameTake(0, "kick");
    EXPECT_EQ(told(), QStringList());
    tell("kick");
    studio_->session().trashTake(0);
    EXPECT_EQ(told(), QStringList{"kick was moved to the trash"});
}

TEST_F(TakeWithoutPoses, IsNotToldInAnotherSessionNorWithoutOne) {
    ASSERT_TRUE(studio_->session().create(home() + "-second", "second"));
    EXPECT_EQ(told(), QStringList());
    studio_->session().open(home() + "-first");
    ASSERT_TRUE(waitFor([this] { return studio_->session().isOpen(); }));
    tell("swing");
    studio_->session().close();
    EXPECT_EQ(told(), QStringList());
}

TEST_F(NoticesTest, AfterTryItTheKeyboardStaysOnThePage) {
    auto& page = dynamic_cast<StartPage&>(window_->page(Step::kStart));
    window_->activateWindow();
    page.tryButton()->setFocus();
    QTest::mouseClick(page.tryButton(), Qt::LeftButton);
    EXPECT_EQ(window_->focusWidget(), &page);
    EXPECT_TRUE(waitFor([this] { return studio_->take().isOpen() && studio_->jobs().idle(); }));
}

TEST_F(NoticesTest, ATakeInTheTrashIsToldWithUndo) {
    openSampleTake();
    ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
    studio_->session().trashTake(0);
    ASSERT_EQ(told(), QStringList{"sample_001 was moved to the trash"});
    EXPECT_EQ(studio_->session().session().findTake("sample_001"), -1);
    Button* undo = nullptr;
    for (auto* button : window_->notices().findChildren<Button*>())
        if (button->text() == "Undo")
            undo = button;
    ASSERT_TRUE(undo);
    QTest::mouseClick(undo, Qt::LeftButton);
    EXPECT_GE(studio_->session().session().findTake("sample_001"), 0);
    EXPECT_EQ(told(), QStringList());
    EXPECT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
}

}  // namespace
}  // namespace noctule::ui
