// SPDX-License-Identifier: Apache-2.0
#include "ui/robot/robot_running.h"

namespace noctule::ui {
namespace {

using AtEnd = robot_link::MotionPoses::AtEnd;

/// A screen that does not look keeps no more than this.
constexpr size_t kMostMoments = 5000;

std::array<double, 2> armLengths(const robot::PerformerArms& performer) {
    return {performer.armLength_m(robot::Side::kLeft), performer.armLength_m(robot::Side::kRight)};
}

}  // namespace

RobotRunning::RobotRunning(Plan plan)
    : plan_(std::move(plan)), feed_(plan_.skeleton, plan_.performer), table_(plan_.parts->joints) {
    keys_.speed_scale = plan_.speed;
    if (plan_.motion)
        motion_ = std::make_unique<robot_link::MotionPoses>(
            std::move(*plan_.motion), feed_, plan_.repeats ? AtEnd::kRepeats : AtEnd::kStays, false);
    thread_ = std::jthread([this] { run(); });
}

RobotRunning::~RobotRunning() {
    cancel_.cancel();
    thread_.join();
}

void RobotRunning::setKeys(bool dead_man, bool clutch) {
    const std::lock_guard lock(mutex_);
    keys_.dead_man = dead_man;
    keys_.clutch = clutch;
}

void RobotRunning::press(bool robot::TeleopKeys::*key) {
    const std::lock_guard lock(mutex_);
    keys_.*key = true;
}

void RobotRunning::setSpeed(double share) {
    const std::lock_guard lock(mutex_);
    keys_.speed_scale = share;
}

void RobotRunning::setRecorder(std::shared_ptr<robot_link::DriveRecorder> recorder) {
    const std::lock_guard lock(mutex_);
    recorder_ = std::move(recorder);
}

void RobotRunning::run() {
    const robot_link::DrivePlan plan{*plan_.link,
                                     feed_,
                                     plan_.parts->model,
                                     plan_.parts->profile,
                                     plan_.parts->driven,
                                     armLengths(plan_.performer),
                                     plan_.settings,
                                     std::nullopt,
                                     [this](const robot::DriveOutput&) {
                                         const std::lock_guard lock(mutex_);
                                         const robot::TeleopKeys pressed = keys_;
                                         keys_.accept = keys_.stop = keys_.reset = false;
                                         return pressed;
                                     },
                                     [] { return false; },
                                     [](const std::string&) {},
                                     false,
                                     [this](const robot_link::DriveMoment& moment) { watch(moment); }};
    const auto report = robot_link::runDrive(plan, {nullptr, &cancel_});
    const std::lock_guard lock(mutex_);
    if (!report)
        news_.end = report.error();
}

void RobotRunning::watch(const robot_link::DriveMoment& moment) {
    const auto seconds = [&](int64_t steady_ns) {
        return static_cast<double>(steady_ns - moment.start_ns) * 1e-9;
    };
    RobotMoment shown;
    shown.time_s = seconds(moment.now_ns);
    shown.output = moment.output;
    shown.pose_time_s = static_cast<double>(moment.pose_time_ns) * 1e-9;
    if (moment.link.state) {
        shown.actual = moment.link.state->q;
        shown.actual_time_s = seconds(moment.link.state_arrived_ns);
    }
    table_.add(moment);
    const std::lock_guard lock(mutex_);
    if (recorder_)
        recorder_->add(moment);
    if (news_.moments.size() < kMostMoments)
        news_.moments.push_back(std::move(shown));
    news_.rows += table_.takeText();
}

RobotRunning::News RobotRunning::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(news_, {});
}

}  // namespace noctule::ui
