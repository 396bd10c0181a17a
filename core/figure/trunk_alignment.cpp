// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/figure/aligner.h"
#include "core/figure/facing.h"
#include "core/math/order_statistics.h"
#include "core/math/rotation.h"

namespace noctule::figure {
namespace {

constexpr double kSnap_rad = radians(8), kSnapSide_rad = radians(8);

}  // namespace

Vector3d snapped(const Vector3d& direction, double within_rad) {
    const Vector3d unit = direction.normalized();
    Eigen::Index largest = 0;
    unit.cwiseAbs().maxCoeff(&largest);
    const Vector3d axis = Vector3d::Unit(largest) * (unit[largest] > 0 ? 1 : -1);
    return angleOf(unit, axis) < within_rad ? axis : unit;
}

double angleOf(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

Aligner::Aligner(const MotionClip& clip, const SeenMotion& seen, const JointMapping& mapping,
                 const Skeleton& target)
    : clip_(clip), seen_(seen), mapping_(mapping), target_(target), zero_(zeroPositions(clip)) {
    const Vector3d across = zero("LeftUpLeg") - zero("RightUpLeg");
    const Vector3d rise = trunkOf({zero_, {}}, mapping);
    const Vector3d left = across.normalized();
    const Vector3d up = (rise - left * left.dot(rise)).normalized();
    Matrix3d axes;
    axes << left, up, left.cross(up);
    q_zero_body_ = axes.determinant() > 0.5 ? Quaterniond(axes) : Quaterniond::Identity();
}

Alignment Aligner::align() {
    trunk_stands_ = trunkStands();
    if (trunk_stands_)
        alignStandingTrunk();
    else
        alignTrunkByBones();
    for (const std::string side : {"Left", "Right"}) {
        alignLimb(side, "Arm", "ForeArm", "Hand", chest());
        alignLimb(side, "UpLeg", "Leg", "Foot", "Hips");
        alignHand(side);
        alignFoot(side);
    }
    return {q_, trunk_stands_};
}

Vector3d Aligner::meanIn(const std::string& joint,
                         const std::function<Vector3d(const GlobalPose&)>& direction) const {
    const size_t j = static_cast<size_t>(at(joint));
    return seen_.mean([&](const GlobalPose& pose) {
        return Vector3d(pose.q_world_joint[j].conjugate() * direction(pose));
    });
}

/// The trunk's bone next to the hips, or the one above the chest.
std::pair<int, int> Aligner::trunkBone(bool upper) const {
    const double least =
        0.04 * seen_.meanOf([&](const GlobalPose& p) { return trunkOf(p, mapping_).norm(); });
    const int from = at(upper ? chest() : "Hips");
    std::vector<int> chain;
    if (!upper)
        chain = chainBetween(clip_.skeleton, from, at(chest()));
    else
        for (const char* joint : {"Neck", "Head"})
            if (has(joint))
                chain.push_back(at(joint));
    for (const int to : chain)
        if (seen_.distance(from, to) > least)
            return {from, to};
    return {-1, -1};
}

/// How much less straight the trunk is in the zero pose than in the motion, radians.
double Aligner::zeroBend() const {
    const auto [hips, spine] = trunkBone(false);
    const auto [chest, neck] = trunkBone(true);
    if (spine < 0 || neck < 0)
        return 0;
    const auto bend = [&, hips = hips, spine = spine, chest = chest, neck = neck](const auto& p) {
        return angleOf(p[static_cast<size_t>(spine)] - p[static_cast<size_t>(hips)],
                       p[static_cast<size_t>(neck)] - p[static_cast<size_t>(chest)]);
    };
    constexpr double kStraight = radians(12), kTooBent = radians(45);
    const double zero = bend(zero_);
    if (zero < kStraight)
        return 0;
    if (zero > kTooBent)
        return zero;
    std::vector<double> moving;
    for (const GlobalPose& pose : seen_.poses())
        moving.push_back(bend(pose.p_world_joint));
    return zero - middleValue(moving);
}

bool Aligner::trunkStands() const {
    constexpr double kSameWidth = 0.35, kParallel = radians(12), kAcross = radians(15), kBent = radians(8);
    for (const char* joint : {"Arm", "UpLeg"}) {
        const std::string left = std::string("Left") + joint, right = std::string("Right") + joint;
        const double width = seen_.distance(at(left), at(right));
        if (!(std::abs((zero(left) - zero(right)).norm() - width) < kSameWidth * width))
            return false;
    }
    const Vector3d hips = zero("LeftUpLeg") - zero("RightUpLeg"), arms = zero("LeftArm") - zero("RightArm");
    const Vector3d rise = trunkOf({zero_, {}}, mapping_);
    if (rise.norm() < hips.norm() / 2 || angleOf(hips, arms) > kParallel ||
        std::abs(angleOf(hips, rise) - std::numbers::pi / 2) > kAcross)
        return false;
    return zeroIsSymmetric() && zeroBend() < kBent;
}

/// Poses that programs mean as zero poses have both sides alike; a frame of a motion has not.
bool Aligner::zeroIsSymmetric() const {
    constexpr double kAlike = radians(15);
    for (const auto& [from, to] : {std::pair{"Arm", "ForeArm"}, std::pair{"UpLeg", "Leg"}}) {
        const auto inBody = [&, from = from, to = to](const std::string& side) {
            return Vector3d(q_zero_body_.conjugate() * (zero(side + to) - zero(side + from)));
        };
        const Vector3d right = inBody("Right");
        if (angleOf(inBody("Left"), Vector3d(-right.x(), right.y(), right.z())) > kAlike)
            return false;
    }
    return true;
}

void Aligner::alignStandingTrunk() {
    for (const char* joint : {"Hips", "Spine", "Chest", "Neck", "Head", "LeftShoulder", "RightShoulder"})
        if (has(joint))
            q_[joint] = q_zero_body_;
}

void Aligner::setAxes(const std::string& joint, const Vector3d& left, const Vector3d& up) {
    Matrix3d axes;
    axes.col(1) = up.normalized();
    axes.col(0) = (left - axes.col(1) * axes.col(1).dot(left)).normalized();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    q_[joint] = axes.allFinite() ? Quaterniond(axes) : Quaterniond::Identity();
}

void Aligner::alignTrunkByBones() {
    const auto across = [&](const std::string& joint) {
        return [this, joint](const GlobalPose& pose) {
            return Vector3d((place(pose, "Left" + joint) - place(pose, "Right" + joint)).normalized());
        };
    };
    const auto rise = [&](const GlobalPose& pose) { return Vector3d(trunkOf(pose, mapping_).normalized()); };
    const auto upOf = [&](const std::string& joint, std::pair<int, int> bone) {
        return bone.second < 0 ? meanIn(joint, rise) : seen_.between(at(joint), bone.first, bone.second);
    };
    setAxes("Hips", meanIn("Hips", across("UpLeg")), upOf("Hips", trunkBone(false)));
    const bool collars = has("LeftShoulder") && has("RightShoulder") &&
                         seen_.distance(at("LeftShoulder"), at("RightShoulder")) >
                             0.1 * seen_.distance(at("LeftArm"), at("RightArm"));
    if (has("Chest"))
        setAxes("Chest", meanIn("Chest", across(collars ? "Shoulder" : "Arm")),
                upOf("Chest", trunkBone(true)));
    if (has("Spine")) {
        const std::vector<int> above = chainBetween(clip_.skeleton, at("Spine"), at(chest()));
        const Vector3d left = meanIn("Spine", [&](const GlobalPose& pose) {
            return Vector3d(canonical(pose, "Hips") * Vector3d::UnitX() +
                            canonical(pose, chest()) * Vector3d::UnitX());
        });
        setAxes("Spine", left, upOf("Spine", {at("Spine"), above.empty() ? -1 : above.front()}));
    }
    alignHead();
    for (const std::string side : {"Left", "Right"})
        if (has(side + "Shoulder"))
            alignShoulder(side);
}

/// Up is where the tip is; without a tip the head continues the neck: along the same axis of its frame.
void Aligner::alignHead() {
    const auto chestAxis = [&](const Vector3d& axis) {
        return [this, axis](const GlobalPose& pose) { return Vector3d(canonical(pose, chest()) * axis); };
    };
    for (const std::string joint : {"Neck", "Head"}) {
        if (!has(joint))
            continue;
        const Vector3d usual = meanIn(joint, chestAxis(Vector3d::UnitY()));
        const auto& end = clip_.skeleton.joint(at(joint)).end_m;
        Vector3d up = usual;
        bool has_tip = false;
        if (joint == "Neck" && has("Head"))
            up = bone("Neck", "Head");
        else if (has_tip = end && end->norm() > 1e-3; has_tip)
            up = *end;
        else if (has("Neck") && has("Head"))
            up = bone("Neck", "Head");
        constexpr double kFar = radians(50);
        if (up.norm() < 1e-3 || angleOf(up, usual) > kFar)
            up = usual;
        setAxes(joint, snapped(meanIn(joint, chestAxis(Vector3d::UnitX())), kSnapSide_rad),
                has_tip ? up : snapped(up, kSnap_rad));
    }
}

/// Outwards along the collar bone, up as the chest is on the mean.
void Aligner::alignShoulder(const std::string& side) {
    const double sign = side == "Left" ? 1 : -1;
    const std::string joint = side + "Shoulder";
    const auto chestAxis = [&](const Vector3d& axis) {
        return meanIn(
            joint, [&, axis](const GlobalPose& pose) { return Vector3d(canonical(pose, chest()) * axis); });
    };
    const Vector3d collar = bone(joint, side + "Arm");
    const Vector3d left =
        collar.norm() > 1e-3 ? Vector3d(sign * snapped(collar, kSnap_rad)) : chestAxis(Vector3d::UnitX());
    Vector3d up = snapped(chestAxis(Vector3d::UnitY()), kSnap_rad);
    up -= left.normalized() * left.normalized().dot(up);
    setAxes(joint, left, up);
}

Alignment alignFigure(const MotionClip& clip, const SeenMotion& seen, const JointMapping& mapping,
                      const Skeleton& target) {
    return Aligner(clip, seen, mapping, target).align();
}

Vector3d boneOf(const Skeleton& skeleton, const std::string& joint, const std::string& child) {
    const int j = skeleton.find(joint), c = skeleton.find(child);
    if (c >= 0 && skeleton.joint(c).parent == j)
        return skeleton.joint(c).offset_m;
    return j >= 0 && skeleton.joint(j).end_m ? *skeleton.joint(j).end_m : Vector3d::Zero();
}

}  // namespace noctule::figure
