// SPDX-License-Identifier: Apache-2.0
#include "core/figure/seen_motion.h"

#include <algorithm>

#include "core/math/order_statistics.h"

namespace noctule::figure {

SeenMotion::SeenMotion(const MotionClip& clip, size_t most) {
    const size_t count = clip.frames.size();
    const size_t stride = std::max<size_t>(1, (count + most - 1) / most);
    for (size_t f = 0; f < count; f += stride) {
        poses_.push_back(globalPose(clip, f));
        frames_.push_back(f);
    }
}

double SeenMotion::distance(int a, int b) const {
    std::vector<double> distances;
    for (const GlobalPose& pose : poses_)
        distances.push_back(
            (pose.p_world_joint[static_cast<size_t>(a)] - pose.p_world_joint[static_cast<size_t>(b)]).norm());
    return middleValue(std::move(distances));
}

Vector3d SeenMotion::between(int frame, int from, int to) const {
    return mean([&](const GlobalPose& pose) {
        return Vector3d(
            pose.q_world_joint[static_cast<size_t>(frame)].conjugate() *
            (pose.p_world_joint[static_cast<size_t>(to)] - pose.p_world_joint[static_cast<size_t>(from)]));
    });
}

Vector3d SeenMotion::mean(const std::function<Vector3d(const GlobalPose&)>& of) const {
    Vector3d sum = Vector3d::Zero();
    for (const GlobalPose& pose : poses_)
        sum += of(pose);
    return poses_.empty() ? sum : Vector3d(sum / static_cast<double>(poses_.size()));
}

double SeenMotion::meanOf(const std::function<double(const GlobalPose&)>& of) const {
    double sum = 0;
    for (const GlobalPose& pose : poses_)
        sum += of(pose);
    return poses_.empty() ? sum : sum / static_cast<double>(poses_.size());
}

std::vector<Vector3d> zeroPositions(const MotionClip& clip) {
    std::vector<Vector3d> p;
    for (int j = 0; j < clip.skeleton.size(); ++j) {
        const Joint& joint = clip.skeleton.joint(j);
        const Vector3d offset =
            clip.p_parent_joint_m.empty() ? joint.offset_m : clip.p_parent_joint_m[0][static_cast<size_t>(j)];
        p.push_back(j == 0 ? Vector3d::Zero() : Vector3d(p[static_cast<size_t>(joint.parent)] + offset));
    }
    return p;
}

int commonAncestor(const Skeleton& skeleton, int a, int b) {
    while (a != b)
        (a > b ? a : b) = skeleton.joint(std::max(a, b)).parent;
    return a;
}

std::vector<int> chainBetween(const Skeleton& skeleton, int above, int joint) {
    std::vector<int> chain;
    for (; joint > above; joint = skeleton.joint(joint).parent)
        chain.push_back(joint);
    if (joint != above)
        return {};
    std::reverse(chain.begin(), chain.end());
    return chain;
}

}  // namespace noctule::figure
