// SPDX-License-Identifier: Apache-2.0
// What of a live session waits for the device, the disk or the filter: for jobs, one at a time, never for the
// interface's thread.
#pragma once

#include <memory>
#include <optional>

#include "core/job/job.h"
#include "devices/live/live_session.h"

namespace noctule::ui {

/// Begins a stream, or a take in the midst of the one that is looked at, and waits for its first sound.
std::optional<Error> beginStream(LiveSession& session, const StreamRequest& request, const JobContext& job);

/// Ends what began last in good order: waits until all that the device still held has come, unless its stream
/// goes on, then completes the take.
StreamResult endStream(LiveSession& session, const JobContext& job);

}  // namespace noctule::ui
