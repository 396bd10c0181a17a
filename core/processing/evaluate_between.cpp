// SPDX-License-Identifier: Apache-2.0
#include "core/processing/evaluate_between.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/math/linear_solvers.h"
#include "core/math/rotation.h"
#include "core/processing/cross_clocks.h"
#include "core/processing/pose_runs.h"

namespace noctule {
namespace {

constexpr double kNear_m = 0.3;

/// One subject's estimated and true motion.
struct Judged {
    std::string name;
    TimedMotion estimate, reference;
    int64_t from_ns = 0;  ///< after the rest
    int suit = 0;
    std::vector<RelativeRow> relatives;
};

double headingAngle(const Quaterniond& q) {
    return 2 * std::atan2(q.y(), q.w());
}

double headingError(const Pose& estimate, const Pose& truth) {
    return std::remainder(headingAngle(estimate.q_parent_joint[0] * truth.q_parent_joint[0].conjugate()),
                          2 * std::numbers::pi);
}

std::optional<Vector3d> placeOf(const Skeleton& skeleton, const Pose& pose, const char* joint) {
    const int index = skeleton.find(joint);
    if (index < 0)
        return std::nullopt;
    return globalPose(skeleton, pose).p_world_joint[static_cast<size_t>(index)];
}

/// Sums up one pair of ends.
class EndPair {
public:
    EndPair(const char* from, const char* to) : from_(from), to_(to) {}

    void add(const Judged& a, const Judged& b, const std::array<Pose, 4>& poses) {
        const auto from = placeOf(a.estimate.skeleton, poses[0], from_),
                   to = placeOf(b.estimate.skeleton, poses[1], to_),
                   true_from = placeOf(a.reference.skeleton, poses[2], from_),
                   true_to = placeOf(b.reference.skeleton, poses[3], to_);
        if (!from || !to || !true_from || !true_to)
            return;
        const double of_a = headingError(poses[0], poses[2]), of_b = headingError(poses[1], poses[3]);
        const double relative = std::remainder(of_b - of_a, 2 * std::numbers::pi);
        const Vector3d found = *to - *from, truth = *true_to - *true_from;
        const Quaterniond back(axisAngle(Vector3d::UnitY(), -(of_a + 0.5 * relative)));
        const double error_m2 = (back * found - truth).squaredNorm();
        squares_ += error_m2;
        world_squares_ += (found - truth).squaredNorm();
        heading_squares_ += relative * relative;
        ++frames_;
        if (truth.norm() < kNear_m)
            near_squares_ += error_m2, ++near_;
    }
    bool isOf(const RelativeRow& row) const { return row.joint == from_ && row.other_joint == to_; }
    /// Against what the run says of this vector.
    void judge(const Judged& a, const Judged& b, const std::array<Pose, 4>& poses, const Matrix3d& cov_m2) {
        const auto seen = [this](const Skeleton& of, const Pose& pose, const Skeleton& of_other,
                                 const Pose& other) -> std::optional<Vector3d> {
            const auto from = placeOf(of, pose, from_), to = placeOf(of_other, other, to_);
            if (!from || !to)
                return std::nullopt;
            return pose.q_parent_joint[0].conjugate() * (*to - *from);
        };
        const auto found = seen(a.estimate.skeleton, poses[0], b.estimate.skeleton, poses[1]),
                   truth = seen(a.reference.skeleton, poses[2], b.reference.skeleton, poses[3]);
        constexpr double kSingular = 1e-12;  ///< rounding, of the largest variance
        const Eigensystem axes = eigensystemOf(cov_m2);
        if (!found || !truth || !(axes.values[0] > kSingular * axes.values[2]))
            return;
        const Vector3d error = *found - *truth;
        nees_ += (axes.vectors.transpose() * error).cwiseAbs2().cwiseQuotient(axes.values).sum() / 3;
        variances_m2_ += cov_m2.trace();
        ++stated_;
    }
    std::optional<BetweenEvaluation> finish(const Judged& a, const Judged& b) const {
        if (frames_ == 0)
            return std::nullopt;
        const auto rms = [](double squares, int64_t count) {
            return std::sqrt(squares / static_cast<double>(count));
        };
        BetweenEvaluation found{a.name, b.name, from_, to_, 1000 * rms(squares_, frames_), {}, 0, 0, frames_};
        if (near_ > 0)
            found.rms_near_mm = 1000 * rms(near_squares_, near_);
        found.rms_world_mm = 1000 * rms(world_squares_, frames_);
        found.heading_deg = degrees(rms(heading_squares_, frames_));
        if (stated_ > 0) {
            found.sigma_mm = 1000 * rms(variances_m2_, stated_);
            found.nees = nees_ / static_cast<double>(stated_);
        }
        return found;
    }

private:
    const char *from_, *to_;
    double squares_ = 0, near_squares_ = 0, world_squares_ = 0, heading_squares_ = 0;
    int64_t frames_ = 0, near_ = 0;
    double nees_ = 0, variances_m2_ = 0;
    int64_t stated_ = 0;
};

Result<Judged> readJudged(const Take& take, int64_t run, const TakeSubject& subject) {
    Judged judged;
    judged.name = subject.name;
    auto estimate = take.poses(run, subject.suit());
    if (!estimate)
        return estimate.error();
    auto reference = take.reference(subject.suit());
    if (!reference)
        return reference.error();
    const auto rest = take.restInterval(subject.suit());
    if (!rest)
        return rest.error();
    if (*rest)
        judged.from_ns = std::llround(
            1e9 * take.suitClock(subject.suit())
                      .takeTime_s(static_cast<double>((*rest)->last) / sampleRateOf(take, subject.suit())));
    auto relatives = take.relatives(run, subject.suit());
    if (!relatives)
        return relatives.error();
    judged.suit = subject.suit();
    judged.relatives = std::move(*relatives);
    judged.estimate = std::move(*estimate);
    judged.reference = std::move(*reference);
    return judged;
}

void judgeStated(const Judged& a, const Judged& b, std::vector<EndPair>& pairs) {
    PoseSampler of_a(a.estimate, bridgeableGap_ns(a.estimate)),
        of_b(b.estimate, bridgeableGap_ns(b.estimate)), true_a(a.reference, bridgeableGap_ns(a.reference)),
        true_b(b.reference, bridgeableGap_ns(b.reference));
    for (const RelativeRow& row : a.relatives) {
        if (row.other_suit != b.suit || row.time_ns < std::max(a.from_ns, b.from_ns))
            continue;
        const auto one = of_a.at(row.time_ns), other = of_b.at(row.time_ns), truth = true_a.at(row.time_ns),
                   other_truth = true_b.at(row.time_ns);
        if (one && other && truth && other_truth)
            for (EndPair& pair : pairs)
                if (pair.isOf(row))
                    pair.judge(a, b, {*one, *other, *truth, *other_truth}, row.cov_m2);
    }
}

void judgePair(const Judged& a, const Judged& b, std::vector<BetweenEvaluation>& found) {
    std::vector<EndPair> pairs;
    for (const auto& [from, to] : kComparedEnds)
        pairs.emplace_back(from, to);
    PoseSampler of_b(b.estimate, bridgeableGap_ns(b.estimate)),
        true_a(a.reference, bridgeableGap_ns(a.reference)),
        true_b(b.reference, bridgeableGap_ns(b.reference));
    for (const TimedPose& frame : a.estimate.frames) {
        if (!frame.pose || frame.time_ns < std::max(a.from_ns, b.from_ns))
            continue;
        const auto other = of_b.at(frame.time_ns), truth = true_a.at(frame.time_ns),
                   other_truth = true_b.at(frame.time_ns);
        if (!other || !truth || !other_truth)
            continue;
        for (EndPair& pair : pairs)
            pair.add(a, b, {*frame.pose, *other, *truth, *other_truth});
    }
    judgeStated(a, b, pairs);
    for (const EndPair& pair : pairs)
        if (auto evaluation = pair.finish(a, b))
            found.push_back(std::move(*evaluation));
}

}  // namespace

Result<std::vector<BetweenEvaluation>> evaluateBetween(const EvaluateRequest& request,
                                                       const std::vector<TakeSubject>& subjects,
                                                       const JobContext& job) {
    const auto take = Take::open(request.take_path, Access::kRead, {job.cancel});
    if (!take)
        return take.error();
    const auto chosen =
        request.run_number ? poseRun(*take, *request.run_number) : choosePoseRun(*take, request.run);
    if (!chosen)
        return chosen.error();
    std::vector<Judged> judged;
    for (const TakeSubject& subject : subjects) {
        auto one = readJudged(*take, chosen->run, subject);
        if (!one)
            return one.error();
        judged.push_back(std::move(*one));
    }
    const RunSettings settings = runSettings(*chosen, {}, take->level());
    std::vector<BetweenEvaluation> found;
    for (size_t a = 0; a < judged.size(); ++a)
        for (size_t b = a + 1; b < judged.size(); ++b) {
            if (job.cancelled())
                return JobContext::cancelledError();
            if (settings.joins(judged[a].suit, judged[b].suit)) {
                judgePair(judged[a], judged[b], found);
            } else if (!judged[a].reference.frames.empty() && !judged[b].reference.frames.empty()) {
                BetweenEvaluation& pair = found.emplace_back();
                pair.a = judged[a].name;
                pair.b = judged[b].name;
                pair.observed = false;
            }
        }
    return found;
}

}  // namespace noctule
