// SPDX-License-Identifier: Apache-2.0
// What a jig's takes and its table of known distances have in common: one measurement per pair and stretch,
// and what is missing on either side. First step of calibrateSourceOffsets.
#pragma once

#include "core/calibration/source_offsets/source_offsets.h"

namespace noctule {

/// Share by which a kelvin more shortens a flight.
constexpr double kStretchPerKelvin = 1.8e-3;

struct JigData {
    Suit suit;                        ///< of the first take
    std::vector<double> mic_delay_s;  ///< in force, per board
    std::vector<JigMeasurement> measurements;
    int stretches = 0;
    std::vector<Finding> findings;
};

JigData measureJig(const std::vector<Observations>& takes, const KnownDistances& known,
                   const SourceOffsetSettings& settings);

/// "board 7, l_forearm", "source 8, hat": numbers from 1, and the ids that stand in the file.
std::string jigBoard(const Suit& suit, int board);
std::string jigSource(const Suit& suit, int source);
/// With a capital, where it is one of these.
std::string asSentence(std::string words);

}  // namespace noctule
