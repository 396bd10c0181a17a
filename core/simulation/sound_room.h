// SPDX-License-Identifier: Apache-2.0
// What throws sound back: the floor, walls, scattering points and the body's own capsules. World frame,
// metres.
#pragma once

#include <cstdint>
#include <vector>

#include "core/simulation/cast_scenario.h"
#include "core/simulation/propagation.h"
#include "core/simulation/random.h"
#include "core/simulation/sound_scenario.h"

namespace noctule::simulation {

/// An indirect way of sound, good for any small motion of its microphone: `before_m` to the last point, then
/// straight on. `later`: the same way for sound that leaves a moment later, from where the source is then.
struct EchoPath {
    struct Leg {
        Vector3d last_point_m;
        double before_m = 0;
    };
    Leg now, later;
    double gain = 0;  ///< relative to the source's axis at 1 m without absorption
};

/// The room of one take. The floor is y = 0. Each wall is vertical and stands the drawn distance beyond the
/// farthest point that the middle of the suit reaches in its direction, so that nobody walks through it.
/// Scattering points are small spheres (furniture, lamps) 0.6 to 2.5 m from where the suit begins.
class Room {
public:
    Room(const World& world, const SoundScenario& scenario, uint64_t seed);
    /// Of a cast: floor, ceiling and four walls where the chamber has them.
    static Room chamber(const ChamberScenario& chamber, const SoundScenario& scenario, uint64_t seed);

    struct Query {
        PathEnds ends;
        Vector3d source_later_m;
        int source_segment = -1, board_segment = -1;
        double ka = 0;
        double least_gain = 0;  ///< weaker ways are left out
    };
    /// Ways over the room's reflectors and the capsules, those that the body blocks left out. Clears
    /// `echoes`.
    void echoes(const Query& query, const std::vector<WorldCapsule>& capsules, const Medium& medium,
                std::vector<EchoPath>& echoes) const;

    /// Points p with normal . p > offset_m are inside.
    struct Plane {
        Vector3d normal;
        double offset_m = 0, gain = 0;
    };
    struct Sphere {
        Vector3d center_m;
        double radius_m = 0;
    };
    const std::vector<Plane>& planes() const { return planes_; }
    const std::vector<Sphere>& spheres() const { return spheres_; }

private:
    Room() = default;
    void scatter(const Vector3d& middle, int count, Random& random);

    std::vector<Plane> planes_;
    std::vector<Sphere> spheres_;
};

/// Mean of all microphones: about the middle of the body.
Vector3d middleOfSuit(const World& world, double t_s);

}  // namespace noctule::simulation
