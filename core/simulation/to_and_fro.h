// SPDX-License-Identifier: Apache-2.0
// The time of a performance that is gone through to and fro for ever: forth to its end, back to its
// beginning, forth again. A performer who only began again at the end would jump by metres; whoever carried
// on from there would leave the room. Position, velocity and acceleration are continuous.
#pragma once

namespace noctule::simulation {

/// A turn takes so long, less in what is shorter.
inline constexpr double kTurning_s = 2;

struct PlayedTime {
    double t_s = 0;                 ///< of the performance, 0 to its length
    double rate = 1;                ///< its derivative: 1 forth, -1 back
    double acceleration_per_s = 0;  ///< its second derivative
};

/// `once_s`: length of the performance. Begins at its beginning, forth.
PlayedTime toAndFro(double t_s, double once_s);

}  // namespace noctule::simulation
