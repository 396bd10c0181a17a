// SPDX-License-Identifier: Apache-2.0
#include "core/motion/motion_curves.h"

#include <algorithm>
#include <limits>

#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kStillSpeed_rad_per_s = 0.1, kStillDistance_m = 0.01;
constexpr int64_t kSmoothing_ns = 100'000'000;  ///< of speeds: longer than the steps of slow cameras

/// Pairs that tell left from right. Distances do not depend on axes.
std::vector<std::pair<size_t, size_t>> judgedPairs(const std::vector<CommonJoint>& common) {
    const auto find = [&](const std::string& name) {
        const auto found = std::find_if(common.begin(), common.end(),
                                        [&](const CommonJoint& joint) { return joint.name == name; });
        return static_cast<size_t>(found - common.begin());
    };
    std::vector<std::pair<size_t, size_t>> pairs;
    for (const auto& [a, b] :
         {std::pair{"LeftHand", "Head"}, std::pair{"RightHand", "Head"}, std::pair{"LeftHand", "LeftUpLeg"},
          std::pair{"RightHand", "RightUpLeg"}, std::pair{"LeftHand", "RightHand"},
          std::pair{"LeftFoot", "Spine"}, std::pair{"RightFoot", "Spine"}, std::pair{"LeftFoot", "RightFoot"},
          std::pair{"LeftHand", "LeftFoot"}, std::pair{"RightHand", "RightFoot"},
          std::pair{"LeftHand", "RightFoot"}, std::pair{"RightHand", "LeftFoot"}})
        if (find(a) < common.size() && find(b) < common.size())
            pairs.emplace_back(find(a), find(b));
    return pairs;
}

/// Mean over a window about each value.
void smooth(std::vector<float>& values, int half_window) {
    std::vector<double> sum(values.size() + 1, 0);
    for (size_t i = 0; i < values.size(); ++i)
        sum[i + 1] = sum[i] + static_cast<double>(values[i]);
    const int size = static_cast<int>(values.size());
    for (int i = 0; i < size; ++i) {
        const int begin = std::max(0, i - half_window), end = std::min(size, i + half_window + 1);
        values[static_cast<size_t>(i)] = static_cast<float>(
            (sum[static_cast<size_t>(end)] - sum[static_cast<size_t>(begin)]) / (end - begin));
    }
}

class CurveMaker {
public:
    CurveMaker(const TimedMotion& motion, const std::vector<CommonJoint>& common, bool second)
        : skeleton_(motion.skeleton), pairs_(judgedPairs(common)) {
        for (const CommonJoint& joint : common) {
            index_.push_back(static_cast<size_t>(second ? joint.second : joint.first));
            if (joint.moves && joint.ancestor >= 0)
                turning_.push_back({index_.back(), index_[static_cast<size_t>(joint.ancestor)]});
        }
        curves_.resize(turning_.size() + pairs_.size() + 1);
    }

    void add(const Pose& pose, double step_s) {
        const GlobalPose global = globalPose(skeleton_, pose);
        size_t c = 0;
        for (const auto& [joint, ancestor] : turning_) {
            const Quaterniond q = global.q_world_joint[ancestor].conjugate() * global.q_world_joint[joint];
            push(c, before_.empty() ? 0 : angleBetween(before_[c], q) / step_s, q);
            ++c;
        }
        for (const auto& [a, b] : pairs_)
            push(c++, (global.p_world_joint[index_[a]] - global.p_world_joint[index_[b]]).norm(),
                 Quaterniond::Identity());
        const Quaterniond& root = global.q_world_joint[index_[0]];
        push(c, before_.empty() ? 0 : logQuaternion(root * before_[c].conjugate()).y() / step_s, root);
        before_ = now_;
        now_.clear();
    }

    std::vector<AlignmentCurve> finish(int64_t step_ns) {
        for (size_t c = 0; c < curves_.size(); ++c) {
            const bool distance = c >= turning_.size() && c + 1 < curves_.size();
            curves_[c].least_deviation = distance ? kStillDistance_m : kStillSpeed_rad_per_s;
            if (!distance && curves_[c].values.size() > 1) {
                curves_[c].values[0] = curves_[c].values[1];
                smooth(curves_[c].values, static_cast<int>(kSmoothing_ns / 2 / step_ns));
            }
        }
        return std::move(curves_);
    }

private:
    void push(size_t curve, double value, const Quaterniond& q) {
        curves_[curve].values.push_back(static_cast<float>(value));
        now_.push_back(q);
    }

    const Skeleton& skeleton_;
    std::vector<std::pair<size_t, size_t>> pairs_;    ///< into index_
    std::vector<size_t> index_;                       ///< joint of the skeleton per common joint
    std::vector<std::pair<size_t, size_t>> turning_;  ///< joint and its ancestor
    std::vector<Quaterniond> before_, now_;           ///< per curve
    std::vector<AlignmentCurve> curves_;
};

}  // namespace

std::vector<AlignmentCurve> motionCurves(const TimedMotion& motion, const std::vector<CommonJoint>& common,
                                         bool second, int64_t step_ns) {
    if (motion.frames.empty() || common.empty())
        return {};
    CurveMaker maker(motion, common, second);
    PoseSampler sampler(motion, std::numeric_limits<int64_t>::max());
    std::optional<Pose> pose;
    const int64_t last_ns = motion.frames.back().time_ns;
    size_t unseen = 0;  // steps before the first pose is seen
    for (int64_t t_ns = motion.frames.front().time_ns; t_ns <= last_ns; t_ns += step_ns) {
        if (std::optional<Pose> now = sampler.at(t_ns))
            pose = std::move(now);
        if (!pose) {
            ++unseen;
            continue;
        }
        for (; unseen > 0; --unseen)
            maker.add(*pose, static_cast<double>(step_ns) * 1e-9);
        maker.add(*pose, static_cast<double>(step_ns) * 1e-9);
    }
    return maker.finish(step_ns);
}

}  // namespace noctule
