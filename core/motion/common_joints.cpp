// SPDX-License-Identifier: Apache-2.0
#include "core/motion/common_joints.h"

#include <algorithm>
#include <map>

#include "core/body/bone_names.h"

namespace noctule {
namespace {

bool hasAlias(const Joint& joint, const std::string& name) {
    return std::any_of(joint.aliases.begin(), joint.aliases.end(),
                       [&](const auto& alias) { return alias.second == name; });
}

/// What each joint is called by its own skeleton and in our names. A skeleton with all main joints in our
/// names is taken as it is; another one is read by the table of bone names, since the same word can be
/// another joint elsewhere (LeftShoulder is the upper arm in Xsens' files).
class CanonicalNames {
public:
    explicit CanonicalNames(const Skeleton& skeleton)
        : skeleton_(skeleton), of_joint_(skeleton.joints().size()) {
        if (std::ranges::all_of(mainJoints(), [&](const auto& name) { return skeleton.find(name) >= 0; }))
            return;
        std::vector<NamedBone> bones;
        for (const Joint& joint : skeleton.joints())
            bones.push_back({joint.name, joint.parent});
        bone_of_joint_ = jointsByName(bones).bone_of_joint;
        for (const auto& [joint, bone] : bone_of_joint_)
            of_joint_[static_cast<size_t>(bone)] = joint;
    }

    /// Empty where the table does not know the joint.
    const std::string& of(int joint) const { return of_joint_[static_cast<size_t>(joint)]; }

    /// The same joint as the other skeleton's joint i, or -1.
    int findSame(const Joint& joint, const std::string& canonical) const {
        const std::string& name = canonical.empty() ? joint.name : canonical;
        if (const auto known = bone_of_joint_.find(name); known != bone_of_joint_.end())
            return known->second;
        const int exact = skeleton_.find(name);
        if (exact >= 0)
            return of(exact).empty() ? exact : -1;
        for (int i = 0; i < skeleton_.size(); ++i)
            if (of(i).empty() &&
                (hasAlias(joint, skeleton_.joint(i).name) || hasAlias(skeleton_.joint(i), name)))
                return i;
        return -1;
    }

private:
    const Skeleton& skeleton_;
    std::vector<std::string> of_joint_;
    std::map<std::string, int> bone_of_joint_;
};

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
    const CanonicalNames first_names(first), second_names(second);
    const auto sameOf = [&](int i) { return second_names.findSame(first.joint(i), first_names.of(i)); };
    const int second_root = std::max(0, sameOf(0));
    common.push_back({first.joint(0).name, 0, second_root, true, -1, false});
    for (int i = 1; i < first.size(); ++i) {
        const int same = sameOf(i);
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
