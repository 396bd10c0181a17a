// SPDX-License-Identifier: Apache-2.0
// The session of the virtual suit: makes a sample take and processes it, in a folder of its own that is
// recognised and used again. On any thread.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/job/job.h"
#include "core/job/result.h"

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

/// Failed or cancelled, the disk is as it was.
Result<VirtualSession> makeVirtualSession(const VirtualSessionRequest& request, const JobContext& job);

}  // namespace noctule::ui
