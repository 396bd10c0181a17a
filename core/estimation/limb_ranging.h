// SPDX-License-Identifier: Apache-2.0
// How a lost limb lies, from distances and the joints' freedoms. A limb is lost while its gyroscope is at the
// end of its range or silent. Afterwards the gyroscope follows its turn again, so that one attitude is
// sought: that of now. Distances of a window decide it: a robust least-squares fit (Gauss-Newton) from
// starting points all over SO(3). Sound may come late by way of the floor but never early, so the loss
// function has two sides: Geman and McClure's for late arrivals, Cauchy's for early ones (Barron 2019). A
// filter cannot do that, for it linearises about one attitude and gates out what contradicts it.
// limb_alignment.h does the same by forces.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "core/math/conventions.h"

namespace noctule {

struct LimbRangingParameters {
    double memory_s = 1.5;                    ///< of distances
    double suspected_s = 5;                   ///< after a gap in the gyroscope's readings
    double longest_s = 0.03;                  ///< between readings; more is a gap
    double error_m = 0.004, flesh_m = 0.012;  ///< of a distance beyond its own sigma; on soft tissue
    double held_rad = 0.15;                   ///< by which joints give in directions without freedom
    double alike = 4;                         ///< distances in a row that share one error
    double contradicted = 4;                  ///< mean loss of a distance that starts a search
    double lost_rad = 0.45, lost_sigma = 4;   ///< the estimate is off by as much, and as surely
    double explained = 2.5;                   ///< largest mean squared normalised residual of a solution,
    double explained_share = 0.5;             ///< and the least share of distances that it explains
};

class LimbRanging {
public:
    explicit LimbRanging(const LimbRangingParameters& parameters = {}) : parameters_(parameters) {}

    /// The microphone is at p_carried_m + R_world_limb * p_limb_m in the world: what does not turn with the
    /// limb, and what does.
    struct Reading {
        double time_s = 0, distance_m = 0, variance_m2 = 0;
        Vector3d p_source_m, p_carried_m, p_limb_m;
    };
    /// a^T D b = c for the limb's error D = R_believed^T R, within the joint's laxity: unit vectors in the
    /// limb's frame.
    struct Held {
        Vector3d a, b;
        double c = 0;
    };

    /// A reading of the limb's gyroscope within its range, in the limb's frame, without bias.
    void turnSeen(double time_s, const Vector3d& rate_rad_per_s);
    /// The limb's turn has not been seen up to `time_s`.
    void breakOff(double time_s);
    /// The limb's parent has been found elsewhere: distances so far tell nothing.
    void forget() { readings_.clear(); }
    bool isSuspected() const { return last_s_ && *last_s_ - *broken_s_ < parameters_.suspected_s; }
    bool hasBeenSilent(double time_s) const { return last_s_ && time_s - *last_s_ > parameters_.longest_s; }
    void add(const Reading& reading, double flesh_share);

    /// Where the limb is, if it cannot be as believed, R_world_limb.
    struct Found {
        Quaterniond q_believed_limb;
        Quaterniond q_limb_axes;  ///< axes of the error's principal directions
        Vector3d variance_rad2;   ///< along these
    };
    std::optional<Found> contradict(double time_s, const Matrix3d& R_world_limb,
                                    const std::vector<Held>& held) const;

private:
    struct Problem;
    struct Fit;

    LimbRangingParameters parameters_;
    std::optional<double> last_s_, broken_s_;
    Quaterniond q_first_limb_ =
        Quaterniond::Identity();  ///< of the gyroscope: at last_s_ against its beginning
    Vector3d rate_rad_per_s_ = Vector3d::Zero();
    std::vector<Reading> readings_;  ///< oldest first; p_limb_m in the limb's frame at that beginning
};

}  // namespace noctule
