// SPDX-License-Identifier: Apache-2.0
// What a survey of a room's anchors goes by: how far anchors are from each other, and how far they are from
// somebody in a suit who walks past them. Metres and seconds; the world has Y up.
#pragma once

#include <string>
#include <vector>

#include "core/math/conventions.h"

namespace noctule::room_survey {

/// One housing with a microphone, a source or both.
struct Anchor {
    std::string id;
    bool hears = false, sounds = false;
    double apart_m = 0;                   ///< from its microphone to its source
    Vector3d rough_m = Vector3d::Zero();  ///< its middle, as the room's file has it; never a prior
    int sent = 0,
        heard = 0;  ///< its pulses, and those that anybody heard; of an anchor that only hears: of all
};

/// A pulse of one anchor in another one. One clock times both.
struct AnchorRange {
    int from = 0, to = 0;
    double time_s = 0, distance_m = 0, sigma_m = 0;
};

/// A pulse between an anchor and a device of the performer. The poses do without the room: they begin above
/// the origin, facing +z, and drift.
struct WalkRange {
    double time_s = 0;  ///< common time
    int anchor = 0;
    bool anchor_hears = false;        ///< else it sounds
    int device = 0;                   ///< one per board or source; those of one housing are one
    Vector3d p_m = Vector3d::Zero();  ///< of the device by the poses, at emission or arrival
    Matrix3d R_world_segment = Matrix3d::Identity();
    double distance_m = 0, sigma_m = 0;
};

/// An operator's own measurement.
struct KnownHeight {
    int anchor = 0;
    double height_m = 0;
};

struct Evidence {
    std::vector<Anchor> anchors;
    std::vector<AnchorRange> between;
    std::vector<WalkRange> walk;  ///< in the order of time; empty: nobody walked
    std::string performer;        ///< name
    int devices = 0;
    bool clock_known = false;  ///< of the room against the performer's, to some microseconds
    std::vector<KnownHeight> heights;
};

}  // namespace noctule::room_survey
