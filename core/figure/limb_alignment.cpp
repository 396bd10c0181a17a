// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/figure/aligner.h"
#include "core/math/rotation.h"

namespace noctule::figure {
namespace {

/// Mean of angles that weigh by how well they are seen.
class MeanAngle {
public:
    void add(double angle_rad, double weight) {
        cosine_ += weight * std::cos(angle_rad);
        sine_ += weight * std::sin(angle_rad);
        weight_ += weight;
    }
    double weight() const { return weight_; }
    double mean_rad() const { return std::atan2(sine_, cosine_); }

private:
    double cosine_ = 0, sine_ = 0, weight_ = 0;
};

/// Angle about a unit axis that takes `from` nearest to `to`.
double turnAbout(const Vector3d& axis, const Vector3d& from, const Vector3d& to) {
    const Vector3d a = from - axis * axis.dot(from), b = to - axis * axis.dot(to);
    return std::atan2(axis.dot(a.cross(b)), a.dot(b));
}

}  // namespace

/// Upper bone along its direction, twisted as the bend of elbow or knee shows; the lower one keeps the zero
/// pose's relation to it unless the bend shows otherwise.
void Aligner::alignLimb(const std::string& side, const std::string& upper_name, const std::string& lower_name,
                        const std::string& end_name, const std::string& parent) {
    const std::string upper = side + upper_name, lower = side + lower_name, end = side + end_name;
    const Vector3d upper_bone = bone(upper, lower), wanted = boneOf(target_, upper, lower);
    if (upper_bone.norm() < 1e-6 || wanted.norm() < 1e-6) {
        q_[upper] = q_[lower] = q_.at(parent);
        return;
    }
    q_[upper] = untwisted(upper, upper_bone, wanted, parent);
    q_[lower] = q_[upper];
    const Vector3d lower_wanted = boneOf(target_, lower, end).normalized();
    Vector3d lower_bone = Vector3d::Zero();
    if (has(end))
        lower_bone = bone(lower, end);
    else if (const auto& tip = clip_.skeleton.joint(at(lower)).end_m)
        lower_bone = *tip;
    if (lower_bone.norm() < 1e-6)
        return;
    if (has(end))
        q_[upper] = q_[upper] * axisAngle(wanted.normalized(), bendTwist(upper, lower, end));
    const Vector3d straight = q_[upper] * lower_wanted;
    q_[lower] = smallestRotation(straight, lower_bone) * q_[upper];
    if (!has(end))
        return;
    constexpr double kPronation = radians(110), kShin = radians(25), kFolded = radians(150);
    const double twist = hingeTwist(upper, lower, end);
    const bool folded = angleOf(straight, lower_bone) > kFolded;
    if (std::abs(twist) > (folded ? radians(5) : upper_name == "Arm" ? kPronation : kShin))
        q_[lower] = q_[lower] * axisAngle(lower_wanted, twist);
}

/// The bone along its target by the smallest turn from the trunk: in the zero pose where that can be
/// believed, else on the mean over the motion.
Quaterniond Aligner::untwisted(const std::string& upper, const Vector3d& upper_bone, const Vector3d& wanted,
                               const std::string& parent) const {
    constexpr double kNear = radians(100);
    if (trunk_stands_ && angleOf(q_zero_body_ * wanted, upper_bone) < kNear)
        return smallestRotation(q_zero_body_ * wanted, upper_bone) * q_zero_body_;
    const Quaterniond some = smallestRotation(wanted, upper_bone);
    const Vector3d axis = wanted.normalized();
    const Vector3d across = axis.unitOrthogonal();
    MeanAngle twist;
    for (const GlobalPose& pose : seen_.poses()) {
        const Quaterniond q_upper = pose.q_world_joint[static_cast<size_t>(at(upper))];
        const Quaterniond q_parent = canonical(pose, parent);
        const Vector3d along = q_upper * upper_bone, rest = q_parent * wanted;
        const Quaterniond hanging = smallestRotation(rest, along) * q_parent;
        twist.add(turnAbout(axis, across, (q_upper * some).conjugate() * (hanging * across)),
                  1.05 + std::cos(angleOf(rest, along)));
    }
    return some * axisAngle(axis, twist.mean_rad());
}

/// How far the upper segment has to turn about its bone so that the lower one bends where the hinge bends it;
/// 0 where the limb stays straight, since its twist cannot be seen then.
double Aligner::bendTwist(const std::string& upper, const std::string& lower, const std::string& end) const {
    const int u = target_.find(upper), l = target_.find(lower);
    if (u < 0 || l < 0 || target_.joint(l).dof.empty())
        return 0;
    const Vector3d along = target_.joint(l).offset_m.normalized();
    Vector3d hinge = target_.joint(l).dof[0].axis;
    if (target_.joint(l).type == JointType::kBall)
        return 0;
    const Vector3d bend = seen_.mean([&](const GlobalPose& pose) {
        const Vector3d in_upper =
            canonical(pose, upper).conjugate() * (place(pose, end) - place(pose, lower)).normalized();
        return Vector3d(in_upper - along * along.dot(in_upper));
    });
    constexpr double kVisible = 0.05;
    return bend.norm() < kVisible ? 0 : turnAbout(along, hinge.cross(along), bend);
}

/// How far the lower segment's hinge is from the upper one's, about the lower bone; 0 where it is not seen.
double Aligner::hingeTwist(const std::string& upper, const std::string& lower, const std::string& end) const {
    const int l = target_.find(lower);
    if (l < 0 || target_.joint(l).dof.empty() || target_.joint(l).type == JointType::kBall)
        return 0;
    const Vector3d along = boneOf(target_, lower, end).normalized();
    const Vector3d hinge = target_.joint(l).dof[0].axis;
    MeanAngle twist;
    for (const GlobalPose& pose : seen_.poses()) {
        const Vector3d upper_bone = place(pose, lower) - place(pose, upper);
        const Vector3d lower_bone = place(pose, end) - place(pose, lower);
        const double bend = std::sin(std::min(angleOf(upper_bone, lower_bone), std::numbers::pi / 2));
        const Vector3d seen = canonical(pose, lower).conjugate() * (canonical(pose, upper) * hinge);
        twist.add(turnAbout(along, hinge, seen), bend);
    }
    constexpr double kVisible = 0.1;
    const double count = static_cast<double>(seen_.poses().size());
    return twist.weight() < kVisible * count ? 0 : twist.mean_rad();
}

/// A hand continues its forearm, unless its own bone or its frame on the mean says otherwise.
void Aligner::alignHand(const std::string& side) {
    const std::string hand = side + "Hand", forearm = side + "ForeArm";
    if (!has(hand))
        return;
    const Vector3d wanted = side == "Left" ? Vector3d::UnitX() : Vector3d(-Vector3d::UnitX());
    q_[hand] = q_.at(forearm);
    const auto& tip = clip_.skeleton.joint(at(hand)).end_m;
    constexpr double kBent = radians(30), kUnlikely = radians(45);
    if (tip && tip->norm() > 1e-3 && angleOf(q_[hand] * wanted, *tip) > kBent)
        q_[hand] = smallestRotation(q_[hand] * wanted, *tip) * q_[hand];
    const Vector3d usual =
        meanIn(hand, [&](const GlobalPose& pose) { return Vector3d(canonical(pose, forearm) * wanted); });
    if (usual.norm() > 0.5 && angleOf(q_[hand] * wanted, usual) > kUnlikely)
        q_[hand] = smallestRotation(q_[hand] * wanted, usual) * q_[hand];
    constexpr double kTwisted = radians(25);  // a wrist does not twist; on the mean it is little
    MeanAngle twist;
    for (const GlobalPose& pose : seen_.poses())
        twist.add(
            turnAbout(wanted, Vector3d::UnitY(),
                      canonical(pose, hand).conjugate() * (canonical(pose, forearm) * Vector3d::UnitY())),
            1);
    if (std::abs(twist.mean_rad()) > kTwisted)
        q_[hand] = q_[hand] * axisAngle(wanted, twist.mean_rad());
}

}  // namespace noctule::figure
