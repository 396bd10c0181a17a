// SPDX-License-Identifier: Apache-2.0
#include "core/motion/timed_poses.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace noctule {
namespace {

Quaterniond shortestSlerp(const Quaterniond& a, const Quaterniond& b, double fraction) {
    return a.normalized().slerp(fraction, b.normalized());  // Eigen takes the short way whatever the signs
}

}  // namespace

bool isUsable(const Pose& pose) {
    const auto good = [](const Quaterniond& q) { return q.coeffs().allFinite() && q.norm() > 0.5; };
    return pose.p_world_root.allFinite() &&
           std::all_of(pose.q_parent_joint.begin(), pose.q_parent_joint.end(), good);
}

Result<TimedMotion> PoseSource::all() const {
    TimedMotion motion{skeleton, {}};
    const Status walked = forEach([&motion](TimedPose&& frame) {
        motion.frames.push_back(std::move(frame));
        return true;
    });
    if (!walked)
        return walked.error();
    return motion;
}

Result<std::optional<PoseSpan>> PoseSource::seen() const {
    std::optional<PoseSpan> span;
    const Status walked = forEach([&span](TimedPose&& frame) {
        if (frame.pose && isUsable(*frame.pose))
            span = PoseSpan{span ? span->first_ns : frame.time_ns, frame.time_ns};
        return true;
    });
    if (!walked)
        return walked.error();
    return span;
}

PoseSource sourceOf(const TimedMotion& motion) {
    return {motion.skeleton, [&motion](const PoseSink& sink) -> Status {
                for (TimedPose frame : motion.frames)
                    if (!sink(std::move(frame)))
                        break;
                return Done{};
            }};
}

Status MotionCheck::next(const TimedPose& frame) {
    const auto which = [&] { return where_ + ": frame " + std::to_string(count_ - 1); };
    if (count_++ > 0 && frame.time_ns <= last_ns_)
        return Error{ErrorKind::kUnusable, which() + " is not later than the one before it",
                     "Write the poses in the order of their times"};
    last_ns_ = frame.time_ns;
    const bool fits = (!frame.pose || frame.pose->q_parent_joint.size() == joints_) &&
                      (frame.sigma_rad.empty() || frame.sigma_rad.size() == 3 * joints_);
    if (!fits)
        return Error{ErrorKind::kUnusable,
                     which() + " does not fit its skeleton of " + std::to_string(joints_) + " joints",
                     "Use the actor that the poses were made with"};
    return Done{};
}

Status checkMotion(const TimedMotion& motion, const std::string& where) {
    MotionCheck check(motion.skeleton, where);
    for (const TimedPose& frame : motion.frames)
        if (Status fits = check.next(frame); !fits)
            return fits;
    return Done{};
}

Pose interpolate(const Pose& a, const Pose& b, double fraction) {
    require(a.q_parent_joint.size() == b.q_parent_joint.size(), "poses of two skeletons cannot be mixed");
    Pose pose;
    pose.p_world_root = (1 - fraction) * a.p_world_root + fraction * b.p_world_root;
    pose.q_parent_joint.reserve(a.q_parent_joint.size());
    for (size_t j = 0; j < a.q_parent_joint.size(); ++j)
        pose.q_parent_joint.push_back(shortestSlerp(a.q_parent_joint[j], b.q_parent_joint[j], fraction));
    return pose;
}

PoseSampler::PoseSampler(const TimedMotion& motion, int64_t max_gap_ns)
    : motion_(motion), max_gap_ns_(max_gap_ns) {
    for (size_t i = 0; i < motion.frames.size(); ++i)
        if (motion.frames[i].pose && isUsable(*motion.frames[i].pose))
            seen_.push_back(i);
}

std::optional<Pose> PoseSampler::at(int64_t time_ns) {
    const auto frame = [this](size_t i) -> const TimedPose& { return motion_.frames[seen_[i]]; };
    if (next_ > 0 && frame(next_ - 1).time_ns > time_ns)
        next_ = 0;
    while (next_ < seen_.size() && frame(next_).time_ns <= time_ns)
        ++next_;
    if (next_ == 0)
        return std::nullopt;
    const TimedPose& before = frame(next_ - 1);
    if (before.time_ns == time_ns)
        return interpolate(*before.pose, *before.pose, 0);
    if (next_ == seen_.size() || frame(next_).time_ns - before.time_ns > max_gap_ns_)
        return std::nullopt;
    const double step = static_cast<double>(frame(next_).time_ns - before.time_ns);
    return interpolate(*before.pose, *frame(next_).pose,
                       static_cast<double>(time_ns - before.time_ns) / step);
}

std::optional<PoseSpan> PoseSampler::seen() const {
    if (seen_.empty())
        return std::nullopt;
    return PoseSpan{motion_.frames[seen_.front()].time_ns, motion_.frames[seen_.back()].time_ns};
}

std::optional<Pose> PoseSampler::held(int64_t time_ns) {
    const auto span = seen();
    return span ? at(std::clamp(time_ns, span->first_ns, span->last_ns)) : std::nullopt;
}

std::optional<Pose> poseAt(const TimedMotion& motion, int64_t time_ns, int64_t max_gap_ns) {
    const auto seen = [](const TimedPose& frame) { return frame.pose && isUsable(*frame.pose); };
    const auto& frames = motion.frames;
    const auto later = std::upper_bound(frames.begin(), frames.end(), time_ns,
                                        [](int64_t t, const TimedPose& frame) { return t < frame.time_ns; });
    auto before = later;
    while (before != frames.begin() && time_ns - std::prev(before)->time_ns <= max_gap_ns)
        if (seen(*--before))
            break;
    if (before == later || !seen(*before))
        return std::nullopt;
    if (before->time_ns == time_ns)
        return interpolate(*before->pose, *before->pose, 0);
    for (auto after = later; after != frames.end() && after->time_ns - before->time_ns <= max_gap_ns; ++after)
        if (seen(*after))
            return interpolate(*before->pose, *after->pose,
                               static_cast<double>(time_ns - before->time_ns) /
                                   static_cast<double>(after->time_ns - before->time_ns));
    return std::nullopt;
}

int64_t usualStep_ns(const TimedMotion& motion) {
    std::vector<int64_t> steps;
    for (size_t i = 1; i < motion.frames.size(); ++i)
        steps.push_back(motion.frames[i].time_ns - motion.frames[i - 1].time_ns);
    if (steps.empty())
        return 0;
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

int64_t bridgeableGap_ns(const TimedMotion& motion) {
    constexpr int64_t kLeast_ns = 50'000'000;
    const int64_t step_ns = usualStep_ns(motion);
    return std::max(kLeast_ns, step_ns + step_ns / 2);
}

TimedMotion resample(const TimedMotion& motion, double frames_per_second) {
    require(frames_per_second > 0 && frames_per_second < 1e5, "a frame rate lies between 0 and 100 kHz");
    TimedMotion result{motion.skeleton, {}};
    const auto seen = [](const TimedPose& f) { return f.pose && isUsable(*f.pose); };
    const auto first = std::find_if(motion.frames.begin(), motion.frames.end(), seen);
    const auto last = std::find_if(motion.frames.rbegin(), motion.frames.rend(), seen);
    if (first == motion.frames.end())
        return result;
    PoseSampler sampler(motion, std::numeric_limits<int64_t>::max());
    for (int64_t i = 0;; ++i) {
        const int64_t time_ns =
            first->time_ns + std::llround(static_cast<double>(i) * 1e9 / frames_per_second);
        if (time_ns > last->time_ns)
            return result;
        result.frames.push_back({time_ns, sampler.at(time_ns), {}});
    }
}

MotionClip toClip(const std::string& name, const TimedMotion& motion, double frames_per_second) {
    MotionClip clip;
    clip.name = name;
    clip.skeleton = motion.skeleton;
    clip.frame_time_s = 1 / frames_per_second;
    for (TimedPose& frame : resample(motion, frames_per_second).frames)
        clip.frames.push_back(std::move(*frame.pose));
    return clip;
}

}  // namespace noctule
