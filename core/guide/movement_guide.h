// SPDX-License-Identifier: Apache-2.0
// Guide of the calibration from movement: its steps are the exercises, one after the other, each from the
// rest pose. It waits until the performer stands still, then until the movement begins, and takes the step
// when it has lasted long enough and no board that the exercise asks for was left out. Each exercise shows
// the rest pose anew: nobody holds it twice alike, and what it leaves to chance is evened out.
#pragma once

#include "core/guide/exercises.h"
#include "core/guide/guide.h"

namespace noctule {

class MovementGuide : public Guide {
public:
    static constexpr double kStand_s = 2, kMove_s = 7.5;
    /// Deviation of a board's rates over a second, the slowest of the exercises' movements.
    static constexpr double kIdle_rad_per_s = 0.12;

    MovementGuide(const Suit& suit, const Calibration& calibration, int sample_rate_hz)
        : Guide(suit, calibration, sample_rate_hz, kExerciseCount),
          rate_hz_(sample_rate_hz),
          moved_(suit.boards.size()) {}

    bool isMoving() const { return moving_from_.has_value(); }

protected:
    Hindrance see(const HealthReport& health, Guidance& guidance) override;
    void learn(int step, const HealthReport& health) override;
    void unlearn(int step) override;

private:
    int nextStep() const;
    void standAgain();
    Hindrance seeStanding(const HealthReport& health, bool all_calm);
    Hindrance seeMoving(const HealthReport& health, const std::vector<int>& heard, bool all_calm,
                        Guidance& guidance);
    double since_s(int64_t sample, int64_t now) const { return static_cast<double>(now - sample) / rate_hz_; }

    int rate_hz_;
    std::optional<int64_t> stood_from_, moving_from_;
    std::vector<bool> moved_, left_out_;  ///< per board, in this exercise; in the one that was in vain
};

}  // namespace noctule
