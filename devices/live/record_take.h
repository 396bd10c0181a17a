// SPDX-License-Identifier: Apache-2.0
// The whole of a recording as one job: connects the device, records so many seconds, until cancelled or as
// another program wishes, ends the take in good order. Waits; the studio's screens use LiveSession instead.
#pragma once

#include "core/job/job.h"
#include "devices/live/live_group.h"
#include "devices/remote/remote_trigger.h"

namespace noctule {

struct RecordReport {
    StreamResult stream;
    link::LinkStatistics link;
    int sample_rate_hz = 0;
    bool interrupted = false;  ///< cancelled before its time; the take is there
};

/// `seconds` absent: until cancelled, which is no failure of a recording. Fails when no take came to be;
/// what ended one early stands in the report.
Result<RecordReport> recordTake(std::unique_ptr<Device> device, StreamRequest request,
                                std::optional<double> seconds, const JobContext& job);

/// Waits, streaming, until another program begins a recording, and records until it ends it, `seconds` are
/// over or the job is cancelled. The take has the name that it gives, and its notes. Cancelled before it
/// began, no take comes to be.
Result<RecordReport> recordWhenTriggered(std::unique_ptr<Device> device, StreamRequest request,
                                         const RemoteTriggerOptions& options, std::optional<double> seconds,
                                         const JobContext& job);

/// One suit of several.
struct SuitReport : RecordReport {
    std::string address, serial;
    bool is_room = false;
};

struct GroupReport {
    std::vector<SuitReport> suits;      ///< all of one take
    std::vector<std::string> warnings;  ///< of suits beside each other; whole sentences
    bool interrupted = false;
};

/// The same of several suits, one device each, into one take. Fails, and leaves no take, when one of them
/// does not answer or does not start.
Result<GroupReport> recordTogether(std::vector<std::unique_ptr<Device>> devices, GroupRequest request,
                                   std::optional<double> seconds, const JobContext& job);

/// Begins a take of boxes that are ready and waits for sound of each; yields what begin() yields. On an error
/// no take is left.
Result<std::vector<std::string>> beginTogether(LiveGroup& group, const GroupRequest& request,
                                               const JobContext& job);
/// Stops all boxes in good order and completes the take.
GroupReport endTogether(LiveGroup& group, const JobContext& job);

}  // namespace noctule
