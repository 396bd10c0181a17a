// SPDX-License-Identifier: Apache-2.0
// Output predictor: carries the newest pose of a filter forward to the newest readings of the gyroscopes, by
// dead reckoning. A filter gives a pose when ranges and readings around its instant are complete, some 15 ms
// late; whoever follows a performer live need not wait for that. Nothing goes back into the filter.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "core/body/actor.h"
#include "core/estimation/suit_model.h"
#include "core/inertial/reading.h"
#include "core/live/inertial_calibrator.h"
#include "core/motion/timed_poses.h"

namespace noctule {

class PosePredictor {
public:
    /// Fails (kUnusable) when the suit does not fit the actor.
    static Result<std::unique_ptr<PosePredictor>> create(const Suit& suit, const Calibration& calibration,
                                                         const Actor& actor, double sample_rate_hz);

    /// Of each board in order of time.
    void add(const InertialReading& reading);
    /// Of the filter, in order of time.
    void add(const TimedPose& pose);

    /// The pose at the instant of the newest reading. Segments with a gyroscope turn as it says, between
    /// two readings at their mean rate; the others go with their parents; the root goes on at its speed. The
    /// filter's own pose where no reading is newer than it. Nothing before the first pose.
    ///
    /// Error at 15 ms: rounding and noise of a gyroscope make 0.01 degrees; what a rate changes by after the
    /// newest reading makes 0.1 degrees at 100 rad/s^2. A filter that is more than kLongest_s behind is not
    /// carried farther than that.
    std::optional<TimedPose> predict() const;

    static constexpr double kLongest_s = 0.1;

private:
    struct Rate {
        double time_s;
        Vector3d omega_rad_per_s;  ///< of the segment, in the segment's frame
    };
    struct Segment {
        int joint = -1;  ///< of the skeleton; -1: the board does not turn with a segment
        Matrix3d R_segment_board = Matrix3d::Identity();
        std::deque<Rate> rates;  ///< oldest first, kKept_s long
    };
    PosePredictor(const Suit& suit, const Calibration& calibration, const Actor& actor,
                  double sample_rate_hz);
    /// Of the segment from `from_s` to `to_s`; nothing without a reading near enough.
    static std::optional<Quaterniond> turn(const Segment& segment, double from_s, double to_s);

    Skeleton skeleton_;
    InertialCalibrator calibrator_;
    std::vector<Segment> boards_;
    double newest_s_ = 0;
    std::optional<TimedPose> base_;
    Vector3d v_world_root_m_per_s_ = Vector3d::Zero();
};

}  // namespace noctule
