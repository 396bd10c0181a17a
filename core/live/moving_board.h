// SPDX-License-Identifier: Apache-2.0
// Which board moves while all others are kept still, so that it can be told by hand which is which. The board
// at the end of a limb turns more than those above it. Readings in, an answer once it is sure.
#pragma once

#include <optional>
#include <vector>

#include "core/inertial/reading.h"
#include "core/suit/suit.h"

namespace noctule {

struct MovingBoardSettings {
    double window_s = 1.5;
    /// Mean turning rate over the window; a standing person sways with 0.02 rad/s.
    double least_rad_per_s = 0.5;
    /// Against the board that turns second most.
    double least_lead = 1.5;
};

class MovingBoard {
public:
    MovingBoard(const Suit& suit, int sample_rate_hz, const MovingBoardSettings& settings = {});

    /// In order of time per board; the same reading twice counts once.
    void add(const InertialReading& reading);
    /// The one that moves; absent while none does or two do.
    std::optional<int> found() const;

private:
    struct Window {
        double at_sample = -1;
        double turning_rad_per_s = 0;  ///< smoothed
        double full_scale_rad_per_s = 0;
        int count = 0;
    };
    std::vector<Window> windows_;
    double window_samples_;
    MovingBoardSettings settings_;
};

}  // namespace noctule
