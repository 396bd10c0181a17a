// SPDX-License-Identifier: Apache-2.0
// Log-out and a polite kill end the studio in good order; and the start page's cards of suits.
#include <QProcess>
#include <QProcessEnvironment>
#include <csignal>

#include "core/recording/take.h"
#include "tests/devices/support/answerer.h"
#include "tests/devices/support/test_box.h"
#include "tests/ui/main_window/studio_fixture.h"
#include "ui/views/session/start_page.h"
#include "ui/widgets/button.h"

namespace noctule::ui {
namespace {

using noctule::test::TestBox;

class EndOfStudio : public test::StudioWindow {
protected:
    QString makeSession(const QString& name) {
        EXPECT_TRUE(studio_->session().create(home() + '-' + name, name));
        EXPECT_TRUE(waitFor([&] { return studio_->session().isOpen(); }));
        return home() + '-' + name;
    }
    static bool isLocked(const QString& session) { return QFile::exists(session + "/session.lock"); }
    /// Where a program stands that did not end; needs gdb.
    static std::string stacksOf(const QProcess& program) {
        QProcess debugger;
        debugger.start(
            "gdb", {"-p", QString::number(program.processId()), "-batch", "-ex", "thread apply all bt 30"});
        return debugger.waitForFinished(-1) ? debugger.readAll().toStdString()
                                            : " (no gdb: its stacks are not known)";
    }
    bool connectTo(const TestBox& box) {
        studio_->suit().connectTo(QString::fromStdString(box.address()));
        return waitFor([&] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; });
    }
    StartPage& startPage() { return dynamic_cast<StartPage&>(window_->page(Step::kStart)); }
};

TEST_F(EndOfStudio, TheProgramEndsInGoodOrderWhenItIsAskedTo) {
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
        const QString session = makeSession(QStringLiteral("asked %1").arg(signal));
        studio_->session().close();
        ASSERT_TRUE(waitFor([&] { return !isLocked(session); }));
        QProcess program;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("XDG_CONFIG_HOME", folder_.filePath("config"));
        environment.insert("XDG_DATA_HOME", folder_.filePath("data"));
        program.setProcessEnvironment(environment);
        program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        program.start(NOCTULE_PROGRAM, {session});
        ASSERT_TRUE(QTest::qWaitFor([&] { return isLocked(session); }, 60'000)) << "it opened no session";
        ASSERT_EQ(kill(static_cast<pid_t>(program.processId()), signal), 0);
        ASSERT_TRUE(program.waitForFinished(30'000)) << signal << stacksOf(program);
        EXPECT_EQ(program.exitStatus(), QProcess::NormalExit) << signal;
        EXPECT_EQ(program.exitCode(), 0) << signal;
        EXPECT_FALSE(isLocked(session)) << signal;
    }
}

TEST_F(EndOfStudio, ATakeThatRunsIsCompletedAndNothingIsAsked) {
    TestBox box({.loops = true});
    const QString session = makeSession("running");
    ASSERT_TRUE(connectTo(box));
    ASSERT_EQ(studio_->suit().record({"walk", {}, 0, 0}), "");
    ASSERT_TRUE(waitFor([&] { return studio_->suit().recordedSeconds() > 0.5; }));
    EXPECT_TRUE(isLocked(session));
    window_->endInGoodOrder();
    ASSERT_TRUE(waitFor([&] { return !window_->isVisible(); }));
    EXPECT_FALSE(isLocked(session));
    const auto take = Take::open((session + "/takes/walk_001.noctule").toStdString());
    ASSERT_TRUE(take);
    EXPECT_EQ(take->meta().at("state"), "complete");
}

TEST_F(EndOfStudio, ASuitThatIsFoundIsConnectedFromTheStartPage) {
    EXPECT_TRUE(startPage().connectButton()->isVisibleTo(&startPage()));
    TestBox box({.loops = true});
    auto announced = noctule::test::testAnnouncement();
    announced.tcp_port = box.port();
    noctule::test::Answerer answerer(announced);
    studio_->finder().start({answerer.port(), false});
    ASSERT_TRUE(waitFor([&] { return startPage().suitButtons().size() == 1; }));
    EXPECT_EQ(startPage().suitButtons()[0]->text(), "Connect");
    EXPECT_FALSE(startPage().connectButton()->isVisibleTo(&startPage())) << "the card has the button";
    startPage().suitButtons()[0]->click();
    EXPECT_EQ(window_->step(), Step::kConnect);
    ASSERT_TRUE(waitFor([&] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; }));
    window_->goTo(Step::kStart);
    ASSERT_EQ(startPage().suitButtons().size(), 1);
    EXPECT_EQ(startPage().suitButtons()[0]->text(), "Show it") << "it is connected already";
    EXPECT_FALSE(startPage().connectButton()->isVisibleTo(&startPage()));
}

}  // namespace
}  // namespace noctule::ui
