// SPDX-License-Identifier: Apache-2.0
// Where a board does not change its motion: it lies still or turns evenly. Found from its readings alone,
// before any calibration, by blocks of a quarter of a second whose gyroscope and accelerometer neither waver
// nor step; the first and the last block of a stretch are left out. Nominal units: with zeros 2048.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/calibration/observations.h"

namespace noctule {

struct SteadyStretch {
    int take = 0;  ///< index among the takes
    double begin_s = 0, end_s = 0;
    std::span<const CountReading> readings;      ///< of the take; never empty
    Vector3d rate_rad_per_s = Vector3d::Zero();  ///< nominal, mean
    bool turns = false;                          ///< on a turntable; else it lies still

    double length_s() const { return end_s - begin_s; }
};

/// One board in all takes that have it, by its id. The takes must outlive it.
struct BoardRecord {
    std::string id;
    std::string words;  ///< "board 7, left forearm"
    Board board;
    const Calibration* in_force = nullptr;  ///< of the first take that has the board
    struct Part {
        int take;
        const std::vector<CountReading>* readings;
    };
    std::vector<Part> parts;

    size_t readingCount() const;
    /// Of all takes, in order; also short ones.
    std::vector<SteadyStretch> steadyStretches() const;
};

/// In the order of the suits.
std::vector<BoardRecord> boardRecords(const std::vector<Observations>& takes);
std::vector<BoardRecord> boardRecords(std::vector<Observations>&& takes) = delete;  ///< records point into it

}  // namespace noctule
