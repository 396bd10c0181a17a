// SPDX-License-Identifier: Apache-2.0
// The session of the virtual suit: makes a sample take and processes it, in a folder of its own that is
// recognised and used again. On any thread.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/job/job.h"
#include "core/job/result.h"
#include "core/session/session.h"

namespace noctule::ui {

struct VirtualSessionRequest {
    std::filesystem::path sessions_folder;
    std::string session_name;  ///< "Virtual suit"; " 2" and so on when something else has the name
    std::string take_base;     ///< "sample"
    std::string software, created_utc;
    std::function<Status(const std::string& path, const JobContext&)> make_take;
};

struct VirtualSession {
    std::filesystem::path folder;
    std::string take;  ///< its name, processed
};

/// Makes a take, processes it and puts it into the session's takes; its name. Failed or cancelled, the disk
/// is as it was. Of the request: names, maker and header.
Result<std::string> makeSimulatedTake(const VirtualSessionRequest& request, const Session& session,
                                      const JobContext& job);

/// Failed or cancelled, the disk is as it was.
Result<VirtualSession> makeVirtualSession(const VirtualSessionRequest& request, const JobContext& job);

}  // namespace noctule::ui
