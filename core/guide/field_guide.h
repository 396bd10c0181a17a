// SPDX-License-Identifier: Apache-2.0
// Guide of the magnetometers' calibration: first the field of the spot, while the suit is carried about a
// little, then all directions, in any order, with each sensor judged by itself. It keeps the readings, seven
// a second of each board; they are what the solver calibrates from.
#pragma once

#include <deque>

#include "core/guide/guide.h"
#include "core/sensor_calibration/field_turn.h"

namespace noctule {

class FieldGuide : public Guide {
public:
    enum Step { kSpot, kTurn, kSteps };
    static constexpr double kSpotWindow_s = 6;         ///< of the spot's field
    static constexpr double kFastest_deg_per_s = 180;  ///< a reading is then smeared by 25 degrees

    /// Boards without a magnetometer are skipped.
    FieldGuide(const Suit& suit, const Calibration& calibration, int sample_rate_hz);

    bool keepsReadings() const override { return true; }
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
    /// The readings of one sensor from the beginning.
    void startAnew(int board);

protected:
    Hindrance see(const HealthReport& health, Guidance& guidance) override;
    void unlearn(int step) override;

private:
    struct Moment {
        int64_t sample = 0;
        SpotMoment moment;
    };
    bool asks(int board) const { return !isSkipped(board) && suit().boards[index(board)].has_magnetometer; }
    bool collect(const HealthReport& health, bool turns);
    void judgeSome();
    Hindrance seeSpot(const HealthReport& health);
    Hindrance seeTurn(Guidance& guidance);

    int rate_hz_;
    std::vector<FieldTurn> turns_;
    std::vector<double> read_at_;
    std::vector<bool> iron_;
    std::deque<Moment> moments_;
    SpotField spot_;
    double turning_deg_per_s_ = 0;
    int judged_ = 0;
};

}  // namespace noctule
