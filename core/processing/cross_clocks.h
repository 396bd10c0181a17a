// SPDX-License-Identifier: Apache-2.0
// By whose clocks the distances between suits were measured. A writer may take the recorder's first guess, or
// correct its clocks first, or store arrivals alone; these stay in the microphone's samples. Here all become
// distances by the guess, so that one correction of the clocks serves both.
#pragma once

#include <map>
#include <utility>

#include "core/acoustics/speed_of_sound.h"
#include "core/processing/take_clocks.h"

namespace noctule {

/// Of a suit's samples; that of the take where the suit names none.
double sampleRateOf(const Take& take, int suit);

/// By the calibration in force and the mean of all suits' thermometers.
SpeedOfSound soundOf(const Take& take, const Calibration& calibration);

class CrossClocks {
public:
    /// `known`: clocks as far as they are known better than by the guess.
    static Result<CrossClocks> of(const Take& take, const TakeClocks& known = {});

    /// The range's distance by the first guess of both clocks.
    double byGuess_m(int from_suit, int to_suit, const RangeMeasurement& range, double c_m_per_s) const;
    /// Flight of the sound by that guess, from the samples of emission and arrival, whatever distance is
    /// stated.
    double flight_s(int from_suit, int to_suit, const RangeMeasurement& range) const {
        return flight_s(suits_.at(from_suit), suits_.at(to_suit), range, &SuitDelays::guess);
    }

private:
    struct SuitDelays {
        double rate_hz = 0, c_m_per_s = 0;
        SuitClock guess{}, best{};
        std::vector<double> source_s{}, board_s{};  ///< offset of a source, delay of a microphone
    };

    static double flight_s(const SuitDelays& from, const SuitDelays& to, const RangeMeasurement& range,
                           SuitClock SuitDelays::*clock);
    Status addSuits(const Take& take, const TakeClocks& known);
    Status findOtherClocks(const Take& take, const TakeClocks& known);

    std::map<int, SuitDelays> suits_;
    std::map<std::pair<int, int>, bool> by_other_clocks_;  ///< from, to: distances are not by the guess
};

}  // namespace noctule
