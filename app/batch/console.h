// SPDX-License-Identifier: Apache-2.0
// Standard output and standard error of a batch job. Results go to the one, messages and progress to the
// other; progress only when that is a terminal. Safe to use from several threads.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

#include "core/job/job.h"

namespace noctule::batch {

class Console : public ProgressSink {
public:
    /// `program`: who speaks in errors.
    Console(bool quiet, bool json, std::string program = "noctule");

    void warn(const std::string& sentence);
    void error(const Error& error);  ///< also when quiet
    /// The result: text for people (not when quiet or for machines). False when it could not be written.
    bool print(const std::string& text);
    /// The one JSON object of --json.
    bool printJson(const std::string& json);
    bool wantsJson() const { return json_; }

    void progress(double fraction, const std::string& stage) override;
    void endProgress();

private:
    void eraseProgress();

    std::string program_;
    bool quiet_, json_, shows_progress_;
    bool line_open_ = false;
    std::chrono::steady_clock::time_point next_ = {};
    std::mutex mutex_;
};

}  // namespace noctule::batch
