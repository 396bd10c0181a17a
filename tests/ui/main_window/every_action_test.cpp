// SPDX-License-Identifier: Apache-2.0
// Every action of every page is done once in both themes, whatever it opens is looked at and closed. An
// exception ends the program; a missing icon fails the test (tests/ui/support/main.cpp).
#include <QDialog>
#include <QMenu>
#include <set>

#include "tests/devices/support/test_box.h"
#include "tests/ui/main_window/studio_fixture.h"
#include "ui/style/theme.h"
#include "ui/views/page.h"

namespace noctule::ui {
namespace {

using noctule::test::TestBox;

class EveryActionTest : public test::StudioWindow {
protected:
    void SetUp() override {
        qApp->setAttribute(Qt::AA_DontUseNativeDialogs);
        path_ = qgetenv("PATH");
        qputenv("PATH", folder_.path().toLocal8Bit());  // no file manager starts
        StudioWindow::SetUp();
        closer_.setInterval(50);
        QObject::connect(&closer_, &QTimer::timeout, [this] { closeWhatIsOpen(); });
        closer_.start();
    }

    void TearDown() override {
        closer_.stop();
        qputenv("PATH", path_);
        StudioWindow::TearDown();
    }

    /// As an operator who looks and thinks better of it.
    void closeWhatIsOpen() {
        if (QWidget* popup = QApplication::activePopupWidget()) {
            EXPECT_FALSE(popup->grab().isNull());
            popup->close();
        } else if (QWidget* modal = QApplication::activeModalWidget()) {
            EXPECT_FALSE(modal->grab().isNull());
            EXPECT_FALSE(modal->windowTitle().isEmpty()) << modal->metaObject()->className();
            titles_.insert(modal->windowTitle().toStdString());
            if (auto* dialog = qobject_cast<QDialog*>(modal))
                dialog->reject();
            else
                modal->close();
        }
    }

    /// But not what ends the program.
    QList<QAction*> actionsOfPage(Step step) {
        QList<QAction*> actions = window_->actions().all();
        actions.removeAll(window_->actions()[Command::kQuit]);
        return actions + window_->page(step).menuActions();
    }

    void doAll(Step step) {
        window_->goTo(step);
        for (const QPointer<QAction> action : actionsOfPage(step)) {
            if (!action || action->isSeparator() || !action->isEnabled())
                continue;
            SCOPED_TRACE(action->text().toStdString());
            EXPECT_FALSE(action->text().isEmpty());
            action->trigger();
            QCoreApplication::processEvents();
            ++done_;
            if (window_->step() != step)
                window_->goTo(step);
        }
        ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle() && !QApplication::activeModalWidget(); }));
    }

    void doAllOnEveryPage() {
        for (const Scheme scheme : {Scheme::kDark, Scheme::kLight, Scheme::kContrast})
            for (const Step step : test::kEveryStep) {
                Theme::get().setScheme(scheme);
                SCOPED_TRACE(static_cast<int>(step));
                doAll(step);
            }
        Theme::get().setScheme(Scheme::kDark);
    }

    /// Some actions let the suit go.
    bool connectTo(const TestBox& box) {
        LiveSuit& suit = studio_->suit();
        if (suit.phase() == LiveSuit::Phase::kNone)
            studio_->suits().add(QString::fromStdString(box.address()));
        return waitFor([&] { return suit.phase() == LiveSuit::Phase::kLooking; });
    }
    /// And some end the take.
    bool stopTake() {
        return waitFor([this] {
            if (studio_->suits().phase() == LiveSuit::Phase::kRecording)
                studio_->suits().stopRecording();
            return !studio_->suits().isTakeOpen();
        });
    }

    QByteArray path_;
    QTimer closer_;
    std::set<std::string> titles_;
    int done_ = 0;
};

TEST_F(EveryActionTest, WithoutASession) {
    doAllOnEveryPage();
    EXPECT_GE(done_, 7 * 2 * 10);
    EXPECT_GE(titles_.size(), 6U)
        << "new and open session, open take, import, preferences, put on, shortcuts, about";
}

TEST_F(EveryActionTest, WithATake) {
    openSampleTake();
    doAllOnEveryPage();
    EXPECT_GE(done_, 7 * 2 * 15);
}

TEST_F(EveryActionTest, WithASuit) {
    TestBox box({.loops = true});
    ASSERT_TRUE(studio_->session().create(home() + "-suit", "suit"));
    for (const Step step : test::kEveryStep) {
        ASSERT_TRUE(connectTo(box));
        doAll(step);
        ASSERT_TRUE(stopTake());
    }
    EXPECT_GE(done_, 8 * 15);
}

TEST_F(EveryActionTest, WhileATakeIsRecorded) {
    TestBox box({.loops = true});
    ASSERT_TRUE(studio_->session().create(home() + "-suit", "suit"));
    for (const Step step : test::kEveryStep) {
        ASSERT_TRUE(connectTo(box));
        ASSERT_EQ(studio_->suit().record({"walk", {}, 0, 0}), "");
        ASSERT_TRUE(waitFor([this] { return studio_->suits().isTakeOpen(); }));
        doAll(step);
        ASSERT_TRUE(stopTake());
    }
    EXPECT_GE(done_, 8 * 15);
}

}  // namespace
}  // namespace noctule::ui
