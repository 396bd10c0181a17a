// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/laboratory.h"

#include <gtest/gtest.h>

#include "core/suit/default_suit.h"

namespace noctule::simulation {
namespace {

/// Mountings of which nothing is stated count as some degrees off.
TEST(Laboratory, StatesMountingsThatAreExactAndNoOthers) {
    const Suit suit = defaultSuit();
    for (const Scenario& scenario : {Scenario::nominal(), Scenario::realistic()}) {
        const Calibration calibration =
            laboratoryCalibration(suit, scenario, drawHiddenTruth(suit, scenario, 1));
        for (const BoardCalibration& board : calibration.boards)
            EXPECT_EQ(board.sigma_mounting_rad.has_value(), scenario.mounting_rad == 0) << scenario.name;
        EXPECT_EQ(calibration.boards.size(), suit.boards.size());
    }
}

}  // namespace
}  // namespace noctule::simulation
