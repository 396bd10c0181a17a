// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/source_figure.h"

#include <algorithm>

#include "core/math/rotation.h"

namespace noctule::simulation {
namespace {

/// Joint positions where all frames are parallel to the world. Animated joint positions replace the offsets.
std::vector<Vector3d> zeroPositions(const MotionClip& clip) {
    std::vector<Vector3d> p;
    for (int j = 0; j < clip.skeleton.size(); ++j) {
        const Joint& joint = clip.skeleton.joint(j);
        const Vector3d offset = clip.p_parent_joint_m.empty() ? joint.offset_m : clip.p_parent_joint_m[0][j];
        p.push_back(j == 0 ? Vector3d::Zero() : Vector3d(p[joint.parent] + offset));
    }
    return p;
}

/// Distance from a joint to the farthest joint or tip below it; 0 when nothing hangs on it.
double reach(const MotionClip& clip, const std::vector<Vector3d>& p, int top) {
    std::vector<bool> below(p.size(), false);
    below[top] = true;
    double farthest = 0;
    for (int j = top; j < clip.skeleton.size(); ++j) {
        const Joint& joint = clip.skeleton.joint(j);
        below[j] = below[j] || (joint.parent >= 0 && below[joint.parent]);
        if (!below[j])
            continue;
        farthest = std::max(farthest, (p[j] - p[top]).norm());
        if (joint.end_m)
            farthest = std::max(farthest, (p[j] + *joint.end_m - p[top]).norm());
    }
    return farthest;
}

/// Axes of the zero pose: columns left, up, forward.
Matrix3d bodyAxes(const std::vector<Vector3d>& p, const JointMapping& m) {
    const Vector3d left = (p[m.at("LeftUpLeg")] - p[m.at("RightUpLeg")]).normalized();
    const Vector3d hips = (p[m.at("LeftUpLeg")] + p[m.at("RightUpLeg")]) / 2;
    const Vector3d rise = (p[m.at("LeftArm")] + p[m.at("RightArm")]) / 2 - hips;
    const Vector3d up = (rise - left * left.dot(rise)).normalized();
    Matrix3d axes;
    axes << left, up, left.cross(up);
    return axes;
}

/// Where the bone of a limb ends. Bones of the shoulders begin anywhere between spine and collar, so that
/// their direction says nothing.
std::string childOf(const std::string& joint) {
    for (const auto& [name, child] : {std::pair{"UpLeg", "Leg"}, std::pair{"ForeArm", "Hand"}})
        for (const std::string side : {"Left", "Right"})
            if (joint == side + name)
                return side + child;
    for (const std::string side : {"Left", "Right"}) {
        if (joint == side + "Leg")
            return side + "Foot";
        if (joint == side + "Arm")
            return side + "ForeArm";
    }
    return "";
}

}  // namespace

BodyMeasures measure(const MotionClip& clip, const JointMapping& m) {
    const std::vector<Vector3d> p = zeroPositions(clip);
    const auto at = [&](const std::string& joint) { return p[m.at(joint)]; };
    const auto bothSides = [&](const std::string& a, const std::string& b) {
        if (!m.contains("Left" + b) || !m.contains("Right" + b))
            return 0.0;
        return ((at("Left" + b) - at("Left" + a)).norm() + (at("Right" + b) - at("Right" + a)).norm()) / 2;
    };
    const Vector3d up = bodyAxes(p, m).col(1);
    const Vector3d hips = (at("LeftUpLeg") + at("RightUpLeg")) / 2;
    const double shoulder_height = ((at("LeftArm") + at("RightArm")) / 2 - hips).dot(up);

    BodyMeasures measures;
    measures.upper_arm_m = bothSides("Arm", "ForeArm");
    measures.forearm_m = bothSides("ForeArm", "Hand");
    measures.thigh_m = bothSides("UpLeg", "Leg");
    measures.shin_m = bothSides("Leg", "Foot");
    measures.shoulder_width_m = (at("LeftArm") - at("RightArm")).norm();
    measures.hip_width_m = (at("LeftUpLeg") - at("RightUpLeg")).norm();
    if (m.contains("LeftHand") && m.contains("RightHand"))
        measures.hand_m = (reach(clip, p, m.at("LeftHand")) + reach(clip, p, m.at("RightHand"))) / 2;
    if (m.contains("LeftToeBase") && m.contains("LeftFoot")) {
        const Vector3d foot = at("LeftToeBase") - at("LeftFoot");
        measures.foot_m = (foot - up * up.dot(foot)).norm();
    }
    // An adult of 1.75 m: thigh and shin 0.43 each, hip joints to shoulder joints 0.45 (default actor).
    const double shin = measures.shin_m > 0 ? measures.shin_m : measures.thigh_m;
    measures.height_m = 1.75 * (measures.thigh_m + shin + shoulder_height) / (0.43 + 0.43 + 0.45);
    // The default actor's hip joints lie 0.05 below its hips, its shoulders at 0.40 of a trunk of 0.44.
    measures.trunk_m = (shoulder_height - 0.05 * measures.height_m / 1.75) * 0.44 / 0.40;
    return measures;
}

SourceFigure::SourceFigure(const MotionClip& clip, JointMapping mapping, const Skeleton& target)
    : mapping_(std::move(mapping)), target_(target), q_source_target_(target.joints().size()) {
    for (const Joint& joint : target_.joints()) {
        const auto found = mapping_.find(joint.name);
        source_of_.push_back(found == mapping_.end() ? -1 : found->second);
    }
    alignSegments(clip);
    for (const std::string side : {"Left", "Right"}) {
        alignTwist(clip, side + "Arm", side + "ForeArm");
        alignTwist(clip, side + "UpLeg", side + "Leg");
    }
    const BodyMeasures measures = measure(clip, mapping_);
    leg_length_m_ = measures.thigh_m + (measures.shin_m > 0 ? measures.shin_m : measures.thigh_m);
}

Vector3d SourceFigure::targetBone(const std::string& joint, const std::string& child) const {
    const int c = target_.find(child);
    if (c >= 0 && target_.joint(c).parent == target_.find(joint))
        return target_.joint(c).offset_m;
    const int j = target_.find(joint);
    return j >= 0 && target_.joint(j).end_m ? *target_.joint(j).end_m : Vector3d::Zero();
}

void SourceFigure::alignSegments(const MotionClip& clip) {
    const std::vector<Vector3d> p = zeroPositions(clip);
    const Quaterniond q_body(bodyAxes(p, mapping_));
    for (int j = 0; j < target_.size(); ++j) {
        const std::string& name = target_.joint(j).name;
        const std::string child = childOf(name);
        Quaterniond& q = q_source_target_[j] = q_body;
        if (source_of_[j] < 0 || child.empty() || !mapping_.contains(child))
            continue;
        const Vector3d source_bone = p[mapping_.at(child)] - p[source_of_[j]];
        const Vector3d target_bone = targetBone(name, child);
        if (source_bone.norm() > 1e-3 && target_bone.norm() > 1e-3)
            q = smallestRotation(q_body * target_bone, source_bone) * q_body;
    }
    for (const std::string side : {"Left", "Right"}) {  // a hand continues its forearm
        const int hand = target_.find(side + "Hand"), forearm = target_.find(side + "ForeArm");
        if (hand >= 0 && forearm >= 0)
            q_source_target_[hand] = q_source_target_[forearm];
    }
}

void SourceFigure::alignTwist(const MotionClip& clip, const std::string& limb, const std::string& child) {
    const int upper = target_.find(limb), lower = target_.find(child);
    if (upper < 0 || lower < 0 || source_of_[upper] < 0 || source_of_[lower] < 0 ||
        target_.joint(lower).dof.empty() || target_.joint(lower).type == JointType::kBall)
        return;
    const Vector3d bone = target_.joint(lower).offset_m.normalized();
    const Vector3d hinge = target_.joint(lower).dof[0].axis;
    const Vector3d lower_bone = targetBone(child, childOf(child)).normalized();
    Vector3d bend = Vector3d::Zero();  // mean of the lower bone's part across the upper bone
    const size_t stride = std::max<size_t>(1, clip.frames.size() / 2000);
    size_t count = 0;
    for (size_t f = 0; f < clip.frames.size(); f += stride, ++count) {
        const GlobalPose source = globalPose(clip, f);
        const Vector3d in_upper =
            (source.q_world_joint[source_of_[upper]] * q_source_target_[upper]).conjugate() *
            (source.q_world_joint[source_of_[lower]] * q_source_target_[lower] * lower_bone);
        bend += in_upper - bone * bone.dot(in_upper);
    }
    bend /= static_cast<double>(count);
    if (bend.norm() < 0.05)  // the limb stays straight: its twist cannot be seen
        return;
    const Vector3d wanted = hinge.cross(bone);
    const double twist = std::atan2(bone.dot(wanted.cross(bend)), wanted.dot(bend));
    q_source_target_[upper] = q_source_target_[upper] * axisAngle(bone, twist);
    const Quaterniond lower_twist = axisAngle(lower_bone, twist);
    q_source_target_[lower] = q_source_target_[lower] * lower_twist;
    const int hand = target_.find(limb.starts_with("Left") ? "LeftHand" : "RightHand");
    if (limb.ends_with("Arm") && hand >= 0)
        q_source_target_[hand] = q_source_target_[lower];
}

std::optional<Quaterniond> SourceFigure::target(int joint, const GlobalPose& source) const {
    if (source_of_[joint] < 0)
        return std::nullopt;
    return source.q_world_joint[source_of_[joint]] * q_source_target_[joint];
}

Vector3d SourceFigure::hipCentre(const GlobalPose& source) const {
    return (source.p_world_joint[mapping_.at("LeftUpLeg")] +
            source.p_world_joint[mapping_.at("RightUpLeg")]) /
           2;
}

}  // namespace noctule::simulation
