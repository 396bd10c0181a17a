// SPDX-License-Identifier: Apache-2.0
#include "core/processing/export_take.h"

#include <cmath>
#include <limits>

#include "core/formats/bvh.h"
#include "core/formats/positions_csv.h"
#include "core/job/atomic_file.h"
#include "core/math/rotation.h"
#include "core/processing/pose_runs.h"

namespace noctule {
namespace {

/// Turn about the vertical that takes +Z to where the root faces. Seen from right above or below (lying), the
/// root's up says more than its forward.
Quaterniond headingOf(const Quaterniond& q_world_root) {
    const Vector3d forward = q_world_root * Vector3d::UnitZ();
    const Vector3d facing = std::hypot(forward.x(), forward.z()) > 0.1
                                ? forward
                                : Vector3d(q_world_root * Vector3d::UnitY() * -forward.y());
    return axisAngle(Vector3d::UnitY(), std::atan2(facing.x(), facing.z()));
}

void holdRoot(MotionClip& clip, RootMotion root) {
    if (root == RootMotion::kMoving)
        return;
    const Vector3d first = clip.frames.front().p_world_root;
    for (Pose& pose : clip.frames) {
        pose.p_world_root = Vector3d(first.x(), pose.p_world_root.y(), first.z());
        if (root == RootMotion::kHeading)
            pose.q_parent_joint[0] = headingOf(pose.q_parent_joint[0]).conjugate() * pose.q_parent_joint[0];
    }
}

Result<MotionClip> cut(const Take& take, const TimedMotion& motion, const ExportRequest& request) {
    MotionClip clip;
    clip.name = take.header().name;
    clip.skeleton = motion.skeleton;
    clip.frame_time_s = 1 / request.frames_per_second;
    if (!motion.frames.empty()) {
        PoseSampler sampler(motion, std::numeric_limits<int64_t>::max());
        const auto toNs = [](double s) { return static_cast<int64_t>(std::llround(s * 1e9)); };
        const int64_t begin = request.from_s ? toNs(*request.from_s) : motion.frames.front().time_ns;
        const int64_t end = request.to_s ? std::min(toNs(*request.to_s), motion.frames.back().time_ns)
                                         : motion.frames.back().time_ns;
        for (int64_t i = 0;; ++i) {
            const int64_t time_ns = begin + toNs(static_cast<double>(i) / request.frames_per_second);
            if (time_ns > end)
                break;
            if (auto pose = sampler.at(time_ns))
                clip.frames.push_back(std::move(*pose));
        }
    }
    if (clip.frames.empty())
        return Error{ErrorKind::kUnusable, take.path() + ": there is no pose in the part to export",
                     "Choose --from and --to within the take's duration"};
    holdRoot(clip, request.root);
    return clip;
}

}  // namespace

Result<ExportSummary> exportTake(const ExportRequest& request, const JobContext& job) {
    for (const std::string& path : {request.bvh_path, request.csv_path})
        if (!path.empty())
            if (Status free = checkOutputPath(path, request.overwrite); !free)
                return free.error();
    const auto opened = Take::open(request.take_path);
    if (!opened)
        return opened.error();
    const auto run = choosePoseRun(*opened, request.run);
    if (!run)
        return run.error();
    job.progress(0, "Reading poses");
    const auto motion = opened->poses(run->run);
    if (!motion)
        return motion.error();
    const auto clip = cut(*opened, *motion, request);
    if (!clip)
        return clip.error();
    ExportSummary summary{run->name, clip->frames.size(), clip->duration_s(), {}};
    const auto written = [&](const std::string& path, const Status& done) {
        if (done)
            summary.files.push_back(path);
        return done;
    };
    if (job.cancelled())
        return JobContext::cancelledError();
    job.progress(0.3, "Writing");
    if (!request.bvh_path.empty()) {
        BvhOptions options;
        options.metres_per_unit = request.metres_per_unit;
        if (Status done =
                written(request.bvh_path, writeBvh(request.bvh_path, *clip, options, request.overwrite));
            !done)
            return done.error();
    }
    if (job.cancelled())
        return JobContext::cancelledError();
    job.progress(0.7, "Writing");
    if (!request.csv_path.empty())
        if (Status done = written(request.csv_path, writePositionsCsv(request.csv_path, *clip, request.angles,
                                                                      request.overwrite));
            !done)
            return done.error();
    job.progress(1, "Done");
    return summary;
}

}  // namespace noctule
