// SPDX-License-Identifier: Apache-2.0
#include "core/processing/export_take.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/job/atomic_file.h"
#include "core/math/rotation.h"
#include "core/processing/bone_confidence.h"
#include "core/processing/export_files.h"
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

Result<ExportedMotion> cut(const Take& take, const TimedMotion& motion, const ExportRequest& request) {
    ExportedMotion exported;
    MotionClip& clip = exported.clip;
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
            if (auto pose = sampler.at(time_ns)) {
                clip.frames.push_back(std::move(*pose));
                exported.confidence.push_back(boneConfidence(motion, time_ns));
            }
        }
    }
    if (clip.frames.empty())
        return Error{ErrorKind::kUnusable, take.path() + ": there is no pose in the part to export",
                     "Choose --from and --to within the take's duration"};
    holdRoot(clip, request.root);
    const auto is_empty = [](const std::vector<float>& row) { return row.empty(); };
    if (std::any_of(exported.confidence.begin(), exported.confidence.end(), is_empty))
        exported.confidence.clear();
    return exported;
}

}  // namespace

std::vector<std::string> outputsOf(const ExportRequest& request) {
    std::vector<std::string> paths;
    for (const std::string* path : {&request.bvh_path, &request.fbx_path, &request.glb_path,
                                    &request.csv_path, &request.mot_path, &request.sto_path})
        if (!path->empty())
            paths.push_back(*path);
    return paths;
}

Result<ExportSummary> exportTake(const ExportRequest& request, const JobContext& job) {
    for (const std::string& path : outputsOf(request))
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
    const auto exported = cut(*opened, *motion, request);
    if (!exported)
        return exported.error();
    const MotionClip& clip = exported->clip;
    ExportSummary summary{run->name, clip.frames.size(), clip.duration_s(), {}};
    const auto writers = exportWriters(request, *exported);
    for (size_t i = 0; i < writers.size(); ++i) {
        if (job.cancelled())
            return JobContext::cancelledError();
        job.progress(0.3 + 0.7 * static_cast<double>(i) / static_cast<double>(writers.size()), "Writing");
        if (Status done = writers[i].write(); !done)
            return done.error();
        summary.files.push_back(writers[i].path);
    }
    job.progress(1, "Done");
    return summary;
}

}  // namespace noctule
