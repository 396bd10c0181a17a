// SPDX-License-Identifier: Apache-2.0
// A robot without hardware, in simulated time: own limits of place and speed, latency until a command is
// heard, lag of its joints, refusal of commands that are too far from where it is, and faults.
#pragma once

#include <deque>

#include "core/robot/driven_parts.h"

namespace noctule::virtual_robot {

struct BodyOptions {
    double latency_s = 0;        ///< until a command is heard
    double lag_s = 0.02;         ///< time constant of every joint; larger: it follows later
    double refuse_beyond = 0.5;  ///< rad or m between a command and where the joint is; 0: nothing is refused
    double watchdog_s = 0.2;     ///< without a command for so long the joints stand still
};

class RobotBody {
public:
    RobotBody(const robot::DrivenParts& parts, const BodyOptions& options);

    const std::vector<std::string>& joints() const { return joints_; }
    /// Values in the order of joints(); sizes must fit.
    void command(int64_t now_ns, uint64_t sequence, const std::vector<double>& q);
    /// The tip of one arm in its base link, as Robonaut's controller wants it; the other arms stay.
    void commandTip(int64_t now_ns, size_t arm, const Matrix3d& R_base_tip, const Vector3d& p_base_tip);
    /// Moves on; time that went by while it was stalled is lost.
    void advance(int64_t now_ns);

    const std::vector<double>& q() const { return q_; }
    const std::vector<double>& v() const { return v_; }
    bool refuses() const { return refuses_ || refuses_all_; }
    uint64_t obeyedSequence() const { return obeyed_; }
    int64_t refusedCommands() const { return refused_count_; }
    /// The largest step of a joint's target from one command to the next, and its joint.
    double largestStep() const { return largest_step_; }

    // Faults
    void setLatency(double latency_s) { options_.latency_s = latency_s; }
    void setLag(double lag_s) { options_.lag_s = lag_s; }
    void setRefusesAll(bool refuses) { refuses_all_ = refuses; }
    /// False: no joint has the name.
    bool setStuck(const std::string& joint, bool stuck);

private:
    struct Heard {
        int64_t at_ns;
        uint64_t sequence;
        std::vector<double> q;
    };
    void obey(const Heard& heard);

    BodyOptions options_;
    std::vector<robot::RobotArm> arms_;
    std::vector<std::string> joints_;
    std::vector<double> lower_, upper_, speed_, q_, v_, target_, last_command_;
    std::vector<bool> stuck_;
    std::deque<Heard> waiting_;
    int64_t last_ns_ = 0, heard_ns_ = 0, refused_count_ = 0;
    uint64_t obeyed_ = 0;
    double largest_step_ = 0;
    bool refuses_ = false, refuses_all_ = false;
};

}  // namespace noctule::virtual_robot
