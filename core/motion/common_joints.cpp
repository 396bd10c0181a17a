// SPDX-License-Identifier: Apache-2.0
#include "core/motion/common_joints.h"

#include <algorithm>

namespace noctule {
namespace {

bool hasAlias(const Joint& joint, const std::string& name) {
    return std::any_of(joint.aliases.begin(), joint.aliases.end(),
                       [&](const auto& alias) { return alias.second == name; });
}

int findSame(const Joint& joint, const Skeleton& other) {
    const int exact = other.find(joint.name);
    if (exact >= 0)
        return exact;
    for (int i = 0; i < other.size(); ++i)
        if (hasAlias(joint, other.joint(i).name) || hasAlias(other.joint(i), joint.name))
            return i;
    return -1;
}

bool isAncestor(const Skeleton& skeleton, int ancestor, int joint) {
    for (int j = skeleton.joint(joint).parent; j >= 0; j = skeleton.joint(j).parent)
        if (j == ancestor)
            return true;
    return false;
}

/// True when a joint strictly between them can move.
bool movesBetween(const Skeleton& skeleton, int ancestor, int joint) {
    for (int j = skeleton.joint(joint).parent; j > ancestor; j = skeleton.joint(j).parent)
        if (skeleton.joint(j).type != JointType::kFixed)
            return true;
    return false;
}

/// Parents precede children, so the last one found is the nearest.
int nearestMovingAncestor(const std::vector<CommonJoint>& known, const CommonJoint& joint,
                          const Skeleton& first, const Skeleton& second) {
    for (int i = static_cast<int>(known.size()) - 1; i > 0; --i) {
        const CommonJoint& other = known[static_cast<size_t>(i)];
        if (other.moves && isAncestor(first, other.first, joint.first) &&
            isAncestor(second, other.second, joint.second))
            return i;
    }
    return 0;
}

}  // namespace

std::vector<CommonJoint> commonJoints(const Skeleton& first, const Skeleton& second) {
    std::vector<CommonJoint> common;
    if (first.size() == 0 || second.size() == 0)
        return common;
    const int second_root = std::max(0, findSame(first.joint(0), second));
    common.push_back({first.joint(0).name, 0, second_root, true, -1, false});
    for (int i = 1; i < first.size(); ++i) {
        const int same = findSame(first.joint(i), second);
        if (same < 0 || same == second_root)
            continue;
        CommonJoint joint{first.joint(i).name, i, same, false, 0, false};
        joint.moves =
            first.joint(i).type != JointType::kFixed && second.joint(same).type != JointType::kFixed;
        joint.ancestor = nearestMovingAncestor(common, joint, first, second);
        const CommonJoint& ancestor = common[static_cast<size_t>(joint.ancestor)];
        joint.composed =
            movesBetween(first, ancestor.first, i) || movesBetween(second, ancestor.second, same);
        common.push_back(joint);
    }
    return common;
}

}  // namespace noctule
