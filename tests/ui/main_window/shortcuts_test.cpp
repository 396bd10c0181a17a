// SPDX-License-Identifier: Apache-2.0
// Keys of the operator's own: chosen in the Shortcuts dialog, kept, followed by menus, hints and pages.
#include "tests/ui/main_window/studio_fixture.h"
#include "ui/main_window/jobs_panel.h"
#include "ui/main_window/shortcuts_dialog.h"
#include "ui/style/keys.h"
#include "ui/views/page.h"
#include "ui/widgets/button.h"
#include "ui/widgets/key_hint.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

class ShortcutsTest : public test::StudioWindow {
protected:
    void TearDown() override {
        Keys::get().restoreUsual();
        StudioWindow::TearDown();
    }
    QList<ShortcutGroup> groups() {
        return {{"Anywhere", window_->actions().all()},
                {"Record", window_->page(Step::kRecord).menuActions()},
                {"Review", window_->page(Step::kReview).menuActions()}};
    }
    QAction& command(Command which) { return *window_->actions()[which]; }
    QAction& ofPage(Step step, const QString& name) {
        for (QAction* action : window_->page(step).menuActions())
            if (Keys::get().nameOf(*action) == name)
                return *action;
        throw std::runtime_error("no such command");
    }
    /// What the dialog said against it; empty when the key was taken.
    QString give(QAction& action, Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        ShortcutsDialog dialog(groups());
        dialog.choose(action);
        QTest::keyClick(&dialog.keyField(), key, modifiers);
        return dialog.problem();
    }
};

TEST_F(ShortcutsTest, AKeyOfTheOperatorsOwnActsAtOnceAndAfterARestart) {
    EXPECT_EQ(give(command(Command::kJobs), Qt::Key_K, Qt::ControlModifier), "");
    EXPECT_EQ(command(Command::kJobs).shortcuts(), QList<QKeySequence>{QKeySequence("Ctrl+K")});
    QTest::keyClick(window_.get(), Qt::Key_K, Qt::ControlModifier);
    EXPECT_TRUE(window_->jobsPanel().isVisible());
    QTest::keyClick(window_.get(), Qt::Key_J, Qt::ControlModifier);
    EXPECT_TRUE(window_->jobsPanel().isVisible()) << "the usual key no longer acts";
    const auto tools = window_->jobsPanel().findChildren<ToolButton*>();
    EXPECT_TRUE(std::any_of(tools.begin(), tools.end(), [](const ToolButton* tool) {
        return tool->toolTip().contains("Ctrl+K");
    })) << "hints follow";
    restart();
    EXPECT_EQ(command(Command::kJobs).shortcut(), QKeySequence("Ctrl+K"));
}

TEST_F(ShortcutsTest, PlainKeysOfAPageCanBeChanged) {
    QAction& marker = ofPage(Step::kRecord, "record/marker");
    EXPECT_EQ(give(marker, Qt::Key_K), "");
    EXPECT_EQ(marker.shortcut(), QKeySequence("K"));
    EXPECT_EQ(ofPage(Step::kReview, "review/marker").shortcut(), QKeySequence("M")) << "of another page";
    EXPECT_EQ(give(ofPage(Step::kRecord, "record/record"), Qt::Key_F9), "");
    const auto hints = window_->page(Step::kRecord).findChildren<KeyHint*>();
    EXPECT_TRUE(std::any_of(hints.begin(), hints.end(),
                            [](const KeyHint* hint) { return hint->accessibleName() == "F9"; }));
}

TEST_F(ShortcutsTest, AKeyIsNeverGivenToTwoCommands) {
    QAction& jobs = command(Command::kJobs);
    EXPECT_TRUE(give(jobs, Qt::Key_E, Qt::ControlModifier).contains("“Export”"));
    EXPECT_TRUE(give(jobs, Qt::Key_L, Qt::ControlModifier).contains("“Loop”")) << "of a page";
    EXPECT_TRUE(give(jobs, Qt::Key_Right, Qt::ControlModifier).contains("fixed")) << "of the timeline";
    EXPECT_TRUE(give(jobs, Qt::Key_F8).contains("fixed")) << "of the robot";
    EXPECT_EQ(jobs.shortcut(), QKeySequence("Ctrl+J"));
    QAction& marker = ofPage(Step::kRecord, "record/marker");
    EXPECT_TRUE(give(marker, Qt::Key_N).contains("“Note now”"));
    EXPECT_TRUE(give(marker, Qt::Key_J, Qt::ControlModifier).contains("“Jobs”"));
    EXPECT_EQ(marker.shortcut(), QKeySequence("M"));
}

TEST_F(ShortcutsTest, KeysThatTypeOrOpenMenusAreRefused) {
    QAction& jobs = command(Command::kJobs);
    for (const auto& [key, modifiers] :
         {std::pair{Qt::Key_K, Qt::NoModifier}, std::pair{Qt::Key_C, Qt::ControlModifier},
          std::pair{Qt::Key_F, Qt::AltModifier}, std::pair{Qt::Key_Return, Qt::NoModifier}})
        EXPECT_NE(give(jobs, key, modifiers), "") << key;
    EXPECT_EQ(jobs.shortcut(), QKeySequence("Ctrl+J"));
}

TEST_F(ShortcutsTest, RestoreDefaultsGivesAllUsualKeysBack) {
    QAction& open = command(Command::kOpenSession);
    const QList<QKeySequence> usual = open.shortcuts();
    give(open, Qt::Key_K, Qt::ControlModifier);
    give(ofPage(Step::kReview, "review/play"), Qt::Key_P);
    ShortcutsDialog dialog(groups());
    dialog.restoreButton().click();
    EXPECT_EQ(open.shortcuts(), usual);
    EXPECT_EQ(ofPage(Step::kReview, "review/play").shortcut(), QKeySequence("Space"));
}

TEST_F(ShortcutsTest, AKeyThatTwoShareByDesignCanBeHadBack) {
    QAction& out = ofPage(Step::kReview, "review/out");
    EXPECT_EQ(give(out, Qt::Key_U, Qt::ControlModifier), "");
    EXPECT_EQ(give(out, Qt::Key_O, Qt::ControlModifier), "");
    EXPECT_EQ(out.shortcut(), QKeySequence("Ctrl+O"));
    EXPECT_TRUE(command(Command::kOpenSession).shortcuts().contains(QKeySequence("Ctrl+O")));
}

TEST_F(ShortcutsTest, OpenHasItsKeyOnReviewOnceOutHasAnother) {
    const QAction& open = command(Command::kOpenSession);
    const QAction& out = ofPage(Step::kReview, "review/out");
    EXPECT_TRUE(open.shortcuts().contains(QKeySequence("Ctrl+O")));
    window_->goTo(Step::kReview);
    EXPECT_EQ(open.shortcuts(), QList<QKeySequence>{QKeySequence("Ctrl+Shift+O")});
    EXPECT_EQ(give(ofPage(Step::kReview, "review/out"), Qt::Key_U, Qt::ControlModifier), "");
    EXPECT_TRUE(open.shortcuts().contains(QKeySequence("Ctrl+O"))) << "also while Review is shown";
    EXPECT_EQ(give(ofPage(Step::kReview, "review/out"), Qt::Key_O, Qt::ControlModifier), "");
    EXPECT_EQ(out.shortcut(), QKeySequence("Ctrl+O"));
    EXPECT_FALSE(open.shortcuts().contains(QKeySequence("Ctrl+O")));
    EXPECT_EQ(give(command(Command::kOpenSession), Qt::Key_K, Qt::ControlModifier), "");
    EXPECT_EQ(give(command(Command::kOpenSession), Qt::Key_O, Qt::ControlModifier), "") << "its usual key";
    window_->goTo(Step::kStart);
    EXPECT_EQ(open.shortcut(), QKeySequence("Ctrl+O"));
}

TEST_F(ShortcutsTest, NoKeyLeadsToTheRobotWhileThereIsNone) {
    QAction& robot = command(Command::kStepRobot);
    Keys::get().choose("window/step_robot", QKeySequence("Ctrl+K"));
    EXPECT_TRUE(robot.shortcuts().isEmpty());
    const Step before = window_->step();
    QTest::keyClick(window_.get(), Qt::Key_K, Qt::ControlModifier);
    EXPECT_EQ(window_->step(), before);
    window_->actions().setRobotShown(true);
    EXPECT_EQ(robot.shortcuts(), QList<QKeySequence>{QKeySequence("Ctrl+K")});
    window_->actions().setRobotShown(false);
    EXPECT_TRUE(robot.shortcuts().isEmpty());
}

TEST_F(ShortcutsTest, TheUsualKeyCanBeHadBack) {
    QAction& jobs = command(Command::kJobs);
    EXPECT_EQ(give(jobs, Qt::Key_K, Qt::ControlModifier), "");
    EXPECT_EQ(give(jobs, Qt::Key_J, Qt::ControlModifier), "");
    EXPECT_EQ(jobs.shortcuts(), QList<QKeySequence>{QKeySequence("Ctrl+J")});
    EXPECT_FALSE(QSettings().contains("keys/window/jobs")) << "it is no choice any more";
    QAction& next = ofPage(Step::kReview, "review/next_frame");
    EXPECT_EQ(give(next, Qt::Key_K), "");
    EXPECT_EQ(give(next, Qt::Key_Right), "");
    EXPECT_EQ(next.shortcut(), QKeySequence("Right"));
}

TEST_F(ShortcutsTest, AnOwnKeyGoesBeforeTheUsualKeyOfANewCommand) {
    Keys::get().choose("window/jobs", QKeySequence("Ctrl+K"));
    QAction fresh;
    Keys::get().adopt(fresh, "window/fresh", {QKeySequence("Ctrl+K")});
    EXPECT_TRUE(fresh.shortcuts().isEmpty());
    Keys::get().restoreUsual();
    EXPECT_EQ(fresh.shortcut(), QKeySequence("Ctrl+K"));
}

}  // namespace
}  // namespace noctule::ui
