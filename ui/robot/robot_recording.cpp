// SPDX-License-Identifier: Apache-2.0
// What RobotDrive records: commands and the robot's states, into the take of the suit or the one in Review.
#include <QFileInfo>
#include <QPointer>

#include "core/processing/recorded_drive.h"
#include "ui/language/core_words.h"
#include "ui/robot/robot_drive.h"
#include "ui/robot/robot_running.h"

namespace noctule::ui {
namespace {

/// More points are not seen in a drawing of this size.
constexpr size_t kMostDrawn = 4000;

std::vector<robot::PathPoint> drawable(const std::vector<robot::PathPoint>& path) {
    const size_t stride = path.size() / kMostDrawn + 1;
    std::vector<robot::PathPoint> few;
    for (size_t i = 0; i < path.size(); i += stride)
        few.push_back(path[i]);
    return few;
}

/// Of the first arm of the take's last drive.
Result<RobotDrive::HandPaths> recordedHand(const std::string& path, const JobContext& job) {
    const auto take = Take::open(path, Access::kRead, {job.cancel});
    if (!take)
        return take.error();
    const auto drive = readRecordedDrive(*take);
    if (!drive)
        return drive.error();
    const auto hands = handsOf(*drive);
    RobotDrive::HandPaths paths;
    if (hands.empty())
        return paths;
    paths.commanded = drawable(hands.front().wanted);
    paths.achieved = drawable(hands.front().reached);
    paths.tracking = summaryOf(*drive).tracking.front();
    return paths;
}

RobotDriveRow rowOf(const RobotParts& parts, const QString& address, bool of_take, const Studio& studio) {
    RobotDriveRow row;
    row.created_utc = studio.parts().utc_now ? studio.parts().utc_now() : std::string();
    row.software = studio.parts().software;
    row.robot = parts.model.name;
    row.address = address.toStdString();
    row.leader = of_take ? "take" : "suit";
    row.rate_hz = 1 / robot::DriveSettings().teleop.dt_s;
    row.joints = parts.joints;
    for (const robot::RobotArm& arm : parts.driven.arms)
        row.arms.push_back(arm.profile.name);
    return row;
}

}  // namespace

QString RobotDrive::whyNotRecord() const {
    if (leader_ == Leader::kSuit)
        return tr("The suit leads: its recording holds the robot’s commands, too.");
    if (!running_)
        return tr("Connect the robot first.");
    return whyNoLeader();
}

void RobotDrive::setRecording(bool on) {
    if (on == isRecording())
        return;
    if (!on)
        return endRecording();
    if (!whyNotRecord().isEmpty())
        return;
    auto sink = robot_link::sinkIntoTake(studio_.take().path().toStdString());
    if (!sink) {
        emit studio_.failed(coreWords(sink.error().message), coreWords(sink.error().remedy), About::kCapture);
        return emit recordingChanged();
    }
    emit studio_.settled(About::kCapture);
    beginRecording(std::move(*sink), 0);
}

/// A take that the suit records holds what the robot does meanwhile.
void RobotDrive::followSuitsTake() {
    if (leader_ != Leader::kSuit)
        return;
    const auto input = studio_.suit().takeInput();
    if (!input)
        return endRecording();
    if (running_ && !recorder_)
        beginRecording(robot_link::sinkIntoRecording(input->recorder), input->origin_ns);
}

void RobotDrive::beginRecording(std::unique_ptr<robot_link::DriveSink> sink, int64_t pose_origin_ns) {
    const RobotDriveRow row = rowOf(*parts_, choice_.address, leader_ == Leader::kTake, studio_);
    recorder_ = std::make_shared<robot_link::DriveRecorder>(row, parts_->driven.arms, pose_origin_ns,
                                                            std::move(sink));
    running_->setRecorder(recorder_);
    emit recordingChanged();
}

/// What waits is written by a job; the robot goes on meanwhile.
void RobotDrive::endRecording() {
    const auto recorder = std::exchange(recorder_, nullptr);
    if (!recorder)
        return;
    if (running_)
        running_->setRecorder(nullptr);
    emit recordingChanged();
    using Record = robot_link::DriveRecord;
    const bool of_take = recorder->state().take == studio_.take().path().toStdString();
    if (!of_take)
        recorded_take_ = QString::fromStdString(recorder->state().take);
    studio_.jobs().start<Record>(
        tr("Saving the robot’s commands"),
        [recorder, parts = parts_](const JobContext&) -> Result<Record> { return recorder->finish(); },
        [self = QPointer(this), of_take](Result<Record> record) -> QString {
            // Of a suit's take its recorder tells.
            if (self && record && of_take)
                self->recorded(*record, QFileInfo(QString::fromStdString(record->take)).fileName());
            return {};
        },
        Jobs::Loudness::kQuiet);
}

void RobotDrive::recorded(const robot_link::DriveRecord& record, const QString& take) {
    if (record.trouble) {
        const QString lost = record.lost > 0 ? tr("%n command(s) and states of the robot are not in %1.",
                                                  nullptr, static_cast<int>(record.lost))
                                                   .arg(take)
                                             : QString();
        emit studio_.failed(coreWords(record.trouble->message) + (lost.isEmpty() ? "" : " " + lost),
                            coreWords(record.trouble->remedy), About::kCapture);
    } else {
        studio_.say(tr("The robot’s commands and states are in %1.").arg(take));
    }
    if (record.written > 0)
        readRecorded(QString::fromStdString(record.take));
}

void RobotDrive::readRecorded(const QString& take) {
    studio_.jobs().start<HandPaths>(
        tr("Reading the robot’s commands"),
        [path = take.toStdString()](const JobContext& job) { return recordedHand(path, job); },
        [self = QPointer(this)](Result<HandPaths> paths) -> QString {
            if (self && paths) {
                self->recorded_paths_ = std::move(*paths);
                emit self->recordingChanged();
            }
            return {};
        },
        Jobs::Loudness::kQuiet);
}

}  // namespace noctule::ui
