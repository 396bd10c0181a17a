// SPDX-License-Identifier: Apache-2.0
// What of a live session waits for the device, the disk or the filter: for jobs, one at a time, never for the
// interface's thread.
#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "core/job/job.h"
#include "devices/live/record_take.h"

namespace noctule::ui {

/// Begins a stream, or a take in the midst of the one that is looked at, and waits for its first sound.
std::optional<Error> beginStream(LiveSession& session, const StreamRequest& request, const JobContext& job);

/// Ends what began last in good order: waits until all that the device still held has come, unless its stream
/// goes on, then completes the take.
StreamResult endStream(LiveSession& session, const JobContext& job);

/// How a take of one suit or of several ended, in words.
struct TakeEnd {
    QString path;           ///< empty: there is no file
    QString trouble;        ///< empty: nothing was wrong
    bool is_empty = false;  ///< nothing was recorded, and the file is gone
};
/// `parts`: of all its suits. Removes the file of a take that ended by itself before anything of any suit was
/// recorded. `unasked`: nobody stopped it, so what a device tells is its trouble too.
TakeEnd endOfTake(const std::vector<RecordReport>& parts, bool unasked);

}  // namespace noctule::ui
