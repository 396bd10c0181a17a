// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/limb_turn.h"

#include "core/job/contract.h"
#include "core/math/rotation.h"

namespace noctule {

LimbTurns::LimbTurns(const KinematicTree& tree, const MotionState& motion) {
    for (size_t i = 0; i < tree.links().size(); ++i) {
        const Link& link = tree.links()[i];
        Turn turn;
        const Matrix3d R_parent_link = motion.q_parent_link[i].toRotationMatrix();
        turn.R_world_link = R_parent_link;
        turn.parent_rate = turn.parent_accel = turn.rate = turn.accel = Vector3d::Zero();
        if (link.parent >= 0) {
            const Turn& parent = turns_[static_cast<size_t>(link.parent)];
            turn.R_world_link = parent.R_world_link * R_parent_link;
            turn.parent_rate = R_parent_link.transpose() * (parent.parent_rate + parent.rate);
            turn.parent_accel = R_parent_link.transpose() *
                                (parent.parent_accel + parent.parent_rate.cross(parent.rate) + parent.accel);
        }
        if (link.type == LinkType::kHinge) {
            turn.rate = motion.rate[link.first] * link.axis;
            turn.accel = motion.accel[link.first] * link.axis;
        } else if (link.count >= 3) {
            turn.rate = motion.rate.segment<3>(link.first + link.count - 3);
            turn.accel = motion.accel.segment<3>(link.first + link.count - 3);
        }
        const Matrix3d W = skew(turn.parent_rate);
        turn.rate_by_theta = -W;
        turn.accel_by_theta = -skew(turn.parent_accel) + (skew(turn.rate) + W) * W;
        turns_.push_back(turn);
    }
}

Eigen::MatrixX3d LimbTurns::errorOf(const KinematicTree& tree, int link,
                                    const std::vector<bool>& stays) const {
    require(tree.link(link).type == LinkType::kBall, "LimbTurns: only a ball joint turns alone");
    const Eigen::Index n = tree.freedoms();
    Eigen::MatrixX3d error = Eigen::MatrixX3d::Zero(3 * n, 3);
    const auto add = [&](size_t i, const Matrix3d& theta) {
        const int first = tree.links()[i].first;
        error.middleRows<3>(first) = theta;
        error.middleRows<3>(n + first) = turns_[i].rate_by_theta * theta;
        error.middleRows<3>(2 * n + first) = turns_[i].accel_by_theta * theta;
    };
    std::vector<bool> turns(tree.links().size(), false);  // with the limb
    turns[static_cast<size_t>(link)] = true;
    add(static_cast<size_t>(link), Matrix3d::Identity());
    const Matrix3d& R_world_limb = turns_[static_cast<size_t>(link)].R_world_link;
    for (size_t i = static_cast<size_t>(link) + 1; i < tree.links().size(); ++i) {
        const Link& carried = tree.links()[i];
        if (!turns[static_cast<size_t>(carried.parent)])
            continue;
        if (carried.type == LinkType::kBall && stays[i])
            add(i, -turns_[i].R_world_link.transpose() * R_world_limb);
        else
            turns[i] = true;
    }
    return error;
}

Eigen::VectorXd bendTurns(const KinematicTree& tree, const MotionState& motion, Eigen::VectorXd correction) {
    constexpr double kStraight_rad = 0.003;  // bent by 1e-5 of a rate: less than any gyroscope notices
    const Eigen::Index n = tree.freedoms();
    if (correction.head(n).cwiseAbs().maxCoeff() < kStraight_rad)
        return correction;
    const LimbTurns turns(tree, motion);
    for (size_t i = 1; i < tree.links().size(); ++i) {
        const Link& link = tree.links()[i];
        if (link.type != LinkType::kBall)
            continue;
        const Vector3d theta = correction.segment<3>(link.first);
        const LimbTurns::Turn& turn = turns.of(i);
        const Matrix3d back = expQuaternion(-theta).toRotationMatrix();
        const Vector3d parent_rate = back * turn.parent_rate,
                       rate = turn.parent_rate + turn.rate - parent_rate,
                       accel = turn.parent_accel + turn.parent_rate.cross(turn.rate) + turn.accel -
                               back * turn.parent_accel - parent_rate.cross(rate);
        correction.segment<3>(n + link.first) += rate - turn.rate - turn.rate_by_theta * theta;
        correction.segment<3>(2 * n + link.first) += accel - turn.accel - turn.accel_by_theta * theta;
    }
    return correction;
}

LinkTransitions limbShift(const KinematicTree& tree, const LimbTurns& before, const LimbTurns& after) {
    LinkTransitions shift{tree.freedoms()};
    for (size_t i = 1; i < tree.links().size(); ++i) {
        if (tree.links()[i].type != LinkType::kBall)
            continue;
        const LimbTurns::Turn &from = before.of(i), &to = after.of(i);
        const Matrix3d theta = to.R_world_link.transpose() * from.R_world_link;
        shift.links.push_back({.first = tree.links()[i].first,
                               .count = 3,
                               .turn = theta,
                               .rate_by_theta = to.rate_by_theta * theta - from.rate_by_theta,
                               .accel_by_theta = to.accel_by_theta * theta - from.accel_by_theta});
    }
    return shift;
}

}  // namespace noctule
