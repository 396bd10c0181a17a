// SPDX-License-Identifier: Apache-2.0
// Connect with the virtual suit's program, which streams the tiny take (two boards, two sources), and with
// its faults.
#include "ui/views/connect/connect_page.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QMenu>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTcpSocket>
#include <QTest>
#include <algorithm>

#include "core/recording/take.h"
#include "tests/devices/support/answerer.h"
#include "tests/devices/support/test_box.h"
#include "tests/support/take_files.h"
#include "tests/ui/support/wait.h"
#include "ui/models/part_names.h"
#include "ui/models/studio.h"
#include "ui/style/theme.h"
#include "ui/views/connect/assign_panel.h"
#include "ui/views/connect/board_card.h"
#include "ui/views/connect/body_map.h"
#include "ui/views/connect/device_card.h"
#include "ui/views/connect/devices_panel.h"
#include "ui/views/connect/live_pairs.h"
#include "ui/views/connect/map_marker.h"
#include "ui/views/connect/readiness_panel.h"
#include "ui/views/number_rows.h"
#include "ui/widgets/button.h"
#include "ui/widgets/name_field.h"
#include "ui/widgets/problem_card.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

namespace fs = std::filesystem;
using noctule::test::TestBox;

class ConnectPageTest : public testing::Test {
protected:
    void SetUp() override {
        Theme::install(*qApp);
        QSettings().clear();
        fs::remove_all(QStandardPaths::writableLocation(QStandardPaths::CacheLocation).toStdString());
        StudioParts parts;
        parts.software = "noctule test";
        parts.utc_now = [] { return std::string("2026-03-01T10:00:00Z"); };
        parts.make_sample_take = [](const std::string& path, const JobContext&) -> Status {
            fs::copy_file(noctule::test::kTinyTake, path);
            return Done{};
        };
        parts.virtual_suit_program = NOCTULE_PROGRAM;
        studio_ = std::make_unique<Studio>(parts);
        studio_->settings().setValue("folders/suits", QString::fromStdString(home_.file("suits")));
        ASSERT_TRUE(studio_->session().create(QString::fromStdString(home_.file("s")), "Test"));
        page_ = std::make_unique<ConnectPage>(*studio_);
        page_->leftDock()->setParent(nullptr);
        page_->rightDock()->setParent(nullptr);
        page_->resize(900, 740);
        page_->leftDock()->resize(248, 740);
        page_->rightDock()->resize(295, 740);
        page_->show();
        page_->leftDock()->show();
        page_->rightDock()->show();
        page_->enter();
    }
    void TearDown() override {
        delete page_->leftDock();
        delete page_->rightDock();
        page_.reset();
        studio_.reset();
    }

    QString verdict() { return page_->readiness().verdict(); }
    /// A box that nobody has calibrated.
    bool connectTo(const TestBox& box) {
        studio_->suit().connectTo(QString::fromStdString(box.address()));
        return waitFor([&] { return verdict() == "Connected"; });
    }
    void connectVirtualSuit() {
        QTest::mouseClick(page_->devices().virtualCard().button(), Qt::LeftButton);
        ASSERT_TRUE(waitFor([&] { return verdict() == "Ready"; })) << verdict().toStdString();
    }
    void tell(const QByteArray& command) {
        const QStringList control = studio_->virtualSuit().controlAddress().split(':');
        QTcpSocket socket;
        socket.connectToHost(control[0], control[1].toUShort());
        ASSERT_TRUE(socket.waitForConnected());
        socket.write(command + '\n');
        ASSERT_TRUE(waitFor([&] { return socket.canReadLine(); }));
        EXPECT_EQ(socket.readLine().trimmed(), "ok") << command.toStdString();
    }
    QStringList problems() {
        QStringList titles;
        for (const ProblemCard* card : page_->readiness().cards())
            titles << card->title();
        return titles;
    }
    Tone toneOfBoard(int board) { return static_cast<MapMarker*>(page_->map().boardButton(board))->tone(); }
    /// The button of the worst problem with this text.
    Button* action(const QString& text) {
        for (Button* button : page_->readiness().cards().at(0)->findChildren<Button*>())
            if (button->text() == text)
                return button;
        return nullptr;
    }

    const noctule::test::Folder home_;
    std::unique_ptr<Studio> studio_;
    std::unique_ptr<ConnectPage> page_;
};

TEST_F(ConnectPageTest, WithoutASuitItShowsWhereBoardsSitAndWhatToDo) {
    EXPECT_EQ(verdict(), "No suit is connected");
    EXPECT_EQ(page_->map().boardCount(), 18);
    EXPECT_TRUE(page_->pairs().isHidden());
    EXPECT_FALSE(page_->readiness().wayOn()->isVisible());
    EXPECT_FALSE(page_->assigning().findButton()->isEnabled());
    EXPECT_EQ(page_->devices().virtualCard().words().action, "Start");
}

TEST_F(ConnectPageTest, FromNothingToReady) {
    connectVirtualSuit();
    EXPECT_EQ(page_->devices().virtualCard().words().state, "connected");
    EXPECT_EQ(page_->readiness().numbers().value(0), "2 of 2");
    EXPECT_EQ(page_->map().boardCount(), 2);
    EXPECT_NE(toneOfBoard(0), Tone::kNeutral);
    EXPECT_TRUE(page_->pairs().isVisible());
    ASSERT_TRUE(waitFor([&] { return page_->pairs().grid().columnCount() == 2; }));
    QTest::mouseClick(page_->map().boardButton(1), Qt::LeftButton);
    EXPECT_EQ(page_->chosenBoard(), 1);
    EXPECT_EQ(page_->card().board(), 1);
    EXPECT_EQ(page_->pairs().grid().currentColumn(), 1);
    QSignalSpy steps(studio_.get(), &Studio::stepRequested);
    QTest::mouseClick(page_->readiness().wayOn(), Qt::LeftButton);
    ASSERT_EQ(steps.count(), 1);
    EXPECT_EQ(steps[0][0].value<Step>(), Step::kRecord);
    QTest::mouseClick(page_->devices().virtualCard().button(), Qt::LeftButton);
    EXPECT_EQ(verdict(), "No suit is connected");
    EXPECT_EQ(page_->map().boardCount(), 18);
}

TEST_F(ConnectPageTest, AnUnpluggedBoardIsNamedUntilItIsBackOrGoneOnWithout) {
    connectVirtualSuit();
    tell("unplug 2");
    ASSERT_TRUE(waitFor([&] { return verdict() == "Not ready yet"; }));
    EXPECT_EQ(problems().value(0), "Left hand sends nothing");
    EXPECT_EQ(toneOfBoard(1), Tone::kError);
    EXPECT_TRUE(page_->map().boardButton(1)->accessibleDescription().startsWith("no signal since"));
    EXPECT_EQ(page_->readiness().wayOn()->text(), "Continue without board 2");
    EXPECT_EQ(page_->readiness().numbers().value(0), "1 of 2");
    ASSERT_TRUE(action("Go on without it"));
    QTest::mouseClick(action("Go on without it"), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return verdict() == "Ready"; }));
    EXPECT_FALSE(problems().contains("Left hand sends nothing"));
    tell("plug 2");
    ASSERT_TRUE(waitFor([&] { return toneOfBoard(1) != Tone::kError; }));
    tell("unplug 2");
    EXPECT_TRUE(waitFor([&] { return verdict() == "Not ready yet"; })) << "what was accepted is over";
}

TEST_F(ConnectPageTest, AnUncalibratedSuitIsNotReadyAndTheButtonIsThere) {
    TestBox box({.loops = true});
    ASSERT_TRUE(connectTo(box)) << verdict().toStdString();
    EXPECT_TRUE(page_->readiness().verdictText().startsWith("Not calibrated: the body cannot move yet."))
        << page_->readiness().verdictText().toStdString();
    EXPECT_TRUE(page_->readiness().verdictText().contains("All 2 boards and 2 sources are here."))
        << page_->readiness().verdictText().toStdString();
    EXPECT_EQ(problems(), QStringList{"The suit is not calibrated"}) << problems().join(", ").toStdString();
    QSignalSpy steps(studio_.get(), &Studio::stepRequested);
    ASSERT_TRUE(action("Calibrate"));
    QTest::mouseClick(action("Calibrate"), Qt::LeftButton);
    EXPECT_EQ(page_->readiness().wayOn()->text(), "Continue to Calibrate");
    QTest::mouseClick(page_->readiness().wayOn(), Qt::LeftButton);
    ASSERT_EQ(steps.count(), 2);
    for (const auto& step : steps)
        EXPECT_EQ(step[0].value<Step>(), Step::kCalibrate);
}

TEST_F(ConnectPageTest, ACalibratedSuitIsReadyOnceItIsChecked) {
    TestBox box({.loops = true});
    ASSERT_TRUE(connectTo(box));
    const Take take = std::move(Take::open(noctule::test::kTinyTake).value());
    studio_->suit().setCalibration(take.calibrationInForce()->value);
    ASSERT_TRUE(waitFor([&] { return problems().contains("Not checked since it was put on"); }))
        << problems().join(", ").toStdString();
    EXPECT_EQ(verdict(), "Connected");
    QSignalSpy checks(studio_.get(), &Studio::checkRequested);
    ASSERT_TRUE(action("Check the suit"));
    QTest::mouseClick(action("Check the suit"), Qt::LeftButton);
    EXPECT_EQ(checks.count(), 1);
    studio_->setChecked(CheckedSuit{QDateTime::currentDateTime(), false});
    EXPECT_TRUE(problems().contains("Something has moved since the calibration"));
    EXPECT_EQ(verdict(), "Connected");
    studio_->setChecked(CheckedSuit{QDateTime::currentDateTime(), true});
    EXPECT_TRUE(waitFor([&] { return verdict() == "Ready"; }));
}

TEST_F(ConnectPageTest, BlinkingIsSeenAndNotOfferedForAnUnpluggedBoard) {
    connectVirtualSuit();
    QTest::mouseClick(page_->map().boardButton(0), Qt::LeftButton);
    const auto blink = [&]() -> Button* {
        for (Button* button : page_->card().findChildren<Button*>())
            if (button->text().contains("link"))
                return button;
        return nullptr;
    };
    ASSERT_TRUE(blink());
    EXPECT_EQ(blink()->text(), "Blink board 1");
    QTest::mouseClick(blink(), Qt::LeftButton);
    EXPECT_EQ(blink()->text(), "Board 1 blinks");
    EXPECT_EQ(page_->map().boardButton(0)->accessibleDescription(), "its light blinks");
    EXPECT_EQ(studio_->suit().blinkingBoard(), 0);
    EXPECT_TRUE(QTest::qWaitFor([&] { return studio_->suit().blinkingBoard() < 0; }, 8000));
    EXPECT_EQ(blink()->text(), "Blink board 1");
    tell("unplug 2");
    ASSERT_TRUE(waitFor([&] { return verdict() == "Not ready yet" && !studio_->suit().isPlugged(1); }));
    EXPECT_TRUE(waitFor([&] { return !action("Blink board 2"); })) << "once the cards are told anew";
    QTest::mouseClick(page_->map().boardButton(1), Qt::LeftButton);
    EXPECT_FALSE(blink()->isEnabled());
    studio_->suit().blinkBoard(1);
    EXPECT_EQ(studio_->suit().blinkingBoard(), -1);
}

TEST_F(ConnectPageTest, ABoxThatIsFoundHasTheFilledButton) {
    EXPECT_FALSE(page_->readiness().connectButton()->isVisible());
    TestBox box({.loops = true});
    auto announced = noctule::test::testAnnouncement();
    announced.tcp_port = box.port();
    noctule::test::Answerer answerer(announced);
    studio_->finder().start({answerer.port(), false});
    ASSERT_TRUE(waitFor([&] { return page_->readiness().connectButton()->isVisible(); }));
    EXPECT_EQ(page_->readiness().connectButton()->text(), "Connect Blue suit");
    QTest::mouseClick(page_->readiness().connectButton(), Qt::LeftButton);
    EXPECT_TRUE(waitFor([&] { return verdict() == "Connected"; }));
}

/// Of the box that has this serial number; null: it is not in the list.
const DeviceWords* wordsOf(const DevicesPanel& devices, const QString& serial) {
    for (const DeviceCard* card : devices.cards())
        if (card->words().serial == serial)
            return &card->words();
    return nullptr;
}

TEST_F(ConnectPageTest, ABoxWhoseAddressAnotherOneHasIsNotConnected) {
    const TestBox box({.loops = true});
    ASSERT_TRUE(connectTo(box));
    auto gone = noctule::test::testAnnouncement("NB-000999");
    gone.tcp_port = box.port();
    noctule::test::Answerer answerer(gone);
    studio_->finder().start({answerer.port(), false});
    DevicesPanel& devices = page_->devices();
    ASSERT_TRUE(waitFor([&] { return wordsOf(devices, "NB-000999") != nullptr; }));
    EXPECT_EQ(wordsOf(devices, "NB-000999")->state, "");
}

TEST_F(ConnectPageTest, ABoxThatAnswersAtAnotherAddressIsTheSameSuit) {
    auto before = std::make_unique<TestBox>(TestBox::Options{.loops = true});
    ASSERT_TRUE(connectTo(*before));
    const TestBox now({.loops = true});
    before.reset();
    ASSERT_TRUE(waitFor([&] { return studio_->suit().isLost(); }));
    auto announced = noctule::test::testAnnouncement();
    announced.tcp_port = now.port();
    noctule::test::Answerer answerer(announced);
    studio_->finder().start({answerer.port(), false});
    DevicesPanel& devices = page_->devices();
    ASSERT_TRUE(waitFor([&] { return devices.cards()[0]->words().state == "link broken"; }));
    EXPECT_EQ(devices.cards().size(), 1u);
    EXPECT_EQ(devices.cards()[0]->words().action, "Connect again");
    QTest::mouseClick(devices.cards()[0]->button(), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return devices.cards()[0]->words().state == "connected"; }));
    EXPECT_EQ(studio_->suits().connected().size(), 1u) << "nobody wears the same box twice";
    EXPECT_EQ(studio_->suit().address(), QString::fromStdString(now.address()));
}

TEST_F(ConnectPageTest, DeleteGoesOnWithoutTheChosenBoard) {
    connectVirtualSuit();
    tell("unplug 1");
    ASSERT_TRUE(waitFor([&] { return verdict() == "Not ready yet"; }));
    QTest::mouseClick(page_->map().boardButton(0), Qt::LeftButton);
    for (QAction* act : page_->actions())
        if (act->shortcut() == QKeySequence(Qt::Key_Delete))
            act->trigger();
    EXPECT_TRUE(waitFor([&] { return verdict() == "Ready"; }));
}

TEST_F(ConnectPageTest, ACutLinkIsSaidAndComesBack) {
    connectVirtualSuit();
    tell("cut 2");
    ASSERT_TRUE(waitFor([&] { return problems().value(0) == "The link is broken"; }));
    EXPECT_EQ(verdict(), "Not ready yet");
    const DeviceWords& words = page_->devices().virtualCard().words();
    EXPECT_TRUE(waitFor([&] { return words.state == "link broken"; }));
    EXPECT_TRUE(waitFor([&] { return verdict() == "Ready" && words.state == "connected"; }));
}

TEST_F(ConnectPageTest, ABoardDraggedOntoAnotherSwapsTheTwoAndIsUndone) {
    connectVirtualSuit();
    QAbstractButton* from = page_->map().boardButton(1);
    const QPoint to =
        from->mapFromGlobal(page_->map().mapToGlobal(page_->map().boardButton(0)->geometry().center()));
    QTest::mousePress(from, Qt::LeftButton);
    QTest::mouseMove(from, QPoint(40, 40));
    QMouseEvent move(QEvent::MouseMove, to, Qt::LeftButton, Qt::LeftButton, {});
    QApplication::sendEvent(from, &move);
    QApplication::sendEvent(from, &move);
    QTest::mouseRelease(from, Qt::LeftButton, {}, to);
    const auto segment = [&](size_t board) { return studio_->suit().suit().boards[board].segment; };
    ASSERT_TRUE(waitFor([&] { return segment(0) == "LeftHand"; }));
    EXPECT_EQ(segment(1), "Chest");
    const Suit& own = studio_->session().session().performers[0].suit;
    EXPECT_EQ(own.boards[0].serial, "NB-004100") << "remembered by serial number";
    studio_->session().undoStack().undo();
    EXPECT_EQ(segment(0), "Chest");
}

TEST_F(ConnectPageTest, FindingByMovingSaysWhatToDo) {
    connectVirtualSuit();
    AssignPanel& assigning = page_->assigning();
    QTest::mouseClick(assigning.findButton(), Qt::LeftButton);
    EXPECT_TRUE(assigning.isFinding());
    EXPECT_TRUE(assigning.words().startsWith("Move one limb"));
    EXPECT_TRUE(assigning.words().endsWith("Listening for 0 s.")) << assigning.words().toStdString();
    EXPECT_TRUE(waitFor([&] { return !assigning.words().contains("for 0 s"); })) << "seconds, or the board";
    QTest::mouseClick(assigning.findButton(), Qt::LeftButton);
    EXPECT_FALSE(assigning.isFinding());
}

TEST_F(ConnectPageTest, FoundBoxesAreCardsWithTheirState) {
    noctule::test::Answerer box(noctule::test::testAnnouncement());
    studio_->finder().start({box.port(), false});
    DevicesPanel& devices = page_->devices();
    ASSERT_TRUE(waitFor([&] { return devices.cards().size() == 1; }));
    EXPECT_EQ(devices.cards()[0]->words().name, "Blue suit");
    EXPECT_EQ(devices.cards()[0]->words().action, "Connect");
    auto busy = noctule::test::testAnnouncement();
    busy.busy = true;
    box.announce(busy);
    ASSERT_TRUE(waitFor([&] { return devices.cards()[0]->words().state == "busy"; }));
    EXPECT_EQ(devices.cards()[0]->words().action, "");
    studio_->finder().remember("NB-000777");
    box.answers(false);
    ASSERT_TRUE(waitFor([&] { return devices.cards()[0]->words().state == "not here"; }));
    EXPECT_EQ(devices.cards()[0]->words().action, "") << "no click meant for Disconnect forgets a suit";
    ASSERT_TRUE(devices.cards()[0]->menuButton()->isVisible());
    QAction* forget = devices.cards()[0]->menuButton()->menu()->actions().first();
    EXPECT_EQ(forget->text(), "Forget");
    forget->trigger();
    EXPECT_TRUE(waitFor([&] { return devices.cards().empty(); }));
}

TEST_F(ConnectPageTest, ABoxIsNamedInPlaceAndKeepsItsName) {
    noctule::test::Answerer box(noctule::test::testAnnouncement());
    studio_->finder().start({box.port(), false});
    DevicesPanel& devices = page_->devices();
    ASSERT_TRUE(waitFor([&] { return devices.cards().size() == 1; }));
    DeviceCard& card = *devices.cards()[0];
    const auto type = [&](const QString& name, Qt::Key end) {
        QTest::mouseClick(card.renameButton(), Qt::LeftButton);
        auto* field = card.findChild<NameField*>();
        ASSERT_TRUE(field);
        EXPECT_EQ(field->selectedText(), card.words().name);
        QTest::keyClicks(field, name);
        QTest::keyClick(field, end);
        ASSERT_TRUE(waitFor([&] { return !card.findChild<NameField*>(); }));
    };
    type("Stage left", Qt::Key_Return);
    EXPECT_EQ(card.words().name, "Stage left");
    type("nothing", Qt::Key_Escape);
    EXPECT_EQ(card.words().name, "Stage left");
    EXPECT_EQ(studio_->finder().suits().at(0).name, "Stage left");
    type("  ", Qt::Key_Return);
    EXPECT_EQ(card.words().name, "Blue suit") << "without a name of one's own the box's is shown";
}

TEST_F(ConnectPageTest, AWrongAddressIsToldInPlaceAndASilentOneInTheList) {
    DevicesPanel& devices = page_->devices();
    devices.addressField().setText("nowhere");
    QTest::keyClick(&devices.addressField(), Qt::Key_Return);
    EXPECT_TRUE(devices.addressProblem().contains("nowhere"));
    for (int times = 0; times < 2; ++times)
        for (QAbstractButton* button : devices.findChildren<QAbstractButton*>())
            if (button->text() == "Other address or port")
                button->click();
    EXPECT_EQ(devices.addressProblem(), "") << "the form is opened anew";
    devices.addressField().setText("tcp://127.0.0.1:9");
    QTest::keyClick(&devices.addressField(), Qt::Key_Return);
    EXPECT_EQ(devices.addressProblem(), "");
    const auto silent = [&] {  // boxes of other tests may be announced beside it
        const auto cards = devices.cards();
        const auto found =
            std::ranges::find_if(cards, [](const auto* card) { return card->words().state == "silent"; });
        return found == cards.end() ? nullptr : *found;
    };
    ASSERT_TRUE(waitFor([&] { return silent() != nullptr; }));
    EXPECT_EQ(silent()->words().action, "Ask again");
}

TEST_F(ConnectPageTest, TheCardOfABoardStandsWhereThereIsRoom) {
    connectVirtualSuit();
    EXPECT_TRUE(page_->isAncestorOf(&page_->card()));
    page_->resize(760, 740);
    EXPECT_TRUE(page_->readiness().isAncestorOf(&page_->card()));
    page_->resize(1000, 740);
    EXPECT_TRUE(page_->isAncestorOf(&page_->card()));
}

TEST_F(ConnectPageTest, ABoxOfAnchorsIsARoomAndNobodyWearsIt) {
    const TestBox box({.loops = true, .fixed = true});
    studio_->suit().connectTo(QString::fromStdString(box.address()));
    ASSERT_TRUE(waitFor([&] { return page_->map().boardCount() == 2; }));
    EXPECT_TRUE(page_->map().showsRoom());
    EXPECT_TRUE(page_->assigning().isHidden());
    auto announced = noctule::test::testAnnouncement();
    announced.tcp_port = box.port();
    noctule::test::Answerer answerer(announced);
    studio_->finder().start({answerer.port(), false});
    const auto& cards = page_->devices().cards();
    EXPECT_TRUE(waitFor([&] { return cards[0]->words().detail.endsWith("anchors of the room"); }));
    EXPECT_EQ(cards.size(), 1u);
    studio_->suit().disconnectSuit();
    ASSERT_TRUE(waitFor([&] { return page_->map().boardCount() == 18; }));
    EXPECT_FALSE(page_->map().showsRoom());
    EXPECT_FALSE(page_->assigning().isHidden());
}

}  // namespace
}  // namespace noctule::ui
