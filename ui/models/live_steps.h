// SPDX-License-Identifier: Apache-2.0
// What of a live session waits for the device, the disk or the filter: for jobs, one at a time, never for the
// interface's thread.
#pragma once

#include <memory>
#include <optional>

#include "core/job/job.h"
#include "devices/live/live_session.h"

namespace noctule::ui {

/// Ends the stream that is open in good order, begins the next and waits for its first sound. `settings`
/// are the box's before it starts.
std::optional<Error> beginStream(LiveSession& session, const StreamRequest& request,
                                 const std::optional<link::Settings>& settings, const JobContext& job);

/// The take begins in the midst of the stream that is looked at, which goes on.
std::optional<Error> beginInMidst(LiveSession& session, const StreamRequest& request);

/// Waits until all that the device still held has come, then completes the take.
StreamResult endStream(LiveSession& session, const JobContext& job);

}  // namespace noctule::ui
