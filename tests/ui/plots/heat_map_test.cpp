// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/heat_map.h"

#include <QAccessible>
#include <QSignalSpy>

#include "tests/ui/plots/plots_fixture.h"

namespace noctule::ui {
namespace {

class HeatMapTest : public test::PlotsFixture {
protected:
    void SetUp() override {
        PlotsFixture::SetUp();
        map_ = std::make_unique<HeatMap>(*studio_);
        show(*map_, 400, 300);
        ASSERT_TRUE(open());
        ASSERT_TRUE(waitFor([this] { return map_->grid().columnCount() == 2; }));
    }
    void TearDown() override {
        map_.reset();
        PlotsFixture::TearDown();
    }
    void click(int row, int column) {
        QTest::mouseClick(&map_->grid(), Qt::LeftButton, {}, map_->grid().cellRect(row, column).center());
    }
    std::unique_ptr<HeatMap> map_;
};

TEST_F(HeatMapTest, CellsSayWhatThePairsDid) {
    const PairGridContent& content = map_->grid().content();
    ASSERT_EQ(content.cells.size(), 2u);
    EXPECT_EQ(content.cell(0, 0).state, PairCell::State::kHeard);
    EXPECT_NEAR(content.cell(0, 0).confidence, 0.2, 0.005);  // 0.25 in four of five pulses
    EXPECT_EQ(content.cell(0, 1).state, PairCell::State::kLost);
    EXPECT_EQ(content.cell(0, 0).words, "Source 1 to board 1, right forearm: 0.20");
    ASSERT_EQ(content.groups.size(), 2u);
    EXPECT_EQ(content.groups[0].name, "R arm");
}

TEST_F(HeatMapTest, AClickChoosesThePairEverywhere) {
    QSignalSpy chosen(&studio_->selection(), &Selection::pairChanged);
    click(0, 0);
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(studio_->selection().source(), 0);
    EXPECT_EQ(studio_->selection().board(), 0);
    EXPECT_EQ(map_->readout(),
              "Source 1 to board 1, right forearm: 0.20\n96 ranges kept, 48 left out, residual 2.0\u00A0mm");
}

TEST_F(HeatMapTest, FollowsTheSelectionOfOthers) {
    studio_->selection().setPair(0, 1);
    EXPECT_EQ(map_->grid().currentColumn(), 1);
    EXPECT_TRUE(map_->readout().startsWith("Board 2, left hand, hears no source"));
}

TEST_F(HeatMapTest, ArrowsWalkTheCells) {
    map_->grid().setFocus();
    QTest::keyClick(&map_->grid(), Qt::Key_Right);  // nothing is chosen yet: the first cell
    EXPECT_EQ(studio_->selection().board(), 0);
    QTest::keyClick(&map_->grid(), Qt::Key_Right);
    EXPECT_EQ(studio_->selection().board(), 1);
    QTest::keyClick(&map_->grid(), Qt::Key_Right);
    EXPECT_EQ(studio_->selection().board(), 1);
    QTest::keyClick(&map_->grid(), Qt::Key_Home);
    EXPECT_EQ(studio_->selection().board(), 0);
}

TEST_F(HeatMapTest, FollowsInAndOutAndTheCursor) {
    click(0, 0);
    studio_->time().setRange(0, 0.5);
    EXPECT_TRUE(waitFor([this] { return map_->readout().contains("26 ranges kept"); }))
        << map_->readout().toStdString();
    studio_->time().setTime(1);
    map_->setShowsCursor(true);
    const PairCell& cell = map_->grid().content().cell(0, 0);
    EXPECT_EQ(cell.state, PairCell::State::kHeard);
    EXPECT_NE(map_->readout().indexOf("ranges kept"), -1);
}

TEST_F(HeatMapTest, IsATableToScreenReaders) {
    QAccessibleInterface* grid = QAccessible::queryAccessibleInterface(&map_->grid());
    ASSERT_NE(grid, nullptr);
    EXPECT_EQ(grid->role(), QAccessible::Table);
    QAccessibleTableInterface* table = grid->tableInterface();
    ASSERT_NE(table, nullptr);
    EXPECT_EQ(table->rowCount(), 1);
    EXPECT_EQ(table->columnCount(), 2);
    click(0, 0);
    QAccessibleInterface* cell = table->cellAt(0, 0);
    ASSERT_NE(cell, nullptr);
    EXPECT_EQ(cell->role(), QAccessible::Cell);
    EXPECT_EQ(cell->text(QAccessible::Name), "Source 1 to board 1, right forearm: 0.20");
    EXPECT_EQ(cell->text(QAccessible::Value), "0.20");
    EXPECT_TRUE(cell->state().selected);
    EXPECT_FALSE(table->cellAt(0, 1)->state().selected);
    EXPECT_TRUE(cell->rect().contains(map_->grid().mapToGlobal(map_->grid().cellRect(0, 0).center())));
}

TEST_F(HeatMapTest, WithoutATakeASentenceSaysWhatWillBeHere) {
    studio_->take().close();
    EXPECT_EQ(map_->grid().columnCount(), 0);
    EXPECT_TRUE(map_->readout().startsWith("Open a take"));
}

/// Opens the take that a test has changed.
class HeatMapOfATake : public test::PlotsFixture {
protected:
    void TearDown() override {
        map_.reset();
        PlotsFixture::TearDown();
    }
    void openIn() {
        map_ = std::make_unique<HeatMap>(*studio_);
        show(*map_, 400, 300);
        studio_->take().open(QString::fromStdString(path()));
        ASSERT_TRUE(waitFor([this] { return studio_->take().isOpen(); }));
    }
    std::unique_ptr<HeatMap> map_;
};

TEST_F(HeatMapOfATake, WithoutSourceOffsetsBoardsAreHeardAndNotUsable) {
    auto take = Take::open(path(), Access::kReadWrite);
    ASSERT_TRUE(take) << take.error().text();
    auto edit = TakeEdit::begin(*take);
    ASSERT_TRUE(edit);
    ASSERT_TRUE(edit->setMeta("level", "signal"));
    ASSERT_TRUE(edit->commit());
    openIn();
    ASSERT_TRUE(waitFor([this] { return map_->grid().columnCount() == 2; }));
    studio_->selection().setPair(0, 1);
    EXPECT_TRUE(
        map_->readout().startsWith("Board 2, left hand: heard, but not usable without source offsets"))
        << map_->readout().toStdString();
}

class HeatMapWithoutResult : public HeatMapOfATake {
protected:
    void addResults() override {}
};

TEST_F(HeatMapWithoutResult, SaysSoAndNotThatItReads) {
    openIn();
    EXPECT_TRUE(waitFor([this] { return map_->readout().startsWith("This take has no result yet."); }))
        << map_->readout().toStdString();
    EXPECT_FALSE(map_->readout().contains("Reading ranges"));
}

TEST(PairGridTest, CellsShareTheRoomAtAnySize) {
    Theme::install(*qApp);
    PairGrid grid;
    PairGridContent content;
    content.rows.resize(32);
    content.columns.resize(32);
    content.cells.resize(32 * 32);
    grid.setContent(content);
    for (const QSize size : {grid.minimumSizeHint(), QSize(900, 700)}) {
        grid.resize(size);
        for (const QPoint cell : {QPoint(0, 0), QPoint(17, 5), QPoint(31, 31)}) {
            const QRect rect = grid.cellRect(cell.y(), cell.x());
            EXPECT_GE(rect.width(), 8);
            EXPECT_TRUE(grid.rect().contains(rect));
            EXPECT_EQ(grid.cellAt(rect.center()), cell);
        }
    }
}

}  // namespace
}  // namespace noctule::ui
