// SPDX-License-Identifier: Apache-2.0
// The whole of a recording as one job: connects the device, records so many seconds or until cancelled, ends
// the take in good order. Waits; the studio's screens use LiveSession instead.
#pragma once

#include "core/job/job.h"
#include "devices/live/live_session.h"

namespace noctule {

struct RecordReport {
    StreamResult stream;
    link::LinkStatistics link;
    int sample_rate_hz = 0;
    bool interrupted = false;  ///< cancelled before its time; the take is there
};

/// `seconds` absent: until cancelled, which is no failure of a recording. Fails when no take came to be;
/// what ended one early stands in the report.
Result<RecordReport> recordTake(std::unique_ptr<Device> device, const StreamRequest& request,
                                std::optional<double> seconds, const JobContext& job);

}  // namespace noctule
