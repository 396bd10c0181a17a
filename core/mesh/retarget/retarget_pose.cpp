// SPDX-License-Identifier: Apache-2.0
// Poses of the target from poses of ours: turned, put on the ground, legs bent and feet laid flat. What is
// known from both rest poses is found in retarget.cpp.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/math/easing.h"
#include "core/math/rotation.h"
#include "core/mesh/retarget/foot_skin.h"
#include "core/mesh/retarget/retarget.h"

namespace noctule {
namespace {

constexpr double kNearFloor_m = 0.03;  ///< heel and toes of ours: below, a foot begins to lie flat
/// Where our lowest sole is higher, nobody stands, and nothing has to give way.
constexpr double kMostFloor_m = 0.1;

/// A turn about a place.
Eigen::Isometry3d about(const Vector3d& p, const Quaterniond& q) {
    return Eigen::Translation3d(p) * q * Eigen::Translation3d(-p);
}

}  // namespace

std::vector<Eigen::Isometry3d> Retargeter::turned(const GlobalPose& source, const Vector3d& p_hips) const {
    std::vector<Eigen::Isometry3d> motions(rest_.size(), Eigen::Isometry3d::Identity());
    const auto hips = static_cast<size_t>(hips_);
    std::vector<bool> below(rest_.size(), false);
    below[hips] = true;
    for (size_t n = hips; n < rest_.size(); ++n) {
        const int parent = parents_[n];
        const bool hangs = parent >= 0 && below[static_cast<size_t>(parent)];
        below[n] = below[n] || hangs;
        const Vector3d p_rest = rest_[n].translation();
        const Vector3d p = hangs ? Vector3d(motions[static_cast<size_t>(parent)] * p_rest) : p_hips;
        if (hangs)
            motions[n] = motions[static_cast<size_t>(parent)];
        if (turned_[n].joint >= 0)
            motions[n].linear() =
                source.q_world_joint[static_cast<size_t>(turned_[n].joint)] * turned_[n].align;
        motions[n].translation() = p - motions[n].linear() * p_rest;
    }
    Eigen::Isometry3d standing(upright_);
    standing.pretranslate(Vector3d(0, -ground_, 0));
    for (size_t n = 0; n < motions.size(); ++n)
        if (!below[n])
            motions[n] = stands_[n] ? standing : motions[hips];
    return motions;
}

LegPlaces Retargeter::placesOf(const Leg& leg, const GlobalPose& source,
                               const std::vector<Eigen::Isometry3d>& motions) const {
    const auto at = [&](int node) -> Vector3d {
        return motions[static_cast<size_t>(node)] * rest_[static_cast<size_t>(node)].translation();
    };
    LegPlaces places{at(leg.thigh), at(leg.shin), at(leg.foot), {}, {}, {}};
    places.knee_axis = source.q_world_joint[static_cast<size_t>(leg.shin_joint)] * Vector3d::UnitX();
    const auto foot = static_cast<size_t>(leg.foot_joint);
    for (size_t i = 0; i < 2; ++i) {
        places.sole[i] = motions[static_cast<size_t>(leg.foot)] * leg.p_rest[i];
        places.sole_ours[i] = source.p_world_joint[foot] + source.q_world_joint[foot] * leg.p_joint_m[i];
    }
    return places;
}

/// The lowest sole as high above the ground as our lowest.
std::vector<Eigen::Isometry3d> Retargeter::onGround(const GlobalPose& source) const {
    std::vector<Eigen::Isometry3d> motions = turned(source, scale_ * source.p_world_joint[0]);
    double ours = 1e9, theirs = 1e9;
    for (const Leg& leg : legs_) {
        const LegPlaces places = placesOf(leg, source, motions);
        for (size_t i = 0; i < 2; ++i) {
            ours = std::min(ours, places.sole_ours[i].y());
            theirs = std::min(theirs, places.sole[i].y());
        }
    }
    for (size_t n = 0; n < motions.size(); ++n)
        if (!stands_[n])
            motions[n].translation().y() += scale_ * ours - theirs;
    return motions;
}

/// Turns the shin about the knee, then the leg about the hip until it points at the ankle's new place; the
/// foot keeps its direction.
void Retargeter::bend(size_t side, const LegPlaces& places, const Vector3d& shift, double knee_rad,
                      std::vector<Eigen::Isometry3d>& motions) const {
    const Eigen::Isometry3d knee = about(places.knee, axisAngle(places.knee_axis, knee_rad));
    const Vector3d bent = knee * places.ankle;
    const Eigen::Isometry3d hip =
        about(places.hip, smallestRotation(bent - places.hip, places.ankle + shift - places.hip));
    const Eigen::Isometry3d foot(Eigen::Translation3d(hip * bent - places.ankle));
    for (size_t n = 0; n < motions.size(); ++n)
        switch (leg_parts_[side][n]) {
            case LegPart::kNone:
                break;
            case LegPart::kThigh:
                motions[n] = hip * motions[n];
                break;
            case LegPart::kShin:
                motions[n] = hip * knee * motions[n];
                break;
            case LegPart::kFoot:
            case LegPart::kToes:
                motions[n] = foot * motions[n];
                break;
        }
}

/// A foot, and then its toes, lie flat as far as ours does on the floor; what would lie below it turns up
/// about ankle and ball, until the part lies flat at most.
void Retargeter::putOnFloor(size_t side, double flat, double floor,
                            std::vector<Eigen::Isometry3d>& motions) const {
    const Leg& leg = legs_[side];
    const auto put = [&](int node, const std::vector<Vector3d>& skin, auto goesAlong) {
        const Eigen::Isometry3d& motion = motions[static_cast<size_t>(node)];
        const Vector3d centre = motion * rest_[static_cast<size_t>(node)].translation();
        const auto turn = [&](const Quaterniond& q) {
            const Eigen::Isometry3d turned = about(centre, q);
            for (size_t n = 0; n < motions.size(); ++n)
                if (goesAlong(leg_parts_[side][n]))
                    motions[n] = turned * motions[n];
        };
        const Vector3d up = motion.linear() * upright_.transpose() * Vector3d::UnitY();
        turn(Quaterniond::Identity().slerp(flat, smallestRotation(up, Vector3d::UnitY())));
        const Vector3d ahead = motion.linear() * (leg.p_rest[1] - leg.p_rest[0]);
        const Vector3d axis = ahead.cross(Vector3d::UnitY());
        if (axis.norm() < 1e-3 * ahead.norm() || skin.empty())
            return;  // it stands on end
        std::vector<Vector3d> points;
        for (const Vector3d& p_rest : skin)
            points.push_back(motion * p_rest);
        const double most_rad = std::atan2(-ahead.y(), axis.norm());
        turn(
            axisAngle(axis.normalized(), turnAboveFloor(points, centre, axis.normalized(), floor, most_rad)));
    };
    const auto isToes = [](LegPart part) { return part == LegPart::kToes; };
    put(leg.foot, leg.foot_skin, [&](LegPart part) { return part == LegPart::kFoot || isToes(part); });
    if (leg.toes >= 0)
        put(leg.toes, leg.toes_skin, isToes);
}

double LegPlaces::kneeTurn(const Vector3d& shift) const {
    if (shift == Vector3d::Zero())
        return 0;
    const Vector3d up = hip - knee, down = ankle - knee, n = knee_axis;
    // up . R(n, turn) down = a cos(turn) + b sin(turn) + c, which the law of cosines wants to be `wanted`
    const double c = up.dot(n) * down.dot(n), a = up.dot(down) - c, b = up.dot(n.cross(down));
    const double wanted = (up.squaredNorm() + down.squaredNorm() - (ankle + shift - hip).squaredNorm()) / 2;
    const double across = std::hypot(a, b);
    if (across < 1e-9)
        return 0;
    const double folded = std::atan2(b, a), reach = std::acos(std::clamp((wanted - c) / across, -1.0, 1.0));
    return (folded < 0 ? -1 : 1) * (std::abs(folded) - reach);
}

std::vector<Eigen::Isometry3d> Retargeter::motions(const Pose& source, const FootCorrections& feet) const {
    const GlobalPose global = globalPose(source_, source);
    std::vector<Eigen::Isometry3d> motions = onGround(global);
    for (size_t side = 0; side < 2; ++side) {
        const FootCorrection& foot = feet[side];
        if (foot.p_root != Vector3d::Zero() || foot.knee_rad != 0)
            bend(side, placesOf(legs_[side], global, motions), global.q_world_joint[0] * foot.p_root,
                 foot.knee_rad, motions);
    }
    std::array<double, 2> lowest_m{}, highest_m{};
    for (size_t side = 0; side < 2; ++side) {
        const auto sole_m = placesOf(legs_[side], global, motions).sole_ours;
        std::tie(lowest_m[side], highest_m[side]) = std::minmax(sole_m[0].y(), sole_m[1].y());
    }
    const double floor_m = std::min(lowest_m[0], lowest_m[1]);
    for (size_t side = 0; side < 2; ++side)
        putOnFloor(side, eased(1 - (highest_m[side] - floor_m) / kNearFloor_m),
                   scale_ * std::min(floor_m, kMostFloor_m), motions);
    return motions;
}

std::array<LegPlaces, 2> Retargeter::legs(const Pose& source, const FootCorrections& feet) const {
    const GlobalPose global = globalPose(source_, source);
    const std::vector<Eigen::Isometry3d> moved = motions(source, feet);
    return {placesOf(legs_[0], global, moved), placesOf(legs_[1], global, moved)};
}

RigPose Retargeter::pose(const Pose& source, const FootCorrections& feet) const {
    const std::vector<Eigen::Isometry3d> moved = motions(source, feet);
    RigPose pose = rest_;
    for (size_t n = 0; n < pose.size(); ++n)
        pose[n] = moved[n] * rest_[n];
    return pose;
}

}  // namespace noctule
