// SPDX-License-Identifier: Apache-2.0
// When the performer stands upright and still, and how each sensor is turned on its segment. The standing
// pose gives the mounting but for the direction that the body faces; legs turn about the axis from right to
// left, which gives that (as in functional calibration: Seel, Raisch, Schauer, Sensors 14, 2014).
#pragma once

#include "core/body/actor.h"
#include "core/posing/headings.h"

namespace noctule::posing {

/// Instants `first` to `last` of the tracks.
struct Standing {
    size_t first = 0, last = 0;
    bool marked = false;  ///< in the rest pose that the actor names
    bool walks = false;   ///< told from walking; else the first still second
    size_t middle() const { return (first + last) / 2; }
};

/// The still second in which segments are inclined most as in walking, else the first still one.
Standing findStanding(const SensorTracks& tracks);

/// Upright, arms hanging, palms to the thighs, faces Z; `rest`: in the actor's rest pose.
Pose standingPose(const Actor& actor, bool rest);

/// At the middle of `standing`. Headings are stated by a marked rest pose and the tracks' mountings; a sensor
/// that is inclined otherwise than its mounting says is believed the less.
StandingHeadings standingHeadings(const Actor& actor, const SensorTracks& tracks, const Standing& standing);

struct Mountings {
    std::vector<Quaterniond> q_segment_sensor;  ///< per sensor
    std::vector<char> known;  ///< per sensor; 0: it does not read while the performer stands
    double facing_rad = 0;    ///< heading of the body while it stands, in the sensors' common world
    std::vector<std::string> warnings;
};
Mountings findMountings(const Actor& actor, const SensorTracks& tracks, const Headings& headings,
                        const std::vector<SensorPair>& pairs, const Standing& standing);

}  // namespace noctule::posing
