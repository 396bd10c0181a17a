// SPDX-License-Identifier: Apache-2.0
// All that the screens work on. A view is given the context that it needs, a page that composes several of
// them the Studio, which is all three; they talk to each other through it only.
#pragma once

#include <QPointer>
#include <mutex>
#include <utility>

#include "core/processing/process_take.h"
#include "ui/models/capture_context.h"
#include "ui/models/review_context.h"
#include "ui/models/shared_context.h"

namespace noctule::ui {

/// Instead of what the take of one performer holds; takes of several keep what each one has.
struct PartsOfOne {
    std::optional<Calibration> calibration{};
    std::optional<Actor> actor{};
    bool fills_in = false;  ///< the calibration is for takes only that hold none of their own
};

class Studio : public SharedContext, public CaptureContext, public ReviewContext {
    Q_OBJECT
public:
    explicit Studio(StudioParts parts, QObject* parent = nullptr);

    SharedContext& shared() { return *this; }
    /// A session with a sample take, processed and open in Review. The one made earlier is used again. A job;
    /// cancelled, nothing of it stays.
    Job* tryVirtualSuit();
    /// A take of the open session (one by date when none is open) with a simulated suit on the motion's
    /// person, processed and open in Review. A job; cancelled, nothing of it stays. Null: no session, and
    /// session().failed() said why.
    Job* importMotion(std::shared_ptr<const figure::UnderstoodMotion> motion, const std::string& scenario);
    /// The most accurate settings for a take that is recorded: the whole take smoothed, or of several people
    /// all together, and pulses found by their whole shape. Opens the take, so not on the interface's thread.
    static ProcessRequest accurateRequest(const std::string& take_path, const PartsOfOne& own,
                                          const JobContext& job);
    /// Processes a take of the session as a job; shows the new run when the take is open.
    Job* process(const ProcessRequest& request);
    Job* processAccurately(const std::string& take_path, const PartsOfOne& own = {});
    /// One after the other, so that all that waits holds no other work up.
    void processInTurn(std::vector<std::pair<std::string, PartsOfOne>> takes);

private:
    void processNext(std::vector<std::pair<std::string, PartsOfOne>> takes);
    Job* startAccurately(const std::string& take_path, const PartsOfOne& own);
    Job* startProcessing(const std::string& take_path,
                         std::function<ProcessRequest(const JobContext&)> settings);

    QPointer<Job> trying_;                          ///< the virtual suit
    std::shared_ptr<std::timed_mutex> processing_;  ///< a take takes one writer, the machine one filter
};

}  // namespace noctule::ui
