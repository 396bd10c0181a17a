// SPDX-License-Identifier: Apache-2.0
// Boards of one take that read at rates of their own, or are there for a part of it only.
#include "core/processing/take_quality.h"
#include "tests/core/processing/made_take.h"
#include "tests/support/take_files.h"

namespace noctule {
namespace {

class BoardRates : public test::MadeTake {
protected:
    std::vector<ReportBoard> boards() const {
        const Take take = Take::open(path()).value();
        return boardQuality(take, take.suit().value(), Calibration{}, kPrimaryRun).value();
    }
    /// Two seconds of board 1 at another rate, without a loss.
    void setRate(int rate_hz) {
        test::runSql(path(),
                     "DELETE FROM inertial WHERE board=1; WITH RECURSIVE n(i) AS (SELECT 0 UNION ALL "
                     "SELECT i+1 FROM n WHERE i<" +
                         std::to_string(2 * rate_hz - 1) +
                         ") INSERT INTO inertial(run,board,frame,sample,gx,gy,gz,ax,ay,az,corrected) "
                         "SELECT 0,1,i,i*" +
                         std::to_string(test::kRate_hz) + ".0/" + std::to_string(rate_hz) +
                         ",0,0,0,0,0,0,0 FROM n");
    }
};

TEST_F(BoardRates, EachOwesTheFramesOfItsOwnRate) {
    for (const int rate_hz : {25, 1000}) {
        setRate(rate_hz);
        const auto boards = this->boards();
        EXPECT_EQ(boards[0].frames_expected, test::kFrames) << rate_hz;
        EXPECT_EQ(boards[0].frames_lost, 0) << rate_hz;
        EXPECT_EQ(boards[1].frames_expected, 2 * rate_hz) << rate_hz;
        EXPECT_EQ(boards[1].frames_lost, 0) << rate_hz;
        EXPECT_FALSE(boards[1].joined_s || boards[1].left_s) << rate_hz;
    }
    test::runSql(path(), "DELETE FROM inertial WHERE board=1 AND frame%4=1");
    EXPECT_EQ(boards()[1].frames_expected, 2000);
    EXPECT_EQ(boards()[1].frames_lost, 500) << "what a frame number shows is lost at any rate";
}

TEST_F(BoardRates, OneThatJoinsLateLostNothingSince) {
    test::runSql(path(), "DELETE FROM inertial WHERE board=0 AND frame<168");
    for (const bool counts_from_its_begin : {false, true}) {
        if (counts_from_its_begin)
            test::runSql(path(), "UPDATE inertial SET frame=frame-168 WHERE board=0");
        const ReportBoard board = boards()[0];
        ASSERT_TRUE(board.joined_s);
        EXPECT_NEAR(*board.joined_s, 1.2, 1e-9);
        EXPECT_FALSE(board.left_s);
        EXPECT_EQ(board.frames_absent, 168);
        EXPECT_EQ(board.frames_lost, 168);
        EXPECT_EQ(board.lostShareWhileThere(), 0);
    }
}

TEST_F(BoardRates, OneThatLeavesEarlyIsSaidSo) {
    test::runSql(path(), "DELETE FROM inertial WHERE board=0 AND frame>70");
    setRate(140);
    const ReportBoard board = boards()[0];
    ASSERT_TRUE(board.left_s);
    EXPECT_NEAR(*board.left_s, 0.5, 1e-9);
    EXPECT_EQ(board.frames_absent, 209);
    EXPECT_EQ(board.lostShareWhileThere(), 0);
}

TEST_F(BoardRates, ASuitThatJoinsLateLostNothing) {
    test::runSql(path(), "DELETE FROM inertial WHERE frame<168");
    const auto boards = this->boards();
    EXPECT_TRUE(boards[0].joined_s && boards[1].joined_s);
    EXPECT_EQ(boards[0].frames_expected, test::kFrames - 168);
    EXPECT_EQ(boards[0].frames_lost, 0);
    EXPECT_EQ(boards[0].frames_absent, 0);
}

/// Its own clock begins 1.2 s after the take, so that its samples end at 0.8 s.
TEST_F(BoardRates, ASecondSuitThatStartsLateStaysToTheEnd) {
    test::runSql(path(),
                 "INSERT INTO suit(id,json,clock_offset_ns) SELECT 2,json,1200000000 FROM suit WHERE id=1;"
                 "INSERT INTO inertial(run,suit,board,frame,sample,gx,gy,gz,ax,ay,az,corrected) "
                 "SELECT run,2,board,frame,sample,gx,gy,gz,ax,ay,az,corrected FROM inertial WHERE frame<112");
    Take take = Take::open(path()).value();
    EXPECT_EQ(take.sampleCount(1).value(), 2 * test::kRate_hz);
    EXPECT_EQ(take.sampleCount(2).value(), test::kRate_hz * 4 / 5);
    take.view(2);
    for (const ReportBoard& board :
         boardQuality(take, take.suit().value(), Calibration{}, kPrimaryRun).value()) {
        EXPECT_FALSE(board.joined_s || board.left_s) << board.id;
        EXPECT_EQ(board.frames_expected, 112) << board.id;
    }
}

}  // namespace
}  // namespace noctule
