// SPDX-License-Identifier: Apache-2.0
// What goes into an estimator, in SI units and seconds of the suit's clock.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/acoustics/range.h"
#include "core/math/conventions.h"

namespace noctule {

/// One sensor axis: its reading is the true vector's component along its own sensitive axis. Axes are
/// separate because a frame may lack some of them; a misaligned triad then still gives exact equations.
struct AxisReading {
    Vector3d sensitive_axis_board = Vector3d::UnitX();  ///< unit vector
    double value = 0;                                   ///< rad/s or m/s^2 (specific force)
    double sigma = 0;
    int beyond =
        0;  ///< +1 or -1: the sensor was at the end of its range, the truth lies at `value` or beyond
};

/// Up to three readings of a triad.
struct TriadReading {
    std::array<AxisReading, 3> axes;
    int count = 0;

    void add(const AxisReading& axis) { axes[static_cast<size_t>(count++)] = axis; }
    bool isClipped() const { return inRange().count < count; }
    /// Without the axes that were at the end of their range.
    TriadReading inRange() const {
        TriadReading kept;
        for (int i = 0; i < count; ++i)
            if (const AxisReading& axis = axes[static_cast<size_t>(i)]; axis.beyond == 0)
                kept.add(axis);
        return kept;
    }
};

/// The vector that three axes within their ranges sensed, in the board's frame; nothing otherwise.
std::optional<Vector3d> sensedVector(const TriadReading& triad);

struct InertialMeasurement {
    int board = 0;
    double time_s = 0;  ///< instant of the reading
    TriadReading gyro, accel;
};

/// A distance from a source at emission to a microphone at arrival.
struct DistanceMeasurement {
    int64_t id = 0;  ///< the caller's; comes back in DistanceDecision
    int source = 0;
    int board = 0;
    double emission_s = 0;
    double arrival_s = 0;  ///< at the microphone
    double distance_m = 0;
    double sigma_m = 0;      ///< at full confidence
    double confidence = 1;   ///< w_s * w_t, 0..1; the angle's factor is the estimator's own
    CarrierRange carrier{};  ///< where there is one, the estimator says which cycle it is
};

/// The root as another system sees it.
struct RootMeasurement {
    double time_s = 0;
    Vector3d p_world_root = Vector3d::Zero();
    Quaterniond q_world_root = Quaterniond::Identity();
    double sigma_p_m = 0, sigma_q_rad = 0;
};

/// Mean readings over the time in which the performer held the rest pose.
struct RestReadings {
    double begin_s = 0, end_s = 0;
    std::vector<InertialMeasurement> mean_by_board;  ///< sigma: of the mean
};

struct DistanceDecision {
    int64_t id = 0;
    int board = 0;
    RangeFate fate = RangeFate::kUsed;
    double w_a = 1;  ///< confidence from the angle to the source's normal, with the pose then believed
    double innovation_m = 0;  ///< measured minus expected
    double sigma_m = 0;       ///< of the innovation
    /// What was used instead of the measured distance: by the carrier where its cycle was not in doubt, else
    /// by the envelope. Absent without a carrier, or when nothing was used.
    struct Settled {
        double distance_m = 0, sigma_m = 0;
    };
    std::optional<Settled> settled{};
};

/// Which sensors an estimator listens to.
struct SensorSelection {
    bool accelerometers = true, gyroscopes = true, distances = true;
};

}  // namespace noctule
