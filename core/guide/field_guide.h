// SPDX-License-Identifier: Apache-2.0
// Guide of the magnetometers' calibration: the field of the spot, while the suit is carried about a little;
// the field near the floor, where steel lies in most buildings; then all directions, in any order, with each
// sensor judged by itself. It keeps the readings, seven a second of each board: the solver works on them.
#pragma once

#include <deque>

#include "core/guide/guide.h"
#include "core/sensor_calibration/field_turn.h"

namespace noctule {

class FieldGuide : public Guide {
public:
    enum Step { kSpot, kFloor, kTurn, kSteps };
    static constexpr double kSpotWindow_s = 6;         ///< of the spot's field
    static constexpr double kFastest_deg_per_s = 180;  ///< a reading is then smeared by 25 degrees

    /// Boards without a magnetometer are skipped.
    FieldGuide(const Suit& suit, const Calibration& calibration, int sample_rate_hz);

    bool keepsReadings() const override { return true; }
    /// The suit has it, skipped or not.
    bool hasField(int board) const { return suit().boards[index(board)].has_magnetometer; }
    const FieldTurn& turnOf(int board) const { return turns_[index(board)]; }
    const SpotField& spot() const { return spot_; }
    /// The lesser count of the sensors that are asked for, cell by cell.
    FieldSphere sphere() const;
    /// Of the sensor that has seen least, 0 to 1.
    double leastShare() const;
    int leastBoard() const;
    int enoughBoards() const;
    bool carriesIronNow(int board) const { return iron_[index(board)]; }
    double turning_deg_per_s() const { return turning_deg_per_s_; }
    /// How much stronger the field is now than it is usually at this spot, in percent.
    std::optional<double> strongerNow_percent() const;
    /// The readings of one sensor from the beginning.
    void startAnew(int board);
    /// The floor is not looked at.
    void leaveOutFloor();

    /// What has been turned so far.
    const std::vector<FieldReading>& readingsOf(int board) const { return heard_[index(board)]; }
    /// From what was kept before, in place of what there is.
    void give(int board, const std::vector<FieldReading>& readings);
    void give(const SpotField& spot) { spot_ = spot; }

protected:
    Hindrance see(const HealthReport& health, Guidance& guidance) override;
    void learn(int step, const HealthReport& health) override;
    void unlearn(int step) override;

private:
    struct Moment {
        int64_t sample = 0;
        bool moves = false;
        SpotMoment moment;
    };
    bool asks(int board) const { return !isSkipped(board) && hasField(board); }
    bool isHeardNow(const HealthReport& health, int board) const;
    bool moves(const HealthReport& health, double limit_m_per_s2) const;
    bool collect(const HealthReport& health, int step);
    void judgeSome();
    void findIron();
    std::vector<SpotMoment> momentsSince(int64_t sample);
    Hindrance seeSpot(const HealthReport& health, Guidance& guidance);
    Hindrance seeFloor(const HealthReport& health, Guidance& guidance);
    Hindrance seeTurn(Guidance& guidance);

    int rate_hz_;
    std::vector<FieldTurn> turns_;
    std::vector<std::vector<FieldReading>> heard_;
    std::vector<bool> iron_;
    std::deque<Moment> moments_;
    std::vector<SpotMoment> at_spot_;  ///< those that the spot was judged by
    SpotField spot_;
    bool was_lowered_ = false;
    int64_t calm_since_ = -1;
    double turning_deg_per_s_ = 0;
    int judged_ = 0;
};

}  // namespace noctule
