// SPDX-License-Identifier: Apache-2.0
// What the performer does over a whole take, as a smooth function of time: stand in the rest pose, go over
// into the motion within a second, and begin it again when it ends before the take does. Every part is
// continuous up to the acceleration: cubic splines through the motion's frames, quintic cross-fades between
// parts.
#pragma once

#include <optional>

#include "core/simulation/coordinates.h"
#include "core/simulation/motion_fit.h"
#include "core/simulation/spline.h"

namespace noctule::simulation {

struct Timing {
    double rest_seconds = 3;
    double duration_s = 0;  ///< of the whole take; 0: rest and the motion once
};

/// Where on the floor a performer begins: +Z is ahead, a positive yaw turns to the left.
struct StandingPlace {
    double x_m = 0, z_m = 0, yaw_rad = 0;
};

class Performance {
public:
    /// Without a motion the performer stands in the rest pose; then a duration must be given.
    Performance(Coordinates coordinates, std::vector<double> rest_row, const FittedMotion* motion,
                const Timing& timing);

    double duration_s() const { return duration_s_; }
    double rest_seconds() const { return rest_seconds_; }
    const Coordinates& coordinates() const { return coordinates_; }

    /// The row of coordinates at a time; quaternions are not normalised.
    template <class T>
    void at(double t_s, std::vector<T>& row) const;

    /// World frames of all joints at a time.
    template <class T>
    void frames(double t_s, std::vector<Frame<T>>& frames) const;

    Pose pose(double t_s) const;

    /// All of it is turned and shifted: without, it begins above the origin facing +Z.
    void standAt(const StandingPlace& place);
    /// Of the whole take, instead of what the timing says.
    void lastFor(double duration_s);
    /// Lasts so long: all that it is now, rest pose and motion, is gone through to and fro.
    void comeBack(double duration_s);

    /// Without a motion: from the pose of the moment into another one within kPosing_s, standing where the
    /// performer stands, lowest point on the floor.
    void takePose(const Pose& pose, double t_s);
    /// The pose that was taken last is that of the beginning.
    void keepPose();
    static constexpr double kPosing_s = 1.5;

private:
    /// Turn about the vertical and horizontal shift that lets a repetition go on where the one before ended.
    struct Placement {
        Quaterniond q = Quaterniond::Identity();
        Vector3d p = Vector3d::Zero();
    };

    /// Rows of coordinates and when the performer begins to go over into them.
    struct Posing {
        double begin_s = 0;
        std::vector<double> row;
    };

    template <class T>
    static void placeRoot(const Placement& placement, std::vector<T>& row);
    template <class T>
    void performedAt(double t_s, std::vector<T>& row) const;
    template <class T>
    void posedAt(double t_s, std::vector<T>& row) const;
    void placeRepetitions();
    template <class T>
    void motionAt(double t_s, std::vector<T>& row) const;
    template <class T>
    void repetitionAt(size_t repetition, double t_s, std::vector<T>& row) const;

    Coordinates coordinates_;
    std::vector<double> rest_row_;
    std::vector<Posing> posings_;
    Spline motion_;
    std::vector<Placement> repetitions_;
    std::optional<Placement> place_;
    double rest_seconds_ = 0, duration_s_ = 0;
    double transition_s_ = 1;  ///< from the rest pose into the motion
    double seam_s_ = 0;        ///< cross-fade between repetitions
    double once_s_ = 0;        ///< from its beginning to where it turns back; 0: never
};

}  // namespace noctule::simulation
