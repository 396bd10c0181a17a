// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/level_meters.h"

#include <gtest/gtest.h>

#include <QAccessible>
#include <QApplication>
#include <QImage>
#include <QSignalSpy>
#include <QTest>

#include "ui/plots/pairs_heard.h"
#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

class LevelMetersTest : public testing::Test {
protected:
    void SetUp() override {
        Theme::install(*qApp);
        meters_ = std::make_unique<LevelMeters>();
        meters_->resize(436, 160);
        meters_->setGroups({{"Trunk", 0, 1}, {"Left arm", 2, 3}});
        meters_->setLevels({{"Hips (board 1)", -24, -12, -36, false, false},
                            {"Chest (board 2)", -6, -0.4, -20, true, false},
                            {"Left arm (board 3)", -96, -96, {}, false, true},
                            {"Left hand (board 4)", -48, -40, -96, false, false}});
    }
    /// Pixels of a colour in a board's column.
    int pixels(int board, const QColor& color) {
        const QImage image = meters_->grab().toImage();
        const QRect meter = meters_->meterRect(board);
        int count = 0;
        for (int y = meter.top(); y <= meter.bottom(); ++y)
            for (int x = meter.left(); x <= meter.right(); ++x)
                count += image.pixelColor(x, y) == color;
        return count;
    }
    std::unique_ptr<LevelMeters> meters_;
};

TEST_F(LevelMetersTest, SaysEachBoardInWords) {
    EXPECT_EQ(meters_->words(0), "Hips (board 1): sound \u221224 dB, peak \u221212 dB, motion \u221236 dB");
    EXPECT_EQ(meters_->words(2), "Left arm (board 3): silent");
    EXPECT_EQ(meters_->words(4), "");
}

TEST_F(LevelMetersTest, AClickAndTheArrowsChooseABoard) {
    QSignalSpy chosen(meters_.get(), &LevelMeters::chosen);
    QTest::mouseClick(meters_.get(), Qt::LeftButton, {}, meters_->meterRect(2).center());
    EXPECT_EQ(meters_->current(), 2);
    QTest::keyClick(meters_.get(), Qt::Key_Left);
    QTest::keyClick(meters_.get(), Qt::Key_Left);
    QTest::keyClick(meters_.get(), Qt::Key_Left);
    EXPECT_EQ(meters_->current(), 0);
    EXPECT_EQ(chosen.count(), 4);
    meters_->setLevels({});
    EXPECT_EQ(meters_->current(), -1);
}

TEST_F(LevelMetersTest, ALouderBoardHasALongerBarAndOneThatClipsAnotherColour) {
    const Tokens& tokens = Theme::get().tokens();
    EXPECT_GT(pixels(0, tokens.ctl), pixels(1, tokens.ctl)) << "what the bar leaves free";
    EXPECT_GT(pixels(1, tokens.warn), 0);
    EXPECT_EQ(pixels(0, tokens.warn), 0);
    EXPECT_GT(pixels(0, tokens.ok), 0) << "the peak that is held";
    EXPECT_EQ(pixels(2, tokens.ctl), 0) << "a silent board is no level of zero";
    EXPECT_GT(pixels(2, tokens.err), 0) << "it has its mark";
    EXPECT_EQ(pixels(0, tokens.err), 0);
    EXPECT_GT(pixels(0, tokens.acc), pixels(3, tokens.acc)) << "motion";
}

TEST(PairsHeardTest, ShowsARowPerSourceAndSaysIt) {
    Theme::install(*qApp);
    HeardWindow window(2, 1, 1000);
    RangeMeasurement range;
    range.source = 1, range.pulse_sample = 9950, range.w_s = 1, range.w_t = 1;
    const std::vector<std::optional<RangeMeasurement>> newest{std::nullopt, range};
    window.add(newest);
    window.advanceTo(9999);
    PairsHeard heard;
    heard.resize(240, 60);
    heard.setHeard(window, {"Source 1 (belly)", "Source 2 (hat)"});
    EXPECT_EQ(heard.rowCount(), 2);
    EXPECT_EQ(heard.words(0), "Source 1 (belly): not heard now");
    EXPECT_EQ(heard.words(1), "Source 2 (hat): heard with confidence 1.00 now");
    const QImage image = heard.grab().toImage();
    EXPECT_EQ(image.pixelColor(238, 30), Theme::get().confidence(1)) << "now, at the right";
    EXPECT_EQ(image.pixelColor(100, 30), Theme::get().tokens().ctl);
    EXPECT_EQ(image.pixelColor(238, 8), Theme::get().tokens().ctl);
}

}  // namespace
}  // namespace noctule::ui
