// SPDX-License-Identifier: Apache-2.0
// Contacts of the feet on the timeline: set, dragged, deleted, undone and written into the take.
#include "ui/plots/contact_bars.h"

#include <QAccessible>
#include <QSignalSpy>

#include "core/processing/take_contacts.h"
#include "tests/ui/plots/plots_fixture.h"
#include "ui/plots/timeline.h"

namespace noctule::ui {
namespace {

class ContactBarsTest : public test::PlotsFixture {
protected:
    void SetUp() override {
        PlotsFixture::SetUp();
        window_ = std::make_unique<TimeWindow>(studio_->time());
        timeline_ = std::make_unique<Timeline>(*studio_, *window_);
        show(*timeline_, 800, timeline_->sizeHint().height());
    }
    void TearDown() override {
        timeline_.reset();
        window_.reset();
        PlotsFixture::TearDown();
    }
    /// With these contacts as if they had been found and kept.
    void openWith(const std::vector<FootContacts>& feet) {
        if (!feet.empty()) {
            ASSERT_TRUE(changeContacts(path(), {.after = feet}, {}));
        }
        ASSERT_TRUE(open());
        ASSERT_TRUE(waitFor([this] { return studio_->contacts().contacts() != nullptr; }));
    }
    void openWithTwo() { openWith({{"LeftFoot", {{0.5, 1.0}, {1.5, 1.8}}}}); }

    void drag(const QPoint& from, const QPoint& to) {
        press(from);
        QMouseEvent move(QEvent::MouseMove, to, timeline_->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(timeline_.get(), &move);
        QTest::mouseRelease(timeline_.get(), Qt::LeftButton, {}, to);
    }
    void press(const QPoint& at) { QTest::mousePress(timeline_.get(), Qt::LeftButton, {}, at); }
    void click(const QPoint& at) { QTest::mouseClick(timeline_.get(), Qt::LeftButton, {}, at); }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(timeline_.get(), key, modifiers);
    }
    QPoint left(double t_s) const { return timeline_->footPoint(0, t_s); }
    QPoint right(double t_s) const { return timeline_->footPoint(1, t_s); }

    /// "LeftFoot 0.50-1.00 found", rounded to a hundredth.
    static QStringList words(const std::vector<FootContacts>& feet) {
        QStringList words;
        for (const FootContacts& foot : feet)
            for (const FootContact& contact : foot.contacts)
                words.append(QString("%1 %2-%3 %4")
                                 .arg(QString::fromStdString(foot.foot))
                                 .arg(contact.from_s, 0, 'f', 2)
                                 .arg(contact.to_s, 0, 'f', 2)
                                 .arg(contact.by_hand ? "by hand" : "found"));
        return words;
    }
    QStringList shown() const {
        const auto feet = studio_->contacts().contacts();
        return feet ? words(*feet) : QStringList{"not known"};
    }
    /// As the file says; "left to the results" unless an operator's hold.
    QStringList inFile() const {
        const auto edited = Take::open(path()).value().editedContacts().value();
        return edited ? words(*edited) : QStringList{"left to the results"};
    }
    bool become(const QStringList& wanted) {
        return waitFor([&] { return studio_->jobs().idle() && inFile() == wanted && shown() == wanted; });
    }
    QStringList both() const { return inFile() + QStringList{"shown:"} + shown(); }
    UndoHistory& undo() { return studio_->session().undoStack(); }

    std::unique_ptr<TimeWindow> window_;
    std::unique_ptr<Timeline> timeline_;
};

TEST_F(ContactBarsTest, AnEndIsDraggedToAFrame) {
    openWithTwo();
    drag(left(1.0), left(1.2));
    ASSERT_TRUE(become({"LeftFoot 0.50-1.20 by hand", "LeftFoot 1.50-1.80 found"}))
        << both().join(", ").toStdString();
    const double to_s = studio_->contacts().contacts()->front().contacts.front().to_s;
    EXPECT_NEAR(to_s * 140, std::round(to_s * 140), 1e-4) << "on a frame";
    drag(left(0.5), left(0.3));
    ASSERT_TRUE(become({"LeftFoot 0.30-1.20 by hand", "LeftFoot 1.50-1.80 found"}));
    undo().undo();
    undo().undo();
    ASSERT_TRUE(become({"LeftFoot 0.50-1.00 found", "LeftFoot 1.50-1.80 found"}));
    undo().redo();
    EXPECT_TRUE(become({"LeftFoot 0.50-1.20 by hand", "LeftFoot 1.50-1.80 found"}));
}

TEST_F(ContactBarsTest, ABarIsDraggedWholeAndStaysInTheTake) {
    openWithTwo();
    const double before_s = studio_->time().time();
    drag(left(1.65), left(1.35));
    ASSERT_TRUE(become({"LeftFoot 0.50-1.00 found", "LeftFoot 1.20-1.50 by hand"}))
        << both().join(", ").toStdString();
    EXPECT_EQ(studio_->time().time(), before_s) << "the cursor stays";
    drag(left(1.35), left(1.99));
    EXPECT_TRUE(become({"LeftFoot 0.50-1.00 found", "LeftFoot 1.70-2.00 by hand"}))
        << both().join(", ").toStdString();
}

TEST_F(ContactBarsTest, BarsThatMeetBecomeOne) {
    openWithTwo();
    drag(left(1.0), left(1.6));
    EXPECT_TRUE(become({"LeftFoot 0.50-1.80 by hand"})) << both().join(", ").toStdString();
}

TEST_F(ContactBarsTest, APressAloneChoosesAndChangesNothing) {
    openWithTwo();
    click(left(0.75));
    EXPECT_TRUE(timeline_->contactBars().hasChosen());
    EXPECT_EQ(timeline_->contactBars().chosenWords(), "Left foot stands from 0:00.50 to 0:01.00, found");
    EXPECT_EQ(undo().count(), 0);
    QAccessibleInterface* slider = QAccessible::queryAccessibleInterface(timeline_.get());
    EXPECT_TRUE(
        slider->text(QAccessible::Value).endsWith("; Left foot stands from 0:00.50 to 0:01.00, found"));
}

TEST_F(ContactBarsTest, ADoubleClickWhereNothingIsSetsOne) {
    openWith({});
    EXPECT_FALSE(studio_->contacts().areEdited());
    QSignalSpy said(studio_.get(), &Studio::said);
    QTest::mouseDClick(timeline_.get(), Qt::LeftButton, {}, right(1.0));
    ASSERT_TRUE(become({"RightFoot 0.90-1.10 by hand"})) << both().join(", ").toStdString();
    EXPECT_TRUE(studio_->contacts().areEdited());
    EXPECT_EQ(said.count(), 1) << "from now on they are the operator's";
    EXPECT_TRUE(window_->showsAll());
    QTest::mouseDClick(timeline_.get(), Qt::LeftButton, {}, right(1.0));
    EXPECT_EQ(undo().count(), 1) << "there is one already";
    undo().undo();
    EXPECT_TRUE(waitFor([this] { return inFile() == QStringList{"left to the results"}; }));
    EXPECT_TRUE(waitFor([this] { return shown().isEmpty() && !studio_->contacts().areEdited(); }));
}

TEST_F(ContactBarsTest, DeleteClearsAndNoneIsAlsoAWord) {
    openWithTwo();
    click(left(0.75));
    key(Qt::Key_Delete);
    ASSERT_TRUE(become({"LeftFoot 1.50-1.80 found"}));
    click(left(1.65));
    key(Qt::Key_Delete);
    ASSERT_TRUE(become({}));
    EXPECT_TRUE(studio_->contacts().areEdited());
    undo().undo();
    undo().undo();
    EXPECT_TRUE(become({"LeftFoot 0.50-1.00 found", "LeftFoot 1.50-1.80 found"}));
}

TEST_F(ContactBarsTest, AllOfItGoesByKeyboard) {
    openWithTwo();
    studio_->time().setTime(0.6);
    key(Qt::Key_Up);
    EXPECT_EQ(timeline_->contactBars().chosenWords(), "Left foot stands from 0:00.50 to 0:01.00, found");
    key(Qt::Key_I);
    ASSERT_TRUE(become({"LeftFoot 0.60-1.00 by hand", "LeftFoot 1.50-1.80 found"}))
        << both().join(", ").toStdString();
    key(Qt::Key_Right, Qt::ControlModifier);
    EXPECT_NEAR(studio_->time().time(), 1.5, 1e-6);
    studio_->time().setTime(1.9);
    key(Qt::Key_O);
    ASSERT_TRUE(become({"LeftFoot 0.60-1.00 by hand", "LeftFoot 1.50-1.90 by hand"}));
    key(Qt::Key_Down);
    EXPECT_FALSE(timeline_->contactBars().hasChosen()) << "the right foot never stands";
    studio_->time().setTime(1.0);
    key(Qt::Key_Insert);
    ASSERT_TRUE(
        become({"LeftFoot 0.60-1.00 by hand", "LeftFoot 1.50-1.90 by hand", "RightFoot 0.90-1.10 by hand"}))
        << both().join(", ").toStdString();
    key(Qt::Key_Delete);
    ASSERT_TRUE(become({"LeftFoot 0.60-1.00 by hand", "LeftFoot 1.50-1.90 by hand"}));
    key(Qt::Key_Escape);
    key(Qt::Key_Delete);
    EXPECT_EQ(undo().count(), 4) << "none is chosen any more";
}

TEST_F(ContactBarsTest, QuickEditsFollowEachOther) {
    openWithTwo();
    drag(left(1.0), left(1.2));
    drag(left(1.5), left(1.4));  // before the first one is written
    timeline_->contactBars().removeChosen();
    EXPECT_TRUE(become({"LeftFoot 0.50-1.20 by hand"})) << both().join(", ").toStdString();
    undo().undo();
    undo().undo();
    EXPECT_TRUE(become({"LeftFoot 0.50-1.20 by hand", "LeftFoot 1.50-1.80 found"}));
}

TEST_F(ContactBarsTest, BackToWhatWasFound) {
    openWithTwo();
    EXPECT_TRUE(studio_->contacts().areEdited());
    timeline_->contactBars().restoreFound();
    ASSERT_TRUE(waitFor([this] { return inFile() == QStringList{"left to the results"}; }));
    ASSERT_TRUE(waitFor([this] { return shown().isEmpty(); })) << "in this motion no foot is found to stand";
    EXPECT_FALSE(studio_->contacts().areEdited());
    undo().undo();
    EXPECT_TRUE(become({"LeftFoot 0.50-1.00 found", "LeftFoot 1.50-1.80 found"}));
}

TEST_F(ContactBarsTest, WhatCannotBeWrittenIsToldAndLeavesTheStack) {
    openWithTwo();
    std::filesystem::rename(path(), path() + ".away");
    QSignalSpy failed(studio_.get(), &Studio::failed);
    drag(left(1.0), left(1.2));
    ASSERT_TRUE(waitFor([&] { return failed.count() == 1; }));
    std::filesystem::rename(path() + ".away", path());
    EXPECT_TRUE(become({"LeftFoot 0.50-1.00 found", "LeftFoot 1.50-1.80 found"}));
    undo().undo();
    EXPECT_EQ(undo().count(), 0);
    drag(left(1.0), left(1.2));
    EXPECT_TRUE(become({"LeftFoot 0.50-1.20 by hand", "LeftFoot 1.50-1.80 found"}));
}

TEST_F(ContactBarsTest, TheMenuOffersWhatCanBeDone) {
    openWithTwo();
    studio_->time().setTime(1.2);
    const auto offered = [&] {
        QStringList texts;
        for (const QAction* action : timeline_->findChild<QMenu*>()->actions())
            if (!action->isSeparator() && action->isEnabled())
                texts.append(action->text());
        return texts;
    };
    const auto openMenu = [&](const QPoint& at) {
        QStringList texts;
        QTimer::singleShot(0, timeline_.get(), [&] {
            texts = offered();
            timeline_->findChild<QMenu*>()->close();
        });
        QContextMenuEvent event(QContextMenuEvent::Mouse, at, timeline_->mapToGlobal(at));
        QApplication::sendEvent(timeline_.get(), &event);
        return texts;
    };
    EXPECT_EQ(openMenu(left(0.75)),
              QStringList({"End at the cursor", "Delete contact", "Back to what was found"}));
    EXPECT_EQ(openMenu(right(0.75)), QStringList({"Set a contact at the cursor", "Back to what was found"}));
}

}  // namespace
}  // namespace noctule::ui
