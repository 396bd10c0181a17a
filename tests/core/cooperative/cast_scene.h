// SPDX-License-Identifier: Apache-2.0
// Two people as Welch 2018 had them: 13 transceivers each, four in the room, 100 steps a second, ranges with
// 2 mm of noise. The motions lie beside the repository (../shared/data/bvh/cmu); tests skip without.
#pragma once

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "core/cooperative/point_filter.h"

namespace noctule::cooperative {

struct CastScene {
    std::vector<std::vector<Vector3d>> places_m;  ///< per step, of all points
    std::vector<int> user_of_point;
    std::vector<Vector3d> anchors_m;
    double dt_s = 0.01;
    int wrists[2] = {4, 17};  ///< the right ones, of the first two users with 13 points each
    double q_m2_per_s3 = 0.03;

    int users() const { return user_of_point.back() + 1; }
};

/// Four anchors on tripods at the corners of a square of 5 m, 0.5 and 2.5 m high in turn.
std::vector<Vector3d> fourAnchors();

/// CMU 18_01 and the same person turned about where the right hands meet; both begin half a metre farther.
CastScene handshake();
/// CMU 60_05 and 61_05 at 60 Hz and 1.4 times the size.
CastScene salsa();
/// Several handshakes in a ring, neighbours 1 m apart; an even number of people.
CastScene ringOf(int people);
/// Points that move as the filter believes: white acceleration of density q.
CastScene drawnScene(int users, int points_each, int steps, double q_m2_per_s3, unsigned seed);

struct CastScore {
    double rms_mm = 0, wrist_to_wrist_mm = 0, nees = 0;
    double shape_mm = 0;  ///< after the best common turn and shift
    double turn_deg = 0;  ///< the largest common turn
    size_t steps = 0;
    double worst_mm = 0;  ///< the largest rms of one step
};

struct CastRun {
    PointFilterSettings settings;
    unsigned seed = 1;
    double sigma_m = 0.002;
    double start_sigma_m = 0.01, start_sigma_m_per_s = 0.3;
    int warm_up_steps = 50;  ///< not scored
    /// Told the filter and the truth after each step.
    std::function<void(const PointFilter&, size_t step)> watch = {};
};

CastScore runCast(const CastScene& scene, const CastRun& run);

}  // namespace noctule::cooperative
