// SPDX-License-Identifier: Apache-2.0
#include "core/figure/lost_tracking.h"

#include <algorithm>

#include "core/math/rotation.h"

namespace noctule::figure {
namespace {

constexpr double kMoves_rad = 0.02;  // a joint that turns less in the whole clip says nothing
constexpr double kJump_rad = 0.12;   // zeros nearer to their neighbours than this do no harm
constexpr double kLimbJump_rad = 0.5;
constexpr double kLongestOfAJoint_s = 0.5;

bool isZero(const Quaterniond& q) {
    return q.vec().isZero(0);
}

/// Frames begin to end - 1.
struct Run {
    size_t begin, end;
};

template <class F>
std::vector<Run> runsOf(size_t count, F holds) {
    std::vector<Run> runs;
    for (size_t f = 0; f < count; ++f)
        if (holds(f)) {
            if (runs.empty() || runs.back().end != f)
                runs.push_back({f, f});
            runs.back().end = f + 1;
        }
    return runs;
}

class Bridge {
public:
    explicit Bridge(MotionClip& clip) : clip_(clip) {
        for (size_t j = 0; j < joints(); ++j) {
            double most = 0;
            for (const Pose& pose : clip.frames)
                most = std::max(most, angleBetween(pose.q_parent_joint[j], clip.frames[0].q_parent_joint[j]));
            if (most > kMoves_rad)
                moving_.push_back(j);
        }
    }

    Result<LostTracking> run() {
        const size_t count = clip_.frames.size();
        if (count < 3 || moving_.size() < 3)
            return lost_;
        std::vector<Run> runs = runsOf(count, [&](size_t f) { return isLost(f); });
        std::erase_if(runs, [&](const Run& run) { return largestJump(run) < kJump_rad; });
        size_t lost = 0;
        for (const Run& run : runs)
            lost += run.end - run.begin;
        if (2 * lost > count)
            return Error{ErrorKind::kUnusable,
                         clip_.name + ": tracking is lost in " + std::to_string(lost) + " of " +
                             std::to_string(count) + " frames: all their angles are zero",
                         "Cut the part out in which the subject was seen"};
        for (const Run& run : runs)
            bridgeRows(run);
        for (const size_t joint : moving_)
            bridgeJoint(joint);
        bridgeRoot();
        cutEnds();
        return lost_;
    }

private:
    size_t joints() const { return clip_.skeleton.joints().size(); }

    bool isLost(size_t f) const {
        return std::all_of(moving_.begin(), moving_.end(),
                           [&](size_t j) { return isZero(clip_.frames[f].q_parent_joint[j]); });
    }

    double jumpTo(size_t f, size_t other) const {
        double most = 0;
        for (const size_t j : moving_)
            most = std::max(
                most, angleBetween(clip_.frames[f].q_parent_joint[j], clip_.frames[other].q_parent_joint[j]));
        return most;
    }
    /// The smaller of the jumps at a run's two ends.
    double largestJump(const Run& run) const {
        const double before = run.begin > 0 ? jumpTo(run.begin, run.begin - 1) : 1e9;
        const double after = run.end < clip_.frames.size() ? jumpTo(run.end - 1, run.end) : 1e9;
        return std::min(before, after);
    }

    void bridgeRows(const Run& run) {
        const size_t length = run.end - run.begin;
        if (run.begin == 0) {
            lost_.cut_first = length;
            return;
        }
        if (run.end == clip_.frames.size()) {
            lost_.cut_last = length;
            return;
        }
        lost_.bridged += length;
        lost_.longest = std::max(lost_.longest, length);
        const Pose before = clip_.frames[run.begin - 1], after = clip_.frames[run.end];
        for (size_t f = run.begin; f < run.end; ++f) {
            const double share = static_cast<double>(f - run.begin + 1) / static_cast<double>(length + 1);
            clip_.frames[f].p_world_root = before.p_world_root * (1 - share) + after.p_world_root * share;
            for (size_t j = 0; j < joints(); ++j)
                clip_.frames[f].q_parent_joint[j] =
                    before.q_parent_joint[j].slerp(share, after.q_parent_joint[j]);
            if (!clip_.p_parent_joint_m.empty())
                for (size_t j = 0; j < joints(); ++j)
                    clip_.p_parent_joint_m[f][j] = clip_.p_parent_joint_m[run.begin - 1][j] * (1 - share) +
                                                   clip_.p_parent_joint_m[run.end][j] * share;
        }
    }

    /// Zeros of one joint alone, with a jump before and after: a limb that was out of sight.
    void bridgeJoint(size_t j) {
        const size_t most = static_cast<size_t>(kLongestOfAJoint_s / clip_.frame_time_s) + 1;
        size_t bridged = 0;
        const auto q = [&](size_t f) -> Quaterniond& { return clip_.frames[f].q_parent_joint[j]; };
        for (const Run& run : runsOf(clip_.frames.size(), [&](size_t f) { return isZero(q(f)); })) {
            if (run.begin == 0 || run.end == clip_.frames.size() || run.end - run.begin > most)
                continue;
            const Quaterniond before = q(run.begin - 1), after = q(run.end);
            const double away =
                std::min(angleBetween(before, q(run.begin)), angleBetween(after, q(run.begin)));
            if (away < std::max(kLimbJump_rad, 2 * angleBetween(before, after)))
                continue;
            for (size_t f = run.begin; f < run.end; ++f)
                q(f) = before.slerp(
                    static_cast<double>(f - run.begin + 1) / static_cast<double>(run.end - run.begin + 1),
                    after);
            bridged += run.end - run.begin;
        }
        if (bridged > 0)
            lost_.joints.emplace_back(clip_.skeleton.joint(static_cast<int>(j)).name, bridged);
    }

    /// Places of zeros of the root alone: far from where it was before and is afterwards.
    void bridgeRoot() {
        constexpr double kFar = 0.5, kSteps = 20;
        const auto p = [&](size_t f) -> Vector3d& { return clip_.frames[f].p_world_root; };
        std::vector<double> steps;
        for (size_t f = 1; f < clip_.frames.size(); ++f)
            steps.push_back((p(f) - p(f - 1)).norm());
        std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2),
                         steps.end());
        const double usual = steps[steps.size() / 2];
        size_t bridged = 0;
        for (const Run& run : runsOf(clip_.frames.size(), [&](size_t f) { return p(f).isZero(0); })) {
            if (run.begin == 0 || run.end == clip_.frames.size())
                continue;
            const Vector3d before = p(run.begin - 1), after = p(run.end);
            const double away = std::min(before.norm(), after.norm());
            if (away < kSteps * usual || (after - before).norm() > kFar * away)
                continue;
            for (size_t f = run.begin; f < run.end; ++f) {
                const double share =
                    static_cast<double>(f - run.begin + 1) / static_cast<double>(run.end - run.begin + 1);
                p(f) = before * (1 - share) + after * share;
            }
            bridged += run.end - run.begin;
        }
        if (bridged > 0)
            lost_.joints.emplace_back("the place of " + clip_.skeleton.joint(0).name, bridged);
    }

    void cutEnds() {
        const auto cut = [&](auto& rows) {
            if (rows.empty())
                return;
            rows.resize(rows.size() - lost_.cut_last);
            rows.erase(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(lost_.cut_first));
        };
        cut(clip_.frames);
        cut(clip_.p_parent_joint_m);
    }

    MotionClip& clip_;
    std::vector<size_t> moving_;  ///< joints that turn
    LostTracking lost_;
};

}  // namespace

Result<LostTracking> bridgeLostTracking(MotionClip& clip) {
    return Bridge(clip).run();
}

}  // namespace noctule::figure
