// SPDX-License-Identifier: Apache-2.0
#include "core/motion/segment_match.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/rotation.h"
#include "core/math/rotation_fit.h"

namespace noctule {
namespace {

constexpr double kSame_rad = 0.0175;    ///< 1 degree
constexpr double kMirrored_rad = 0.44;  ///< 25 degrees between one limb and the other's mirror image
constexpr double kShortestBone_m = 0.01;

/// Where all joints are with all rotations at identity; frames are parallel then.
std::vector<Vector3d> zeroPositionsOf(const Skeleton& skeleton) {
    return globalPose(skeleton, skeleton.zeroPose()).p_world_joint;
}

/// The common joints of two skeletons by name, with their bones.
class CommonFigure {
public:
    CommonFigure(const Skeleton& first, const Skeleton& second, const std::vector<CommonJoint>& common)
        : common_(common), p_first_(zeroPositionsOf(first)), p_second_(zeroPositionsOf(second)) {}

    int find(const std::string& name) const {
        for (size_t i = 0; i < common_.size(); ++i)
            if (common_[i].name == name)
                return static_cast<int>(i);
        return -1;
    }
    Vector3d first(const std::string& from, const std::string& to) const {
        return between(p_first_, &CommonJoint::first, from, to);
    }
    Vector3d second(const std::string& from, const std::string& to) const {
        return between(p_second_, &CommonJoint::second, from, to);
    }
    bool hasAll(const std::vector<std::string>& names) const {
        return std::ranges::all_of(names, [this](const std::string& name) { return find(name) >= 0; });
    }

    /// The joint at the other end of a limb's bone. Bones of shoulders and trunk begin and end where each
    /// system likes, so their directions say nothing.
    std::string childOf(const std::string& name) const {
        for (const auto& [joint, child] :
             {std::pair{"Arm", "ForeArm"}, std::pair{"ForeArm", "Hand"}, std::pair{"UpLeg", "Leg"},
              std::pair{"Leg", "Foot"}, std::pair{"Foot", "ToeBase"}})
            for (const std::string side : {"Left", "Right"})
                if (name == side + joint && find(side + child) >= 0 &&
                    first(name, side + child).norm() > kShortestBone_m &&
                    second(name, side + child).norm() > kShortestBone_m)
                    return side + child;
        return "";
    }

private:
    Vector3d between(const std::vector<Vector3d>& p, int CommonJoint::*side, const std::string& from,
                     const std::string& to) const {
        const auto at = [&](const std::string& name) {
            return p[static_cast<size_t>(common_[static_cast<size_t>(find(name))].*side)];
        };
        return at(to) - at(from);
    }

    const std::vector<CommonJoint>& common_;
    std::vector<Vector3d> p_first_, p_second_;
};

double angleOf(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Columns left, up, forward of a zero pose; nothing when it shows no trunk.
std::optional<Matrix3d> axesOf(const Vector3d& left, const Vector3d& rise) {
    if (left.norm() < kShortestBone_m || rise.norm() < 5 * kShortestBone_m ||
        std::abs(left.normalized().dot(rise.normalized())) > 0.3)
        return std::nullopt;
    Matrix3d axes;
    axes.col(0) = left.normalized();
    axes.col(1) = (rise - axes.col(0) * axes.col(0).dot(rise)).normalized();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    return axes;
}

/// From the middle of the thighs to the middle of the upper arms.
template <class Between>
std::optional<Matrix3d> bodyAxesOf(const Between& between) {
    const Vector3d rise = (between("LeftUpLeg", "LeftArm") + between("RightUpLeg", "RightArm")) / 2;
    const Vector3d shoulders = between("RightArm", "LeftArm"), hips = between("RightUpLeg", "LeftUpLeg");
    return angleOf(shoulders, hips) > 0.5 ? std::nullopt : axesOf(hips, rise);
}

bool limbsMirror(const CommonFigure& figure, const Matrix3d& axes) {
    for (const std::string joint : {"Arm", "ForeArm", "UpLeg", "Leg"}) {
        const std::string left = figure.childOf("Left" + joint), right = figure.childOf("Right" + joint);
        if (left.empty() || right.empty())
            continue;
        const Vector3d l = axes.transpose() * figure.second("Left" + joint, left).normalized();
        const Vector3d r = axes.transpose() * figure.second("Right" + joint, right).normalized();
        if (angleOf(l, {-r.x(), r.y(), r.z()}) > kMirrored_rad)
            return false;
        if (joint.ends_with("Leg") && l.y() > 0.5)
            return false;
    }
    return true;
}

/// The rotation that takes `axis_first` exactly to `axis_second` and fits `sum` best otherwise.
Quaterniond nearestAbout(const Vector3d& axis_first, const Vector3d& axis_second, const Matrix3d& sum) {
    const Quaterniond straight = smallestRotation(axis_first, axis_second);
    const Vector3d axis = axis_second.normalized();
    const auto fit = [&](double angle_rad) {
        return ((axisAngle(axis, angle_rad) * straight).toRotationMatrix().transpose() * sum).trace();
    };
    const double constant = (fit(0) + fit(std::numbers::pi)) / 2;
    return axisAngle(axis, std::atan2(fit(std::numbers::pi / 2) - constant, fit(0) - constant)) * straight;
}

class MotionFit {
public:
    MotionFit(const CommonFigure& figure, const std::vector<CommonJoint>& common, const PosePairs& pairs)
        : figure_(figure), common_(common), pairs_(pairs) {}

    /// Yaw and its drift have no effect: only the vertical is compared.
    Quaterniond root(const SegmentMatch* known, double& taken_off_rad) const {
        Matrix3d up = Matrix3d::Zero();
        for (const auto& [first, second] : pairs_)
            up += (q_second(second, 0).conjugate() * Vector3d::UnitY()) *
                  (q_first(first, 0).conjugate() * Vector3d::UnitY()).transpose();
        const bool has_hips = figure_.hasAll({"LeftUpLeg", "RightUpLeg"});
        const Vector3d left_first = has_hips ? figure_.first("RightUpLeg", "LeftUpLeg") : Vector3d::Zero();
        const Vector3d left_second = has_hips ? figure_.second("RightUpLeg", "LeftUpLeg") : Vector3d::Zero();
        if (left_first.norm() < kShortestBone_m || left_second.norm() < kShortestBone_m)
            return known ? known->q_second_first : Quaterniond::Identity();
        const Quaterniond found = nearestAbout(left_first, left_second, up);
        taken_off_rad = known ? angleBetween(known->q_second_first, found) : 0;
        return known && taken_off_rad < kBelievable_rad ? known->q_second_first : found;
    }

    Quaterniond segment(size_t i, const Quaterniond& q_second_root, const SegmentMatch* known,
                        double& taken_off_rad) const {
        Matrix3d sum = Matrix3d::Zero();
        for (const auto& [first, second] : pairs_) {
            const Quaterniond in_first = q_first(first, 0).conjugate() * q_first(first, i);
            const Quaterniond in_second =
                (q_second(second, 0) * q_second_root).conjugate() * q_second(second, i);
            sum += (in_second.conjugate() * in_first).toRotationMatrix();
        }
        const Quaterniond free(nearestRotation(sum));
        taken_off_rad = known ? angleBetween(known->q_second_first, free) : 0;
        if (known && taken_off_rad < kBelievable_rad)
            return known->q_second_first;
        const std::string child = figure_.childOf(common_[i].name);
        return child.empty() ? free
                             : nearestAbout(figure_.first(common_[i].name, child),
                                            figure_.second(common_[i].name, child), sum);
    }

private:
    const Quaterniond& q_first(const GlobalPose& pose, size_t i) const {
        return pose.q_world_joint[static_cast<size_t>(common_[i].first)];
    }
    const Quaterniond& q_second(const GlobalPose& pose, size_t i) const {
        return pose.q_world_joint[static_cast<size_t>(common_[i].second)];
    }

    const CommonFigure& figure_;
    const std::vector<CommonJoint>& common_;
    const PosePairs& pairs_;
};

}  // namespace

std::optional<std::vector<SegmentMatch>> matchZeroPoses(const Skeleton& first, const Skeleton& second,
                                                        const std::vector<CommonJoint>& common) {
    const CommonFigure figure(first, second, common);
    if (!figure.hasAll({"LeftUpLeg", "RightUpLeg", "LeftArm", "RightArm"}))
        return std::vector<SegmentMatch>(common.size());
    const auto first_axes = bodyAxesOf([&](auto a, auto b) { return figure.first(a, b); });
    if (!first_axes)
        return std::vector<SegmentMatch>(common.size());
    const auto second_axes = bodyAxesOf([&](auto a, auto b) { return figure.second(a, b); });
    if (!second_axes || !limbsMirror(figure, *second_axes))
        return std::nullopt;
    Quaterniond q_body(Matrix3d(*second_axes * first_axes->transpose()));
    if (angleBetween(q_body, Quaterniond::Identity()) < kSame_rad)
        q_body = Quaterniond::Identity();
    std::vector<SegmentMatch> matches;
    for (const CommonJoint& joint : common) {
        const std::string child = figure.childOf(joint.name);
        const bool hand = joint.name.ends_with("Hand") && joint.ancestor > 0;  // continues its forearm
        Quaterniond q = joint.ancestor > 0 && (hand || !child.empty())
                            ? matches[static_cast<size_t>(joint.ancestor)].q_second_first
                            : q_body;
        if (!child.empty()) {
            const Vector3d bone = figure.second(joint.name, child);
            const Quaterniond turn = smallestRotation(q * figure.first(joint.name, child), bone);
            q = angleBetween(turn, Quaterniond::Identity()) < kSame_rad ? q : turn * q;
        }
        const bool same = angleBetween(q, Quaterniond::Identity()) == 0;
        matches.push_back({q.normalized(), same ? FrameFrom::kSame : FrameFrom::kZeroPose, 0});
    }
    return matches;
}

bool isSameFigure(const std::vector<SegmentMatch>& matches) {
    return std::ranges::all_of(matches,
                               [](const SegmentMatch& match) { return match.from == FrameFrom::kSame; });
}

std::vector<SegmentMatch> matchMotions(const Skeleton& first, const Skeleton& second,
                                       const std::vector<CommonJoint>& common, const PosePairs& pairs,
                                       std::optional<std::vector<SegmentMatch>> known) {
    const CommonFigure figure(first, second, common);
    const MotionFit fit(figure, common, pairs);
    std::vector<SegmentMatch> matches(common.size());
    for (size_t i = 0; i < common.size() && !pairs.empty(); ++i) {
        const SegmentMatch* told = known ? &(*known)[i] : nullptr;
        double taken_off_rad = 0;
        const Quaterniond q = i == 0 ? fit.root(told, taken_off_rad)
                                     : fit.segment(i, matches[0].q_second_first, told, taken_off_rad);
        matches[i] = told && q.coeffs() == told->q_second_first.coeffs()
                         ? *told
                         : SegmentMatch{q.normalized(), FrameFrom::kMotion, taken_off_rad};
    }
    return matches;
}

}  // namespace noctule
