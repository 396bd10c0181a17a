// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_robot/robot_body.h"

#include <algorithm>
#include <cmath>

#include "core/robot/inverse_kinematics.h"

namespace noctule::virtual_robot {
namespace {

/// Commands on their way at most: latency of seconds at a thousand commands a second.
constexpr size_t kMostWaiting = 4096;
constexpr int kTipIterations = 40;

}  // namespace

RobotBody::RobotBody(const robot::DrivenParts& parts, const BodyOptions& options)
    : options_(options),
      arms_(parts.arms),
      joints_(parts.joints()),
      speed_(parts.speeds()),
      q_(parts.reference()) {
    for (const robot::Chain* chain : parts.chains())
        for (const robot::ChainJoint& joint : chain->joints()) {
            lower_.push_back(joint.lower);
            upper_.push_back(joint.upper);
        }
    for (size_t i = 0; i < q_.size(); ++i)
        q_[i] = std::clamp(q_[i], lower_[i], upper_[i]);
    v_.assign(q_.size(), 0);
    target_ = q_;
    stuck_.assign(q_.size(), false);
}

void RobotBody::command(int64_t now_ns, uint64_t sequence, const std::vector<double>& q) {
    require(q.size() == q_.size(), "a command has a value for every joint");
    if (!last_command_.empty())
        for (size_t i = 0; i < q.size(); ++i)
            largest_step_ = std::max(largest_step_, std::abs(q[i] - last_command_[i]));
    last_command_ = q;
    waiting_.push_back({now_ns + std::llround(options_.latency_s * 1e9), sequence, q});
    if (waiting_.size() > kMostWaiting)
        waiting_.pop_front();
}

void RobotBody::commandTip(int64_t now_ns, size_t arm, const Matrix3d& R_base_tip,
                           const Vector3d& p_base_tip) {
    require(arm < arms_.size(), "the robot has this arm");
    size_t first = 0;
    for (size_t i = 0; i < arm; ++i)
        first += static_cast<size_t>(arms_[i].chain.size());
    const robot::Chain& chain = arms_[arm].chain;
    std::vector<double> q = last_command_.empty() ? q_ : last_command_;
    robot::JointVector start(chain.size());
    for (int i = 0; i < chain.size(); ++i)
        start[i] = q[first + static_cast<size_t>(i)];
    robot::PostureSearch search;
    search.most_iterations = search.most_per_start = kTipIterations;  // it never begins anew
    const robot::FoundPosture found = robot::findPosture(chain, R_base_tip, p_base_tip, start, search);
    for (int i = 0; i < chain.size(); ++i)
        q[first + static_cast<size_t>(i)] = found.q[i];
    command(now_ns, obeyed_ + waiting_.size() + 1, q);
}

void RobotBody::obey(const Heard& heard) {
    heard_ns_ = heard.at_ns;
    obeyed_ = heard.sequence;
    refuses_ = false;
    for (size_t i = 0; i < q_.size(); ++i)
        refuses_ |= options_.refuse_beyond > 0 && std::abs(heard.q[i] - q_[i]) > options_.refuse_beyond;
    if (refuses()) {
        ++refused_count_;
        target_ = q_;
        return;
    }
    for (size_t i = 0; i < q_.size(); ++i)
        target_[i] = std::clamp(heard.q[i], lower_[i], upper_[i]);
}

void RobotBody::advance(int64_t now_ns) {
    if (last_ns_ == 0)
        last_ns_ = now_ns;
    const double dt_s = static_cast<double>(now_ns - last_ns_) * 1e-9;
    if (dt_s <= 0)
        return;
    last_ns_ = now_ns;
    while (!waiting_.empty() && waiting_.front().at_ns <= now_ns) {
        obey(waiting_.front());
        waiting_.pop_front();
    }
    if (static_cast<double>(now_ns - heard_ns_) * 1e-9 > options_.watchdog_s)
        target_ = q_;
    const double share = options_.lag_s > 0 ? 1 - std::exp(-dt_s / options_.lag_s) : 1;
    for (size_t i = 0; i < q_.size(); ++i) {
        const double step =
            stuck_[i] ? 0 : std::clamp(share * (target_[i] - q_[i]), -speed_[i] * dt_s, speed_[i] * dt_s);
        q_[i] += step;
        v_[i] = step / dt_s;
    }
}

bool RobotBody::setStuck(const std::string& joint, bool stuck) {
    const auto found = std::ranges::find(joints_, joint);
    if (found == joints_.end())
        return false;
    stuck_[static_cast<size_t>(found - joints_.begin())] = stuck;
    return true;
}

}  // namespace noctule::virtual_robot
