// SPDX-License-Identifier: Apache-2.0
// What a calibration's wizard sees of the suit: which step of the procedure is being shown to it, whether all
// boards are as the step wants them, and if not, what hinders. Fed with the suit's health several times a
// second; it counts how long a step has been right without a break. No clocks: times are the suit's own.
// Nothing here calibrates: the solvers (core/calibration) judge what was recorded meanwhile.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "core/live/health.h"
#include "core/suit/calibration.h"

namespace noctule {

enum class GuidedBoard {
    kRight,
    kAbsent,     ///< silent, or too few readings
    kMoves,      ///< neither still nor turning evenly
    kElsewhere,  ///< on another side than most
    kAskew,      ///< not square in its slot
    kIdle,       ///< has not moved as the exercise asks
};

enum class Hindrance {
    kNone,
    kNoReadings,  ///< no board is heard
    kAbsent,      ///< of some boards
    kMoves,
    kElsewhere,
    kAskew,
    kBetweenSteps,  ///< it is none of the procedure's steps
    kDone,          ///< this step has been taken already
    kNotTurning,
    kUnevenTurn,  ///< the table speeds up or slows down
    kOffSpeed,    ///< none of the table's speeds, or not the one asked for
    kTooFast,     ///< beyond 80 % of what a gyroscope can measure
    kUnheard,     ///< too few of the pairs that were measured are heard
    kUnit,        ///< the distances that were measured are in another unit than their table says
    kStand,       ///< before a movement: in the rest pose, for so many seconds more
    kMove,        ///< the rest pose has been held long enough
    kIdle,        ///< the movement left boards out: once more, from the rest pose on
    kNoField,     ///< boards are heard, but nothing of their magnetometers
    kCarry,       ///< move it about here without turning it, so that the field of the spot is seen
    kTilted,      ///< it was turned meanwhile; value: radians
    kBentField,   ///< the field of the spot is bent; value: percent
    kLower,       ///< to the floor, without turning it
    kTurnOn,      ///< directions are missing; value: their share that was seen
};

struct Guidance {
    std::optional<int> step;  ///< that is shown, by what most boards say
    Hindrance hindrance = Hindrance::kNoReadings;
    int board = -1;     ///< the one that hinders most
    int hindering = 0;  ///< boards
    double value = 0;   ///< of the hindrance: radians askew, turns a minute, share of pairs, factor, seconds
    std::vector<GuidedBoard> boards;
    std::vector<std::optional<double>> askew_rad;  ///< per board; absent where nothing tells yet
    int right_boards = 0, asked_boards = 0;
    double worst_accel_deviation_m_per_s2 = 0;  ///< of the boards asked for
    std::optional<double> worst_askew_rad;      ///< of those that count as seated
    double askew_limit_rad = 0;                 ///< up to which they do, of the least known board
    std::optional<double> rpm;                  ///< positive: counter-clockwise as seen from above
    std::optional<double> heard_share;          ///< of the pairs that were measured
    double held_s = 0;                          ///< right without a break

    bool isRight() const { return hindrance == Hindrance::kNone; }
};

class Guide {
public:
    /// `suit` as it is on the rig; `calibration` what is known of its boards so far.
    Guide(const Suit& suit, const Calibration& calibration, int sample_rate_hz, int steps);
    virtual ~Guide() = default;

    const Guidance& look(const HealthReport& health);
    const Guidance& guidance() const { return now_; }

    /// What a step is called in the measurements: of a jig its placement; else empty.
    virtual std::string labelOf(int step) const;
    /// Where sides are shown: which one of kBoardSides points up in a step.
    virtual int sideUpIn(int step) const { return step; }
    int stepCount() const { return static_cast<int>(done_.size()); }
    /// Of the boards that are not skipped.
    bool isDone(int step) const;
    bool isDone(int step, int board) const { return done_[index(step)][index(board)]; }
    bool isFinished() const;
    bool isSkipped(int board) const { return skipped_.contains(board); }
    void skip(int board, bool skipped);

    /// The step that is shown has been recorded: it is done for all boards that were right.
    void take();
    /// Whoever is on it may go on without recording anything: what the guide has seen is the evidence.
    virtual bool keepsReadings() const { return false; }
    /// From what was recorded before.
    void setDone(int step, int board, bool done = true) { done_[index(step)][index(board)] = done; }
    void repeat(int step);
    /// The count begins again.
    void restart();
    /// The suit is gone: nothing of what it showed last holds any more, and the count begins again.
    void lose();

protected:
    /// Fills step, boards, askew_rad and what it measures; returns a hindrance of the whole, if any.
    virtual Hindrance see(const HealthReport& health, Guidance& guidance) = 0;
    /// take() in words of the procedure: what can be learnt from a position that is known now.
    virtual void learn(int step, const HealthReport& health);
    /// What was learnt of it before; it is repeated.
    virtual void unlearn(int step);

    static size_t index(int value) { return static_cast<size_t>(value); }
    int boardCount() const { return static_cast<int>(suit_.boards.size()); }
    const Suit& suit() const { return suit_; }
    const BoardCalibration& calibrationOf(int board) const { return calibrations_[index(board)]; }
    /// Its own procedure has found the values of this board before.
    bool wasCalibrated(int board, const char* procedure) const;
    /// The boards that are heard and not skipped; each is right while it lies still or turns evenly.
    std::vector<int> heardBoards(const HealthReport& health, Guidance& guidance) const;
    /// Is neither skipped nor silent, and has readings.
    bool isHeard(const HealthReport& health, int board) const;

private:
    Hindrance hindranceOf(Guidance& guidance) const;

    Suit suit_;
    std::vector<BoardCalibration> calibrations_;
    int sample_rate_hz_;
    std::vector<std::vector<bool>> done_;  ///< step, board
    std::set<int> skipped_;
    Guidance now_;
    HealthReport health_;
    std::optional<int> held_step_;
    int64_t held_from_ = 0;
};

}  // namespace noctule
