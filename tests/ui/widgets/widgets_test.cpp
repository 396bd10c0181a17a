// SPDX-License-Identifier: Apache-2.0
// What the widgets do: clicks, keys, signals, and what screen readers hear.
#include "ui/widgets/widgets.h"

#include <gtest/gtest.h>

#include <QAccessible>
#include <QApplication>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTest>
#include <QVBoxLayout>
#include <cmath>
#include <memory>

namespace noctule::ui {
namespace {

class WidgetsTest : public testing::Test {
protected:
    void SetUp() override { Theme::install(*qApp); }

    static void show(QWidget& widget) {
        widget.show();
        widget.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&widget));
        QApplication::setActiveWindow(&widget);
    }
    static QAccessibleInterface* reader(QWidget& widget) {
        return QAccessible::queryAccessibleInterface(&widget);
    }
};

TEST_F(WidgetsTest, ratingByMouse) {
    RatingStars stars(2);
    show(stars);
    QSignalSpy changed(&stars, &RatingStars::ratingChanged);
    const auto click = [&stars](int star) {
        QTest::mouseClick(&stars, Qt::LeftButton, {},
                          {stars.width() * (2 * star - 1) / 10, stars.height() / 2});
    };
    click(4);
    EXPECT_EQ(stars.rating(), 4);
    click(4);
    EXPECT_EQ(stars.rating(), 0) << "the same star takes the rating back";
    EXPECT_EQ(changed.count(), 2);
    stars.setRating(3);
    EXPECT_EQ(changed.count(), 2) << "the program's own changes are no user's";
}

TEST_F(WidgetsTest, ratingByKeysAndItsReader) {
    RatingStars stars;
    QTest::keyClick(&stars, Qt::Key_5);
    EXPECT_EQ(stars.rating(), 5);
    QTest::keyClick(&stars, Qt::Key_Right);
    EXPECT_EQ(stars.rating(), 5);
    QTest::keyClick(&stars, Qt::Key_Left);
    EXPECT_EQ(stars.rating(), 4);
    QTest::keyClick(&stars, Qt::Key_0);
    EXPECT_EQ(stars.rating(), 0);
    QTest::keyClick(&stars, Qt::Key_3, Qt::ControlModifier);
    EXPECT_EQ(stars.rating(), 0) << "Ctrl+3 is a step";
    ASSERT_TRUE(reader(stars));
    EXPECT_EQ(reader(stars)->role(), QAccessible::Slider);
    auto* value = reader(stars)->valueInterface();
    ASSERT_TRUE(value);
    value->setCurrentValue(2);
    EXPECT_EQ(stars.rating(), 2);
    EXPECT_EQ(value->maximumValue().toInt(), 5);
}

TEST_F(WidgetsTest, stepsByMouseAndKeys) {
    StepBar steps({"Connect", "Calibrate", "Record"});
    show(steps);
    QSignalSpy clicked(&steps, &StepBar::stepClicked);
    steps.setCurrent(0);
    auto* second = steps.childAt(steps.stepRect(1).center());
    ASSERT_TRUE(second);
    QTest::mouseClick(second, Qt::LeftButton);
    ASSERT_EQ(clicked.count(), 1);
    EXPECT_EQ(clicked[0][0].toInt(), 1);
    EXPECT_EQ(steps.current(), 0) << "the page decides what is present";
    second->setFocus();
    QTest::keyClick(second, Qt::Key_Right);
    auto* third = QApplication::focusWidget();
    ASSERT_NE(third, second);
    QTest::keyClick(third, Qt::Key_Return);
    ASSERT_EQ(clicked.count(), 2);
    EXPECT_EQ(clicked[1][0].toInt(), 2);
    QTest::keyClick(third, Qt::Key_Right);
    EXPECT_EQ(QApplication::focusWidget(), third) << "the last step is the last";
    steps.setState(2, StepBar::State::kAttention);
    EXPECT_EQ(reader(*third)->text(QAccessible::Name).toStdString(), "Record");
    EXPECT_EQ(reader(*third)->text(QAccessible::Description).toStdString(), "Needs attention");
}

TEST_F(WidgetsTest, disabledButtonSaysWhy) {
    Button* button = makeButton(ButtonKind::kPrimary, "Export", "export", QKeySequence("Ctrl+E"));
    button->setToolTip("Writes the files");
    button->setDisabledBecause("There is no take.");
    EXPECT_FALSE(button->isEnabled());
    EXPECT_EQ(button->toolTip().toStdString(), "There is no take.");
    button->setDisabledBecause("The take is not processed.");
    button->setDisabledBecause({});
    EXPECT_TRUE(button->isEnabled());
    EXPECT_EQ(button->toolTip().toStdString(), "Writes the files");
    delete button;
}

TEST_F(WidgetsTest, shortcutMakesAButtonWiderAndIsTold) {
    const std::unique_ptr<Button> plain(makeButton(ButtonKind::kOutlined, "Close"));
    const std::unique_ptr<Button> hinted(makeButton(ButtonKind::kOutlined, "Close", {}, QKeySequence("Esc")));
    EXPECT_GT(hinted->sizeHint().width(), plain->sizeHint().width() + 20);
    EXPECT_EQ(hinted->accessibleDescription().toStdString(), "Esc");
    EXPECT_TRUE(hinted->shortcut().isEmpty()) << "an action acts on it, not the button";
}

TEST_F(WidgetsTest, heightsOfTheGuide) {
    const std::unique_ptr<Button> primary(makeButton(ButtonKind::kPrimary, "Export"));
    const std::unique_ptr<Button> outlined(makeButton(ButtonKind::kOutlined, "Close"));
    EXPECT_EQ(primary->sizeHint().height(), 38);
    EXPECT_EQ(outlined->sizeHint().height(), 30);
    EXPECT_EQ(ToolButton("play", "Play").sizeHint(), QSize(28, 28));
    EXPECT_EQ(DockTitle("Report").sizeHint().height(), 36);
}

TEST_F(WidgetsTest, toolButtonTellsItsNameAndShortcut) {
    ToolButton button("play", "Play", QKeySequence("Space"));
    EXPECT_EQ(button.toolTip().toStdString(), "Play (Space)");
    EXPECT_EQ(button.accessibleName().toStdString(), "Play");
    button.setMeaning("pause", "Pause");
    EXPECT_EQ(button.toolTip().toStdString(), "Pause");
    button.setDisabledBecause("No take is open.");
    EXPECT_EQ(button.toolTip().toStdString(), "No take is open.");
    button.setDisabledBecause({});
    EXPECT_EQ(button.toolTip().toStdString(), "Pause");
}

TEST_F(WidgetsTest, problemCardActs) {
    ProblemCard card(Tone::kError, "Left foot sends nothing", "Board 15 fell silent.");
    Button* blink = card.addAction("Blink board 15", "blink");
    Button* skip = card.addAction("Go on without it");
    EXPECT_EQ(blink->kind(), ButtonKind::kOutlined);
    EXPECT_EQ(skip->kind(), ButtonKind::kText);
    card.setClosable(true);
    show(card);
    QSignalSpy closed(&card, &ProblemCard::closed);
    QTest::mouseClick(card.findChild<ToolButton*>(), Qt::LeftButton);
    EXPECT_EQ(closed.count(), 1);
    EXPECT_EQ(reader(card)->role(), QAccessible::AlertMessage);
    EXPECT_EQ(reader(card)->text(QAccessible::Name).toStdString(), "Left foot sends nothing");
}

TEST_F(WidgetsTest, problemCardStacksActionsThatFindNoRoomBesideOneAnother) {
    QWidget panel;
    panel.resize(700, 300);
    ProblemCard card(Tone::kWarn, "Source 6 is faint", "Short.", &panel);
    Button* check = card.addAction("Check the suit once more");
    Button* go_on = card.addAction("Go on without the source");
    card.resize(600, 200);
    show(panel);
    EXPECT_EQ(check->y(), go_on->y());
    const int least = card.minimumSizeHint().width();
    EXPECT_LT(least, check->width() + go_on->width());
    card.resize(least, 200);
    ASSERT_TRUE(QTest::qWaitFor([&] { return go_on->y() > check->y(); }));
    EXPECT_GE(go_on->y(), check->geometry().bottom());
    EXPECT_LE(std::max(check->geometry().right(), go_on->geometry().right()), card.width());
}

TEST_F(WidgetsTest, problemCardGrowsWithItsText) {
    ProblemCard card(Tone::kWarn, "Source 6 is faint", "Short.");
    show(card);
    card.resize(260, 10);
    const int before = card.heightForWidth(260);
    card.setTexts("Source 6 is faint", QString("A long text that needs many lines. ").repeated(8));
    EXPECT_GT(card.heightForWidth(260), before + 40);
}

TEST_F(WidgetsTest, searchWaitsForAPause) {
    SearchField field("Find a take");
    show(field);
    QSignalSpy searched(&field, &SearchField::searched);
    QTest::keyClicks(&field, "walk");
    EXPECT_EQ(searched.count(), 0);
    ASSERT_TRUE(searched.wait(1000));
    EXPECT_EQ(searched.last()[0].toString().toStdString(), "walk");
    QTest::keyClick(&field, Qt::Key_Escape);
    EXPECT_TRUE(field.text().isEmpty());
    EXPECT_EQ(searched.last()[0].toString().toStdString(), "");
}

TEST_F(WidgetsTest, progressIsKnownOrNot) {
    ProgressLine line;
    auto* bar = line.findChild<QProgressBar*>();
    line.setFraction(0.25);
    EXPECT_EQ(bar->value() * 4, bar->maximum());
    line.setFraction(-1);
    EXPECT_EQ(bar->maximum(), 0);
    QSignalSpy cancelled(&line, &ProgressLine::cancelled);
    show(line);
    QTest::mouseClick(line.findChild<Button*>(), Qt::LeftButton);
    EXPECT_EQ(cancelled.count(), 1);
}

TEST_F(WidgetsTest, meterKeepsToItsRangeAndIsRead) {
    BarMeter meter;
    meter.setValue(1.7);
    EXPECT_DOUBLE_EQ(meter.fraction(), 1);
    meter.setValue(std::nan(""));
    EXPECT_DOUBLE_EQ(meter.fraction(), 0);
    meter.setValue(0.71, Tone::kWarn, "71 percent of ranges");
    EXPECT_EQ(reader(meter)->role(), QAccessible::ProgressBar);
    EXPECT_DOUBLE_EQ(reader(meter)->valueInterface()->currentValue().toDouble(), 0.71);
    EXPECT_EQ(reader(meter)->text(QAccessible::Name).toStdString(), "71 percent of ranges");
}

TEST_F(WidgetsTest, sectionOpensAndCloses) {
    auto* content = new Label("inside");
    CollapsibleSection section("Details", content, false);
    show(section);
    EXPECT_FALSE(content->isVisible());
    auto* heading = section.findChild<QAbstractButton*>();
    QTest::keyClick(heading, Qt::Key_Return);
    EXPECT_TRUE(content->isVisible());
    QTest::keyClick(heading, Qt::Key_Left);
    EXPECT_FALSE(content->isVisible());
    EXPECT_FALSE(section.isOpen());
}

TEST_F(WidgetsTest, formNamesItsControls) {
    FormRows form;
    auto* field = new QLineEdit;
    Label* label = form.addRow("File name", field);
    EXPECT_EQ(label->buddy(), field);
    EXPECT_EQ(field->accessibleName().toStdString(), "File name");
}

TEST_F(WidgetsTest, elidedTextIsInTheTooltipOnly) {
    ElidedLabel label("a name that is far too long for its place");
    EXPECT_LT(label.minimumSizeHint().width(), label.sizeHint().width() / 3);
    EXPECT_EQ(label.text().toStdString(), "a name that is far too long for its place");
}

TEST_F(WidgetsTest, scrollAreaIsNeverNarrowerThanItsContent) {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    for (int i = 0; i < 40; ++i)
        column->addWidget(makeButton(ButtonKind::kOutlined, "A button with some words in it"));
    ScrollArea area(content);
    area.resize(area.minimumSizeHint().width(), 200);
    show(area);
    EXPECT_GE(area.minimumSizeHint().width(), content->minimumSizeHint().width());
    auto* last = content->findChildren<Button*>().last();
    last->setFocus(Qt::TabFocusReason);
    QApplication::processEvents();
    EXPECT_TRUE(area.viewport()->rect().contains(last->mapTo(area.viewport(), last->rect().center())));
}

TEST_F(WidgetsTest, scrollAreaDoesNotFollowTheFocusThatNobodyMoved) {
    auto* content = new QWidget;
    auto* rows = new QVBoxLayout(content);
    for (int i = 0; i < 40; ++i)
        rows->addWidget(makeButton(ButtonKind::kOutlined, "A button"));
    auto* area = new ScrollArea(content);
    auto* other = makeButton(ButtonKind::kOutlined, "Another page");
    QStackedWidget pages;
    pages.addWidget(area);
    pages.addWidget(other);
    pages.resize(300, 200);
    show(pages);
    content->findChildren<Button*>().last()->setFocus(Qt::TabFocusReason);
    QApplication::processEvents();
    area->verticalScrollBar()->setValue(0);
    pages.setCurrentWidget(other);
    QApplication::processEvents();
    pages.setCurrentWidget(area);
    QApplication::processEvents();
    EXPECT_EQ(area->verticalScrollBar()->value(), 0) << "the page came back, and its focus with it";
    area->verticalScrollBar()->setValue(area->verticalScrollBar()->maximum());
    const int low = area->verticalScrollBar()->value();
    content->findChildren<Button*>().last()->hide();
    QApplication::processEvents();
    EXPECT_GT(area->verticalScrollBar()->value(), low / 2) << "what had the focus went";
}

TEST_F(WidgetsTest, scrollAreaKeepsNoHeightOfTextsThatAreHidden) {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    auto* text = new Label(QString("many words ").repeated(200), TextRole::kBody, Ink::kValue);
    text->wrapped();
    column->addWidget(text);
    column->addWidget(makeButton(ButtonKind::kOutlined, "A button"));
    ScrollArea area(content);
    area.resize(200, 200);
    show(area);
    ASSERT_GT(area.verticalScrollBar()->maximum(), 0);
    text->hide();
    EXPECT_TRUE(QTest::qWaitFor([&] { return area.verticalScrollBar()->maximum() == 0; }));
    EXPECT_LE(content->height(), 200);
}

TEST_F(WidgetsTest, aScrollAreaMayGiveItsContentAway) {
    auto* content = new QWidget;
    auto* text = new Label(QString("many words ").repeated(200), TextRole::kBody, Ink::kValue);
    (new QVBoxLayout(content))->addWidget(text->wrapped());
    ScrollArea area(content);
    area.resize(200, 200);
    show(area);
    ASSERT_GT(content->minimumHeight(), 200);
    const std::unique_ptr<QWidget> taken(area.takeWidget());
    area.resize(300, 100);
    QApplication::processEvents();
    EXPECT_EQ(taken.get(), content);
    EXPECT_EQ(area.widget(), nullptr);
}

TEST_F(WidgetsTest, emptyStateOffersItsAction) {
    EmptyState state("Takes will be listed here.", "Record a take");
    show(state);
    QSignalSpy activated(&state, &EmptyState::activated);
    QTest::mouseClick(state.button(), Qt::LeftButton);
    EXPECT_EQ(activated.count(), 1);
    EXPECT_EQ(EmptyState("Nothing to do.").button(), nullptr);
    state.resize(1400, 300);
    QApplication::processEvents();
    EXPECT_NEAR(state.findChild<Label*>()->geometry().center().x(), state.button()->geometry().center().x(),
                1)
        << "on a wide page too";
}

}  // namespace
}  // namespace noctule::ui
