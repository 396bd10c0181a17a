// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/motion_cleaning.h"

#include <algorithm>

#include "core/math/rotation.h"

namespace noctule::simulation {
namespace {

// A joint faster than this between two frames is no person (a punch's forearm turns at 30 rad/s) unless the
// frames are far apart; a root neither.
constexpr double kJumpRadPerS = 60, kJumpMPerS = 15, kLeastJumpRad = 0.35, kLeastJumpM = 0.08;

Status checkFinite(const MotionClip& clip) {
    const auto error = [&](size_t frame, int joint) {
        return Error{ErrorKind::kUnusable,
                     clip.name + ": frame " + std::to_string(frame + 1) + ", joint " +
                         clip.skeleton.joint(joint).name + ": a value is not a finite number",
                     "Repair or cut that frame"};
    };
    for (size_t f = 0; f < clip.frames.size(); ++f) {
        const Pose& pose = clip.frames[f];
        if (!pose.p_world_root.allFinite())
            return error(f, 0);
        for (int j = 0; j < clip.skeleton.size(); ++j)
            if (!pose.q_parent_joint[j].coeffs().allFinite() || pose.q_parent_joint[j].norm() < 1e-6 ||
                (!clip.p_parent_joint_m.empty() && !clip.p_parent_joint_m[f][j].allFinite()))
                return error(f, j);
    }
    return Done{};
}

double largestTurn(const Pose& a, const Pose& b) {
    double largest = 0;
    for (size_t j = 0; j < a.q_parent_joint.size(); ++j)
        largest = std::max(largest, angleBetween(a.q_parent_joint[j], b.q_parent_joint[j]));
    return largest;
}

/// Bridges values of `middle` that are far from both neighbours while these agree. True when any was.
bool bridge(const Pose& before, Pose& middle, const Pose& after, double jump_rad, double jump_m) {
    bool bridged = false;
    for (size_t j = 0; j < middle.q_parent_joint.size(); ++j) {
        const Quaterniond &a = before.q_parent_joint[j], &b = after.q_parent_joint[j];
        Quaterniond& q = middle.q_parent_joint[j];
        const double away = std::min(angleBetween(a, q), angleBetween(b, q));
        if (away > jump_rad && away > 3 * angleBetween(a, b)) {
            q = a.slerp(0.5, b);
            bridged = true;
        }
    }
    const Vector3d &a = before.p_world_root, &b = after.p_world_root;
    const double away = std::min((middle.p_world_root - a).norm(), (middle.p_world_root - b).norm());
    if (away > jump_m && away > 3 * (a - b).norm()) {
        middle.p_world_root = (a + b) / 2;
        bridged = true;
    }
    return bridged;
}

}  // namespace

Result<CleanedMotion> cleanMotion(MotionClip clip) {
    if (clip.frames.empty() || !(clip.frame_time_s > 0))
        return Error{ErrorKind::kUnusable, clip.name + ": there is no motion in it",
                     "Choose a file with frames"};
    Status finite = checkFinite(clip);
    if (!finite)
        return finite.error();

    CleanedMotion cleaned{std::move(clip)};
    std::vector<Pose>& frames = cleaned.clip.frames;
    const double jump_rad = std::max(kLeastJumpRad, kJumpRadPerS * cleaned.clip.frame_time_s);
    const double jump_m = std::max(kLeastJumpM, kJumpMPerS * cleaned.clip.frame_time_s);
    if (frames.size() > 2 && largestTurn(frames[0], frames[1]) > jump_rad &&
        largestTurn(frames[1], frames[2]) < jump_rad / 2) {
        frames.erase(frames.begin());
        if (!cleaned.clip.p_parent_joint_m.empty())
            cleaned.clip.p_parent_joint_m.erase(cleaned.clip.p_parent_joint_m.begin());
        cleaned.dropped_first_frame = true;
    }
    for (size_t f = 1; f + 1 < frames.size(); ++f)
        cleaned.repaired_frames += bridge(frames[f - 1], frames[f], frames[f + 1], jump_rad, jump_m);
    return cleaned;
}

}  // namespace noctule::simulation
