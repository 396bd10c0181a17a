// SPDX-License-Identifier: Apache-2.0
// What really happens around the suit, as the sound sees it: where every microphone, source and piece of
// flesh is at any time. Truth; only the simulator may ask. World frame, metres, seconds since sample 0.
#pragma once

#include <vector>

#include "core/math/conventions.h"

namespace noctule::simulation {

struct WorldCapsule {
    Vector3d a_m, b_m;
    double radius_m = 0;
    int segment = -1;  ///< index of the joint that carries it
};

class World {
public:
    virtual ~World() = default;
    virtual double duration_s() const = 0;
    virtual int boardCount() const = 0;
    virtual int sourceCount() const = 0;
    virtual Vector3d microphone(int board, double t_s) const = 0;
    virtual Vector3d source(int source, double t_s) const = 0;
    virtual Vector3d sourceNormal(int source, double t_s) const = 0;
    /// Index of the joint that carries it, -1 when fixed in the room.
    virtual int boardSegment(int board) const = 0;
    virtual int sourceSegment(int source) const = 0;
    /// The board in the same housing, -1 when there is none.
    virtual int sourceBoard(int) const { return -1; }
    /// All capsules of all performers at time t; clears and fills `capsules`.
    virtual void capsules(double t_s, std::vector<WorldCapsule>& capsules) const = 0;
};

}  // namespace noctule::simulation
