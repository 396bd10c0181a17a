// SPDX-License-Identifier: Apache-2.0
#include "core/robot/inverse_kinematics.h"

#include <cmath>
#include <numbers>

#include "core/math/rotation.h"
#include "core/robot/bounded_least_squares.h"

namespace noctule::robot {
namespace {

struct Missed {
    double distance_m = 0, angle_rad = 0;
};

/// Metres and radians count alike: an arm is about a metre long.
class TipCost {
public:
    TipCost(const Chain& chain, const Matrix3d& R, const Vector3d& p) : chain_(chain), R_(R), p_(p) {}

    void operator()(const JointVector& q, LinearisedCost& at) {
        chain_.forward(q, state_);
        at.clear(chain_.size());
        const int last = chain_.size() - 1;
        const Vector3d place = state_.p_base_tip - p_;
        chain_.pointJacobian(state_, last, state_.p_base_tip, J_);
        at.add(1, place, J_);
        const TurnError turn = turnError(R_, state_.R_base_tip);
        chain_.turnJacobian(state_, last, J_turn_);
        J_.noalias() = turn.by_turn * J_turn_;
        at.add(1, turn.error, J_);
    }

    Missed missed(const JointVector& q) {
        chain_.forward(q, state_);
        return {(state_.p_base_tip - p_).norm(), turnError(R_, state_.R_base_tip).error.norm()};
    }

private:
    const Chain& chain_;
    Matrix3d R_;
    Vector3d p_;
    ChainState state_;
    PointJacobian J_, J_turn_;
};

}  // namespace

double RandomPostures::uniform() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
}

JointVector RandomPostures::next(const Chain& chain) {
    JointVector q(chain.size());
    for (int i = 0; i < chain.size(); ++i) {
        const ChainJoint& joint = chain.joint(i);
        const bool is_endless = !std::isfinite(joint.lower);
        const double from = is_endless ? -std::numbers::pi : joint.lower;
        const double to = is_endless ? std::numbers::pi : joint.upper;
        q[i] = from + (to - from) * uniform();
    }
    return q;
}

TurnError turnError(const Matrix3d& R_target, const Matrix3d& R) {
    TurnError turn;
    turn.error = logQuaternion(Quaterniond(R_target * R.transpose()));
    const double angle = turn.error.norm();
    const Matrix3d cross = skew(turn.error);
    // The error falls as R turns: -Jr^-1(error), Sola 2018, equation 144.
    const double square =
        angle < 1e-4 ? 1.0 / 12
                     : 1 / (angle * angle) - (1 + std::cos(angle)) / (2 * angle * std::sin(angle) + 1e-300);
    turn.by_turn = -(Matrix3d::Identity() + 0.5 * cross + square * cross * cross);
    return turn;
}

FoundPosture findPosture(const Chain& chain, const Matrix3d& R_base_tip, const Vector3d& p_base_tip,
                         const JointVector& q, const PostureSearch& search) {
    const JointVector lower = chain.lower(), upper = chain.upper();
    TipCost cost(chain, R_base_tip, p_base_tip);
    RandomPostures random(search.seed);
    const double tolerance = std::min(search.tolerance_m, search.tolerance_rad);
    const auto is_there = [&](double at) { return at < tolerance * tolerance / 2; };
    FoundPosture found;
    double best = std::numeric_limits<double>::infinity();
    JointVector start = q.cwiseMax(lower).cwiseMin(upper);
    while (found.iterations < search.most_iterations) {
        ++found.starts;
        const int most = std::min(search.most_per_start, search.most_iterations - found.iterations);
        const BoxedReport report = solveInBox(cost, lower, upper, {most, 1e-3, 1e-4}, start, is_there);
        found.iterations += report.iterations;
        if (report.cost < best) {
            best = report.cost;
            found.q = start;
        }
        if (is_there(report.cost))
            break;
        start = random.next(chain);
    }
    const Missed missed = cost.missed(found.q);
    found.distance_m = missed.distance_m;
    found.angle_rad = missed.angle_rad;
    found.arrived = missed.distance_m <= search.tolerance_m && missed.angle_rad <= search.tolerance_rad;
    return found;
}

}  // namespace noctule::robot
