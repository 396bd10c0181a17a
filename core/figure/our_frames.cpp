// SPDX-License-Identifier: Apache-2.0
#include "core/figure/our_frames.h"

#include <algorithm>

#include "core/body/actor.h"
#include "core/body/bone_names.h"
#include "core/body/joint_names.h"
#include "core/figure/alignment.h"
#include "core/math/rotation_fit.h"

namespace noctule::figure {
namespace {

/// Per joint of the file q_source_ours. A joint that is not mapped gets, on the mean, the frame of the mapped
/// joint above it, or else of the one below.
class Frames {
public:
    Frames(const MotionClip& clip, const JointMapping& joints, const Alignment& alignment)
        : skeleton_(clip.skeleton), seen_(clip, 200), frames_(clip.skeleton.joints().size()) {
        std::vector<bool> known(frames_.size(), false);
        for (const auto& [name, joint] : joints)
            if (const auto q = alignment.q_source_canonical.find(name);
                q != alignment.q_source_canonical.end()) {
                frames_[static_cast<size_t>(joint)] = q->second;
                known[static_cast<size_t>(joint)] = true;
            }
        const std::vector<bool> mapped = known;
        for (int j = 0; j < skeleton_.size(); ++j)
            if (const int parent = skeleton_.joint(j).parent;
                !known[static_cast<size_t>(j)] && parent >= 0 && known[static_cast<size_t>(parent)])
                follow(j, parent, known);
        for (int j = skeleton_.size() - 1; j > 0; --j)
            if (const int parent = skeleton_.joint(j).parent;
                known[static_cast<size_t>(j)] && !known[static_cast<size_t>(parent)])
                follow(parent, j, known);
        for (int j = 0; j < skeleton_.size(); ++j)
            if (const int parent = skeleton_.joint(j).parent;
                !known[static_cast<size_t>(j)] && parent >= 0 && known[static_cast<size_t>(parent)])
                follow(j, parent, known);
    }

    const std::vector<Quaterniond>& all() const { return frames_; }

private:
    void follow(int joint, int other, std::vector<bool>& known) {
        Matrix3d sum = Matrix3d::Zero();
        for (const GlobalPose& pose : seen_.poses())
            sum += (pose.q_world_joint[static_cast<size_t>(joint)].conjugate() *
                    pose.q_world_joint[static_cast<size_t>(other)] * frames_[static_cast<size_t>(other)])
                       .toRotationMatrix();
        frames_[static_cast<size_t>(joint)] = Quaterniond(nearestRotation(sum));
        known[static_cast<size_t>(joint)] = true;
    }

    const Skeleton& skeleton_;
    SeenMotion seen_;
    std::vector<Quaterniond> frames_;
};

/// The same movement of every joint about frames that are turned by a constant.
MotionClip turnedFrames(const MotionClip& clip, const std::vector<Quaterniond>& q_old_new) {
    std::vector<Joint> joints = clip.skeleton.joints();
    std::vector<Quaterniond> above(joints.size(), Quaterniond::Identity());
    for (size_t j = 0; j < joints.size(); ++j)
        if (joints[j].parent >= 0)
            above[j] = q_old_new[static_cast<size_t>(joints[j].parent)].conjugate();
    MotionClip turned = clip;
    for (Pose& pose : turned.frames)
        for (size_t j = 0; j < joints.size(); ++j)
            pose.q_parent_joint[j] = (above[j] * pose.q_parent_joint[j] * q_old_new[j]).normalized();
    for (std::vector<Vector3d>& places : turned.p_parent_joint_m)
        for (size_t j = 1; j < joints.size(); ++j)
            places[j] = above[j] * places[j];
    for (size_t j = 0; j < joints.size(); ++j) {
        joints[j].offset_m = above[j] * joints[j].offset_m;
        if (joints[j].end_m)
            joints[j].end_m = q_old_new[j].conjugate() * *joints[j].end_m;
    }
    turned.skeleton = Skeleton::make(std::move(joints)).value();
    return turned;
}

/// Without the joints above all mapped ones: a node at the origin with the hips far from it is no bone.
MotionClip withoutCarriers(const MotionClip& clip, JointMapping& joints) {
    const Skeleton& skeleton = clip.skeleton;
    const auto holds = [&](int top) {
        return std::ranges::all_of(joints, [&](const auto& joint) {
            int j = joint.second;
            while (j > top)
                j = skeleton.joint(j).parent;
            return j == top;
        });
    };
    int top = joints.at("Hips");
    while (!holds(top))
        top = skeleton.joint(top).parent;
    std::vector<int> index(skeleton.joints().size(), -1);
    std::vector<Joint> kept;
    for (int j = top; j < skeleton.size(); ++j) {
        const int parent = skeleton.joint(j).parent;
        if (j > top && (parent < top || index[static_cast<size_t>(parent)] < 0))
            continue;
        index[static_cast<size_t>(j)] = static_cast<int>(kept.size());
        kept.push_back(skeleton.joint(j));
        kept.back().parent = j == top ? -1 : index[static_cast<size_t>(parent)];
        if (j == top) {
            kept.back().type = JointType::kFree;
            kept.back().dof.clear();
            kept.back().offset_m.setZero();
        }
    }
    MotionClip cut = clip;
    for (size_t f = 0; f < clip.frames.size(); ++f) {
        const GlobalPose pose = globalPose(clip, f);
        Pose& frame = cut.frames[f];
        frame = {pose.p_world_joint[static_cast<size_t>(top)], {}};
        std::vector<Vector3d> places;
        for (int j = top; j < skeleton.size(); ++j)
            if (const auto n = static_cast<size_t>(j); index[n] >= 0) {
                frame.q_parent_joint.push_back(j == top ? pose.q_world_joint[n]
                                                        : clip.frames[f].q_parent_joint[n]);
                if (!clip.p_parent_joint_m.empty())
                    places.push_back(clip.p_parent_joint_m[f][n]);
            }
        if (!clip.p_parent_joint_m.empty())
            cut.p_parent_joint_m[f] = std::move(places);
    }
    for (auto& [name, joint] : joints)
        joint = index[static_cast<size_t>(joint)];
    cut.skeleton = Skeleton::make(std::move(kept)).value();
    return cut;
}

void nameAsOurs(MotionClip& clip, const JointMapping& mapping, const Skeleton& target) {
    std::vector<Joint> joints = clip.skeleton.joints();
    const auto& ours = canonicalJointNames();
    std::vector<bool> mapped(joints.size(), false);
    for (const auto& [name, joint] : mapping)
        mapped[static_cast<size_t>(joint)] = true;
    for (size_t j = 0; j < joints.size(); ++j) {
        joints[j].aliases.clear();
        const bool theirs = target.find(joints[j].name) >= 0 && std::ranges::count(ours, joints[j].name) == 0;
        if (!mapped[j] && !theirs)
            joints[j].name = "unmapped " + std::to_string(j);
    }
    for (const auto& [name, joint] : mapping)
        joints[static_cast<size_t>(joint)].name = name;
    for (const char* trunk : {"Chest", "Hips"})  // a file's neck may be the joint that carries the arms
        if (const auto found = mapping.find(trunk); found != mapping.end())
            joints[static_cast<size_t>(found->second)].name = trunk;
    clip.skeleton = Skeleton::make(std::move(joints)).value();
}

}  // namespace

MotionClip inOurFrames(const MotionClip& clip, const JointMapping& joints, const Skeleton& target) {
    const bool has_ours =
        std::ranges::all_of(mainJoints(), [&](const auto& name) { return target.find(name) >= 0; });
    const Skeleton skeleton = has_ours ? target : defaultActor().skeleton;
    const Alignment alignment = alignFigure(clip, SeenMotion(clip), joints, skeleton);
    JointMapping mapping = joints;
    const MotionClip figure = withoutCarriers(clip, mapping);
    MotionClip ours = turnedFrames(figure, Frames(figure, mapping, alignment).all());
    nameAsOurs(ours, mapping, target);
    return ours;
}

}  // namespace noctule::figure
