// SPDX-License-Identifier: Apache-2.0
#include "core/processing/export_take.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/job/atomic_file.h"
#include "core/job/staged_progress.h"
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

Result<ExportedMotion> cut(const Take& take, const TimedMotion& motion, const ExportRequest& request,
                           double frames_per_second) {
    ExportedMotion exported;
    MotionClip& clip = exported.clip;
    clip.name = take.header().name;
    clip.skeleton = motion.skeleton;
    clip.frame_time_s = 1 / frames_per_second;
    if (!motion.frames.empty()) {
        PoseSampler sampler(motion, std::numeric_limits<int64_t>::max());
        const auto toNs = [](double s) { return static_cast<int64_t>(std::llround(s * 1e9)); };
        const int64_t begin = request.from_s ? toNs(*request.from_s) : motion.frames.front().time_ns;
        const int64_t end = request.to_s ? std::min(toNs(*request.to_s), motion.frames.back().time_ns)
                                         : motion.frames.back().time_ns;
        for (int64_t i = 0;; ++i) {
            const int64_t time_ns = begin + toNs(static_cast<double>(i) / frames_per_second);
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

Result<ExportedMotion> exportedMotion(const Take& take, const TimedMotion& motion,
                                      const ExportRequest& request) {
    auto exported = cut(take, motion, request, request.frames_per_second);
    if (!exported || (request.png_path.empty() && request.video_path.empty()))
        return exported;
    auto filmed = cut(take, motion, request, request.film.frames_per_second);
    if (!filmed)
        return filmed.error();
    exported->filmed = std::move(filmed->clip);
    return exported;
}

}  // namespace

const std::vector<ExportFormatEntry>& exportFormats() {
    static const std::vector<ExportFormatEntry> formats{
        {ExportFormat::kBvh, "bvh", "bvh", &ExportRequest::bvh_path},
        {ExportFormat::kFbx, "fbx", "fbx", &ExportRequest::fbx_path},
        {ExportFormat::kGlb, "glb", "glb", &ExportRequest::glb_path},
        {ExportFormat::kCsv, "csv", "csv", &ExportRequest::csv_path},
        {ExportFormat::kMot, "mot", "mot", &ExportRequest::mot_path},
        {ExportFormat::kSto, "sto", "sto", &ExportRequest::sto_path},
        {ExportFormat::kPng, "png", "png", &ExportRequest::png_path},
        {ExportFormat::kVideo, "video", "mp4", &ExportRequest::video_path}};
    return formats;
}

const ExportFormatEntry& entryOf(ExportFormat format) {
    const auto& formats = exportFormats();
    return *std::find_if(formats.begin(), formats.end(),
                         [&](const ExportFormatEntry& entry) { return entry.format == format; });
}

bool isPicture(ExportFormat format) {
    return format == ExportFormat::kPng || format == ExportFormat::kVideo;
}

bool showsBody(ExportFormat format) {
    return format == ExportFormat::kFbx || format == ExportFormat::kGlb || isPicture(format);
}

ExportFormat formatOf(const ExportRequest& request, const std::string& path) {
    const auto& formats = exportFormats();
    const auto found = std::find_if(formats.begin(), formats.end(), [&](const ExportFormatEntry& entry) {
        return request.*entry.path == path;
    });
    require(found != formats.end(), "formatOf() needs one of the request's outputs");
    return found->format;
}

std::vector<std::string> outputsOf(const ExportRequest& request) {
    std::vector<std::string> paths;
    for (const ExportFormatEntry& entry : exportFormats())
        if (!(request.*entry.path).empty())
            paths.push_back(request.*entry.path);
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
    const auto exported = exportedMotion(*opened, *motion, request);
    if (!exported)
        return exported.error();
    const MotionClip& clip = exported->clip;
    ExportSummary summary{
        run->name, clip.frames.size(), exported->filmed.frames.size(), clip.duration_s(), {}};
    const auto writers = exportWriters(request, *exported);
    const double step = 0.7 / static_cast<double>(writers.size());
    for (const ExportWriter& writer : writers) {
        if (job.cancelled())
            return JobContext::cancelledError();
        const double done = 0.3 + step * static_cast<double>(summary.files.size());
        StagedProgress part(job, done, done + step);
        part.job().progress(0, "Writing");
        if (Status written = writer.write(part.job()); !written)
            return written.error();
        summary.files.push_back(writer.path);
    }
    job.progress(1, "Done");
    return summary;
}

}  // namespace noctule
