// SPDX-License-Identifier: Apache-2.0
// The drive that runs: the link, the source of poses and the thread of the loop. For RobotDrive only.
#pragma once

#include <thread>

#include "devices/robot/drive_loop.h"
#include "devices/robot/drive_recorder.h"
#include "devices/robot/drive_table.h"
#include "devices/robot/motion_poses.h"
#include "ui/robot/robot_drive.h"

namespace noctule::ui {

class RobotRunning {
public:
    struct Plan {
        std::shared_ptr<const RobotParts> parts;
        std::unique_ptr<robot_link::RobotInterface> link;
        Skeleton skeleton;
        robot::PerformerArms performer;
        std::optional<TimedMotion> motion;  ///< absent: poses come through put()
        bool repeats = false;
        robot::DriveSettings settings;
        double speed = 1;
    };
    explicit RobotRunning(Plan plan);
    ~RobotRunning();

    robot_link::PoseFeed& feed() { return feed_; }
    robot_link::MotionPoses* motion() { return motion_ ? motion_.get() : nullptr; }
    robot_link::LinkStatus status() const { return plan_.link->status(); }
    /// What is held; pressed keys wait until a step has taken them.
    void setKeys(bool dead_man, bool clutch);
    void press(bool robot::TeleopKeys::*key);
    void setSpeed(double share);
    /// Every step from now on goes there, too; null: nowhere.
    void setRecorder(std::shared_ptr<robot_link::DriveRecorder> recorder);

    struct News {
        std::vector<RobotMoment> moments;
        std::string rows;
        std::optional<Error> end;  ///< the loop is over
    };
    News take();

private:
    void run();
    void watch(const robot_link::DriveMoment& moment);

    Plan plan_;
    robot_link::PoseFeed feed_;
    std::unique_ptr<robot_link::MotionPoses> motion_;
    CancelFlag cancel_;
    std::mutex mutex_;
    robot::TeleopKeys keys_;
    News news_;
    std::shared_ptr<robot_link::DriveRecorder> recorder_;
    robot_link::DriveTable table_;
    std::jthread thread_;
};

}  // namespace noctule::ui
