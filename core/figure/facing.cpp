// SPDX-License-Identifier: Apache-2.0
#include "core/figure/facing.h"

#include <cmath>

#include "core/body/joint_names.h"

namespace noctule::figure {
namespace {

constexpr const char* kSidesOfBody[] = {"Left", "Right"};

Vector3d placeOf(const GlobalPose& pose, const JointMapping& mapping, const std::string& joint) {
    return pose.p_world_joint[static_cast<size_t>(mapping.at(joint))];
}

Vector3d middleOf(const GlobalPose& pose, const JointMapping& mapping, const std::string& joint) {
    return (placeOf(pose, mapping, "Left" + joint) + placeOf(pose, mapping, "Right" + joint)) / 2;
}

/// To the left as the names have it; across the trunk.
Vector3d namedLeft(const GlobalPose& pose, const JointMapping& mapping, const std::string& joint) {
    const Vector3d up = trunkOf(pose, mapping).normalized();
    const Vector3d left = placeOf(pose, mapping, "Left" + joint) - placeOf(pose, mapping, "Right" + joint);
    return (left - up * up.dot(left)).normalized();
}

Vector3d namedForward(const GlobalPose& pose, const JointMapping& mapping, const std::string& joint) {
    return namedLeft(pose, mapping, joint).cross(trunkOf(pose, mapping).normalized());
}

/// Unit vector from ankle to toe or tip of the foot; zero without.
Vector3d footOf(const MotionClip& clip, const GlobalPose& pose, const JointMapping& mapping,
                const std::string& side) {
    if (!mapping.contains(side + "Foot"))
        return Vector3d::Zero();
    const size_t foot = static_cast<size_t>(mapping.at(side + "Foot"));
    Vector3d bone = Vector3d::Zero();
    if (mapping.contains(side + "ToeBase"))
        bone = placeOf(pose, mapping, side + "ToeBase") - pose.p_world_joint[foot];
    else if (const auto& end = clip.skeleton.joint(static_cast<int>(foot)).end_m)
        bone = pose.q_world_joint[foot] * *end;
    return bone.norm() > 1e-9 ? bone.normalized() : Vector3d::Zero();
}

/// How far the middle of a limb stands out of the line between its ends, by the limb's length.
Vector3d bendOf(const GlobalPose& pose, const JointMapping& mapping, const std::string& first,
                const std::string& middle, const std::string& last) {
    if (!mapping.contains(last))
        return Vector3d::Zero();
    const Vector3d a = placeOf(pose, mapping, first), b = placeOf(pose, mapping, middle),
                   c = placeOf(pose, mapping, last);
    const double length = (b - a).norm() + (c - b).norm();
    return length > 0 ? Vector3d((b - (a + c) / 2) / length) : Vector3d::Zero();
}

/// Positive: toes and knees are where the names say the front is.
double frontOfLegs(const MotionClip& clip, const SeenMotion& seen, const JointMapping& mapping) {
    constexpr double kKnees = 3;  // a knee bent by 45 degrees counts as much as a foot
    return seen.meanOf([&](const GlobalPose& pose) {
        const Vector3d forward = namedForward(pose, mapping, "UpLeg");
        double sum = 0;
        for (const std::string side : kSidesOfBody) {
            sum += footOf(clip, pose, mapping, side).dot(forward) / 2;
            sum += kKnees * bendOf(pose, mapping, side + "UpLeg", side + "Leg", side + "Foot").dot(forward);
        }
        return sum;
    });
}

/// Positive: elbows stand out to the back.
double frontOfArms(const SeenMotion& seen, const JointMapping& mapping) {
    constexpr double kElbows = 3;
    return seen.meanOf([&](const GlobalPose& pose) {
        const Vector3d forward = namedForward(pose, mapping, "Arm");
        double sum = 0;
        for (const std::string side : kSidesOfBody)
            sum -=
                kElbows * bendOf(pose, mapping, side + "Arm", side + "ForeArm", side + "Hand").dot(forward);
        return sum;
    });
}

}  // namespace

Vector3d trunkOf(const GlobalPose& pose, const JointMapping& mapping) {
    return middleOf(pose, mapping, "Arm") - middleOf(pose, mapping, "UpLeg");
}

Vector3d legsOf(const GlobalPose& pose, const JointMapping& mapping) {
    const bool ankles = mapping.contains("LeftFoot") && mapping.contains("RightFoot");
    return middleOf(pose, mapping, "UpLeg") - middleOf(pose, mapping, ankles ? "Foot" : "Leg");
}

Sides judgeSides(const MotionClip& clip, const SeenMotion& seen, const JointMapping& mapping) {
    constexpr double kSure = 0.25, kCrossed = -0.3;
    const double legs = frontOfLegs(clip, seen, mapping), arms = frontOfArms(seen, mapping);
    const double together = seen.meanOf([&](const GlobalPose& pose) {
        return namedLeft(pose, mapping, "UpLeg").dot(namedLeft(pose, mapping, "Arm"));
    });
    const bool crossed = together < kCrossed;
    Sides sides;
    if (std::abs(legs) > kSure) {
        sides.legs_exchanged = legs < 0;
        sides.arms_exchanged = sides.legs_exchanged != crossed;
    } else if (std::abs(arms) > kSure) {
        sides.arms_exchanged = arms < 0;
        sides.legs_exchanged = sides.arms_exchanged != crossed;
    } else {
        sides.unknown = true;
        sides.arms_exchanged = crossed;
    }
    return sides;
}

bool isOfLimbs(const std::string& joint, const std::string& limbs) {
    if (mirroredSegment(joint) == joint)
        return false;
    const bool leg = joint.ends_with("Leg") || joint.ends_with("Foot") || joint.ends_with("ToeBase");
    return leg == (limbs == "legs");
}

JointMapping exchanged(const JointMapping& mapping, const Sides& sides) {
    JointMapping turned;
    for (const auto& [name, joint] : mapping) {
        const bool turns = (sides.legs_exchanged && isOfLimbs(name, "legs")) ||
                           (sides.arms_exchanged && isOfLimbs(name, "arms"));
        turned[turns ? mirroredSegment(name) : name] = joint;
    }
    return turned;
}

}  // namespace noctule::figure
