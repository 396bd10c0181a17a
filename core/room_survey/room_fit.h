// SPDX-License-Identifier: Apache-2.0
// Robust least squares of all anchors' places from ranges between them and to a performer's devices.
//
// Unknown are, per anchor, its middle and half the way from its microphone to its source; per device a
// constant error of where it sits; the speed of sound's relative error; and, every half second, by how much
// the performer's poses are displaced and turned and the room's clock is off (nodes). The performer's rest
// pose at the beginning holds the world; without a performer a frame near the start is kept, as loosely as
// nothing else tells. Cauchy's loss, so that echoes pull little; flesh and poses err alike within half a
// second, and by how much is learnt from the residuals.
#pragma once

#include "core/job/job.h"
#include "core/room_survey/evidence.h"

namespace noctule::room_survey {

struct FitSettings {
    double node_s = 0.5;
    double device_m = 0.007;  ///< constant error of a device's place on its segment, per axis
    double scale = 1e-3;      ///< of the speed of sound: 0.6 K
    double least_flesh_m = 0.003, first_flesh_m = 0.01;  ///< of a device, the same for half a second
    double drift_m = 0.03, drift_rad = 0.01;    ///< of the poses, per sqrt(s); larger: they are believed less
    double floor_m = 0.03, tilt_rad = 0.035;    ///< of the poses at any time: feet and gravity hold them
    double begin_m = 0.001, begin_rad = 0.001;  ///< of the rest pose, which is the world's origin
    double clock_m = 0.003, clock_drift_m = 3e-4;  ///< of a clock that is known; drift per sqrt(s)
    double unknown_clock_m = 3, unknown_drift_m = 0.01;
    double height_m = 0.003;  ///< of heights that an operator measured
    double loss_sigma = 2.5;  ///< residuals beyond it pull less and less
    int most_iterations = 40;
};

/// The performer's poses, corrected: q (p) + t; `clock_m` as in AnchorStart.
struct Correction {
    Vector3d t_m = Vector3d::Zero();
    Quaterniond q = Quaterniond::Identity();
    double clock_m = 0;
};

struct RoomUnknowns {
    std::vector<Vector3d> places_m,
        halves_m;                     ///< per anchor; microphone = place - half, source = place + half
    std::vector<Vector3d> devices_m;  ///< in the frame of the segment
    double scale = 0;                 ///< ranges are longer than distances by this share
    std::vector<Correction> nodes;

    Vector3d microphone_m(size_t anchor) const { return places_m[anchor] - halves_m[anchor]; }
    Vector3d source_m(size_t anchor) const { return places_m[anchor] + halves_m[anchor]; }
};

struct RoomFit {
    RoomUnknowns unknowns;
    Eigen::MatrixXd cov_places_m2;          ///< 3 per anchor, in the world
    std::vector<double> between_m, walk_m;  ///< residuals, in the order of pairDistances() and of the walk
    std::vector<Vector3d> devices_at_m;     ///< per range of the walk: its device in the world
    double flesh_m = 0;
    int iterations = 0;
    bool converged = false;
};

/// `places_m`: first places, `clock_m`: of the room's clock.
Result<RoomFit> fitRoom(const Evidence& evidence, const std::vector<Vector3d>& places_m, double clock_m,
                        const FitSettings& settings, const JobContext& job);

/// Covariance of the anchors relative to each other: what no turn or displacement of all of them changes.
Eigen::MatrixXd constellationCovariance(const std::vector<Vector3d>& places_m,
                                        const Eigen::MatrixXd& cov_places_m2);
/// Columns: displacements of all anchors along x, y, z, then turns about these axes through their middle.
Eigen::MatrixXd commonMotions(const std::vector<Vector3d>& places_m);

}  // namespace noctule::room_survey
