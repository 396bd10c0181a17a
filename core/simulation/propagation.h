// SPDX-License-Identifier: Apache-2.0
// One pulse on its way from a source to a microphone: spreading, absorption, directivity and the body in
// between. Pure geometry, without samples: the sound synthesis and the readings level both ask here. World
// frame, metres, seconds; gains are amplitude ratios relative to the source's axis at 1 m without absorption.
#pragma once

#include <vector>

#include "core/simulation/world.h"

namespace noctule::simulation {

/// What air and flesh do to sound.
struct Medium {
    double speed_of_sound_m_per_s = 345;
    double absorption_db_per_m = 1.3;
    bool directivity = true;          ///< false: sources are heard alike from everywhere
    bool occlusion = true;            ///< false: the body is transparent
    bool late_path = true;            ///< false: behind a limb there is silence
    double behind_source_db = -20;    ///< against the source's axis
    double late_path_db = -20;        ///< of the way around the body against the free one ...
    double late_path_db_per_cm = -4;  ///< ... and for every centimetre of detour
};

struct SoundScenario;
Medium mediumOf(const SoundScenario& scenario, double speed_of_sound_m_per_s);

/// Source and microphone at one instant.
struct PathEnds {
    Vector3d source_m, normal;  ///< normal: unit vector of the source's axis
    Vector3d microphone_m;
};

struct DirectPath {
    double distance_m = 0;  ///< straight from source to microphone
    double detour_m = 0;    ///< what the way around the body is longer; 0 in line of sight
    bool occluded = false;
    bool behind_source = false;
    double angle_rad = 0;  ///< between the source's normal and the microphone, 0..pi
    double gain = 0;       ///< of what is heard first; 0: nothing is
};

/// Where sound arrives that left at one instant while both ends move.
struct Flight {
    double arrival_s = 0;
    double distance_m = 0;  ///< from the source at emission to the microphone at arrival
};

/// Far field of a circular piston, 2 J1(ka sin)/(ka sin), in front; behind it the same level everywhere.
double pistonDirectivity(double ka, double cos_angle, double behind_source_db = -20);

/// Spherical spreading and absorption over that length, relative to 1 m without absorption. Nearer than 1 cm
/// the level stays what it is there.
double airGain(double length_m, double absorption_db_per_m);

/// The straight line between two points cuts a capsule. Flesh gives way to what is strapped onto it: a
/// capsule counts only as thick as leaves both points 1 cm outside, so a board that soft tissue or a mounting
/// error has pushed into its own limb still hears what lies before it, while the far side of the limb stays
/// in shadow.
bool blocks(const WorldCapsule& capsule, const Vector3d& from_m, const Vector3d& to_m);

/// By how much the shortest way around a blocking capsule exceeds the straight one: the shortest of a taut
/// string around the capsule's cylinder (unrolled, exact) and strings around its sections by planes through
/// the line. Up to 4 mm too long where the best way crosses a rounded end askew. 0 when the capsule does not
/// block.
double detourAround(const WorldCapsule& capsule, const Vector3d& from_m, const Vector3d& to_m);

/// The direct path with everything frozen at one instant. Of several capsules in the way the largest detour
/// counts (the true way is never shorter). ka: of this source.
DirectPath directPath(const PathEnds& ends, const std::vector<WorldCapsule>& capsules, double ka,
                      const Medium& medium);

/// The straight flight of sound that leaves `source` at `emission_s`, the microphone moving meanwhile.
/// Capsules and line of sight play no part.
Flight directFlight(const World& world, int source, int board, double emission_s,
                    double speed_of_sound_m_per_s);

}  // namespace noctule::simulation
