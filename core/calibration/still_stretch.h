// SPDX-License-Identifier: Apache-2.0
// The part of a take in which the performer stands still, and what boards and microphones say there on
// average. Time is cut into slots of a quarter of a second; a slot is still when no board shakes within it or
// has turned since the slot before. Thresholds are those of a person who stands (sway of a few degrees a
// second), far above the sensors' noise. Times in seconds of the take, everything else as observed (counts).
#pragma once

#include <vector>

#include "core/calibration/observations.h"

namespace noctule {

/// One board, averaged over the still stretch.
struct StillBoard {
    int readings = 0;
    bool clipped = false;
    Vector3d gyro_counts = Vector3d::Zero();   ///< zeros with which the readings integrate to no rotation
    Vector3d accel_counts = Vector3d::Zero();  ///< mean
    /// Of these averages, from how parts of the stretch differ; the gyroscope's knows of the sway that
    /// gravity shows.
    Vector3d sigma_gyro_counts = Vector3d::Zero(), sigma_accel_counts = Vector3d::Zero();
    double sway_rad = 0;  ///< by which the board leans otherwise at the end than at the beginning

    bool heard() const { return readings > 0; }
};

/// One pair, averaged over the still stretch; without pairs that are heard only now and then.
struct StillFlight {
    int source = 0, board = 0;
    double flight_s = 0;  ///< median
    double spread_s = 0;  ///< of a single one, robust
    double confidence = 0, c_m_per_s = 0;
};

struct BoardMovement {
    int board = 0;
    double begin_s = 0, end_s = 0;
};

struct StillStretch {
    bool found = false;   ///< at least kShortestStill_s of stillness
    bool marked = false;  ///< inside the take's rest pose; else looked for in the whole take
    Stretch stretch;
    std::vector<BoardMovement> movements;  ///< within the rest pose (or the take), longest first
    std::vector<StillBoard> boards;        ///< one per board of the suit
    std::vector<StillFlight> flights;

    static constexpr double kShortestStill_s = 1;
    /// Somebody stands still and a board says so.
    bool isUsable() const;
};

StillStretch findStillStretch(const Observations& take);

/// The performer stands still again later in the take, for at least kShortestStill_s, with every board as
/// upright as in `pose`.
std::vector<Stretch> returnsTo(const StillStretch& pose, const Observations& take);

}  // namespace noctule
