// SPDX-License-Identifier: Apache-2.0
#include "core/processing/root_in_world.h"

#include <algorithm>
#include <cmath>

#include "core/math/rotation.h"
#include "core/processing/cross_clocks.h"
#include "core/processing/pose_runs.h"

namespace noctule {
namespace {

double yawError(const Pose& found, const Pose& truth) {
    const Quaterniond error = found.q_parent_joint[0] * truth.q_parent_joint[0].conjugate();
    return std::remainder(2 * std::atan2(error.y(), error.w()), 2 * std::numbers::pi);
}

std::optional<RootInWorld> compare(const TimedMotion& found, const TimedMotion& truth, int64_t from_ns) {
    PoseSampler sampler(truth, bridgeableGap_ns(truth));
    double places_m2 = 0, yaws_rad2 = 0, frames = 0;
    for (const TimedPose& frame : found.frames) {
        const auto of = frame.time_ns < from_ns ? std::nullopt : sampler.at(frame.time_ns);
        if (!frame.pose || !of)
            continue;
        places_m2 += (frame.pose->p_world_root - of->p_world_root).squaredNorm();
        yaws_rad2 += std::pow(yawError(*frame.pose, *of), 2);
        frames += 1;
    }
    if (frames == 0)
        return std::nullopt;
    return RootInWorld{std::sqrt(places_m2 / frames), degrees(std::sqrt(yaws_rad2 / frames))};
}

}  // namespace

Result<std::optional<RootInWorld>> rootInWorld(const std::string& take_path, const std::string& run,
                                               const TakeSubject& subject, const JobContext& job) {
    const auto take = Take::open(take_path, Access::kRead, {job.cancel});
    if (!take)
        return take.error();
    const auto subjects = take->subjects();
    if (!subjects)
        return subjects.error();
    if (std::ranges::none_of(*subjects, &TakeSubject::room))
        return std::optional<RootInWorld>();
    const auto chosen = choosePoseRun(*take, run);
    if (!chosen)
        return chosen.error();
    const RunSettings settings = runSettings(*chosen, {}, take->level());
    if (!settings.uses_room || std::ranges::count(settings.unjoined, subject.suit()) > 0)
        return std::optional<RootInWorld>();
    const auto found = take->poses(chosen->run, subject.suit());
    if (!found)
        return found.error();
    const auto truth = take->reference(subject.suit());
    if (!truth)
        return truth.error();
    const auto rest = take->restInterval(subject.suit());
    if (!rest)
        return rest.error();
    int64_t from_ns = 0;
    if (*rest)
        from_ns = std::llround(
            1e9 * take->suitClock(subject.suit())
                      .takeTime_s(static_cast<double>((*rest)->last) / sampleRateOf(*take, subject.suit())));
    return compare(*found, *truth, from_ns);
}

}  // namespace noctule
