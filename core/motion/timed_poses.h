// SPDX-License-Identifier: Apache-2.0
// A motion as a run of poses at instants of the take's clock, equally spaced or not, with holes where nothing
// was seen: what an estimator writes and what a reference system delivers.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/clip.h"

namespace noctule {

struct TimedPose {
    int64_t time_ns = 0;
    std::optional<Pose> pose;  ///< absent: not seen (a row whose rotation or position is NULL)
    std::vector<double>
        sigma_rad;  ///< 3 per joint, right perturbation, 0 along what cannot move; may be empty
};

struct TimedMotion {
    Skeleton skeleton;
    std::vector<TimedPose> frames;  ///< times strictly increasing
};

/// From the first usable pose of a motion to the last.
struct PoseSpan {
    int64_t first_ns = 0, last_ns = 0;
};

/// Called for every frame; false stops the walk.
using PoseSink = std::function<bool(TimedPose&&)>;

/// A motion that is gone through from its beginning whenever it is needed, and need not fit into memory.
struct PoseSource {
    Skeleton skeleton;
    std::function<Status(const PoseSink&)> forEach;

    Result<TimedMotion> all() const;
    /// None: nothing was seen.
    Result<std::optional<PoseSpan>> seen() const;
};

/// `motion` must outlive it.
PoseSource sourceOf(const TimedMotion& motion);
PoseSource sourceOf(TimedMotion&& motion) = delete;

/// Looks at one frame after the other, and fails (kUnusable) when times do not increase or a pose does not
/// fit the skeleton; `where` names the motion.
class MotionCheck {
public:
    MotionCheck(const Skeleton& skeleton, std::string where)
        : joints_(skeleton.joints().size()), where_(std::move(where)) {}
    Status next(const TimedPose& frame);

private:
    size_t joints_;
    std::string where_;
    int64_t count_ = 0, last_ns_ = 0;
};

/// Every frame of it.
Status checkMotion(const TimedMotion& motion, const std::string& where);

/// True when position and rotations are finite and no quaternion is near zero.
bool isUsable(const Pose& pose);

/// Slerp of every joint and a straight line of the root; fraction 0..1 from a to b.
Pose interpolate(const Pose& a, const Pose& b, double fraction);

/// Reads a motion at any instant, walking forward; the motion must outlive it.
class PoseSampler {
public:
    /// Two seen frames further apart than `max_gap_ns` are not joined.
    PoseSampler(const TimedMotion& motion, int64_t max_gap_ns);

    /// The pose at a time; nothing outside the motion or within a gap. Fast when times increase.
    std::optional<Pose> at(int64_t time_ns);
    /// The same; before the motion its first pose, after it the last one.
    std::optional<Pose> held(int64_t time_ns);
    std::optional<PoseSpan> seen() const;

private:
    const TimedMotion& motion_;
    int64_t max_gap_ns_;
    std::vector<size_t> seen_;  ///< indices of usable frames
    size_t next_ = 0;           ///< into seen_: first frame after the last time asked for
};

/// The pose at one time, as PoseSampler gives it, by a binary search.
std::optional<Pose> poseAt(const TimedMotion& motion, int64_t time_ns, int64_t max_gap_ns = 100'000'000);

/// The median time from one frame to the next; 0 with fewer than two frames.
int64_t usualStep_ns(const TimedMotion& motion);

/// Half as much again as the usual step of a motion, 50 ms at least: what interpolation may bridge.
int64_t bridgeableGap_ns(const TimedMotion& motion);

/// The motion at another frame rate, from its first to its last seen frame. Holes of any length are bridged.
TimedMotion resample(const TimedMotion& motion, double frames_per_second);

/// As an animation with equal steps; empty when nothing was seen.
MotionClip toClip(const std::string& name, const TimedMotion& motion, double frames_per_second);

}  // namespace noctule
