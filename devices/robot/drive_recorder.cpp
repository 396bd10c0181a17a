// SPDX-License-Identifier: Apache-2.0
#include "devices/robot/drive_recorder.h"

#include <algorithm>

#include "core/robot/robot_report.h"
#include "devices/live/recorder.h"

namespace noctule::robot_link {
namespace {

/// A take that is being recorded has one writer; rows go through it, in its commits.
class RecordingSink : public DriveSink {
public:
    explicit RecordingSink(std::shared_ptr<Recorder> recorder) : recorder_(std::move(recorder)) {}
    void begin(const RobotDriveRow& drive) override { recorder_->push(drive); }
    void add(RobotRows rows) override {
        handed_ += rows.count();
        recorder_->push(std::move(rows));
    }
    DriveRecord finish() override { return state(); }
    DriveRecord state() const override {
        const RecorderState recording = recorder_->state();
        DriveRecord record{recording.path, handed_, 0, recording.longest_lock_s, {}};
        if (recording.trouble)
            record.trouble = recording.trouble;
        return record;
    }

private:
    const std::shared_ptr<Recorder> recorder_;
    std::atomic<int64_t> handed_ = 0;
};

}  // namespace

std::unique_ptr<DriveSink> sinkIntoRecording(std::shared_ptr<Recorder> recorder) {
    return std::make_unique<RecordingSink>(std::move(recorder));
}

DriveRecorder::DriveRecorder(RobotDriveRow drive, const std::vector<robot::RobotArm>& arms,
                             int64_t pose_origin_ns, std::unique_ptr<DriveSink> sink)
    : arms_(arms), pose_origin_ns_(pose_origin_ns), sink_(std::move(sink)) {
    sink_->begin(drive);
}

void DriveRecorder::add(const DriveMoment& moment) {
    const std::lock_guard lock(mutex_);
    if (finished_)
        return;
    if (!zero_ns_) {
        zero_ns_ = moment.now_ns;
        next_ns_ = moment.now_ns + kBatch_ns;
    }
    learnTakeTime(moment);
    addCommand(moment);
    addState(moment);
    if (moment.now_ns >= next_ns_) {
        handOn();
        next_ns_ = moment.now_ns + kBatch_ns;
    }
}

/// The pose that came soonest tells the take's time best.
void DriveRecorder::learnTakeTime(const DriveMoment& moment) {
    if (!moment.input.performer)
        return;
    const int64_t here = moment.pose_time_ns - pose_origin_ns_ - since(moment.input.performer->arrived_ns);
    take_time_ns_ = std::max(take_time_ns_.value_or(here), here);
}

void DriveRecorder::addCommand(const DriveMoment& moment) {
    RobotCommandRow row{.sequence = static_cast<int64_t>(moment.sequence),
                        .time_ns = since(moment.now_ns),
                        .state = stateName(moment.output.state),
                        .trouble = troubleName(moment.output.trouble),
                        .q = moment.output.q,
                        .tips_m = tipsOf(moment.output.q)};
    if (moment.input.performer) {
        row.pose_time_ns = moment.pose_time_ns - pose_origin_ns_;
        row.pose_arrived_ns = since(moment.input.performer->arrived_ns);
    }
    rows_.commands.push_back(std::move(row));
}

void DriveRecorder::addState(const DriveMoment& moment) {
    const auto& state = moment.link.state;
    if (!state || moment.link.state_arrived_ns <= last_state_ns_)
        return;
    last_state_ns_ = moment.link.state_arrived_ns;
    // What came before the first command is where the robot stood then.
    RobotStateRow row{.time_ns = std::max<int64_t>(0, since(last_state_ns_)),
                      .refuses = (state->flags & kRefuses) != 0,
                      .q = state->q,
                      .v = state->v,
                      .tips_m = tipsOf(state->q)};
    if (state->obeyed_sequence > 0)
        row.obeyed_sequence = static_cast<int64_t>(state->obeyed_sequence);
    rows_.states.push_back(std::move(row));
}

std::vector<Vector3d> DriveRecorder::tipsOf(const std::vector<double>& q) const {
    std::vector<Vector3d> tips;
    size_t first = 0;
    for (const robot::RobotArm& arm : arms_) {
        tips.push_back(robot::tipInChest(arm, q, first));
        first += static_cast<size_t>(arm.chain.size());
    }
    return tips;
}

void DriveRecorder::handOn() {
    if (rows_.empty())
        return;
    rows_.take_time_ns = take_time_ns_;
    sink_->add(std::exchange(rows_, {}));
}

DriveRecord DriveRecorder::finish() {
    {
        const std::lock_guard lock(mutex_);
        if (!finished_)
            handOn();
        finished_ = true;
    }
    return sink_->finish();
}

}  // namespace noctule::robot_link
