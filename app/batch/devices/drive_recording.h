// SPDX-License-Identifier: Apache-2.0
// The verb `drive` with --record: commands and states go into the take that leads, or into a new one of the
// suit that leads. What could not be written is said at the end; it never stops the robot.
#pragma once

#include "app/batch/verb.h"
#include "devices/live/live_session.h"
#include "devices/robot/drive_recorder.h"

namespace noctule::batch {

/// --record, --out-dir, --name.
std::vector<Option> driveRecordingOptions();
/// kUsage: options that do not belong together.
Status checkDriveRecording(const Arguments& arguments);
/// The take of a suit that leads; nothing when none is wanted.
std::optional<RecordingRequest> takeOfSuit(const Arguments& arguments);

class DriveRecording {
public:
    /// `take`: the one that leads; of a suit `input`. `arms` outlive it.
    static Result<std::unique_ptr<DriveRecording>> begin(const RobotDriveRow& drive,
                                                         const std::vector<robot::RobotArm>& arms,
                                                         const std::string& take,
                                                         const std::optional<LiveSession::TakeInput>& input);

    void add(const robot_link::DriveMoment& moment) { recorder_.add(moment); }
    /// Waits until it is written, or cannot be.
    robot_link::DriveRecord finish() { return recorder_.finish(); }

private:
    DriveRecording(const RobotDriveRow& drive, const std::vector<robot::RobotArm>& arms, int64_t origin_ns,
                   std::unique_ptr<robot_link::DriveSink> sink)
        : recorder_(drive, arms, origin_ns, std::move(sink)) {}

    robot_link::DriveRecorder recorder_;
};

/// Says what became of it. `suit`: of a suit that led.
void tellRecording(const VerbContext& context, const robot_link::DriveRecord& record,
                   const std::optional<StreamResult>& suit, Outcome& outcome);

}  // namespace noctule::batch
