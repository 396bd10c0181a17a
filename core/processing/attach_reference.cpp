// SPDX-License-Identifier: Apache-2.0
#include "core/processing/attach_reference.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "core/math/linear_solvers.h"
#include "core/math/rotation_fit.h"
#include "core/motion/common_joints.h"
#include "core/motion/time_offset.h"
#include "core/processing/pose_runs.h"
#include "core/recording/take_edit.h"

namespace noctule {
namespace {

/// What good optical systems reach; a file does not say.
constexpr double kUsualSigma_m = 0.0005, kUsualSigma_rad = 0.0017;
constexpr double kLeastSpread_m = 0.01;         ///< of the hips' points beside their longest line
constexpr double kUsualPointSigma_rad = 0.005;  ///< an orientation from points a hand's breadth apart

Status checkFree(const Take& take, const AttachRequest& request) {
    if (request.overwrite)
        return Done{};
    const bool reference = request.as == AttachAs::kReference;
    size_t rows = 0;
    if (reference) {
        const auto stored = take.reference();
        if (!stored)
            return stored.error();
        rows = stored->frames.size();
    } else {
        const auto stored = take.externalRoot();
        if (!stored)
            return stored.error();
        rows = stored->size();
    }
    if (rows == 0)
        return Done{};
    return Error{ErrorKind::kUsage,
                 take.path() + ": has " + (reference ? "a reference" : "an external root") + " already",
                 "Use --overwrite to replace it"};
}

Result<TimeOffset> alignment(const Take& take, const AttachRequest& request, const TimedMotion& motion,
                             std::string& aligned_with) {
    if (request.shift_s)
        return TimeOffset{std::llround(*request.shift_s * 1e9), 0, 0, {}};
    if (!request.motion)
        return Error{ErrorKind::kUsage,
                     request.source_name + ": positions cannot be aligned in time by themselves",
                     "Say at which time of the take the file begins (--align MILLISECONDS)"};
    const auto run = choosePoseRun(take, "");
    if (!run)
        return Error{
            run.error().kind, run.error().message + ", and the reference is aligned with one",
            run.error().remedy + ", or say at which time of the take the file begins (--align MILLISECONDS)"};
    const auto estimate = take.poses(run->run);
    if (!estimate)
        return estimate.error();
    const auto offset = findTimeOffset(*estimate, motion);
    if (!offset)
        return Error{ErrorKind::kUnusable,
                     request.source_name + ": no joint that it shares with result '" + run->name +
                         "' moves for two seconds, so the shift cannot be told",
                     "Check that it shows this take, or say at which time of it the file begins (--align "
                     "MILLISECONDS)"};
    if (!offset->trusted())
        return Error{ErrorKind::kUnusable,
                     request.source_name + ": compared with result '" + run->name + "', the motion " +
                         distrust(*offset),
                     "Check that it shows this take, or say at which time of it the file begins (--align "
                     "MILLISECONDS)"};
    aligned_with = run->name;
    return *offset;
}

/// The rigid fit of the joints that sit on the hips, frame by frame.
class RootFromPoints {
public:
    static Result<RootFromPoints> create(const Actor& actor, const PositionTable& table,
                                         const std::string& where) {
        RootFromPoints fit;
        const Skeleton& skeleton = actor.skeleton;
        Eigen::AlignedBox3d box;
        for (int j = 0; j < skeleton.size(); ++j) {
            if (j > 0 && skeleton.joint(j).parent != 0)
                continue;
            const auto found = std::find(table.joints.begin(), table.joints.end(), skeleton.joint(j).name);
            if (found == table.joints.end())
                continue;
            fit.columns_.push_back(static_cast<size_t>(found - table.joints.begin()));
            fit.p_root_m_.push_back(j == 0 ? Vector3d::Zero() : skeleton.joint(j).offset_m);
            box.extend(fit.p_root_m_.back());
        }
        if (fit.columns_.size() < 3)
            return Error{ErrorKind::kUnusable,
                         where + ": holds " + std::to_string(fit.columns_.size()) +
                             " joints of the hips, three are needed to see how they are turned",
                         "Give columns for Hips, Spine, LeftUpLeg and RightUpLeg, or a BVH file"};
        return fit;
    }

    /// Nothing when the points lie on a line.
    std::optional<Pose> root(const PositionTable& table, size_t row) const {
        Eigen::Matrix3Xd from(3, static_cast<Eigen::Index>(columns_.size())), to(from);
        for (size_t i = 0; i < columns_.size(); ++i) {
            from.col(static_cast<Eigen::Index>(i)) = p_root_m_[i];
            to.col(static_cast<Eigen::Index>(i)) = table.at(row, columns_[i]);
        }
        const Eigen::Isometry3d fitted = rigidFit(from, to);
        const Eigen::Matrix3Xd centred = to.colwise() - to.rowwise().mean();
        const double across_m2 = eigenvaluesOf(centred * centred.transpose())[1];
        if (!fitted.matrix().allFinite() || across_m2 < kLeastSpread_m * kLeastSpread_m)
            return std::nullopt;
        return Pose{fitted.translation(), {Quaterniond(fitted.linear()).normalized()}};
    }

private:
    std::vector<size_t> columns_;
    std::vector<Vector3d> p_root_m_;
};

/// On the file's clock.
Result<ReferenceMotion> motionToAttach(const Take& take, const AttachRequest& request) {
    const auto actor = take.actorInForce();
    if (request.motion)
        return referenceFrom(*request.motion, actor ? actor->value.skeleton : defaultActor().skeleton);
    if (!actor)
        return actor.error();
    const PositionTable& table = *request.positions;
    const auto fit = RootFromPoints::create(actor->value, table, request.source_name);
    if (!fit)
        return fit.error();
    ReferenceMotion reference;
    for (size_t row = 0; row < table.time_s.size(); ++row)
        reference.motion.frames.push_back({std::llround(table.time_s[row] * 1e9), fit->root(table, row), {}});
    return reference;
}

/// Times that cannot be seconds: a second and more from one row to the next.
std::string otherUnit(const PositionTable& table) {
    std::vector<double> steps_s;
    for (size_t row = 1; row < table.time_s.size(); ++row)
        steps_s.push_back(table.time_s[row] - table.time_s[row - 1]);
    if (steps_s.empty())
        return "";
    const auto middle = steps_s.begin() + static_cast<std::ptrdiff_t>(steps_s.size() / 2);
    std::nth_element(steps_s.begin(), middle, steps_s.end());
    return *middle < 1      ? ""
           : *middle < 1000 ? "milliseconds"
           : *middle < 1e6  ? "microseconds"
                            : "nanoseconds";
}

Status checkTimes(const AttachRequest& request, const TimedMotion& motion, int64_t shift_ns, int64_t end_ns,
                  AttachSummary& summary) {
    const int64_t all = static_cast<int64_t>(motion.frames.size());
    summary.rows_outside = std::ranges::count_if(motion.frames, [&](const TimedPose& frame) {
        return frame.time_ns + shift_ns < 0 || frame.time_ns + shift_ns > end_ns;
    });
    char length[32];
    std::snprintf(length, sizeof length, "%.3f s", static_cast<double>(end_ns) * 1e-9);
    const std::string outside = std::to_string(summary.rows_outside) + " of " + std::to_string(all) +
                                " rows lie outside the take of " + length;
    const std::string unit = request.positions ? otherUnit(*request.positions) : "";
    if (!unit.empty())
        return Error{ErrorKind::kUnusable,
                     request.source_name + ": " + outside + "; the times look like " + unit,
                     "Name the column " +
                         std::string(unit == "milliseconds"   ? "time_ms"
                                     : unit == "microseconds" ? "time_us"
                                                              : "time_ns") +
                         ", or give the times in seconds"};
    if (summary.rows_outside == all)
        return Error{ErrorKind::kUnusable, request.source_name + ": " + outside,
                     "Check when it begins (--align)"};
    if (summary.rows_outside > 0)
        summary.warnings.push_back(request.source_name + ": " + outside + " and were left out.");
    return Done{};
}

void nameMatched(const Take& take, const AttachRequest& request, const ReferenceMotion& reference,
                 AttachSummary& summary) {
    const auto actor = take.actorInForce();
    if (!request.motion || !actor)
        return;
    const Skeleton& skeleton = actor->value.skeleton;
    size_t moving = 0;
    const Skeleton& theirs = reference.motion.skeleton;
    for (const CommonJoint& joint : commonJoints(skeleton, theirs)) {
        const std::string& name = theirs.joint(joint.second).name;
        const auto in_file = reference.names.find(name);
        summary.matched.emplace_back(joint.name, in_file == reference.names.end() ? name : in_file->second);
        moving += joint.moves;
    }
    const auto wanted = static_cast<size_t>(std::ranges::count_if(
        skeleton.joints(), [](const Joint& joint) { return joint.type != JointType::kFixed; }));
    if (moving < wanted)
        summary.warnings.push_back(request.source_name + ": " + std::to_string(moving) + " of the take's " +
                                   std::to_string(wanted) + " moving joints were recognised.");
}

Status writeRows(TakeEdit& edit, const AttachRequest& request, const TimedMotion& motion, int64_t shift_ns,
                 int64_t end_ns, int64_t& rows) {
    const double sigma_rad = request.motion ? kUsualSigma_rad : kUsualPointSigma_rad;
    for (TimedPose frame : motion.frames) {
        frame.time_ns += shift_ns;
        if (frame.time_ns < 0 || frame.time_ns > end_ns)
            continue;
        Status added = Done{};
        if (request.as == AttachAs::kReference)
            added = edit.addReference(frame);
        else if (frame.pose)
            added = edit.addExternalRoot({frame.time_ns, frame.pose->p_world_root,
                                          frame.pose->q_parent_joint[0], kUsualSigma_m, sigma_rad});
        else
            continue;
        if (!added)
            return added;
        ++rows;
    }
    return Done{};
}

Status replaceRows(TakeEdit& edit, const AttachRequest& request, const ReferenceMotion& reference,
                   const AttachSummary& summary) {
    if (request.as == AttachAs::kExternalRoot)
        return edit.removeExternalRoot();
    if (Status removed = edit.removeReference(); !removed)
        return removed;
    const std::string file = std::filesystem::path(request.source_name).filename().string();
    for (const auto& [key, value] :
         {std::pair<const char*, std::string>{"reference_kind", "optical"},
          {"reference_name", file},
          {"reference_shift_s", std::to_string(summary.shift_s)},
          {"reference_frames", reference.in_our_frames ? "ours" : "own"},
          {"reference_joints", nlohmann::json(reference.names).dump()},
          {"reference_shift_sigma_s",
           summary.shift_sigma_s ? std::to_string(*summary.shift_sigma_s) : std::string()}})
        if (Status set = edit.setMeta(key, value); !set)
            return set;
    return edit.setMeta("reference_actor", toJson(reference.actor).dump());
}

}  // namespace

Result<AttachSummary> attachReference(const AttachRequest& request, const JobContext& job) {
    require(request.motion.has_value() != request.positions.has_value(),
            "one of motion and positions is attached");
    if (request.positions && request.as == AttachAs::kReference)
        return Error{ErrorKind::kUnusable,
                     request.source_name +
                         ": positions do not say how the limbs are twisted, so angles cannot be "
                         "compared with them",
                     "Give the motion as BVH, or attach the positions as the root's (--as external-root)"};
    auto opened = Take::open(request.take_path, Access::kReadWrite, {job.cancel});
    if (!opened)
        return opened.error();
    Take& take = *opened;
    if (Status free = checkFree(take, request); !free)
        return free.error();
    const auto rate = take.sampleRate_hz();
    if (!rate)
        return rate.error();
    const auto samples = take.sampleCount();
    if (!samples)
        return samples.error();

    AttachSummary summary;
    job.progress(0, "Aligning");
    const auto reference = motionToAttach(take, request);
    if (!reference)
        return reference.error();
    const TimedMotion& motion = reference->motion;
    const auto offset = alignment(take, request, motion, summary.aligned_with);
    if (!offset)
        return offset.error();
    summary.shift_s = static_cast<double>(offset->add_to_reference_ns) * 1e-9;
    if (!request.shift_s) {
        summary.correlation = offset->correlation;
        summary.shift_sigma_s = static_cast<double>(offset->sigma_ns) * 1e-9;
    }
    const int64_t end_ns = std::llround(static_cast<double>(*samples) * 1e9 / static_cast<double>(*rate));
    if (Status fits = checkTimes(request, motion, offset->add_to_reference_ns, end_ns, summary); !fits)
        return fits.error();
    if (request.as == AttachAs::kReference)
        nameMatched(take, request, *reference, summary);

    auto edit = TakeEdit::begin(take);
    if (!edit)
        return edit.error();
    if (Status replaced = replaceRows(*edit, request, *reference, summary); !replaced)
        return replaced.error();
    if (Status written = writeRows(*edit, request, motion, offset->add_to_reference_ns, end_ns, summary.rows);
        !written)
        return written.error();
    if (summary.rows == 0)
        return Error{ErrorKind::kUnusable,
                     request.source_name + ": none of its rows within the take shows how the hips are turned",
                     "Give columns of joints that do not lie on a line"};
    if (job.cancelled())
        return JobContext::cancelledError();
    if (Status committed = edit->commit(); !committed)
        return committed.error();
    return summary;
}

}  // namespace noctule
