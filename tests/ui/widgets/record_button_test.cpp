// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/record_button.h"

#include <gtest/gtest.h>

#include <QAccessible>
#include <QApplication>
#include <QSignalSpy>
#include <QTest>

#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

class RecordButtonTest : public testing::Test {
protected:
    void SetUp() override {
        Theme::install(*qApp);
        button_ = std::make_unique<RecordButton>();
        button_->resize(button_->sizeHint());
    }
    QColor at(int x, int y) { return button_->grab().toImage().pixelColor(x, y); }
    int middle() const { return button_->width() / 2; }

    std::unique_ptr<RecordButton> button_;
};

TEST_F(RecordButtonTest, ADiscRecordsAndASquareStops) {
    const QColor rec = Theme::get().tokens().rec;
    EXPECT_EQ(at(middle(), middle()), rec);
    button_->setState(RecordButton::State::kRecording);
    EXPECT_EQ(at(middle(), middle()), QColor(Qt::white));
    EXPECT_EQ(at(middle(), middle() - 24), rec) << "the square stands in the disc";
    EXPECT_EQ(button_->accessibleName(), "Stop");
    button_->setState(RecordButton::State::kSaving);
    EXPECT_NE(at(middle(), middle() - 24), rec);
}

TEST_F(RecordButtonTest, CountsDown) {
    button_->setState(RecordButton::State::kCountdown);
    button_->setCountdown(3, 3);
    EXPECT_EQ(button_->digit(), 3);
    button_->setCountdown(2.01, 3);
    EXPECT_EQ(button_->digit(), 3);
    button_->setCountdown(0.4, 3);
    EXPECT_EQ(button_->digit(), 1);
    button_->setState(RecordButton::State::kReady);
    EXPECT_EQ(button_->digit(), 0);
}

TEST_F(RecordButtonTest, OnlyTheRoundIsPressedAndRefusedItStaysEnabled) {
    QSignalSpy clicked(button_.get(), &QAbstractButton::clicked);
    QTest::mouseClick(button_.get(), Qt::LeftButton, {}, {2, 2});
    EXPECT_EQ(clicked.count(), 0);
    button_->setState(RecordButton::State::kRefused);
    QTest::mouseClick(button_.get(), Qt::LeftButton);
    QTest::keyClick(button_.get(), Qt::Key_Return);
    EXPECT_EQ(clicked.count(), 2);
    EXPECT_GE(button_->width(), Theme::get().px(44)) << "style guide, section 8";
}

}  // namespace
}  // namespace noctule::ui
