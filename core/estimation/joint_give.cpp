// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/joint_give.h"

#include <algorithm>
#include <cmath>

namespace noctule {
namespace {

/// A joint that comes out of an outage far off does not give because of that: larger deviations, as multiples
/// of the usual ones, teach no more.
constexpr double kOutlier = 2;
constexpr double kLeastUsual_rad2 = 1e-5;
/// The variance learnt is that of what comes and goes; deviations that stay are believed as large.
constexpr double kWithConstant = 2;
bool lacksFreedoms(const Joint& joint) {
    return joint.type == JointType::kUniversal || joint.type == JointType::kHinge;
}

double square(double x) {
    return x * x;
}

/// t / sin(t) and its derivative by cos(t).
struct AngleBySine {
    explicit AngleBySine(double cosine) {
        const double sine2 = 1 - cosine * cosine;
        if (sine2 < 1e-6 && cosine > 0) {
            ratio = 1 + sine2 / 6;
            return;
        }
        ratio = std::acos(std::clamp(cosine, -1.0, 1.0)) / std::sqrt(std::max(sine2, 1e-6));
        ratio_by_cosine = (cosine * ratio - 1) / std::max(sine2, 1e-6);
    }
    double ratio = 1, ratio_by_cosine = -1.0 / 3;
};

}  // namespace

Skeleton givingSkeleton(const Skeleton& actor, const std::vector<bool>& gives) {
    std::vector<Joint> joints = actor.joints();
    for (size_t j = 0; j < joints.size(); ++j)
        if (gives[j] && lacksFreedoms(joints[j])) {
            joints[j].type = JointType::kBall;
            joints[j].dof = {{"x", Vector3d::UnitX()}, {"y", Vector3d::UnitY()}, {"z", Vector3d::UnitZ()}};
        }
    return Skeleton::make(std::move(joints)).value();
}

JointGive::JointGive(const Skeleton& actor, const KinematicTree& tree, const std::vector<bool>& gives,
                     const std::vector<bool>& seen, const GiveParameters& parameters)
    : parameters_(parameters) {
    for (int j = 0; j < actor.size(); ++j) {
        const Joint& joint = actor.joint(j);
        if (!gives[static_cast<size_t>(j)] || !lacksFreedoms(joint))
            continue;
        const int link = tree.linkOfJoint(j), first = tree.link(link).first;
        const bool is_seen = seen[static_cast<size_t>(j)];
        const Vector3d axis = joint.dof[0].axis, across = axis.unitOrthogonal();
        if (joint.type == JointType::kUniversal) {
            constraints_.push_back({link, first, false, is_seen, axis, joint.dof[1].axis});
        } else {
            constraints_.push_back({link, first, true, is_seen, across, axis});
            constraints_.push_back({link, first, true, is_seen, axis.cross(across), axis});
        }
    }
    for (Constraint& constraint : constraints_)
        constraint.variance_rad2 = square(parameters_.initial_rad);
    is_taught_ = std::ranges::any_of(actor.joints(), lacksFreedoms) || std::ranges::count(seen, true) == 0;
    if (!is_taught_) {
        flesh_share_ = 1;
        mean_variance_rad2_ = square(parameters_.untaught_rad);
    }
}

/// With zero variance. h = fixed^T R moving, and R exp(d) changes it by d^T (moving x R^T fixed). Of a hinge
/// h = sin(t) times a direction, t the angle between the axis and where it was, whose cosine changes
/// likewise.
ObservationBlock JointGive::blockOf(const Constraint& constraint, const MotionState& motion) const {
    const Matrix3d R = motion.q_parent_link[static_cast<size_t>(constraint.link)].toRotationMatrix();
    const Vector3d fixed_link = R.transpose() * constraint.fixed_parent;
    Vector3d slope = constraint.moving_link.cross(fixed_link);
    double deviation =
        fixed_link.dot(constraint.moving_link) - constraint.fixed_parent.dot(constraint.moving_link);
    if (constraint.hinge) {
        const Vector3d axis_before = R.transpose() * constraint.moving_link;
        const AngleBySine by_sine(constraint.moving_link.dot(axis_before));
        slope = by_sine.ratio * slope +
                deviation * by_sine.ratio_by_cosine * constraint.moving_link.cross(axis_before);
        deviation *= by_sine.ratio;
    }
    return {{constraint.first, constraint.first + 1, constraint.first + 2},
            slope.transpose(),
            Eigen::VectorXd::Constant(1, -deviation),
            Eigen::VectorXd::Zero(1)};
}

std::vector<LimbRanging::Held> JointGive::held(const KinematicTree& tree, int link,
                                               const MotionState& motion) const {
    std::vector<LimbRanging::Held> held;
    for (const Constraint& constraint : constraints_) {
        const Matrix3d R = motion.q_parent_link[static_cast<size_t>(constraint.link)].toRotationMatrix();
        const double c = constraint.fixed_parent.dot(constraint.moving_link);
        const bool is_own = constraint.link == link;
        if (!is_own && tree.movingLink(tree.link(constraint.link).parent) != link)
            continue;
        const Vector3d &moving = constraint.moving_link, &fixed = constraint.fixed_parent;
        held.push_back(is_own ? LimbRanging::Held{R.transpose() * fixed, moving, c}
                              : LimbRanging::Held{R * moving, fixed, c});
        if (constraint.hinge)  // and its axis is not turned round
            held.push_back(is_own ? LimbRanging::Held{R.transpose() * moving, moving, 1}
                                  : LimbRanging::Held{R * moving, moving, 1});
    }
    return held;
}

std::vector<int> JointGive::lostLinks(const MotionState& motion) const {
    std::vector<int> lost;
    for (const Constraint& constraint : constraints_)
        if (isLost(constraint, blockOf(constraint, motion)) &&
            (lost.empty() || lost.back() != constraint.link))
            lost.push_back(constraint.link);
    return lost;
}

std::vector<ObservationBlock> JointGive::initial(const MotionState& motion) const {
    std::vector<ObservationBlock> blocks;
    for (const Constraint& constraint : constraints_) {
        blocks.push_back(blockOf(constraint, motion));
        blocks.back().variance[0] = constraint.variance_rad2;
    }
    return blocks;
}

void JointGive::learn(Constraint& constraint, double deviation_rad, double estimate_variance,
                      double interval_s) const {
    constraint.constant_rad +=
        std::min(1.0, interval_s / parameters_.constant_s) * (deviation_rad - constraint.constant_rad);
    const double coming_and_going =
        std::max(0.0, square(deviation_rad - constraint.constant_rad) - estimate_variance);
    const double usual = std::max(constraint.variance_rad2, kLeastUsual_rad2);
    const double seen = std::min(square(parameters_.most_rad),
                                 kWithConstant * std::min(coming_and_going, square(kOutlier) * usual));
    const double memory_s = std::min(parameters_.memory_s, parameters_.first_s + seen_s_);
    constraint.variance_rad2 += std::min(1.0, interval_s / memory_s) * (seen - constraint.variance_rad2);
}

double JointGive::relevance(const Constraint& constraint) const {
    return square(constraint.variance_rad2 / (constraint.variance_rad2 + square(parameters_.relevant_rad)));
}

std::vector<ObservationBlock> JointGive::observe(const MotionState& motion, const Covariance& P,
                                                 double interval_s) {
    std::vector<ObservationBlock> blocks;
    const double lasts_s = parameters_.lasts_s + flesh_share_ * parameters_.lasts_on_flesh_s;
    double share = 0, variance = 0, count = 0;
    for (Constraint& constraint : constraints_) {
        ObservationBlock block = blockOf(constraint, motion);
        const bool is_lost = isLost(constraint, block);
        if (!is_lost && constraint.seen)
            learn(constraint, -block.residual[0], P.innovationVariance(block)[0], interval_s);
        // What is not seen is held at once, however long it lasts: nothing else tells which of the joints at
        // a segment's ends has turned.
        const double relevant = constraint.seen ? relevance(constraint) : 0;
        const double given =
            std::max(square(parameters_.least_rad),
                     constraint.seen ? relevant * constraint.variance_rad2 : mean_variance_rad2_);
        const double whitened = 2 * (parameters_.trembles_s + relevant * lasts_s) / interval_s;
        block.variance[0] = is_lost ? square(parameters_.most_rad) : whitened * given;
        block.origin = {ObservationOrigin::Kind::kGive, static_cast<int>(std::ssize(blocks)), {}};
        if (const double deviation = -block.residual[0];
            !is_lost && std::abs(deviation) > parameters_.lasting_rad) {
            block.origin.target =
                Eigen::VectorXd::Constant(1, std::copysign(parameters_.lasting_rad, deviation));
            block.residual += block.origin.target;
            block.variance[0] = 2 * parameters_.trembles_s / interval_s * square(parameters_.most_rad);
        }
        if (constraint.seen) {
            share += relevant;
            variance += given;
            ++count;
        }
        blocks.push_back(std::move(block));
    }
    seen_s_ += interval_s;
    if (!is_taught_)
        return blocks;
    flesh_share_ = share / std::max(1.0, count);
    mean_variance_rad2_ = variance / std::max(1.0, count);
    return blocks;
}

}  // namespace noctule
