// SPDX-License-Identifier: Apache-2.0
#include "devices/robot/drive_loop.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "devices/machine/clock.h"
#include "devices/robot/drive_table.h"

namespace noctule::robot_link {
namespace {

constexpr int64_t kFirstState_ns = 5'000'000'000;
constexpr std::chrono::milliseconds kLookForState{5};
constexpr int64_t kSayAgain_ns = 2'000'000'000;

std::chrono::steady_clock::time_point timeOf(int64_t steady_ns) {
    return std::chrono::steady_clock::time_point(std::chrono::nanoseconds(steady_ns));
}

/// Where the robot stands, before the first command.
Result<RobotState> firstState(const RobotInterface& link, const JobContext& job) {
    const int64_t until_ns = steadyNow_ns() + kFirstState_ns;
    while (steadyNow_ns() < until_ns) {
        const LinkStatus status = link.status();
        if (status.state)
            return *status.state;
        if (job.cancelled())
            return JobContext::cancelledError();
        if (status.is_hopeless && status.trouble)
            return *status.trouble;
        std::this_thread::sleep_for(kLookForState);
    }
    if (const auto trouble = link.status().trouble)
        return *trouble;
    return Error{ErrorKind::kDevice, link.address() + ": no robot answers",
                 "Check that its program runs and that the address is right"};
}

class DriveLoop {
public:
    DriveLoop(const DrivePlan& plan, const RobotState& first)
        : plan_(plan),
          period_ns_(std::llround(plan.settings.teleop.dt_s * 1e9)),
          drive_(plan.model, plan.profile, plan.parts, plan.human_length_m, plan.settings, first.q),
          table_(plan.parts.joints()),
          speeds_(plan.parts.speeds()) {
        output_.q = first.q;
    }

    DriveReport run(const JobContext& job) {
        const int64_t start_ns = steadyNow_ns();
        int64_t next_ns = start_ns;
        while (!(report_.cancelled = job.cancelled()) && !plan_.ends()) {
            const double run_s = static_cast<double>(next_ns - start_ns) * 1e-9;
            if (plan_.seconds && run_s >= *plan_.seconds)
                break;
            std::this_thread::sleep_until(timeOf(next_ns));
            step(steadyNow_ns(), start_ns);
            if (report_.commands % 50 == 0)
                job.progress(plan_.seconds ? run_s / *plan_.seconds : 0,
                             std::string("Driving: ") + stateName(output_.state));
            next_ns += period_ns_;
            // A late step is left out, not made up for: commands one after another would be too fast.
            while (next_ns <= steadyNow_ns() - period_ns_ / 2) {
                next_ns += period_ns_;
                ++report_.skipped;
            }
        }
        report_.link = plan_.link.status();
        report_.silent_s = static_cast<double>(steadyNow_ns() - report_.link.state_arrived_ns) * 1e-9;
        report_.table = table_.text();
        return std::move(report_);
    }

private:
    void step(int64_t now_ns, int64_t start_ns) {
        const auto newest = plan_.feed.newest();
        const LinkStatus link = plan_.link.status();
        robot::DriveInput input;
        input.now_ns = now_ns;
        if (newest)
            input.performer = newest->seen;
        if (link.state)
            input.robot = {link.state_arrived_ns, link.state->q, (link.state->flags & kRefuses) != 0};
        input.keys = plan_.keys(output_);
        const robot::DriveOutput before = std::exchange(output_, drive_.step(input));
        RobotCommand command = commandOf(now_ns);
        if (newest && newest->count != last_pose_) {
            command.pose_arrived_ns = newest->seen.arrived_ns;
            last_pose_ = newest->count;
        }
        plan_.link.send(command);
        measure(before, input);
        tellChange(before, now_ns);
        const DriveMoment moment{start_ns, now_ns,          input, output_, newest ? newest->time_ns : 0,
                                 link,     command.sequence};
        if (plan_.keeps_rows)
            table_.add(moment);
        if (plan_.watch)
            plan_.watch(moment);
    }

    RobotCommand commandOf(int64_t now_ns) {
        RobotCommand command;
        command.sequence = static_cast<uint64_t>(++report_.commands);
        command.time_ns = now_ns;
        command.q = output_.q;
        command.v = output_.v;
        const bool follows =
            output_.state == robot::TeleopState::kFollowing || output_.state == robot::TeleopState::kBlending;
        report_.following += output_.state == robot::TeleopState::kFollowing;
        command.flags = follows ? kFollows : kHolds;
        if (output_.state == robot::TeleopState::kStopped)
            command.flags |= kStopPressed;
        size_t first = 0;
        robot::ChainState at;
        for (const robot::RobotArm& arm : plan_.parts.arms) {
            robot::JointVector q(arm.chain.size());
            for (int i = 0; i < arm.chain.size(); ++i)
                q[i] = output_.q[first++];
            arm.chain.forward(q, at);
            command.tips.push_back(
                {arm.profile.name, arm.profile.base, at.p_base_tip, Quaterniond(at.R_base_tip)});
        }
        return command;
    }

    void measure(const robot::DriveOutput& before, const robot::DriveInput& input) {
        bool moves = false;
        for (size_t i = 0; i < output_.q.size(); ++i) {
            moves |= output_.q[i] != before.q[i];
            report_.largest_speed_use =
                std::max(report_.largest_speed_use,
                         std::abs(output_.q[i] - before.q[i]) / (speeds_[i] * plan_.settings.teleop.dt_s));
        }
        // Commands that go back to where the robot is follow nobody.
        const bool goes_back = output_.trouble == robot::DriveTrouble::kRobotRefuses ||
                               output_.trouble == robot::DriveTrouble::kJointOff;
        if (!moves || goes_back || !input.performer || !input.robot)
            return;
        const int64_t oldest_ns = std::min(input.performer->arrived_ns, input.robot->arrived_ns);
        report_.longest_hold_s =
            std::max(report_.longest_hold_s, static_cast<double>(input.now_ns - oldest_ns) * 1e-9);
    }

    /// A trouble that comes and goes with every step is said once.
    void tellChange(const robot::DriveOutput& before, int64_t now_ns) {
        if (output_.state != before.state)
            plan_.tell(std::string("Now ") + stateName(output_.state) + ".");
        const bool is_new =
            output_.trouble != before.trouble && output_.trouble != robot::DriveTrouble::kNone;
        if (!is_new || (output_.trouble == told_ && now_ns - told_ns_ < kSayAgain_ns))
            return;
        told_ = output_.trouble;
        told_ns_ = now_ns;
        plan_.tell(sentenceFor(output_));
    }

    const DrivePlan& plan_;
    const int64_t period_ns_;
    robot::LiveDrive drive_;
    DriveTable table_;
    std::vector<double> speeds_;
    robot::DriveOutput output_;
    int64_t last_pose_ = 0, told_ns_ = 0;
    robot::DriveTrouble told_ = robot::DriveTrouble::kNone;
    DriveReport report_;
};

}  // namespace

const char* stateName(robot::TeleopState state) {
    switch (state) {
        case robot::TeleopState::kIdle:
            return "idle";
        case robot::TeleopState::kSynchronising:
            return "synchronising";
        case robot::TeleopState::kBlending:
            return "blending";
        case robot::TeleopState::kFollowing:
            return "following";
        case robot::TeleopState::kHolding:
            return "holding";
        case robot::TeleopState::kLost:
            return "lost";
        case robot::TeleopState::kStopped:
            return "stopped";
    }
    return "";
}

Status awaitRobot(RobotInterface& link, const JobContext& job) {
    link.open();
    const auto first = firstState(link, job);
    return first ? Status(Done{}) : Status(first.error());
}

Result<DriveReport> runDrive(const DrivePlan& plan, const JobContext& job) {
    if (!plan.is_open)
        plan.link.open();
    const auto first = firstState(plan.link, job);
    if (!first)
        return first.error();
    DriveLoop loop(plan, *first);
    return loop.run(job);
}

}  // namespace noctule::robot_link
