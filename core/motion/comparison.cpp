// SPDX-License-Identifier: Apache-2.0
#include "core/motion/comparison.h"

#include "core/math/rotation.h"
#include "core/motion/angle_collector.h"
#include "core/motion/common_joints.h"
#include "core/motion/joint_angles.h"
#include "core/motion/root_drift.h"

namespace noctule {
namespace {

constexpr double kNoSigma_rad = 1e-9;
constexpr const char* kEstimate = "the estimate";

struct Mean {
    double sum = 0;
    int64_t count = 0;
    void add(double value) { sum += value, ++count; }
    std::optional<double> value() const {
        return count > 0 ? std::optional<double>(sum / static_cast<double>(count)) : std::nullopt;
    }
};

bool isEndEffector(const std::string& name) {
    return name == "Head" || name == "LeftHand" || name == "RightHand" || name == "LeftFoot" ||
           name == "RightFoot";
}

Vector3d jointSigma(const TimedPose& frame, int joint) {
    if (frame.sigma_rad.empty())
        return Vector3d::Zero();
    return Vector3d::Map(frame.sigma_rad.data() + 3 * static_cast<std::ptrdiff_t>(joint));
}

/// One motion at one instant, seen through the list of common joints.
class View {
public:
    View(GlobalPose global, int CommonJoint::*side) : global_(std::move(global)), side_(side) {}

    const Quaterniond& q_world(const CommonJoint& joint) const { return global_.q_world_joint[at(joint)]; }
    const Vector3d& p_world(const CommonJoint& joint) const { return global_.p_world_joint[at(joint)]; }

    Quaterniond q_ancestor_joint(const std::vector<CommonJoint>& common, const CommonJoint& joint) const {
        return q_world(common[static_cast<size_t>(joint.ancestor)]).conjugate() * q_world(joint);
    }
    Vector3d p_root_joint(const CommonJoint& root, const CommonJoint& joint) const {
        return q_world(root).conjugate() * (p_world(joint) - p_world(root));
    }

private:
    size_t at(const CommonJoint& joint) const { return static_cast<size_t>(joint.*side_); }

    GlobalPose global_;
    int CommonJoint::*side_;
};

/// What is collected about one common joint.
struct JointRecord {
    AngleCollector angle;
    Mean position_m, nees;
    JointCurve* curve = nullptr;
    Vector3d last_reference_rad = Vector3d::Zero();
};

class Comparer {
public:
    /// Both skeletons must outlive it.
    Comparer(const Skeleton& estimate, const Skeleton& reference, const ComparisonOptions& options)
        : estimate_(estimate),
          reference_(reference),
          common_(commonJoints(estimate, reference)),
          records_(common_.size()) {
        result_.curves.reserve(common_.size());  // records point into it
        for (size_t i = 1; i < common_.size(); ++i)
            if (common_[i].moves && options.curves) {
                result_.curves.push_back({common_[i].name, {}, {}, {}, {}});
                records_[i].curve = &result_.curves.back();
            }
    }

    bool hasMovingJoint() const {
        return std::any_of(common_.begin(), common_.end(),
                           [](const CommonJoint& j) { return j.moves && j.ancestor >= 0; });
    }

    const std::vector<CommonJoint>& common() const { return common_; }

    /// One per common joint; before the first frame.
    void useSegments(const std::vector<SegmentMatch>& segments) {
        segments_ = segments;
        for (size_t i = 0; i < common_.size(); ++i) {
            const CommonJoint& joint = common_[i];
            result_.matched.push_back(
                {joint.name, reference_.joint(joint.second).name, joint.moves, segments_[i]});
        }
    }

    void add(const TimedPose& frame, const Pose& reference_pose) {
        const View estimate(globalPose(estimate_, *frame.pose), &CommonJoint::first);
        const View reference(inOurFrames(reference_pose), &CommonJoint::second);
        if (result_.frames++ == 0)
            first_ns_ = frame.time_ns;
        const double since_first_s = static_cast<double>(frame.time_ns - first_ns_) * 1e-9;
        result_.duration_s = since_first_s;
        const double time_s = secondsOf(frame);
        drift_.add(time_s, {estimate.q_world(common_[0]), estimate.p_world(common_[0])},
                   {reference.q_world(common_[0]), reference.p_world(common_[0])});
        Mean mean_rad;
        for (size_t i = 1; i < common_.size(); ++i)
            addJoint(i, frame, estimate, reference, since_first_s, mean_rad);
        result_.mean_curve_deg.add(time_s, degrees(mean_rad.value().value_or(0)));
    }

    Comparison finish() {
        Mean mean_deg, end_effector_mm, nees;
        for (size_t i = 1; i < common_.size(); ++i) {
            const JointRecord& record = records_[i];
            const double position_mm = 1000 * record.position_m.value().value_or(0);
            if (isEndEffector(common_[i].name))
                end_effector_mm.add(position_mm);
            if (!common_[i].moves)
                continue;
            const AngleStatistics angle = record.angle.statistics();
            result_.joints.push_back({common_[i].name, common_[static_cast<size_t>(common_[i].ancestor)].name,
                                      common_[i].composed, angle, position_mm, record.nees.value()});
            mean_deg.add(angle.mean_deg);
            nees.sum += record.nees.sum, nees.count += record.nees.count;
        }
        result_.mean_deg = mean_deg.value().value_or(0);
        result_.end_effector_mm = end_effector_mm.value();
        result_.nees = nees.value();
        result_.root = drift_.finish();
        return std::move(result_);
    }

    Comparison& result() { return result_; }

private:
    GlobalPose inOurFrames(const Pose& reference_pose) const {
        GlobalPose global = globalPose(reference_, reference_pose);
        for (size_t i = 0; i < common_.size(); ++i)
            if (segments_[i].from != FrameFrom::kSame) {
                Quaterniond& q_world_joint = global.q_world_joint[static_cast<size_t>(common_[i].second)];
                q_world_joint = q_world_joint * segments_[i].q_second_first;
            }
        return global;
    }

    void addJoint(size_t i, const TimedPose& frame, const View& estimate, const View& reference,
                  double since_first_s, Mean& mean_rad) {
        const CommonJoint& joint = common_[i];
        JointRecord& record = records_[i];
        record.position_m.add(
            (estimate.p_root_joint(common_[0], joint) - reference.p_root_joint(common_[0], joint)).norm());
        if (!joint.moves)
            return;
        const Quaterniond q_estimate = estimate.q_ancestor_joint(common_, joint);
        const Quaterniond q_reference = reference.q_ancestor_joint(common_, joint);
        const Vector3d error_rad = logQuaternion(q_estimate.conjugate() * q_reference);
        record.angle.add(since_first_s, error_rad.norm());
        mean_rad.add(error_rad.norm());
        const Vector3d sigma_rad = jointSigma(frame, joint.first);
        for (int k = 0; k < 3 && !joint.composed; ++k)
            if (sigma_rad[k] > kNoSigma_rad && std::isfinite(sigma_rad[k]))
                record.nees.add(error_rad[k] * error_rad[k] / (sigma_rad[k] * sigma_rad[k]));
        if (record.curve)
            addCurve(record, secondsOf(frame), q_estimate, q_reference,
                     frame.sigma_rad.empty() ? nullptr : &sigma_rad);
    }

    static double secondsOf(const TimedPose& frame) { return static_cast<double>(frame.time_ns) * 1e-9; }

    static void addCurve(JointRecord& record, double time_s, const Quaterniond& q_estimate,
                         const Quaterniond& q_reference, const Vector3d* sigma_rad) {
        JointCurve& curve = *record.curve;
        record.last_reference_rad = anglesZxyNear(q_reference, record.last_reference_rad);
        const Vector3d angles_rad = anglesZxyNear(q_estimate, record.last_reference_rad);
        const Vector3d sigmas_rad = sigma_rad ? sigmaZxy(angles_rad, *sigma_rad) : Vector3d::Zero();
        for (size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            curve.estimate_deg[k].add(time_s, degrees(angles_rad[axis]));
            curve.reference_deg[k].add(time_s, degrees(record.last_reference_rad[axis]));
            if (sigma_rad)
                curve.sigma_deg[k].add(time_s, degrees(sigmas_rad[axis]));
        }
        curve.difference_deg.add(time_s, degrees(angleBetween(q_estimate, q_reference)));
    }

    const Skeleton& estimate_;
    const Skeleton& reference_;
    std::vector<CommonJoint> common_;
    std::vector<SegmentMatch> segments_;  // per common joint
    std::vector<JointRecord> records_;    // per common joint
    RootDrift drift_;
    Comparison result_;
    int64_t first_ns_ = 0;
};

/// The shift between the clocks, as asked for or found.
Status settleOffset(const PoseSource& estimate, const TimedMotion& reference,
                    const ComparisonOptions& options, Comparison& report) {
    if (options.reference_offset_ns) {
        report.offset.add_to_reference_ns = *options.reference_offset_ns;
        return Done{};
    }
    if (!options.align_time)
        return Done{};
    const auto whole = estimate.all();
    if (!whole)
        return whole.error();
    if (Status checked = checkMotion(*whole, kEstimate); !checked)
        return checked;
    const auto found = findTimeOffset(*whole, reference);
    if (found && found->trusted())
        report.offset = *found;
    else
        report.refused_offset = found;
    return Done{};
}

bool isSeen(const TimedPose& frame) {
    return frame.pose && isUsable(*frame.pose);
}

/// Both motions at up to 1000 instants, evenly spread whatever the length of the estimate.
Result<PosePairs> collectPairs(const PoseSource& estimate, const TimedMotion& reference,
                               const ComparisonOptions& options, int64_t shift_ns) {
    constexpr size_t kMost = 1000;
    PosePairs pairs;
    PoseSampler sampler(reference, bridgeableGap_ns(reference));
    int64_t spacing_ns = 20'000'000, next_ns = std::numeric_limits<int64_t>::min();
    const Status walked = estimate.forEach([&](TimedPose&& frame) {
        if (frame.time_ns < std::max(options.from_ns, next_ns) || frame.time_ns > options.to_ns ||
            !isSeen(frame) || frame.pose->q_parent_joint.size() != estimate.skeleton.joints().size())
            return true;
        const auto reference_pose = sampler.at(frame.time_ns - shift_ns);
        if (!reference_pose)
            return true;
        pairs.emplace_back(globalPose(estimate.skeleton, *frame.pose),
                           globalPose(reference.skeleton, *reference_pose));
        if (pairs.size() == kMost) {
            for (size_t i = 1; i < kMost / 2; ++i)  // the first stays: moved onto itself it would be emptied
                pairs[i] = std::move(pairs[2 * i]);
            pairs.resize(kMost / 2);
            spacing_ns *= 2;
        }
        next_ns = frame.time_ns + spacing_ns;
        return true;
    });
    if (!walked)
        return walked.error();
    return pairs;
}

Result<std::vector<SegmentMatch>> matchSegments(const PoseSource& estimate, const TimedMotion& reference,
                                                const std::vector<CommonJoint>& common,
                                                const ComparisonOptions& options, int64_t shift_ns) {
    if (!options.match_segments)
        return std::vector<SegmentMatch>(common.size());
    auto known = matchZeroPoses(estimate.skeleton, reference.skeleton, common);
    if (known && isSameFigure(*known))
        return std::move(*known);
    const auto pairs = collectPairs(estimate, reference, options, shift_ns);
    if (!pairs)
        return pairs.error();
    return matchMotions(estimate.skeleton, reference.skeleton, common, *pairs, std::move(known));
}

}  // namespace

const JointComparison* Comparison::find(const std::string& name) const {
    const auto found =
        std::find_if(joints.begin(), joints.end(), [&](const auto& j) { return j.name == name; });
    return found == joints.end() ? nullptr : &*found;
}

Result<Comparison> compareMotions(const PoseSource& estimate, const TimedMotion& reference,
                                  const ComparisonOptions& options) {
    if (Status checked = checkMotion(reference, "the reference"); !checked)
        return checked.error();
    Comparer comparer(estimate.skeleton, reference.skeleton, options);
    if (!comparer.hasMovingJoint())
        return Error{ErrorKind::kUnusable, "the estimate and the reference share no joint that moves",
                     "Name the reference's joints as the actor does, or give the actor aliases for them"};
    Comparison& result = comparer.result();
    if (Status settled = settleOffset(estimate, reference, options, result); !settled)
        return settled.error();
    const int64_t shift_ns = result.offset.add_to_reference_ns;
    const auto segments = matchSegments(estimate, reference, comparer.common(), options, shift_ns);
    if (!segments)
        return segments.error();
    comparer.useSegments(*segments);
    const auto inWindow = [&](int64_t time_ns) {
        return time_ns >= options.from_ns && time_ns <= options.to_ns;
    };
    for (const TimedPose& frame : reference.frames)
        result.reference_missing += inWindow(frame.time_ns + shift_ns) && !isSeen(frame);
    PoseSampler sampler(reference, bridgeableGap_ns(reference));
    MotionCheck check(estimate.skeleton, kEstimate);
    Status checked = Done{};
    const Status walked = estimate.forEach([&](TimedPose&& frame) {
        checked = check.next(frame);
        if (!checked)
            return false;
        if (!inWindow(frame.time_ns))
            return true;
        if (!isSeen(frame)) {
            ++result.estimate_missing;
        } else if (const auto reference_pose = sampler.at(frame.time_ns - shift_ns)) {
            frame.pose = interpolate(*frame.pose, *frame.pose, 0);
            comparer.add(frame, *reference_pose);
        } else {
            ++result.unmatched;
        }
        return true;
    });
    if (!checked)
        return checked.error();
    if (!walked)
        return walked.error();
    if (result.frames == 0)
        return Error{ErrorKind::kUnusable, "the estimate and the reference have no instant in common",
                     "Align their times first, or look at the part where both were recorded"};
    return comparer.finish();
}

Result<Comparison> compareMotions(const TimedMotion& estimate, const TimedMotion& reference,
                                  const ComparisonOptions& options) {
    return compareMotions(sourceOf(estimate), reference, options);
}

}  // namespace noctule
