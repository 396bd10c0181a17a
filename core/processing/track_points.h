// SPDX-License-Identifier: Apache-2.0
// Welch 2018 on a take: every housing of every performer as a free point, from the ranges to the room, within
// and between performers. Ranges of one pulse correct together, at its emission; what a microphone moves
// until it hears follows from its velocity. A source and a microphone in one housing are one point, at the
// microphone; the way between them counts as noise. The take stays as it is: points are no poses.
#pragma once

#include <functional>

#include "core/processing/process_take.h"

namespace noctule {

struct TakePoint {
    std::string subject, device;  ///< device: id of the board, else of the source
    int suit = 0;                 ///< counts from 1
    bool is_source = false;       ///< `device` is a source without a board
};

/// World places at one instant of take time, in the order of PointsSummary::points.
struct PointsFrame {
    double time_s = 0;
    std::vector<Vector3d> p_m;
    std::vector<double> sigma_m;  ///< per axis: root of a third of the covariance's trace
};

struct PointsSummary {
    std::vector<TakePoint> points;
    int64_t frames = 0;
    int64_t heard = 0, used = 0, gated = 0;     ///< ranges; the rest was left to the share or not to be used
    int64_t of_room = 0, own = 0, between = 0;  ///< of those heard
    std::vector<std::string> warnings;          ///< whole sentences
};

/// Called once before the first frame, and then for each.
struct PointsSink {
    std::function<void(const std::vector<TakePoint>&)> begin;
    std::function<void(const PointsFrame&)> add;
};

/// `request.tracker.estimator` is one that givesPoints(). Of a take of sound, ranges are measured first; they
/// lie in the tracker's spool folder meanwhile. kUnusable when the take holds no such ranges, or no
/// anchors for "environment".
Result<PointsSummary> trackPoints(const ProcessRequest& request, const PointsSink& sink,
                                  const JobContext& job);

}  // namespace noctule
