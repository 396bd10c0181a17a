// SPDX-License-Identifier: Apache-2.0
#include "core/processing/export_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/body/floor_move.h"
#include "core/math/rotation.h"
#include "core/processing/bone_confidence.h"
#include "core/processing/contacts_in_force.h"
#include "core/processing/held_pose.h"
#include "core/processing/pose_runs.h"

namespace noctule {
namespace {

void holdRoot(MotionClip& clip, RootMotion root) {
    if (root == RootMotion::kMoving)
        return;
    const Vector3d first = clip.frames.front().p_world_root;
    for (Pose& pose : clip.frames) {
        pose.p_world_root = Vector3d(first.x(), pose.p_world_root.y(), first.z());
        if (root == RootMotion::kHeading)
            pose.q_parent_joint[0] =
                axisAngle(Vector3d::UnitY(), floorHeading(pose.q_parent_joint[0])).conjugate() *
                pose.q_parent_joint[0];
    }
}

/// A run's motion, and when its feet stood; without a body nobody asks for these.
struct RunMotion {
    TimedMotion motion;
    std::vector<FootContacts> feet;
};

Result<ExportedMotion> cut(const Take& take, const RunMotion& from, const ExportRequest& request,
                           double frames_per_second) {
    const TimedMotion& motion = from.motion;
    ExportedMotion exported;
    MotionClip& clip = exported.clip;
    clip.name = request.motion_name.empty() ? take.header().name : request.motion_name;
    clip.skeleton = motion.skeleton;
    clip.frame_time_s = 1 / frames_per_second;
    if (!motion.frames.empty()) {
        PoseSampler sampler(motion, std::numeric_limits<int64_t>::max());
        const auto toNs = [](double s) { return static_cast<int64_t>(std::llround(s * 1e9)); };
        const int64_t begin = request.from_s ? toNs(*request.from_s) : motion.frames.front().time_ns;
        const int64_t last = motion.frames.back().time_ns, to = request.to_s ? toNs(*request.to_s) : last;
        const int64_t end = request.holds_ends ? to : std::min(to, last);
        int64_t end_ns = begin;
        for (int64_t i = 0;; ++i) {
            const int64_t time_ns = begin + toNs(static_cast<double>(i) / frames_per_second);
            if (time_ns > end)
                break;
            if (auto pose = request.holds_ends ? sampler.held(time_ns) : sampler.at(time_ns)) {
                if (clip.frames.empty())
                    exported.begin_s = static_cast<double>(time_ns) * 1e-9;
                clip.frames.push_back(std::move(*pose));
                exported.confidence.push_back(boneConfidence(motion, time_ns));
                end_ns = time_ns;
            }
        }
        if (const auto seen = sampler.seen(); seen && request.holds_ends)
            exported.held =
                heldInWords(request.subject, *seen, toNs(exported.begin_s), end_ns, toNs(clip.frame_time_s));
    }
    if (clip.frames.empty())
        return Error{ErrorKind::kUnusable, take.path() + ": there is no pose in the part to export",
                     "Choose --from and --to within the take's duration"};
    if (locksFeet(request))
        exported.feet = {clip.frames, clip.frame_time_s, footPlants(from.feet, exported.begin_s)};
    holdRoot(clip, request.root);
    const auto is_empty = [](const std::vector<float>& row) { return row.empty(); };
    if (std::any_of(exported.confidence.begin(), exported.confidence.end(), is_empty))
        exported.confidence.clear();
    return exported;
}

}  // namespace

bool locksFeet(const ExportRequest& request) {
    return request.worn && request.with_body && request.lock_feet;
}

Result<ExportedMotion> exportedMotion(const ExportRequest& request) {
    auto take = Take::open(request.take_path);
    if (!take)
        return take.error();
    if (request.suit)
        take->view(*request.suit);
    const auto run = choosePoseRun(*take, request.run);
    if (!run)
        return run.error();
    auto poses = take->poses(run->run);
    if (!poses)
        return poses.error();
    RunMotion motion{std::move(*poses), {}};
    if (request.with_body) {
        auto contacts = contactsInForce(*take, *run, motion.motion);
        if (!contacts)
            return contacts.error();
        motion.feet = std::move(contacts->feet);
    }
    auto exported = cut(*take, motion, request, request.frames_per_second);
    if (!exported)
        return exported;
    exported->run = run->name;
    exported->feet_at_rest = feetAtRest(motion.motion, motion.feet);
    if (request.png_path.empty() && request.video_path.empty())
        return exported;
    auto filmed = cut(*take, motion, request, request.film.frames_per_second);
    if (!filmed)
        return filmed.error();
    exported->filmed = std::move(filmed->clip);
    exported->filmed_feet = std::move(filmed->feet);
    return exported;
}

}  // namespace noctule
