// SPDX-License-Identifier: Apache-2.0
// Where the microphones are at any instant near the present: cubic through the world's positions every 2 ms.
// For motion below 10 Hz and 200 m/s^2 this is exact to 1 um, and it asks the world for all boards at one
// instant after the other, 500 times a second, so that the world can pose its body once for all of them.
#pragma once

#include <deque>
#include <vector>

#include "core/simulation/world.h"

namespace noctule::simulation {

class MicrophoneTrack {
public:
    explicit MicrophoneTrack(const World& world) : world_(world) {}

    /// t >= 0 and not before what was forgotten. Before 0 and after the world's end everything stands still.
    Vector3d position(int board, double t_s);
    void forgetBefore(double t_s);

private:
    static constexpr double kStep_s = 0.002;
    const std::vector<Vector3d>& node(int64_t index);

    const World& world_;
    int64_t first_node_ = 0;
    std::deque<std::vector<Vector3d>> nodes_;
};

}  // namespace noctule::simulation
