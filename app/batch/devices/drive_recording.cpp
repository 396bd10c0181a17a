// SPDX-License-Identifier: Apache-2.0
#include "app/batch/devices/drive_recording.h"

#include <cstdio>

namespace noctule::batch {

std::vector<Option> driveRecordingOptions() {
    return {flag("record", "commands and the robot's states go into the take; with --device into a new one"),
            text("out-dir", "D", "with --record and --device: folder of the new take; made if it is missing"),
            text("name", "N", "of the new take, which becomes the next free N_###").orElse("take")};
}

Status checkDriveRecording(const Arguments& arguments) {
    const bool of_suit = arguments.given("device");
    if (arguments.given("record") && of_suit && !arguments.given("out-dir"))
        return Error{ErrorKind::kUsage, "--record with --device makes a take, and no folder is named",
                     "Give --out-dir D too"};
    for (const char* option : {"out-dir", "name"})
        if (arguments.given(option) && !(arguments.given("record") && of_suit))
            return Error{ErrorKind::kUsage, std::string("--") + option + " belongs to --record and --device",
                         "Give both, or leave it out"};
    return Done{};
}

std::optional<RecordingRequest> takeOfSuit(const Arguments& arguments) {
    if (!arguments.given("record") || !arguments.given("device"))
        return std::nullopt;
    RecordingRequest request;
    request.folder = arguments.text("out-dir");
    request.name = arguments.text("name");
    return request;
}

Result<std::unique_ptr<DriveRecording>> DriveRecording::begin(
    const RobotDriveRow& drive, const std::vector<robot::RobotArm>& arms, const std::string& take,
    const std::optional<LiveSession::TakeInput>& input) {
    auto sink = input ? robot_link::sinkIntoRecording(input->recorder)
                      : Result<std::unique_ptr<robot_link::DriveSink>>(robot_link::sinkIntoTake(take));
    if (!sink)
        return sink.error();
    return std::unique_ptr<DriveRecording>(
        new DriveRecording(drive, arms, input ? input->origin_ns : 0, std::move(*sink)));
}

void tellRecording(const VerbContext& context, const robot_link::DriveRecord& record,
                   const std::optional<StreamResult>& suit, Outcome& outcome) {
    std::optional<Error> trouble = record.trouble;
    if (suit && suit->recording && suit->recording->trouble)
        trouble = suit->recording->trouble;
    outcome.json["recorded"] = {{"take", record.take},
                                {"rows", record.written},
                                {"rows_lost", record.lost},
                                {"longest_wait_ms", 1e3 * record.longest_wait_s}};
    char text[120];
    std::snprintf(text, sizeof text, ": %lld commands and states recorded, %lld lost\n",
                  static_cast<long long>(record.written), static_cast<long long>(record.lost));
    outcome.text += record.take + text;
    if (suit)
        for (const std::string& warning : suit->warnings)
            context.console.warn(warning);
    if (!trouble)
        return;
    if (record.lost > 0)
        trouble->message += "; " + std::to_string(record.lost) + " commands and states are not in the take";
    context.console.error(*trouble);
    if (!outcome.failure) {
        outcome.json["error"] = errorJson(*trouble);
        outcome.failure = trouble;
    }
}

}  // namespace noctule::batch
