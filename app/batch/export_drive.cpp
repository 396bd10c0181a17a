// SPDX-License-Identifier: Apache-2.0
#include "app/batch/export_drive.h"

#include <cmath>

#include "app/batch/files.h"
#include "app/batch/takes.h"
#include "core/job/atomic_file.h"
#include "core/processing/recorded_drive.h"

namespace noctule::batch {
namespace {

constexpr const char* kDriveFiles[] = {"robot-csv", "robot-trajectory", "robot-report"};

std::string contentOf(const RecordedDrive& drive, const std::string& file) {
    if (file == "robot-csv")
        return driveCsv(drive);
    return file == "robot-trajectory" ? driveTrajectory(drive).dump() + "\n" : driveReportHtml(drive);
}

Result<Outcome> exportFrom(const VerbContext& context, const std::string& path) {
    const Arguments& arguments = context.arguments;
    const auto take = Take::open(path, Access::kRead, {&context.cancel});
    if (!take)
        return take.error();
    const auto drive = readRecordedDrive(*take, std::llround(arguments.number("drive").value_or(0)));
    if (!drive)
        return drive.error();
    Outcome outcome;
    outcome.json = {{"take", path}, {"drive", toJson(summaryOf(*drive))}, {"files", nlohmann::json::array()}};
    for (const char* file : kDriveFiles) {
        const std::string out = arguments.text(file);
        if (out.empty())
            continue;
        if (Status written = writeFileAtomically(out, contentOf(*drive, file), arguments.given("overwrite"));
            !written)
            return written.error();
        outcome.json["files"].push_back(out);
        outcome.text += out + ": drive " + std::to_string(drive->about.drive) + ", " +
                        summaryText(summaryOf(*drive)) + ".\n";
    }
    for (const SkippedRows& skipped : take->skippedRows())
        context.console.warn(path + ": " + std::to_string(skipped.count) + " rows of " + skipped.table +
                             " could not be used, first " + skipped.first);
    return outcome;
}

}  // namespace

std::vector<Option> driveExportOptions() {
    return {text("robot-csv", "F", "a robot's commands and states as `drive --record` has recorded them"),
            text("robot-trajectory", "F", "the commands as a JointTrajectory of ROS, JSON"),
            text("robot-report", "F", "HTML: the hands commanded and achieved, in three views, with delay"),
            whole("drive", "N", 1, 1e6, "which drive of the take; else the last")};
}

bool exportsDrive(const Arguments& arguments) {
    for (const char* file : kDriveFiles)
        if (arguments.given(file))
            return true;
    return false;
}

Result<Outcome> exportDrive(const VerbContext& context) {
    const Arguments& arguments = context.arguments;
    if (arguments.operands().size() > 1)
        return Error{ErrorKind::kUsage, "a robot's files are written of one take at a time", "Name one take"};
    if (Status free = checkOutputs(arguments, {std::begin(kDriveFiles), std::end(kDriveFiles)}); !free)
        return free.error();
    return exportFrom(context, arguments.operands().front());
}

}  // namespace noctule::batch
