// SPDX-License-Identifier: Apache-2.0
// Records a drive into a take: what the robot was told, and each state that it told. add() runs on the thread
// of the drive and never waits: neither a disk nor a lock may stop an arm. Rows go on ten times a second.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/job/result.h"
#include "core/recording/robot_rows.h"
#include "devices/robot/drive_loop.h"

namespace noctule {
class Recorder;
}

namespace noctule::robot_link {

/// What became of the rows.
struct DriveRecord {
    std::string take;  ///< its path
    int64_t written = 0, lost = 0;
    double longest_wait_s = 0;     ///< for another program that held the take
    std::optional<Error> trouble;  ///< why rows are missing
};

/// Where rows go. begin() and add() never wait for the disk, finish() does.
class DriveSink {
public:
    virtual ~DriveSink() = default;
    virtual void begin(const RobotDriveRow& drive) = 0;
    virtual void add(RobotRows rows) = 0;
    virtual DriveRecord finish() = 0;
    virtual DriveRecord state() const = 0;
};

/// Into a take that is being recorded; what its recorder makes of the rows stands in the recorder's own
/// state.
std::unique_ptr<DriveSink> sinkIntoRecording(std::shared_ptr<Recorder> recorder);
/// Into a take that exists, in short transactions from a thread of its own. kUnusable and others: it cannot
/// be written now.
Result<std::unique_ptr<DriveSink>> sinkIntoTake(const std::string& path);

class DriveRecorder {
public:
    static constexpr int64_t kBatch_ns = 100'000'000;

    /// `arms` outlive it. `pose_origin_ns`: the time of poses at which the take's time is 0.
    DriveRecorder(RobotDriveRow drive, const std::vector<robot::RobotArm>& arms, int64_t pose_origin_ns,
                  std::unique_ptr<DriveSink> sink);

    /// From one thread at a time.
    void add(const DriveMoment& moment);
    /// Hands on what is left and waits until it is written; later calls of add() do nothing.
    DriveRecord finish();
    DriveRecord state() const { return sink_->state(); }

private:
    void addCommand(const DriveMoment& moment);
    void addState(const DriveMoment& moment);
    void learnTakeTime(const DriveMoment& moment);
    void handOn();
    std::vector<Vector3d> tipsOf(const std::vector<double>& q) const;
    int64_t since(int64_t steady_ns) const { return steady_ns - *zero_ns_; }

    const std::vector<robot::RobotArm>& arms_;
    const int64_t pose_origin_ns_;
    const std::unique_ptr<DriveSink> sink_;
    std::mutex mutex_;
    std::optional<int64_t> zero_ns_;  ///< of the rows: the first command
    int64_t last_state_ns_ = 0, next_ns_ = 0;
    RobotRows rows_;
    std::optional<int64_t> take_time_ns_;  ///< of zero
    bool finished_ = false;
};

}  // namespace noctule::robot_link
