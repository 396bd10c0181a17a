// SPDX-License-Identifier: Apache-2.0
#include "core/robot/teleoperation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/robot/bounded_least_squares.h"
#include "core/robot/inverse_kinematics.h"

namespace noctule::robot {
namespace {

constexpr double kSlowed = 0.25;      ///< of the speed while the pose is uncertain
constexpr double kStayOfHand = 1e-6;  ///< keeps joints that the tip leaves free
constexpr int kHandIterations = 6;

/// Place and rotation of the tip, near to the last posture.
class HandCost {
public:
    HandCost(const Chain& chain, const Matrix3d& R, const Vector3d& p, const JointVector& last)
        : chain_(chain), R_(R), p_(p), last_(last) {}

    void operator()(const JointVector& q, LinearisedCost& at) {
        chain_.forward(q, state_);
        at.clear(chain_.size());
        const int tip = chain_.size() - 1;
        chain_.pointJacobian(state_, tip, state_.p_base_tip, J_);
        at.add(1, Vector3d(state_.p_base_tip - p_), J_);
        const TurnError turn = turnError(R_, state_.R_base_tip);
        chain_.turnJacobian(state_, tip, J_turn_);
        J_.noalias() = turn.by_turn * J_turn_;
        at.add(0.1, turn.error, J_);  // an arm out of reach keeps the place rather than the turn
        at.cost += kStayOfHand * (q - last_).squaredNorm() / 2;
        at.gradient += kStayOfHand * (q - last_);
        at.hessian.diagonal().array() += kStayOfHand;
    }

private:
    const Chain& chain_;
    const Matrix3d& R_;
    const Vector3d& p_;
    const JointVector& last_;
    ChainState state_;
    PointJacobian J_, J_turn_;
};

bool isSound(const TeleopPose& pose, int joints) {
    const double norm = pose.q_world_hand.norm();
    const bool fits = !pose.posture || (pose.posture->size() == joints && pose.posture->allFinite());
    return fits && pose.p_world_hand.allFinite() && pose.p_world_hand.norm() < 1e3 && norm > 0.9 &&
           norm < 1.1 && pose.confidence >= 0;
}

double eased(double t) {
    return t * t * t * (10 + t * (-15 + 6 * t));
}

}  // namespace

Teleoperator::Teleoperator(const Chain& chain, const std::vector<double>& max_speed,
                           const RobotProfile& profile, const TeleopSettings& settings, const JointVector& q)
    : chain_(chain), speeds_(max_speed), settings_(settings) {
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    acceleration_ = profile.max_acceleration > 0 ? profile.max_acceleration : kEndless;
    jerk_ = profile.max_acceleration > 0 && profile.max_jerk > 0 ? profile.max_jerk : kEndless;
    for (Eigen::Index i = 0; i < q.size(); ++i)
        motion_.push_back({q[i], 0, 0});
}

JointVector Teleoperator::places() const {
    JointVector q(static_cast<Eigen::Index>(motion_.size()));
    for (size_t i = 0; i < motion_.size(); ++i)
        q[static_cast<Eigen::Index>(i)] = motion_[i].place;
    return q;
}

void Teleoperator::take(TeleopEvent event) {
    const TeleopState next = after(state_, event);
    if (next == state_)
        return;
    if (next == TeleopState::kSynchronising)
        index_.reset();  // the next pose is where hand and tip belong together
    if (next == TeleopState::kBlending) {
        blend_from_ = places();
        blended_s_ = 0;
    }
    state_ = next;
}

void Teleoperator::handleKeys(const TeleopKeys& keys) {
    if (keys.reset && !keys.stop)
        take(TeleopEvent::kReset);
    if (keys.stop)
        take(TeleopEvent::kStop);
    else if (!keys.dead_man || !keys.clutch)
        take(TeleopEvent::kRelease);
    else if (has_pose_)
        take(TeleopEvent::kEngage);
}

void Teleoperator::watch(int64_t now_ns, const std::optional<TeleopPose>& pose) {
    const bool is_fresh = pose && isSound(*pose, chain_.size()) && pose->time_ns <= now_ns &&
                          static_cast<double>(now_ns - pose->time_ns) * 1e-9 <= settings_.stale_s;
    has_pose_ = is_fresh;
    take(is_fresh ? TeleopEvent::kFind : TeleopEvent::kLose);
}

void Teleoperator::index(const TeleopPose& pose) {
    ChainState state;
    chain_.forward(places(), state);
    index_ = {pose.p_world_hand, state.p_base_tip, pose.q_world_hand.normalized().toRotationMatrix(),
              state.R_base_tip};
}

JointVector Teleoperator::tipAt(const Matrix3d& R, const Vector3d& p, const JointVector& from) const {
    const JointVector lower = chain_.lower(), upper = chain_.upper();
    JointVector q = from.cwiseMax(lower).cwiseMin(upper);
    const JointVector last = q;
    HandCost cost(chain_, R, p, last);
    solveInBox(cost, lower, upper, {kHandIterations, 1e-6, 1e-6}, q, [](double) { return false; });
    return q;
}

JointVector Teleoperator::askedFor(const TeleopPose& pose, bool& is_outside_box) const {
    JointVector q = places();
    Matrix3d R;
    Vector3d p;
    if (pose.posture) {
        ChainState state;
        q = pose.posture->cwiseMax(chain_.lower()).cwiseMin(chain_.upper());
        chain_.forward(q, state);
        R = state.R_base_tip;
        p = state.p_base_tip;
    } else {
        const Matrix3d& A = settings_.R_base_world;
        const Matrix3d R_hand = pose.q_world_hand.normalized().toRotationMatrix();
        p = index_->p_base_tip + settings_.scale * A * (pose.p_world_hand - index_->p_world_hand);
        R = A * R_hand * index_->R_world_hand.transpose() * A.transpose() * index_->R_base_tip;
    }
    const Vector3d inside = p.cwiseMax(settings_.box_min_m).cwiseMin(settings_.box_max_m);
    is_outside_box = inside != p;
    return pose.posture && !is_outside_box ? q : tipAt(R, inside, q);
}

/// Without a wish the joints brake. Place, speed, acceleration and jerk stay inside their limits.
void Teleoperator::move(const JointVector* wish, double speed_scale, const JointVector* last_wish) {
    for (size_t i = 0; i < motion_.size(); ++i) {
        const ChainJoint& joint = chain_.joint(static_cast<int>(i));
        // A stop from full speed may still need the whole limit.
        const double speed = wish ? speeds_[i] * speed_scale : speeds_[i];
        const StepLimiter limiter({joint.lower, joint.upper, speed, acceleration_, jerk_}, settings_.dt_s);
        const auto at = static_cast<Eigen::Index>(i);
        const double wish_speed = last_wish ? ((*wish)[at] - (*last_wish)[at]) / settings_.dt_s : 0;
        const double command =
            wish ? limiter.approach(motion_[i], (*wish)[at], wish_speed) : limiter.brake(motion_[i]);
        motion_[i] = limiter.after(motion_[i], command);
    }
}

void Teleoperator::brakeFrom(const std::vector<JointMotion>& before) {
    motion_ = before;
    last_ghost_.reset();
    move(nullptr, 1);
}

/// The ghost's own speed is met, so that a robot that is fast enough has no lag.
void Teleoperator::follow(const JointVector& ghost, double speed_scale) {
    move(&ghost, speed_scale, last_ghost_ ? &*last_ghost_ : nullptr);
    last_ghost_ = ghost;
}

TeleopCommand Teleoperator::step(int64_t now_ns, const std::optional<TeleopPose>& pose,
                                 const TeleopKeys& keys) {
    watch(now_ns, pose);
    handleKeys(keys);
    TeleopCommand command;
    JointVector ghost = places();
    const bool is_engaged = state_ == TeleopState::kSynchronising || state_ == TeleopState::kBlending ||
                            state_ == TeleopState::kFollowing;
    if (is_engaged && !index_)
        index(*pose);
    if (is_engaged || (has_pose_ && pose->posture))
        ghost = askedFor(*pose, command.is_outside_box);
    if (is_engaged) {
        command.is_slowed = pose->confidence < settings_.least_confidence;
    }
    command.farthest_rad = (ghost - places()).cwiseAbs().maxCoeff(&command.farthest_joint);
    if (keys.accept && command.farthest_rad <= settings_.farthest_rad)
        take(TeleopEvent::kAccept);
    const double scale =
        std::clamp(settings_.speed_scale * keys.speed_scale, 0.0, 1.0) * (command.is_slowed ? kSlowed : 1.0);
    if (state_ == TeleopState::kBlending) {
        blended_s_ += settings_.dt_s;
        const JointVector wish =
            blend_from_ + eased(std::min(1.0, blended_s_ / settings_.blend_s)) * (ghost - blend_from_);
        move(&wish, scale);
        if (blended_s_ >= settings_.blend_s)
            take(TeleopEvent::kBlended);
    } else if (state_ == TeleopState::kFollowing) {
        follow(ghost, scale);
    } else {
        last_ghost_.reset();
        move(retreat_ && !is_engaged ? &*retreat_ : nullptr, scale);
    }
    command.q = places();
    command.ghost = ghost;
    command.state = state_;
    return command;
}

}  // namespace noctule::robot
